#include "devices/line_printer/tone_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "core/error.h"

namespace overstrike {
namespace {

const std::string kUpper64 = [] {
  std::string all;
  for (char c = 0x20; c < 0x60; ++c) all += c;
  return all;
}();

Alphabet measured(double lpi) {
  return measure_alphabet(find_typeface("dejavu-sans-mono"), kUpper64, 10, lpi);
}

int ink_of(const Alphabet& alphabet, const std::string& strikes) {
  Ink all(alphabet.cell_pixels);
  for (const char c : strikes)
    for (const Glyph& glyph : alphabet.glyphs)
      if (glyph.character == c) all.add(glyph.ink);
  return all.count();
}

double worst_error_in_steps(const ToneTable& table) {
  const int last = static_cast<int>(table.levels.size()) - 1;
  const double step = static_cast<double>(table.levels.back().ink) / last;
  double worst = 0;
  for (int i = 0; i <= last; ++i)
    worst = std::max(worst, std::abs(table.levels[i].ink - i * step) / step);
  return worst;
}

void expect_laws(const ToneTable& table, const Alphabet& alphabet, int strikes) {
  EXPECT_EQ(table.levels.front().strikes, "");
  EXPECT_EQ(table.levels.front().ink, 0);
  for (std::size_t i = 0; i < table.levels.size(); ++i) {
    const ToneTable::Level& level = table.levels[i];
    EXPECT_EQ(level.ink, ink_of(alphabet, level.strikes)) << level.strikes;
    EXPECT_LE(static_cast<int>(level.strikes.size()), strikes);
    const std::set<char> distinct(level.strikes.begin(), level.strikes.end());
    EXPECT_EQ(distinct.size(), level.strikes.size()) << level.strikes;
    if (i > 0) {
      EXPECT_GT(level.ink, table.levels[i - 1].ink) << "level " << i;
    }
  }
}

TEST(ToneTable, ObeysItsLaws) {
  for (const double lpi : {6.0, 8.0, 10.0}) {
    const Alphabet alphabet = measured(lpi);
    for (const int levels : {2, 3, 10, 20, 32})
      for (const int strikes : {1, 2, 3, 7, 16})
        expect_laws(make_tone_table(alphabet, levels, strikes), alphabet, strikes);
  }
}

TEST(ToneTable, LevelsLieWithinAThirdOfAStep) {
  for (const double lpi : {6.0, 8.0}) {
    const Alphabet alphabet = measured(lpi);
    for (int levels = 3; levels <= 20; ++levels)
      EXPECT_LE(worst_error_in_steps(make_tone_table(alphabet, levels, 7)), 1.0 / 3)
          << levels << " levels at " << lpi;
  }
}

TEST(ToneTable, TheDarkestIsDark) {
  const ToneTable eight = make_tone_table(measured(8), 20, 7);
  EXPECT_GE(eight.coverage(19), 0.88);
  EXPECT_EQ(eight.most_strikes(), 7);
  EXPECT_GE(make_tone_table(measured(6), 20, 7).coverage(19), 0.72);
}

TEST(ToneTable, MoreStrikesAreDarker) {
  const Alphabet alphabet = measured(8);
  double before = 0;
  for (int strikes = 1; strikes <= 10; ++strikes) {
    const double darkest = make_tone_table(alphabet, 5, strikes).coverage(4);
    EXPECT_GT(darkest, before) << strikes;
    before = darkest;
  }
}

// A single character where one comes near: half of the twenty levels, the blank one included, need
// no overstrike but for two light ones, and on average a level has two strikes.
TEST(ToneTable, StrikesAreFew) {
  const ToneTable table = make_tone_table(measured(8), 20, 7);
  std::size_t strikes = 0;
  for (const ToneTable::Level& level : table.levels) strikes += level.strikes.size();
  EXPECT_LE(strikes, 2.2 * 20);
  EXPECT_GE(std::count_if(table.levels.begin(), table.levels.begin() + 10,
                          [](const auto& level) { return level.strikes.size() <= 1; }),
            8);
}

// Squares of one pixel column each: every tone is a sum, so the best table is known.
TEST(ToneTable, DisjointInkAddsUp) {
  Alphabet alphabet{64, {}};
  int pixel = 0;
  for (const int size : {1, 2, 4, 8}) {
    Glyph glyph{static_cast<char>('0' + size), Ink(64), size, 0};
    for (int i = 0; i < size; ++i) glyph.ink.add(pixel++);
    alphabet.glyphs.push_back(glyph);
  }
  const ToneTable table = make_tone_table(alphabet, 4, 4);
  std::vector<std::string> strikes;
  for (const auto& level : table.levels) strikes.push_back(level.strikes);
  // Wishes 0 5 10 15; 5 = 4 + 1, 10 = 8 + 2.
  EXPECT_THAT(strikes, testing::ElementsAre("", "41", "82", "8421"));
}

// The same glyph under two names, and one inside another: a strike that adds nothing is not struck.
TEST(ToneTable, IdleStrikesAreNotStruck) {
  Alphabet alphabet{64, {}};
  for (const auto& [name, size] : {std::pair('A', 20), std::pair('B', 20), std::pair('C', 7)}) {
    Glyph glyph{name, Ink(64), size, 0};
    for (int i = 0; i < size; ++i) glyph.ink.add(i);
    alphabet.glyphs.push_back(glyph);
  }
  const ToneTable table = make_tone_table(alphabet, 3, 7);
  EXPECT_EQ(table.levels[1].strikes, "C");
  EXPECT_EQ(table.levels[2].strikes, "A");
}

TEST(ToneTable, MoreLevelsThanTonesAreAnError) {
  const Alphabet alphabet = measured(8);
  try {
    make_tone_table(alphabet, 64, 1);
    ADD_FAILURE();
  } catch (const InputError& error) {
    const std::string text = error.what();
    EXPECT_THAT(text, testing::MatchesRegex(
                          "error: levels must be at most [0-9]+, the tones that this type face has "
                          "with 1 strike a cell, found '64'"));
    const int most = std::stoi(text.substr(text.find("most ") + 5));
    expect_laws(make_tone_table(alphabet, most, 1), alphabet, 1);
    EXPECT_THROW(make_tone_table(alphabet, most + 1, 1), InputError);
  }
}

TEST(NearestLevel, IsTheNearest) {
  for (const int levels : {2, 3, 7, 20, 64})
    for (int i = 0; i < levels; ++i) {
      const double exact = static_cast<double>(i) / (levels - 1);
      const double almost_half = 0.499 / (levels - 1);
      EXPECT_EQ(nearest_level(static_cast<float>(exact), levels), i);
      EXPECT_EQ(nearest_level(static_cast<float>(exact + almost_half), levels), i);
      EXPECT_EQ(nearest_level(static_cast<float>(exact - almost_half), levels), i);
    }
}

TEST(NearestLevel, HalfwayIsTheDarkerWhateverRoundingDid) {
  for (const int levels : {2, 3, 7, 20, 64})
    for (int i = 0; i + 1 < levels; ++i) {
      const auto half = static_cast<float>((i + 0.5) / (levels - 1));
      EXPECT_EQ(nearest_level(half, levels), i + 1);
      EXPECT_EQ(nearest_level(std::nextafter(half, 0.0f), levels), i + 1);
      EXPECT_EQ(nearest_level(std::nextafter(half, 1.0f), levels), i + 1);
    }
}

TEST(NearestLevel, WhatIsNoDensityIsTheNearestThatIs) {
  EXPECT_EQ(nearest_level(-0.5f, 20), 0);
  EXPECT_EQ(nearest_level(1.5f, 20), 19);
  EXPECT_EQ(nearest_level(std::numeric_limits<float>::infinity(), 20), 19);
  EXPECT_EQ(nearest_level(-std::numeric_limits<float>::infinity(), 20), 0);
  EXPECT_EQ(nearest_level(std::numeric_limits<float>::quiet_NaN(), 20), 0);
}

}  // namespace
}  // namespace overstrike
