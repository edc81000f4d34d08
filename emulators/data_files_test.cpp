#include "emulators/data_files.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

namespace overstrike::emulator {
namespace {

namespace fs = std::filesystem;

TEST(EmulatorDataFiles, AreFoundInTheUsersFolderThenInTheSourceTree) {
  const fs::path folder = fs::path(::testing::TempDir()) / "overstrike_emulator_data_test";
  fs::create_directories(folder / "plotters");
  std::ofstream(folder / "plotters/hp7475a.profile") << "name: mine\n";
  ::setenv("OVERSTRIKE_DATA", folder.c_str(), 1);
  EXPECT_EQ(find_data_file("plotters/hp7475a.profile"), folder / "plotters/hp7475a.profile");
  fs::remove_all(folder);
  EXPECT_EQ(find_data_file("plotters/hp7475a.profile"),
            fs::path(OVERSTRIKE_SOURCE_DIR) / "data/plotters/hp7475a.profile");
  ::unsetenv("OVERSTRIKE_DATA");
}

TEST(EmulatorDataFiles, WhatIsNowhereIsAnErrorThatNamesIt) {
  try {
    find_data_file("plotters/none.profile");
    ADD_FAILURE() << "found";
  } catch (const Error& error) {
    EXPECT_EQ(std::string(error.what()).rfind("data file plotters/none.profile is missing", 0), 0u)
        << error.what();
  }
}

}  // namespace
}  // namespace overstrike::emulator
