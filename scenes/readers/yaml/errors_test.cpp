// Bad scene files and exactly what is said about them: errors_test.txt, one case after the other,
// text and errors parted by a line "---", cases by a line "===".
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include "scenes/readers/read.h"

namespace overstrike {
namespace {

std::vector<std::string> split(const std::string& text, const std::string& at) {
  std::vector<std::string> parts;
  std::size_t begin = 0, end;
  for (; (end = text.find(at, begin)) != std::string::npos; begin = end + at.size())
    parts.push_back(text.substr(begin, end - begin));
  parts.push_back(text.substr(begin));
  return parts;
}

std::string errors_of(const std::string& text) {
  try {
    read_scene_text(text, "yaml", "s.yaml", "nowhere");
  } catch (const InputError& e) {
    return e.what();
  }
  return {};
}

TEST(SceneErrors, AreSaidInTheseWords) {
  std::ifstream file(OVERSTRIKE_SOURCE_DIR "/scenes/readers/yaml/errors_test.txt");
  const std::string corpus((std::istreambuf_iterator<char>(file)), {});
  const std::vector<std::string> cases = split(corpus, "===\n");
  EXPECT_GT(cases.size(), 30u);
  for (const std::string& one : cases) {
    const std::vector<std::string> parts = split(one, "---\n");
    ASSERT_EQ(parts.size(), 2u) << one;
    EXPECT_EQ(errors_of(parts[0]) + '\n', parts[1]) << parts[0];
  }
}

TEST(SceneErrors, BinaryFiles) {
  EXPECT_EQ(errors_of(std::string("bodies: [\0]", 11)),
            "s.yaml: error: not a text file: byte 10 is NUL");
  EXPECT_EQ(errors_of("bodies:\n  \xE9t\xE9"),
            "s.yaml:2:3: error: not UTF-8: byte 0xE9 (save the file as UTF-8)");
  EXPECT_EQ(errors_of(std::string("\xFF\xFE"
                                  "b\0",
                                  4)),  // UTF-16
            "s.yaml: error: not a text file: byte 4 is NUL");
}

TEST(SceneErrors, MarksAndLineEndsOfOtherSystemsAreNoErrors) {
  EXPECT_EQ(errors_of("\xEF\xBB\xBF"
                      "bodies:\r\n  - box: 1\r\n    at: [0, 0, 1]\r\n"),
            "");
  EXPECT_THAT(errors_of("\xEF\xBB\xBF"
                        "bodies:\r\n  - box: x\r\n"),
              testing::StartsWith("s.yaml:2:10: error: size must be a number, found 'x'\n"));
}

TEST(SceneErrors, ManyAreToldInTheOrderOfTheFileAndTheRestCounted) {
  std::string text = "bodies:\n";
  for (int i = 0; i < 1000; ++i) text += "  - sphere: -1\n";
  try {
    read_scene_text(text, "yaml", "s.yaml", "");
    FAIL();
  } catch (const InputError& e) {
    ASSERT_EQ(e.diagnostics().size(), 201u);
    EXPECT_EQ(e.diagnostics()[0].place.line, 2);
    EXPECT_EQ(e.diagnostics()[199].place.line, 201);
    EXPECT_EQ(e.diagnostics()[200].message, "and 800 more errors");
  }
}

// What follows would take hours or all memory if it were done as said. (ctest's time limit ends
// it.)

TEST(SceneErrors, NestedArraysAreCountedBeforeTheyAreMade) {
  std::string text = "define:\n  a0: {box: 1}\n";
  for (int i = 1; i < 60; ++i)
    text += fmt::format("  a{}: {{use: a{}, array: {{polar: {{count: 1000000}}}}}}\n", i, i - 1);
  EXPECT_THAT(errors_of(text + "bodies: [{use: a59}]\n"),
              testing::HasSubstr("copies make more than 1000000 bodies"));
  EXPECT_EQ(errors_of(text + "bodies: [{use: a0}]\n"), "");  // what is not used costs nothing
}

TEST(SceneErrors, CopiesOfEmptyGroupsAreCountedToo) {
  std::string text = "define:\n  a0: []\n";
  for (int i = 1; i < 30; ++i)
    text += fmt::format("  a{0}: [{{use: a{1}}}, {{use: a{1}}}]\n", i, i - 1);
  EXPECT_THAT(errors_of(text + "bodies: [{use: a29}]\n"),
              testing::HasSubstr("copies make more than 1000000 bodies"));
}

TEST(SceneErrors, LongChainsOfDefinitionsEnd) {
  std::string text = "bodies: []\ndefine:\n  a0: {box: 1}\n";
  for (int i = 1; i < 20000; ++i) text += fmt::format("  a{}: {{use: a{}}}\n", i, i - 1);
  EXPECT_THAT(errors_of(text), testing::HasSubstr("definitions and groups nest deeper than 256"));
  std::string circle = "bodies: []\ndefine:\n";
  for (int i = 0; i < 200; ++i) circle += fmt::format("  a{}: {{use: a{}}}\n", i, (i + 1) % 200);
  EXPECT_THAT(errors_of(circle), testing::HasSubstr("definitions go in a circle: a0 -> a1 -> a2"));
}

TEST(SceneErrors, DeepGroupsAndAliasBombsEndFast) {
  std::string groups = "bodies: ";
  for (int i = 0; i < 100000; ++i) groups += "[{group: ";
  EXPECT_THAT(errors_of(groups), testing::HasSubstr("nested deeper than 480 levels"));
  std::string bomb = "define:\n  a0: &a0 [{box: 1}, {box: 1}]\n";
  for (int i = 1; i < 40; ++i)
    bomb += fmt::format("  a{0}: &a{0} [{{group: *a{1}}}, {{group: *a{1}}}]\n", i, i - 1);
  EXPECT_THAT(errors_of(bomb + "bodies: []\n"), testing::HasSubstr("more than 4 million values"));
}

TEST(SceneErrors, TransformsThatVanishOrExplode) {
  std::string text = "bodies: [";
  for (int i = 0; i < 12; ++i) text += "{scale: 1e-30, group: [";
  text += "{box: 1}";
  for (int i = 0; i < 12; ++i) text += "]}";
  EXPECT_THAT(errors_of(text + "]"), testing::HasSubstr("grow beyond 1e30 or shrink to nothing"));
}

TEST(SceneErrors, AHundredThousandUnknownKeysAreNoHardship) {
  std::string text = "bodies:\n  - box: 1\n";
  for (int i = 0; i < 100000; ++i) text += fmt::format("    key{}: 1\n", i);
  EXPECT_THAT(errors_of(text), testing::HasSubstr("and 99800 more errors"));
}

std::string content(const std::filesystem::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// The text with a few bytes changed, left out, doubled, or cut off behind one.
std::string damaged(std::string text, std::mt19937& random) {
  constexpr std::string_view kBytes = "[]{}:,-&*!|>'\"#%@?~\n\t 0123456789.eE+<\xC3\xFF";
  for (auto slips = 1 + random() % 4; slips > 0 && !text.empty(); --slips) {
    const std::size_t at = random() % text.size();
    const std::size_t length = 1 + random() % 20;
    switch (random() % 5) {
      case 0:
        text[at] = kBytes[random() % kBytes.size()];
        break;
      case 1:
        text.insert(at, 1, kBytes[random() % kBytes.size()]);
        break;
      case 2:
        text.erase(at, length);
        break;
      case 3:
        text.insert(random() % text.size(), text.substr(at, length));
        break;
      default:
        if (random() % 8 == 0) text.resize(at);
    }
  }
  return text;
}

TEST(SceneErrors, DamagedScenesAreReadOrRefused) {
  std::mt19937 random(20);
  int read = 0, refused = 0;
  std::vector<std::string> scenes;
  std::vector<std::filesystem::path> files;
  for (const auto& file : std::filesystem::directory_iterator(OVERSTRIKE_SOURCE_DIR "/scenes"))
    if (file.path().extension() == ".yaml") files.push_back(file.path());
  std::sort(files.begin(), files.end());
  for (const auto& file : files) scenes.push_back(content(file));
  for (int i = 0; i < 2000; ++i) {
    const std::string text = damaged(scenes[random() % scenes.size()], random);
    try {
      read_scene_text(text, "yaml", "s.yaml", "nowhere");
      ++read;
    } catch (const InputError& e) {
      ASSERT_FALSE(e.diagnostics().empty());
      for (const Diagnostic& d : e.diagnostics()) EXPECT_FALSE(d.message.empty()) << text;
      ++refused;
    }  // anything else ends the test
  }
  EXPECT_GT(read, 100);
  EXPECT_GT(refused, 100);
}

}  // namespace
}  // namespace overstrike
