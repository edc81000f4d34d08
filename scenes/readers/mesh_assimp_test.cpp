#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "scenes/readers/mesh_test_files.h"

namespace overstrike::mesh_tests {
namespace {

namespace fs = std::filesystem;

bool assimp_is_loaded() {
  std::ifstream maps("/proc/self/maps");
  for (std::string line; std::getline(maps, line);)
    if (line.find("libassimp") != std::string::npos) return true;
  return false;
}

/// A triangle (0, 0, 0) (1, 0, 0) (0, 2, 0), Y up, placed twice: as it stands, and mirrored in x
/// and moved by 10. Its numbers stand in t.bin.
constexpr const char* kGltf = R"({
  "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 1]}],
  "nodes": [{"mesh": 0}, {"mesh": 0, "translation": [10, 0, 0], "scale": [-1, 1, 1]}],
  "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
  "buffers": [{"uri": "t.bin", "byteLength": 42}],
  "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": 36},
                  {"buffer": 0, "byteOffset": 36, "byteLength": 6}],
  "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
                 "min": [0, 0, 0], "max": [1, 2, 0]},
                {"bufferView": 1, "componentType": 5123, "count": 3, "type": "SCALAR"}]})";

std::string gltf_numbers() {
  std::string bytes;
  for (const float v : {0, 0, 0, 1, 0, 0, 0, 2, 0}) bytes += bytes_of(v);
  for (const std::uint16_t v : {0, 1, 2}) bytes += bytes_of(v);
  return bytes;
}

/// A triangle and a square, of which one corner is at (0, 0, 3).
std::string collada(const std::string& up) {
  return R"(<?xml version="1.0" encoding="utf-8"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit name="meter" meter="1"/><up_axis>)" +
         up + R"(</up_axis></asset>
<library_geometries><geometry id="g"><mesh>
<source id="p"><float_array id="a" count="12">0 0 0 1 0 0 0 2 0 0 0 3</float_array>
<technique_common><accessor source="#a" count="4" stride="3"><param name="X" type="float"/>
<param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<polylist count="2"><input semantic="VERTEX" source="#v" offset="0"/>
<vcount>3 4</vcount><p>0 2 1 0 1 2 3</p></polylist></mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s"><node id="n"><instance_geometry url="#g"/></node>
</visual_scene></library_visual_scenes><scene><instance_visual_scene url="#s"/></scene></COLLADA>)";
}

class AssimpTest : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() /
              ("overstrike-assimp-" + std::to_string(static_cast<long>(::getpid())));
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }
  fs::path write(const std::string& name, const std::string& bytes) const {
    std::ofstream(folder_ / name, std::ios::binary) << bytes;
    return folder_ / name;
  }
  fs::path folder_;
};

// The first test: what is loaded stays.
TEST_F(AssimpTest, IsLoadedByTheFirstFileThatNeedsIt) {
  EXPECT_EQ(outcome("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3", "obj"), "0,0,0 1,0,0 0,1,0 | 0 1 2 @4");
  EXPECT_FALSE(assimp_is_loaded());
  outcome(collada("Z_UP"), "dae");
  EXPECT_TRUE(assimp_is_loaded());
}

TEST_F(AssimpTest, MergesPlacedMeshesAndTurnsThemUp) {
  write("t.bin", gltf_numbers());
  std::vector<Diagnostic> warnings;
  const Mesh mesh = read_mesh(write("t.gltf", kGltf), warnings);
  EXPECT_EQ(dump(mesh), "0,0,0 1,0,0 0,0,2 10,0,0 9,0,0 10,0,2 | 0 1 2 | 5 4 3");
  EXPECT_EQ(mesh.precision, 0x1p-21);  // of 10
}

TEST_F(AssimpTest, KeepsPolygons) {
  EXPECT_EQ(outcome(collada("Z_UP"), "dae"), "0,0,0 0,2,0 1,0,0 0,0,3 | 0 1 2 | 0 2 1 3");
  EXPECT_EQ(outcome(collada("Y_UP"), "dae"), "0,0,0 0,0,2 1,0,0 0,-3,0 | 0 1 2 | 0 2 1 3");
}

TEST_F(AssimpTest, SaysWhatItCannotRead) {
  std::string bytes(1024, '\0');
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<char>(i);
  for (const char* format : {"3mf", "glb", "gltf", "dae", "fbx", "3ds", "x3d"}) {
    const std::string start = std::string("m.") + format + ": error: ";
    EXPECT_THAT(outcome(bytes, format), testing::StartsWith(start + "cannot be read: ")) << format;
    EXPECT_EQ(outcome("", format), start + "the file is empty");
    std::vector<Diagnostic> warnings;
    EXPECT_THROW(read_mesh(write(std::string("m.") + format, bytes), warnings), InputError);
    EXPECT_THROW(read_mesh(write(std::string("e.") + format, ""), warnings), InputError);
    EXPECT_THROW(read_mesh(folder_ / (std::string("none.") + format), warnings), InputError);
  }
  EXPECT_THAT(outcome(kGltf, "gltf"), testing::StartsWith("m.gltf: error: cannot be read: "));
}

}  // namespace
}  // namespace overstrike::mesh_tests
