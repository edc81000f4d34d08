#include "emulators/line_printer/carriage.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>
#include <sstream>

namespace overstrike::emulator {
namespace {

struct Printed {
  std::vector<std::string> pages;  ///< lines end with '|'; "[AB]" is A and B on one place
  LinePrinterReport report;
};

std::string text_of(const PrintedPage& page) {
  std::string text;
  for (const PrintedLine& line : page) {
    for (const StruckCell& cell : line) {
      std::string struck;
      for (unsigned char c = '!'; c <= '~'; ++c)
        if (cell.has(c)) struck += static_cast<char>(c);
      text += struck.empty() ? " " : struck.size() == 1 ? struck : "[" + struck + "]";
    }
    text += '|';
  }
  return text;
}

Printed printed(const std::string& bytes, bool asa = false, int columns = 136,
                std::size_t most_lines = 100) {
  Printed printed;
  Carriage carriage(columns, most_lines, printed.report,
                    [&](const PrintedPage& page) { printed.pages.push_back(text_of(page)); });
  std::istringstream in(bytes);
  asa ? print_asa(in, carriage, printed.report) : print_ascii(in, carriage, printed.report);
  return printed;
}

struct Case {
  const char* bytes;
  std::vector<std::string> pages;
};

TEST(Carriage, ControlCharactersMoveIt) {
  const Case cases[] = {
      {"", {"|"}},
      {"A", {"A|"}},
      {"A\n", {"A|"}},
      {"A\nB", {"A|B|"}},
      {"A\n\n\nB\n", {"A|||B|"}},
      {"A\n\n", {"A||"}},
      {"AB\r#\n", {"[#A]B|"}},
      {"A\r\nB\r\n", {"A|B|"}},
      {"A\r \rB\n", {"[AB]|"}},
      {"AB\b\b_\n", {"[A_]B|"}},
      {"A\b\b\b\bB\n", {"[AB]|"}},
      {"A\tB\n", {"A       B|"}},
      {"12345678\tB\n", {"12345678        B|"}},
      {"  A  \n", {"  A|"}},
      {"A\fB\f", {"A|", "B|"}},
      {"\f\fA", {"|", "|", "A|"}},
      {"A\n\fB\n", {"A|", "B|"}},
      {"A\n\f", {"A|"}},
      {"AA\r A\rA\n", {"AA|"}},
  };
  for (const Case& c : cases)
    EXPECT_THAT(printed(c.bytes).pages, testing::ElementsAreArray(c.pages))
        << testing::PrintToString(std::string(c.bytes));
}

TEST(Carriage, FortranMovesThePaperFirst) {
  const Case cases[] = {
      {"", {"|"}},
      {" A\n B\n", {"A|B|"}},
      {" A\n B", {"A|B|"}},
      {" A\r\n B\r\n", {"A|B|"}},
      {" AB\n+ #\n", {"A[#B]|"}},
      {"+A\n+B\n C\n", {"[AB]|C|"}},
      {" A\n0B\n-C\n", {"A||B|||C|"}},
      {"0A\n", {"|A|"}},
      {"1A\n B\n1C\n", {"A|B|", "C|"}},
      {" A\n1\n", {"A|", "|"}},
      {" \n A\n", {"|A|"}},
      {" A\n \n", {"A||"}},
      {"\n\nA\n", {"|||"}},
      {" A\n+\n B\n", {"A|B|"}},
  };
  for (const Case& c : cases)
    EXPECT_THAT(printed(c.bytes, true).pages, testing::ElementsAreArray(c.pages))
        << testing::PrintToString(std::string(c.bytes));
}

TEST(Carriage, CountsWhatItDid) {
  const LinePrinterReport report = printed("AB C\r##\n\x01\n\f\xff X\x7f").report;
  EXPECT_EQ(report.pages, 2u);
  EXPECT_EQ(report.lines, 3u);
  EXPECT_EQ(report.strikes, 6u);
  EXPECT_EQ(report.overstrikes, 2u);
  EXPECT_EQ(report.beyond, 0u);
  EXPECT_EQ(report.unprintable, 3u);
  EXPECT_EQ(printed("?A\n B\n", true).report.unprintable, 1u);
}

TEST(Carriage, BytesThatAreNoCharactersLeaveTheirPlaceBare) {
  EXPECT_THAT(printed("A\xffX\n").pages, testing::ElementsAre("A X|"));
  EXPECT_THAT(printed(std::string("A\0X\n", 4)).pages, testing::ElementsAre("AX|"));
}

TEST(Carriage, WhatIsRightOfItIsLost) {
  const Printed narrow = printed("ABCDEF\n12\n", false, 4);
  EXPECT_THAT(narrow.pages, testing::ElementsAre("ABCD|12|"));
  EXPECT_EQ(narrow.report.beyond, 2u);
  EXPECT_EQ(printed(std::string(1000000, 'M')).report.beyond, 1000000u - 136u);
}

TEST(Carriage, PagesThatAreTooLongAreErrors) {
  const auto lines = [](std::size_t count) {
    return printed(std::string(count, '\n'), false, 9, 5);
  };
  EXPECT_EQ(lines(5).report.lines, 5u);
  EXPECT_THROW(lines(6), Error);
  EXPECT_THROW(printed("\n\n\n\n\nA", false, 9, 5), Error);
  EXPECT_EQ(printed("\n\n\n\nA\f\n\n\n\nB", false, 9, 5).report.lines, 10u);
  EXPECT_THROW(printed("-\n-\n-\n", true, 9, 5), Error);
  try {
    printed("\f\n\n\n\n\n\n", false, 9, 5);
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), "page 2 has more than 5 lines, the most that such paper takes");
  }
}

// What was counted is what is there, whatever the bytes.
TEST(Carriage, TakesAnyBytes) {
  std::mt19937 random(3);
  const std::string likely = "\n\n\r\b\t\f +-01A#~";
  for (int round = 0; round < 2000; ++round) {
    std::string bytes(random() % 100, ' ');
    for (char& byte : bytes)
      byte = random() % 4 ? likely[random() % likely.size()] : static_cast<char>(random() % 256);
    for (const bool asa : {false, true}) {
      std::uint64_t lines = 0, ink = 0;
      LinePrinterReport report;
      Carriage carriage(20, 1000, report, [&](const PrintedPage& page) {
        lines += page.size();
        for (const PrintedLine& line : page)
          for (const StruckCell& cell : line) ink += !cell.blank();
      });
      std::istringstream in(bytes);
      asa ? print_asa(in, carriage, report) : print_ascii(in, carriage, report);
      EXPECT_EQ(lines, report.lines);
      EXPECT_EQ(ink, report.strikes - report.overstrikes - report.beyond);
    }
  }
}

}  // namespace
}  // namespace overstrike::emulator
