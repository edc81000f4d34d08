#include "emulators/plotter/machine.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>
#include <sstream>

namespace overstrike::emulator {
namespace {

/// "1: 0,0 10,0" for each line of ink.
class Listed final : public Ink {
 public:
  void line(int pen, std::span<const PenPoint> points) override {
    std::ostringstream text;
    text << pen << ':';
    for (const PenPoint& p : points) text << ' ' << p.x << ',' << p.y;
    lines.push_back(text.str());
  }
  std::vector<std::string> lines;
};

PlotterLimits limits() {
  PlotterLimits machine;
  machine.clip_x = 1000;
  machine.clip_y = 500;
  machine.unit_mm = 0.5;
  return machine;
}

struct Drawn {
  explicit Drawn(const std::string& bytes) {
    std::istringstream in(bytes);
    report = run_plotter(in, limits(), ink);
  }
  Listed ink;
  PlotterReport report;
};

using testing::ElementsAre;
using testing::IsEmpty;

TEST(PlotterMachine, DrawsWithThePenDown) {
  EXPECT_THAT(Drawn("IN;SP1;PU10,20;PD30,20,30,40;PU;SP0;").ink.lines,
              ElementsAre("1: 10,20 30,20 30,40"));
  EXPECT_THAT(Drawn("SP2;PA10,20;PD;PA30,20;PU50,60;PD70,60;").ink.lines,
              ElementsAre("2: 10,20 30,20", "2: 50,60 70,60"));
  EXPECT_THAT(Drawn("SP1;PU100,100;PD;PR10,0,0,10;PA0,0").ink.lines,
              ElementsAre("1: 100,100 110,100 110,110 0,0"));
  EXPECT_THAT(Drawn("SP1;PR;PU10,10;PD5,5;DF;PD7,8").ink.lines, ElementsAre("1: 10,10 15,15 7,8"));
  EXPECT_THAT(Drawn("SP1;PU5,6;PD;PU;").ink.lines, ElementsAre("1: 5,6"));  // a dot
  EXPECT_THAT(Drawn("SP1;PD5,0;SP3;PD9,0;").ink.lines, ElementsAre("1: 0,0 5,0", "3: 5,0 9,0"));
  EXPECT_THAT(Drawn("SP1;PD5,0;IN;PA9,9;").ink.lines, ElementsAre("1: 0,0 5,0"));  // IN lifts
  EXPECT_THAT(Drawn("PU1,1;PA2,2;").ink.lines, IsEmpty());
}

TEST(PlotterMachine, StaysInsideTheHardClip) {
  const Drawn run("SP1;PU-100,100;PD200,100,200,900,300,900,300,100;PU;");
  EXPECT_THAT(run.ink.lines, ElementsAre("1: 0,100 200,100 200,500", "1: 300,500 300,100"));
  EXPECT_EQ(run.report.clipped, 4u);
  EXPECT_THAT(Drawn("SP1;PU-5,10;PD10,-5;").ink.lines, ElementsAre("1: 0,5 5,0"));
  EXPECT_THAT(Drawn("SP1;PU-50,10;PD10,-50;").ink.lines, IsEmpty());
}

TEST(PlotterMachine, LongLinesComeInPiecesThatMeet) {
  std::string bytes = "SP1;PD";
  for (int i = 1; i <= 200; ++i) bytes += std::to_string(i) + ",0,";
  const Drawn run(bytes);
  ASSERT_EQ(run.ink.lines.size(), 4u);
  EXPECT_EQ(run.ink.lines[0].substr(run.ink.lines[0].rfind(' ')), " 63,0");
  EXPECT_EQ(run.ink.lines[1].substr(0, 7), "1: 63,0");
  EXPECT_EQ(run.report.pen_down_mm, 100);
}

TEST(PlotterMachine, Reports) {
  const PlotterReport report = Drawn("IN;SP1;PU30,40;PD30,140;PU;SP2;PD;PU;SP0;").report;
  EXPECT_EQ(report.instructions, 9u);
  EXPECT_EQ(report.pen_up_mm, 25);
  EXPECT_EQ(report.pen_down_mm, 50);
  EXPECT_EQ(report.lifts, 2u);
  EXPECT_EQ(report.pen_changes, 2u);
  EXPECT_EQ(report.unknown, 0u);
  EXPECT_THAT(report.skipped, IsEmpty());
  EXPECT_THAT(report.warnings, IsEmpty());
}

TEST(PlotterMachine, SkipsAndNamesWhatItDoesNotDraw) {
  const PlotterReport report = Drawn("IN;CI100;VS10;LBtext\x03;CI5;Q;").report;
  ASSERT_EQ(report.skipped.size(), 3u);
  EXPECT_EQ(report.skipped[0].name, "CI");
  EXPECT_EQ(report.skipped[0].count, 2u);
  EXPECT_EQ(report.skipped[0].first_byte, 3u);
  EXPECT_EQ(report.skipped[1].name, "LB");
  EXPECT_EQ(report.skipped[2].name, "Q");
  EXPECT_EQ(report.unknown, 4u);
}

TEST(PlotterMachine, WarnsOfWhatIsWrong) {
  const auto warnings = [](const char* bytes) { return Drawn(bytes).report.warnings; };
  EXPECT_THAT(warnings("SP1;PD40000,10,20,10;"),
              ElementsAre("byte 12: 40000 is out of range, the move is left out"));
  EXPECT_THAT(Drawn("SP1;PD40000,10,20,10;").ink.lines, ElementsAre("1: 0,0 20,10"));
  EXPECT_THAT(warnings("PA1,2,3;"), ElementsAre("byte 0: PA ends with half a pair of coordinates"));
  EXPECT_THAT(warnings("SP9;"), ElementsAre("byte 0: SP 9 is out of range 0 to 6, the pen stays"));
  EXPECT_THAT(warnings("PD100,0;"), ElementsAre("50.0 mm were drawn with no pen in the holder"));
  EXPECT_THAT(warnings("12;PU!"), ElementsAre("byte 0: 2 bytes or numbers that belong to no "
                                              "instruction from here on"));
  std::string many;
  for (int i = 0; i < 100; ++i) many += "PA1;";
  const auto listed = warnings(many.c_str());
  ASSERT_EQ(listed.size(), kMostWarnings + 1);
  EXPECT_EQ(listed.back(), "and 80 more of these");
}

/// Bytes likely to mean something, and any bytes.
std::string random_bytes(std::mt19937& random) {
  static const char* const kPieces[] = {"PU", "PD",   "PA", "PR",   "SP", "IN",     "DF",  "LB",
                                        "DT", ";",    ",",  "\x1b", ".",  "\x1b.M", "-99", "32767",
                                        "1",  "\x03", "\"", "BP",   "PE", "\x1b%",  "@",   ":"};
  std::string bytes = random() % 2 ? "SP1;PD" : "";
  for (int n = std::uniform_int_distribution(0, 30)(random); n > 0; --n) {
    if (random() % 4 == 0) {
      bytes += static_cast<char>(random());
    } else {
      bytes += kPieces[random() % std::size(kPieces)];
    }
  }
  return bytes;
}

class Judge final : public Ink {
 public:
  void line(int pen, std::span<const PenPoint> points) override {
    EXPECT_TRUE(pen >= 1 && pen <= 6);
    EXPECT_TRUE(!points.empty() && points.size() <= kLongestLine);
    for (const PenPoint& p : points) {
      EXPECT_TRUE(p.x >= 0 && p.x <= 1000 && p.y >= 0 && p.y <= 500) << p.x << ' ' << p.y;
    }
    ++lines;
  }
  int lines = 0;
};

TEST(PlotterMachine, AnyBytesGiveInkInsideTheClipAndAReport) {
  std::mt19937 random(7475);
  Judge judge;
  for (int i = 0; i < 100000; ++i) {
    std::istringstream in(random_bytes(random));
    const PlotterReport report = run_plotter(in, limits(), judge);
    EXPECT_TRUE(std::isfinite(report.pen_down_mm) && std::isfinite(report.pen_up_mm));
    EXPECT_LE(report.warnings.size(), kMostWarnings + 3);
  }
  EXPECT_GT(judge.lines, 1000);
}

}  // namespace
}  // namespace overstrike::emulator
