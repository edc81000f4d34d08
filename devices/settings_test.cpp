#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <functional>

#include "devices/device.h"
#include "devices/nearest.h"

namespace overstrike {
namespace {

DeviceKind printer() {
  DeviceKind kind;
  kind.name = "printer";
  kind.settings = {{"lpi", "8", "lines to the inch"},
                   {"levels", "20", "levels of tone"},
                   {"size", "135x180", "columns x rows"},
                   {"stream", "cr", "cr, asa or plain"}};
  return kind;
}

std::string error_of(const std::function<void()>& work) {
  try {
    work();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

std::string number_error(const std::string& value) {
  return error_of([&] { SettingReader(printer(), {{"lpi", value}}).number("lpi", 1, 24); });
}

TEST(Settings, StandAtTheirDefaults) {
  const SettingReader settings(printer(), {});
  EXPECT_EQ(settings.number("lpi", 1, 24), 8);
  EXPECT_EQ(settings.integer("levels", 2, 20), 20);
  EXPECT_EQ(settings.size("size", 65536), std::pair(135, 180));
  EXPECT_EQ(settings.text("stream"), "cr");
  EXPECT_FALSE(settings.given("lpi"));
}

TEST(Settings, TheLastOneGivenCounts) {
  const SettingReader settings(printer(), {{"lpi", "6"}, {"lpi", "7.5"}, {"size", "40X20"}});
  EXPECT_EQ(settings.number("lpi", 1, 24), 7.5);
  EXPECT_EQ(settings.size("size", 65536), std::pair(40, 20));
  EXPECT_TRUE(settings.given("lpi"));
  EXPECT_FALSE(settings.given("levels"));
}

TEST(Settings, NumbersSayWhatTheyMustBe) {
  EXPECT_EQ(number_error("abc"), "error: lpi must be a number between 1 and 24, found 'abc'");
  for (const char* bad :
       {"", " 6", "6 ", "6,5", "nan", "inf", "-inf", "1e999", "0x10", "0.999", "24.001", "+6"})
    EXPECT_EQ(number_error(bad),
              "error: lpi must be a number between 1 and 24, found '" + std::string(bad) + "'");
  EXPECT_EQ(number_error("24"), "no error");
}

TEST(Settings, WholeNumbersSayWhatTheyMustBe) {
  for (const char* bad : {"2.5", "", "1", "21", "99999999999999", "six"})
    EXPECT_EQ(
        error_of([&] {
          SettingReader(printer(), {{"levels", bad}}).integer("levels", 2, 20);
        }),
        "error: levels must be a whole number between 2 and 20, found '" + std::string(bad) + "'");
}

TEST(Settings, SizesSayWhatTheyMustBe) {
  for (const char* bad : {"", "x", "135", "135x", "x180", "0x180", "135x0", "-1x5", "135x65537",
                          "135x180x2", "135 x 180", "1.5x2"})
    EXPECT_EQ(error_of([&] {
                SettingReader(printer(), {{"size", bad}}).size("size", 65536);
              }),
              "error: size must be COLUMNSxROWS, each between 1 and 65536, found '" +
                  std::string(bad) + "'");
}

TEST(Settings, ChoicesNameTheNearest) {
  constexpr std::array<std::string_view, 3> kWords = {"cr", "asa", "plain"};
  const auto choose = [&](const char* word) {
    return SettingReader(printer(), {{"stream", word}}).choice("stream", kWords);
  };
  EXPECT_EQ(choose("plain"), "plain");
  EXPECT_EQ(error_of([&] { choose("plian"); }),
            "error: stream must be one of cr, asa, plain, found 'plian' (did you mean 'plain'?)");
  EXPECT_EQ(error_of([&] { choose("zebra"); }),
            "error: stream must be one of cr, asa, plain, found 'zebra'");
}

TEST(Settings, UnknownOnesNameTheNearest) {
  const auto given = [](const DeviceKind& kind, const char* name) {
    return error_of([&] { SettingReader(kind, {{name, "1"}}); });
  };
  EXPECT_EQ(given(printer(), "lip"),
            "error: the device 'printer' has no setting 'lip' (did you mean 'lpi'?)");
  EXPECT_EQ(given(printer(), "colour"),
            "error: the device 'printer' has no setting 'colour' (it takes lpi, levels, size, "
            "stream)");
  DeviceKind bare;
  bare.name = "bare";
  EXPECT_EQ(given(bare, "lpi"), "error: the device 'bare' has no setting 'lpi' (it takes none)");
}

TEST(NearestName, CountsSlipsOfTheFingers) {
  constexpr std::array<std::string_view, 3> kNames = {"radius", "height", "x"};
  EXPECT_EQ(nearest_name("radius", kNames), "radius");
  EXPECT_EQ(nearest_name("raduis", kNames), "radius");  // swapped
  EXPECT_EQ(nearest_name("hieght", kNames), "height");
  EXPECT_EQ(nearest_name("radiuss", kNames), "radius");  // one too many
  EXPECT_EQ(nearest_name("adius", kNames), "radius");    // one too few
  EXPECT_EQ(nearest_name("rodios", kNames), "radius");   // two of six
  EXPECT_EQ(nearest_name("rodios", {}), "");
  EXPECT_EQ(nearest_name("colour", kNames), "");
  EXPECT_EQ(nearest_name("y", kNames), "");  // nothing of it is right
  EXPECT_EQ(nearest_name("", kNames), "");
}

TEST(Registry, NamesAndExtensionsAreUnique) {
  std::vector<std::string_view> names, extensions;
  for (const DeviceKind& kind : device_kinds()) {
    names.push_back(kind.name);
    extensions.insert(extensions.end(), kind.extensions.begin(), kind.extensions.end());
    EXPECT_EQ(find_device(kind.name), &kind);
    EXPECT_FALSE(kind.summary.empty());
    for (std::string_view extension : kind.extensions)
      EXPECT_EQ(device_for_file("some.dir/picture" + std::string(extension)), &kind);
  }
  for (auto* list : {&names, &extensions}) {
    std::sort(list->begin(), list->end());
    EXPECT_EQ(std::adjacent_find(list->begin(), list->end()), list->end());
  }
}

TEST(Registry, KnowsWhatItDoesNotKnow) {
  EXPECT_EQ(find_device("abacus"), nullptr);
  EXPECT_EQ(find_device(""), nullptr);
  EXPECT_EQ(device_for_file("picture.abacus"), nullptr);
  EXPECT_EQ(device_for_file("picture"), nullptr);
  EXPECT_EQ(device_for_file("-"), nullptr);
  EXPECT_EQ(device_for_file(""), nullptr);
}

}  // namespace
}  // namespace overstrike
