#include "scenes/readers/read.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <thread>

namespace overstrike {
namespace {

namespace fs = std::filesystem;

class ReadTest : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() /
              ("overstrike-read-" + std::to_string(static_cast<long>(::getpid())));
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }
  fs::path write(const std::string& name, std::string_view text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return folder_ / name;
  }
  static std::string error(const fs::path& path) {
    try {
      read_scene(path);
    } catch (const InputError& e) {
      return e.what();
    }
    return {};
  }
  fs::path folder_;
};

TEST_F(ReadTest, ReadsByExtension) {
  EXPECT_EQ(read_scene(write("a.yaml", "bodies: [{box: 1}]")).scene.bodies.size(), 1u);
  EXPECT_EQ(read_scene(write("a.YML", "bodies: [{box: 1}]")).scene.bodies.size(), 1u);
}

TEST_F(ReadTest, PlacesNameTheFile) {
  const fs::path path = write("a.yaml", "bodies: 3");
  EXPECT_EQ(error(path), path.string() +
                             ":1:9: error: bodies must be a list of bodies, found '3'\n"
                             "    bodies: 3\n            ^");
}

TEST_F(ReadTest, MeshFilesStandBesideTheScene) {
  const fs::path path = write("a.yaml", "bodies: [{mesh: none.stl}]");
  EXPECT_THAT(error(path), testing::HasSubstr("no mesh file 'none.stl'; looked for " +
                                              (folder_ / "none.stl").string()));
}

TEST_F(ReadTest, MeshesThatAreDirectoriesAreRefusedInTheirPlace) {
  fs::create_directory(folder_ / "parts");
  for (const char* scene : {"bodies:\n  - mesh: parts\n", "bodies:\n  - mesh: {file: parts}\n"}) {
    const fs::path path = write("a.yaml", scene);
    EXPECT_THAT(error(path), testing::StartsWith(path.string() + ":2:"));
    EXPECT_THAT(error(path), testing::HasSubstr("error: mesh file 'parts' is a directory: " +
                                                (folder_ / "parts").string()));
  }
}

TEST_F(ReadTest, SaysWhatItCannotRead) {
  EXPECT_EQ(error(folder_ / "missing.yaml"),
            (folder_ / "missing.yaml").string() + ": error: No such file or directory");
  fs::create_directory(folder_ / "dir.yaml");
  EXPECT_EQ(error(folder_ / "dir.yaml"),
            (folder_ / "dir.yaml").string() + ": error: is a directory, not a scene file");
  EXPECT_EQ(error("/dev/null"), "/dev/null: error: is neither a file nor a pipe");
  EXPECT_THAT(
      error(write("a.yanl", "")),
      testing::HasSubstr("unknown format 'yanl' (did you mean 'yaml'?; known are yaml, yml"));
  EXPECT_THAT(error(write("plain", "")),
              testing::HasSubstr("no format: the name has no extension (known are yaml, yml"));
  EXPECT_THAT(error(write("empty.yaml", "")), testing::HasSubstr("the file is empty"));
}

TEST_F(ReadTest, RefusesWhatIsTooLarge) {
  const fs::path path = write("large.yaml", "bodies: []\n");
  fs::resize_file(path, std::uintmax_t{1} << 30);  // sparse
  EXPECT_EQ(error(path),
            path.string() + ": error: is larger than 64 MB (a large mesh belongs in a mesh file)");
}

TEST_F(ReadTest, ReadsPipes) {
  const fs::path path = folder_ / "pipe.yaml";
  ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
  std::thread writer([&] { std::ofstream(path) << "bodies: [{box: 1}, {box: 2}]"; });
  EXPECT_EQ(read_scene(path).scene.bodies.size(), 2u);
  writer.join();
}

TEST(ReadSceneText, KnowsItsFormats) {
  EXPECT_EQ(read_scene_text("bodies: [{box: 1}]", "yml", "-", ".").scene.source, "-");
  EXPECT_THROW(read_scene_text("", "png", "-", "."), InputError);
  const auto formats = scene_formats();
  EXPECT_THAT(formats, testing::IsSupersetOf({"yaml", "yml", "stl", "obj", "off", "ply"}));
}

}  // namespace
}  // namespace overstrike
