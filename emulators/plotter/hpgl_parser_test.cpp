#include "emulators/plotter/hpgl_parser.h"

#include <gtest/gtest.h>

#include <sstream>

namespace overstrike::emulator {
namespace {

/// "PA 1 2 . PU ." : mnemonics, numbers, a point for each end, ? for what belongs nowhere.
std::string parsed(const std::string& bytes) {
  std::istringstream in(bytes);
  HpglParser parser(in);
  std::ostringstream out;
  for (HpglEvent e = parser.next(); e.kind != HpglEvent::Kind::none; e = parser.next()) {
    if (out.tellp() > 0) out << ' ';
    switch (e.kind) {
      case HpglEvent::Kind::instruction:
        out << e.name;
        break;
      case HpglEvent::Kind::number:
        out << e.number;
        break;
      case HpglEvent::Kind::end:
        out << '.';
        break;
      default:
        out << '?';
    }
  }
  return out.str();
}

struct Case {
  const char *bytes, *events;
};

TEST(HpglParser, SyntaxVariants) {
  const Case cases[] = {
      {"IN;SP1;PU100,200;PD300,400;", "IN . SP 1 . PU 100 200 . PD 300 400 ."},
      {"INSP1PU100,200PD300,400", "IN . SP 1 . PU 100 200 . PD 300 400 ."},
      {"in;sp1;pu100,200;Pd300,400", "IN . SP 1 . PU 100 200 . PD 300 400 ."},
      {"PA 100 200", "PA 100 200 ."},
      {"PA100,,200", "PA 100 200 ."},
      {"PA , 100 ,\t200 ;", "PA 100 200 ."},
      {"PA100-200+300-400;", "PA 100 -200 300 -400 ."},
      {"PA1.5,-.25,3.;", "PA 1.5 -0.25 3 ."},
      {"PA1.2.3;", "PA 1.2 0.3 ."},
      {"PA100,\r\n200;\r\nPU;\n", "PA 100 200 . PU ."},
      {"P\nU;P D 1,2", "PU . PD 1 2 ."},
      {"PU;;;PD;", "PU . PD ."},
      {"", ""},
      {";;\n \t", ""},
      {"P", "P ."},
      {"P;U", "P . U ."},
      {"P1,2;", "P 1 2 ."},
      {"PUP", "PU . P ."},
      {"12,13;PU", "? ? PU ."},
      {"PA-;PA+,.;PU", "PA . PA . PU ."},
      {"PA1!2", "PA 1 ? 2 ."},
      {"PA99999999999999999999999999,1", "PA 1e+12 1 ."},
      {"PA\xff"
       "1,2",
       "PA ? 1 2 ."},
  };
  for (const Case& c : cases) EXPECT_EQ(parsed(c.bytes), c.events) << c.bytes;
}

TEST(HpglParser, EscapesAreSkippedWhereverTheyStand) {
  const Case cases[] = {
      {"\x1b.(IN;PU", "IN . PU ."},
      {"PA10\x1b.B0,20;", "PA 100 20 ."},  // never buffered, so even between digits
      {"PA1\x1b.M500;;;13:2,3;", "PA 12 3 ."},
      {"\x1b.I81;;17:\x1b.N;19:PU;", "PU ."},
      {"\x1b.@;13:IN", "IN ."},
      {"\x1b.RPU", "PU ."},
      {"\x1b.H100;5;6PU", "PU ."},  // its colon is missing
      {"\x1b.H1\x1b.BPU", "PU ."},
      {"\x1b"
       "EPU",
       "PU ."},
      {"\x1b%0BPU1,2;\x1b%0A", "PU 1 2 ."},
      {"\x1b%-12345X@PJL SET X=1\r\n@PJL ENTER LANGUAGE=HPGL2\nIN;", "IN ."},
      {"\x1b%-12345X", ""},
      {"\x1b", ""},
      {"\x1b.", ""},
      {"\x1b%", ""},
      {"\x1b\x1b.BPU", "PU ."},
  };
  for (const Case& c : cases) EXPECT_EQ(parsed(c.bytes), c.events) << c.bytes;
}

TEST(HpglParser, TextsAreNotTakenForInstructions) {
  const Case cases[] = {
      {"LBPU;PD;\x03PU;", "LB . PU ."},
      {"DT#;LBPD1,2;#PU", "DT . LB . PU ."},
      {"DT#;DT;LBPD#\x03PU", "DT . DT . LB . PU ."},
      {"DT", "DT ."},
      {"LBnever ends;PU;", "LB ."},
      {"SMP;PU", "SM . PU ."},
      {"SM;PU", "SM . PU ."},
      {"PE<=abc;PU", "PE . PU ."},
      {"CO\"PU;PD;\";PU", "CO . PU ."},
      {"BP5,1,\"a;b\"IN;PU", "BP . PU ."},
  };
  for (const Case& c : cases) EXPECT_EQ(parsed(c.bytes), c.events) << c.bytes;
}

TEST(HpglParser, KnowsWhereThingsStand) {
  std::istringstream in("IN;\x1b.B PA10,-20;?");
  HpglParser parser(in);
  std::vector<std::uint64_t> bytes;
  for (HpglEvent e = parser.next(); e.kind != HpglEvent::Kind::none; e = parser.next()) {
    bytes.push_back(e.byte);
  }
  EXPECT_EQ(bytes, (std::vector<std::uint64_t>{0, 2, 7, 9, 12, 15, 16}));
}

}  // namespace
}  // namespace overstrike::emulator
