#include "scenes/readers/mesh.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <thread>

#include "scenes/readers/mesh_test_files.h"
#include "scenes/readers/read.h"

namespace overstrike::mesh_tests {
namespace {

namespace fs = std::filesystem;

class MeshFileTest : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() /
              ("overstrike-mesh-" + std::to_string(static_cast<long>(::getpid())));
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }
  fs::path write(const std::string& name, std::string_view text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return folder_ / name;
  }
  static std::string error(const fs::path& path) {
    std::vector<Diagnostic> warnings;
    try {
      read_mesh(path, warnings);
    } catch (const InputError& e) {
      return e.what();
    }
    return {};
  }
  fs::path folder_;
};

const std::string kTriangle = "v 0 0 1\nv 1 0 1\nv 0 1 2\nf 1 2 3\n";

TEST_F(MeshFileTest, ReadsByExtension) {
  std::vector<Diagnostic> warnings;
  const fs::path path = write("a.OBJ", kTriangle);
  const Mesh mesh = read_mesh(path, warnings);
  EXPECT_EQ(mesh.source, path.string());
  EXPECT_EQ(dump(mesh), "0,0,1 1,0,1 0,1,2 | 0 1 2 @4");
  EXPECT_THAT(error(write("a.xyz", "")),
              testing::HasSubstr("a.xyz: error: no mesh format: 'xyz' (known are stl, obj"));
}

TEST_F(MeshFileTest, ReadsPipes) {
  std::string text;
  while (text.size() < 200'000) text += "# comment\n";
  const fs::path path = folder_ / "pipe.obj";
  ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
  std::thread writer([&] { std::ofstream(path) << text + kTriangle; });
  std::vector<Diagnostic> warnings;
  EXPECT_EQ(read_mesh(path, warnings).lines, std::vector<int>{20'004});
  writer.join();
}

TEST_F(MeshFileTest, SaysWhatItCannotRead) {
  const auto path = [&](const char* name) { return (folder_ / name).string(); };
  EXPECT_EQ(error(path("none.stl")), path("none.stl") + ": error: No such file or directory");
  fs::create_directory(folder_ / "folder.stl");
  EXPECT_EQ(error(path("folder.stl")),
            path("folder.stl") + ": error: is a directory, not a mesh file");
  fs::create_directory(folder_ / "folder");
  EXPECT_EQ(error(path("folder")), path("folder") + ": error: is a directory, not a mesh file");
  fs::create_symlink("/dev/null", folder_ / "null.obj");
  EXPECT_EQ(error(path("null.obj")), path("null.obj") + ": error: is neither a file nor a pipe");
  for (const char* name : {"e.stl", "e.obj", "e.off", "e.ply"})
    EXPECT_THAT(error(write(name, "")), testing::HasSubstr(": error: the file is empty"));
}

long peak_kilobytes() {
  struct ::rusage usage {};
  ::getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss;
}

// Files of 1 GB and claims of 4 billion are refused by their first bytes: no memory is spent.
TEST_F(MeshFileTest, HugeFilesThatAreNoMeshesCostNothing) {
  const long before = peak_kilobytes();
  for (const char* name : {"zeros.stl", "zeros.obj", "zeros.off", "zeros.ply"}) {
    const fs::path path = write(name, "");
    fs::resize_file(path, std::uintmax_t{1} << 30);  // sparse
    EXPECT_THAT(error(path), testing::HasSubstr("error: "));
  }
  const fs::path cut = write("cut.stl", binary_stl({}, 4'000'000'000u));
  fs::resize_file(cut, std::uintmax_t{1} << 30);
  EXPECT_THAT(error(cut), testing::HasSubstr("ends after 21 474 834 of 4 000 000 000 triangles"));
  const fs::path large = write("large.obj", kTriangle);
  fs::resize_file(large, (std::uintmax_t{4} << 30) + 1);
  EXPECT_THAT(error(large), testing::HasSubstr("is larger than 4 GB"));
  EXPECT_LT(peak_kilobytes() - before, 100'000);
}

TEST_F(MeshFileTest, IsAScene) {
  const fs::path path = write("a.obj", kTriangle);
  const Scene scene = read_scene(path).scene;
  ASSERT_EQ(scene.bodies.size(), 1u);
  EXPECT_EQ(scene.ground_z, 1.0);
  ASSERT_TRUE(scene.light.has_value());
  EXPECT_EQ(scene.light->azimuth_deg, -20);
  EXPECT_EQ(scene.light->elevation_deg, 45);
  EXPECT_EQ(scene.camera.from.azimuth_deg, -60);
  EXPECT_EQ(scene.camera.from.elevation_deg, 25);
  EXPECT_EQ(scene.source, path.string());
}

TEST_F(MeshFileTest, StandsInAScene) {
  write("a.obj", kTriangle);
  const Scene scene = read_scene(write("a.yaml", "bodies: [{mesh: a.obj}]")).scene;
  ASSERT_EQ(scene.bodies.size(), 1u);
  EXPECT_EQ(dump(std::get<Mesh>(*scene.bodies[0].shape)), "0,0,1 1,0,1 0,1,2 | 0 1 2 @4");
}

}  // namespace
}  // namespace overstrike::mesh_tests
