#include "devices/line_printer/line_printer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "core/error.h"

namespace overstrike {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

std::unique_ptr<Device> make(const Settings& settings, std::string& bytes,
                             std::string_view name = "-") {
  return line_printer_kind().make(settings, name, open_memory(bytes));
}

/// The bytes of a picture whose density is a function of column and row.
std::string printed(const Settings& settings, const std::function<float(int, int)>& density,
                    std::string_view name = "-") {
  std::string bytes;
  const std::unique_ptr<Device> device = make(settings, bytes, name);
  const Grid grid = device->layout().grid;
  device->begin();
  std::vector<float> row(static_cast<std::size_t>(grid.columns));
  for (int y = 0; y < grid.rows; ++y) {
    for (std::size_t x = 0; x < row.size(); ++x) row[x] = density(static_cast<int>(x), y);
    device->cells({y, row});
  }
  device->end();
  return bytes;
}

float black(int, int) { return 1; }

std::string error_of(const Settings& settings) {
  std::string bytes;
  try {
    make(settings, bytes);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(LinePrinter, IsRegistered) {
  ASSERT_NE(find_device("line-printer"), nullptr);
  for (const char* name : {"a.txt", "a.lpt", "a.ASA"})
    EXPECT_EQ(device_for_file(name), find_device("line-printer")) << name;
}

TEST(LinePrinter, AsksForCellsOfItsPitch) {
  std::string bytes;
  const Layout layout = make({}, bytes)->layout();
  EXPECT_EQ(layout.grid.columns, 135);
  EXPECT_EQ(layout.grid.rows, 180);
  EXPECT_EQ(layout.grid.pitch_x_mm, 2.54);
  EXPECT_EQ(layout.grid.pitch_y_mm, 3.175);
  EXPECT_TRUE(layout.cells);
  EXPECT_FALSE(layout.strokes);
  EXPECT_TRUE(layout.hatches.empty());
  const Layout other = make({{"size", "80x66"}, {"cpi", "12.7"}, {"lpi", "6"}}, bytes)->layout();
  EXPECT_EQ(other.grid.columns, 80);
  EXPECT_EQ(other.grid.rows, 66);
  EXPECT_EQ(other.grid.pitch_x_mm, 2.0);
  EXPECT_EQ(other.grid.pitch_y_mm, 25.4 / 6);
}

// The default table's characters: blank, its lightest and its darkest.
TEST(LinePrinter, PrintsThisExactly) {
  const auto steps = [](int x, int y) { return y == 1 ? 0.0f : static_cast<float>(x) / 2; };
  const Settings small = {{"size", "3x3"}, {"levels", "3"}, {"strikes", "2"}};
  const auto with = [&](const char* name, const char* value) {
    Settings settings = small;
    settings.emplace_back(name, value);
    return settings;
  };
  EXPECT_EQ(printed(small, steps), " GM\r  #\n\n GM\r  #\n");
  EXPECT_EQ(printed(with("stream", "asa"), steps), "  GM\n+  #\n \n  GM\n+  #\n");
  EXPECT_EQ(printed(with("stream", "plain"), steps), " 7M\n\n 7M\n");
  EXPECT_EQ(printed(small, steps, "x.asa"), printed(with("stream", "asa"), steps));
  EXPECT_EQ(printed(with("stream", "cr"), steps, "x.asa"), printed(small, steps));
}

TEST(LinePrinter, FormsAreThrownWhenAsked) {
  const Settings one = {{"size", "1x2"}, {"levels", "2"}, {"strikes", "1"}, {"forms", "yes"}};
  EXPECT_EQ(printed(one, black), "M\nM\n\f");
  Settings asa = one;
  asa.emplace_back("stream", "asa");
  EXPECT_EQ(printed(asa, black), "1M\n M\n");
}

TEST(LinePrinter, AlwaysPrintsTheRowsAskedForAndNoFormFeed) {
  for (const char* stream : {"cr", "plain"})
    for (const float density : {0.0f, 0.4f, 1.0f}) {
      const std::string bytes = printed({{"stream", stream}}, [&](int, int) { return density; });
      EXPECT_EQ(std::count(bytes.begin(), bytes.end(), '\n'), 180);
      EXPECT_EQ(bytes.find('\f'), std::string::npos);
    }
}

TEST(LinePrinter, UpperCaseUnlessAsked) {
  const auto ramp = [](int x, int) { return static_cast<float>(x) / 63; };
  const auto has_small_letters = [&](const char* charset) {
    const std::string bytes =
        printed({{"size", "64x1"}, {"levels", "64"}, {"charset", charset}, {"strikes", "3"}}, ramp);
    return std::any_of(bytes.begin(), bytes.end(), [](char c) { return c > '_'; });
  };
  EXPECT_FALSE(has_small_letters("upper64"));
  EXPECT_TRUE(has_small_letters("ascii95"));
}

TEST(LinePrinter, EveryPitchHasATable) {
  for (const char* cpi : {"1", "10", "24"})
    for (const char* lpi : {"1", "7.3", "24"})
      EXPECT_THAT(printed({{"cpi", cpi}, {"lpi", lpi}, {"size", "1x1"}, {"levels", "5"}}, black),
                  testing::Not(testing::IsEmpty()));
}

TEST(LinePrinter, WiderThanACarriageWarns) {
  std::string bytes;
  EXPECT_TRUE(make({{"size", "136x1"}}, bytes)->warnings().empty());
  const auto warnings = make({{"size", "137x1"}}, bytes)->warnings();
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(to_string(warnings[0]),
            "warning: 137 columns are more than the 136 of a line printer's carriage");
}

TEST(LinePrinter, WrongSettingsSayWhatTheyMustBe) {
  EXPECT_EQ(error_of({{"lpi", "0"}}), "error: lpi must be a number between 1 and 24, found '0'");
  EXPECT_EQ(error_of({{"cpi", "x"}}), "error: cpi must be a number between 1 and 24, found 'x'");
  EXPECT_EQ(error_of({{"levels", "65"}}),
            "error: levels must be a whole number between 2 and 64, found '65'");
  EXPECT_EQ(error_of({{"strikes", "0"}}),
            "error: strikes must be a whole number between 1 and 16, found '0'");
  EXPECT_EQ(error_of({{"size", "135"}}),
            "error: size must be COLUMNSxROWS, each between 1 and 65536, found '135'");
  EXPECT_EQ(error_of({{"stream", "asq"}}),
            "error: stream must be one of cr, asa, plain, found 'asq' (did you mean 'asa'?)");
  EXPECT_THAT(error_of({{"charset", "ebcdic"}}), StartsWith("error: charset must be one of"));
  EXPECT_THAT(error_of({{"forms", "1"}}), StartsWith("error: forms must be one of no, yes"));
  EXPECT_THAT(error_of({{"typeface", "none"}}), StartsWith("error: typeface must be one of"));
  EXPECT_THAT(error_of({{"levels", "64"}, {"stream", "plain"}}),
              HasSubstr("with 1 strike a cell, found '64'"));
}

}  // namespace
}  // namespace overstrike
