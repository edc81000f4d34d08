#include "scenes/readers/source_text.h"

#include <gtest/gtest.h>

#include <string>

namespace overstrike {
namespace {

std::string all_errors(const Reporter& reporter) {
  try {
    reporter.throw_errors();
  } catch (const InputError& e) {
    return e.what();
  }
  return {};
}

TEST(SourceText, TellsTextFromOtherBytes) {
  constexpr std::size_t kNone = std::string_view::npos;
  EXPECT_EQ(first_non_text(""), kNone);
  EXPECT_EQ(first_non_text("plain\r\n\ttext"), kNone);
  EXPECT_EQ(first_non_text("h\u00fctte \u5efa \U0001F3E0"), kNone);
  EXPECT_EQ(first_non_text(std::string_view("a\0b", 3)), 1u);
  EXPECT_EQ(first_non_text("a\xFF"), 1u);
  EXPECT_EQ(first_non_text("ab\xC3"), 2u);            // cut short
  EXPECT_EQ(first_non_text("\xC0\xAF"), 0u);          // overlong
  EXPECT_EQ(first_non_text("\xE0\x80\x80"), 0u);      // overlong
  EXPECT_EQ(first_non_text("\xED\xA0\x80"), 0u);      // a surrogate
  EXPECT_EQ(first_non_text("\xF4\x90\x80\x80"), 0u);  // beyond Unicode
  EXPECT_EQ(first_non_text("a\x80"), 1u);             // a continuation alone
}

TEST(SourceText, FindsMarks) {
  const TextMark mark = mark_at("ab\ncd\r\nef", 8);
  EXPECT_EQ(mark.line, 3);
  EXPECT_EQ(mark.column, 2);
  EXPECT_EQ(mark_at("ab", 0).column, 1);
}

TEST(Reporter, CountsColumnsInCharactersAndPointsWithACaret) {
  const std::string text = "a: 1\r\n\u00e9\u00e9: x\r\n";
  Reporter reporter(text, "s.yaml");
  reporter.error(mark_at(text, text.find('x')), "bad", "try 2");
  EXPECT_EQ(all_errors(reporter), "s.yaml:2:5: error: bad (try 2)\n    \u00e9\u00e9: x\n        ^");
}

TEST(Reporter, TabsBecomeBlanksInExcerpts) {
  const std::string text = "\t\tx";
  Reporter reporter(text, "s");
  reporter.error(mark_at(text, 2), "bad");
  EXPECT_EQ(all_errors(reporter), "s:1:3: error: bad\n      x\n      ^");
}

TEST(Reporter, LongLinesAreShownRoundThePlace) {
  const std::string text = std::string(200, 'a') + "X" + std::string(300, 'b');
  Reporter reporter(text, "s");
  reporter.error(mark_at(text, 200), "bad");
  EXPECT_EQ(all_errors(reporter), "s:1:201: error: bad\n    ..." + std::string(50, 'a') + "X" +
                                      std::string(39, 'b') + "...\n    " + std::string(53, ' ') +
                                      "^");
}

TEST(Reporter, ALineThatFitsIsShownWhole) {
  const std::string text = "x\n" + std::string(89, 'a') + "X\nz";
  Reporter reporter(text, "s");
  reporter.error(mark_at(text, 91), "bad");
  EXPECT_EQ(all_errors(reporter), "s:2:90: error: bad\n    " + std::string(89, 'a') + "X\n    " +
                                      std::string(89, ' ') + "^");
}

TEST(Reporter, TellsErrorsInTheOrderOfTheFileAndCountsTheRest) {
  const std::string text = "a\nb\nc";
  Reporter reporter(text, "s");
  for (int i = 0; i < 250; ++i) reporter.error(mark_at(text, 4), "late");
  EXPECT_TRUE(reporter.full());
  EXPECT_EQ(reporter.errors(), 250u);
  try {
    reporter.throw_errors();
    FAIL();
  } catch (const InputError& e) {
    EXPECT_EQ(e.diagnostics().size(), 201u);
    EXPECT_EQ(e.diagnostics().back().message, "and 50 more errors");
  }
  Reporter two(text, "s");
  two.append(InputError({"mesh.stl", 1, 1}, "theirs").diagnostics());
  two.error(mark_at(text, 2), "second");
  two.error(mark_at(text, 0), "first");
  two.warning(mark_at(text, 0), "odd");
  EXPECT_EQ(all_errors(two),
            "s:1:1: error: first\n    a\n    ^\ns:1:1: warning: odd\n    a\n    ^\n"
            "s:2:1: error: second\n    b\n    ^\nmesh.stl:1:1: error: theirs");
  EXPECT_EQ(two.warnings().size(), 1u);
}

}  // namespace
}  // namespace overstrike
