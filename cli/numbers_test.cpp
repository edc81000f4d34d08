#include "cli/numbers.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "cli/usage.h"

namespace overstrike {
namespace {

using testing::ElementsAre;

constexpr NumberRule kPair{"--light", "AZ,EL in degrees", 2};
constexpr NumberRule kOne{"--fov", "DEG above 0", 1};

std::string error_of(const NumberRule& rule, std::string_view text) {
  try {
    read_numbers(rule, text);
  } catch (const UsageError& error) {
    return error.what();
  }
  return "no error";
}

TEST(Numbers, AreReadInAllTheirSpellings) {
  EXPECT_THAT(read_numbers(kPair, "-20,45"), ElementsAre(-20, 45));
  EXPECT_THAT(read_numbers(kPair, "+1e1,.5"), ElementsAre(10, 0.5));
  EXPECT_THAT(read_numbers(kPair, "0.1,-0"), ElementsAre(0.1, 0));
}

TEST(Numbers, WhatIsNoFiniteNumberIsRefused) {
  for (const char* text : {"nan,1", "1,inf", "-inf,1", "1,nan(0)", "one,two", "1,", ",1", ",",
                           "1 ,2", "1,2x", "0x10,1", "1e999,1", "--1,2", "+-1,2", "1;2", ""}) {
    EXPECT_EQ(error_of(kPair, text),
              "--light: expected AZ,EL in degrees, found '" + std::string(text) + "'");
  }
}

TEST(Numbers, TheirCountIsChecked) {
  EXPECT_EQ(error_of(kPair, "1"), "--light: expected AZ,EL in degrees, found '1'");
  EXPECT_EQ(error_of(kPair, "1,2,3"), "--light: expected AZ,EL in degrees, found '1,2,3'");
}

TEST(Numbers, BoundsAreOpenBelowAndClosedAbove) {
  EXPECT_EQ(read_number_above(kOne, "179", 0, 179), 179);
  EXPECT_THROW(read_number_above(kOne, "0", 0, 179), UsageError);
  EXPECT_THROW(read_number_above(kOne, "-1", 0, 179), UsageError);
  EXPECT_THROW(read_number_above(kOne, "179.5", 0, 179), UsageError);
}

TEST(Numbers, IntegersAreWhole) {
  EXPECT_EQ(read_integer(kOne, "8", 0, 1024), 8);
  EXPECT_EQ(read_integer(kOne, "+8", 0, 1024), 8);
  for (const char* text : {"8.0", "1e2", "-1", "1025", "", "eight", "99999999999999999999"})
    EXPECT_THROW(read_integer(kOne, text, 0, 1024), UsageError) << text;
}

}  // namespace
}  // namespace overstrike
