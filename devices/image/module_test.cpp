// Links no OpenImageIO: what a program that draws no picture pays for.
#include <dlfcn.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "core/error.h"
#include "devices/device.h"
#include "devices/image/load_module.h"

namespace overstrike {
namespace {

namespace fs = std::filesystem;

/// Whether a library of that name is mapped into this process.
bool mapped(const std::string& name) {
  std::ifstream maps("/proc/self/maps");
  for (std::string line; std::getline(maps, line);)
    if (line.find(name) != std::string::npos) return true;
  return false;
}

// One test, because what is loaded stays.
TEST(ImageModule, IsLoadedByTheFirstPictureAndNotBefore) {
  std::string bytes;
  const auto device = find_device("image")->make({{"size", "2x1"}}, "-", open_memory(bytes));
  device->layout();
  EXPECT_FALSE(mapped("libOpenImageIO"));

  const fs::path folder = fs::path(testing::TempDir()) / "overstrike_image_module_test";
  fs::create_directories(folder);
  std::ofstream(folder / "overstrike_image.so") << "no library";
  ::setenv("OVERSTRIKE_MODULES", folder.c_str(), 1);
  try {
    device->begin();
    ADD_FAILURE() << "loaded";
  } catch (const WorkError& error) {
    EXPECT_THAT(error.what(),
                testing::HasSubstr("overstrike_image_module_test/overstrike_image.so"));
  }
  fs::remove_all(folder);

  device->begin();
  EXPECT_TRUE(mapped("libOpenImageIO"));
  const float row[] = {0, 1};
  device->cells({0, row});
  device->end();
  EXPECT_EQ(bytes.substr(1, 3), "PNG");
  ::unsetenv("OVERSTRIKE_MODULES");
}

}  // namespace
}  // namespace overstrike
