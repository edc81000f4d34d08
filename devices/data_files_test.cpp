#include "devices/data_files.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "core/error.h"

namespace overstrike {
namespace {

namespace fs = std::filesystem;

TEST(DataFiles, AreFoundInTheSourceTree) {
  ::unsetenv("OVERSTRIKE_DATA");
  EXPECT_EQ(find_data_file("plotters/hp7475a.profile"),
            fs::path(OVERSTRIKE_SOURCE_DIR) / "data/plotters/hp7475a.profile");
}

TEST(DataFiles, TheUsersFolderComesFirstAndMissesFallThrough) {
  const fs::path folder = fs::path(::testing::TempDir()) / "overstrike_data_files_test";
  fs::create_directories(folder / "plotters");
  std::ofstream(folder / "plotters/hp7475a.profile") << "name: mine\n";
  ::setenv("OVERSTRIKE_DATA", folder.c_str(), 1);
  EXPECT_EQ(find_data_file("plotters/hp7475a.profile"), folder / "plotters/hp7475a.profile");
  fs::remove_all(folder);
  EXPECT_EQ(find_data_file("plotters/hp7475a.profile"),
            fs::path(OVERSTRIKE_SOURCE_DIR) / "data/plotters/hp7475a.profile");
  ::unsetenv("OVERSTRIKE_DATA");
}

TEST(DataFiles, WhatIsNowhereIsAnErrorThatNamesItAndTheFolders) {
  ::setenv("OVERSTRIKE_DATA", "/nowhere/at/all", 1);
  try {
    find_data_file("plotters/none.profile");
    ADD_FAILURE() << "found";
  } catch (const InputError& error) {
    const std::string text = error.what();
    EXPECT_EQ(
        text.find("plotters/none.profile: error: no such data file (looked in /nowhere/at/all, "),
        0u)
        << text;
  }
  ::unsetenv("OVERSTRIKE_DATA");
}

}  // namespace
}  // namespace overstrike
