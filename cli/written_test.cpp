#include "cli/written.h"

#include <gtest/gtest.h>

namespace overstrike {
namespace {

TEST(WrittenSettings, OptionsAndSets) {
  const Settings settings = {{"size", "0"}, {"lpi", "9"}, {"lpi", "99"}, {"margin", "x"}};
  const WrittenSettings written{settings, 2};
  EXPECT_EQ(as_written(written, "size"), "--size");
  EXPECT_EQ(as_written(written, "lpi"), "--set lpi");  // the last one counts
  EXPECT_EQ(as_written(written, "margin"), "--set margin");
  EXPECT_EQ(as_written(written, "cpi"), "cpi");
}

TEST(WrittenSettings, MessagesThatBeginWithTheName) {
  const Settings settings = {{"size", "0"}};
  const WrittenSettings written{settings, 1};
  EXPECT_EQ(say_as_written(written, "size must be 1, found '0'"), "--size must be 1, found '0'");
  EXPECT_EQ(say_as_written(written, "a size must be 1"), "a size must be 1");
  EXPECT_EQ(say_as_written(written, "size"), "size");
  EXPECT_EQ(say_as_written(written, ""), "");
}

}  // namespace
}  // namespace overstrike
