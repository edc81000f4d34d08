#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <limits>

#include "scenes/readers/mesh_test_files.h"

namespace overstrike::mesh_tests {
namespace {

std::string header(const std::string& format, int vertices, int faces,
                   const std::string& type = "float") {
  return fmt::format(
      "ply\nformat {} 1.0\ncomment made by a test\nelement vertex {}\nproperty {} x\n"
      "property {} y\nproperty {} z\nelement face {}\nproperty list uchar int vertex_indices\n"
      "end_header\n",
      format, vertices, type, type, type, faces);
}

const std::string kText = header("ascii", 3, 1);
const std::string kThree = "0 0 0\n1 0 0\n0 1 0.5\n";
const std::string kDump = "0,0,0 1,0,0 0,1,0.5 | 0 1 2";

TEST(Ply, ReadsText) {
  const Case cases[] = {
      {"plain", kText + kThree + "3 0 1 2\n", kDump + " @14"},
      {"carriage returns",
       "ply\r\nformat ascii 1.0\r\nelement vertex 3\r\nproperty float x\r\nproperty float y\r\n"
       "property float z\r\nelement face 1\r\nproperty list uchar int vertex_index\r\n"
       "end_header\r\n0 0 0\r\n1 0 0\r\n0 1 0.5\r\n3 0 1 2\r\n",
       kDump + " @13"},
      {"other properties, elements and order",
       "ply\nformat ascii 1.0\nobj_info x\nelement camera 2\nproperty float a\n"
       "property list uchar float b\nelement face 1\nproperty uchar red\n"
       "property list uint8 uint32 vertex_indices\nproperty list int float uv\nelement vertex 3\n"
       "property double z\nproperty uchar red\nproperty float64 x\nproperty int16 y\n"
       "element edge 1\nproperty int v\nend_header\n"
       "1 2 3 4\n1 0\n\n255 3 0 1 2 2 0.5 0.5\n0 9 0 0\n0 9 1 0\n0.5 9 0 1\n7\n",
       kDump + " @22"},
      {"faces of several sizes", header("ascii", 4, 2) + kThree + "1 1 1\n4 0 1 3 2\n3 0 1 2\n",
       "0,0,0 1,0,0 0,1,0.5 1,1,1 | 0 1 3 2 @15 | 0 1 2 @16"},
  };
  for (const Case& c : cases) EXPECT_EQ(outcome(c.text, "ply"), c.outcome) << c.name;
}

/// The body of header("binary...", 3, 1, type).
template <class T>
std::string body(bool big, std::int32_t last = 2) {
  std::string bytes;
  for (const double v : {0.0, 0.0, -0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.5})
    bytes += bytes_of(static_cast<T>(v), big);
  bytes += '\3';
  for (const std::int32_t v : {0, 1, last}) bytes += bytes_of(v, big);
  return bytes;
}

TEST(Ply, ReadsBinary) {
  const std::string little = "binary_little_endian", big = "binary_big_endian";
  const auto mixed_header = [](const std::string& format) {
    return "ply\nformat " + format +
           " 1.0\nelement vertex 3\nproperty short y\nproperty list ushort double w\n"
           "property uchar red\nproperty double x\nproperty float z\nelement junk 2\n"
           "property list char short a\nproperty double b\nelement face 1\n"
           "property list int ushort vertex_index\nproperty float quality\nend_header\n";
  };
  const auto mixed_body = [](bool swap) {
    std::string bytes;
    const double xyz[3][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0.5}};
    for (const auto& p : xyz)
      bytes += bytes_of(static_cast<std::int16_t>(p[1]), swap) + bytes_of(std::uint16_t{1}, swap) +
               bytes_of(7.0, swap) + "r" + bytes_of(p[0], swap) +
               bytes_of(static_cast<float>(p[2]), swap);
    for (int i = 0; i < 2; ++i)
      bytes += "\2" + bytes_of(std::int16_t{1}, swap) + bytes_of(std::int16_t{2}, swap) +
               bytes_of(1.0, swap);
    bytes += bytes_of(std::int32_t{3}, swap);
    for (const std::uint16_t v : {0, 1, 2}) bytes += bytes_of(v, swap);
    return bytes + bytes_of(1.0f, swap);
  };
  const Case cases[] = {
      {"little", header(little, 3, 1) + body<float>(false), kDump},
      {"big", header(big, 3, 1) + body<float>(true), kDump},
      {"little, doubles", header(little, 3, 1, "double") + body<double>(false), kDump},
      {"big, doubles", header(big, 3, 1, "double") + body<double>(true), kDump},
      {"little, mixed", mixed_header(little) + mixed_body(false), kDump},
      {"big, mixed", mixed_header(big) + mixed_body(true), kDump},
  };
  for (const Case& c : cases) EXPECT_EQ(outcome(c.text, "ply"), c.outcome) << c.name;
}

TEST(Ply, SaysWhatIsWrongInHeaders) {
  const std::string xyz = "property float x\nproperty float y\nproperty float z\n";
  const std::string faces = "element face 1\nproperty list uchar int vertex_indices\n";
  const Case cases[] = {
      {"empty", "", "m.ply: error: the file is empty"},
      {"another file", "OFF\n", "m.ply:1:1: error: expected 'ply', found 'OFF'\n    OFF\n    ^"},
      {"no end", "ply\nformat ascii 1.0\n", "m.ply:1:1: error: the header has no 'end_header'"},
      {"no format", "ply\nelement vertex 1\n" + xyz + faces + "end_header\n0 0 0\n3 0 0 0\n",
       "m.ply:8:11: error: the header has no 'format'\n    end_header\n              ^"},
      {"an unknown format",
       "ply\nformat utf8 1.1\nelement vertex 1\n" + xyz + faces + "end_header\n",
       "m.ply:2:8: error: the format must be ascii, binary_little_endian or binary_big_endian, "
       "found 'utf8'\n    format utf8 1.1\n           ^\n"
       "m.ply:2:13: error: the version must be 1.0, found '1.1'\n    format utf8 1.1\n"
       "                ^"},
      {"misspelt",
       "ply\nformat ascii 1.0\nelement vertex 1\n" + xyz + faces +
           "propertx int a\nproperty flaot b\nend_header\n",
       "m.ply:9:1: error: unknown statement 'propertx' (did you mean 'property'?)\n"
       "    propertx int a\n    ^\n"
       "m.ply:10:10: error: unknown type 'flaot' (did you mean 'float'?)\n"
       "    property flaot b\n             ^"},
      {"no faces", "ply\nformat ascii 1.0\nelement vertex 1\n" + xyz + "end_header\n0 0 0\n",
       "m.ply:7:11: error: the file has no faces\n    end_header\n              ^"},
      {"no z and no list",
       "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
       "element face 1\nproperty int vertex_indices\nend_header\n0 0\n1\n",
       "m.ply:3:16: error: vertices have no property 'z'\n    element vertex 1\n                   "
       "^\n"
       "m.ply:6:14: error: faces have no list 'vertex_indices' of whole numbers\n"
       "    element face 1\n                 ^"},
      {"a lying count",
       "ply\nformat binary_little_endian 1.0\nelement vertex 4000000000\n" + xyz + faces +
           "end_header\n" + std::string(120, '\0'),
       "m.ply:3:16: error: the file ends after at most 10 of 4 000 000 000 entries of 'vertex'\n"
       "    element vertex 4000000000\n                   ^"},
      {"a negative count",
       "ply\nformat ascii 1.0\nelement vertex -1\n" + xyz + faces + "end_header\n",
       "m.ply:3:16: error: the count of an element must not be negative, found '-1'\n"
       "    element vertex -1\n                   ^"},
      {"an element of nothing",
       "ply\nformat ascii 1.0\nelement void 4000000000\nelement vertex 1\n" + xyz + faces +
           "end_header\n0 0 0\n",
       "m.ply:3:14: error: 'void' has no properties\n    element void 4000000000\n"
       "                 ^"},
  };
  for (const Case& c : cases) EXPECT_EQ(outcome(c.text, "ply"), c.outcome) << c.name;
}

TEST(Ply, SaysWhatIsWrongInText) {
  const Case cases[] = {
      {"ends early", header("ascii", 3, 2) + kThree + "3 0 1 2   \n",
       "m.ply:14:11: error: the file ends after 1 of 2 entries of 'face'\n    3 0 1 2   \n"
       "              ^"},
      {"two vertices", kText + kThree + "2 0 1 \n",
       "m.ply:14:1: error: a face needs at least 3 vertices, found 2\n    2 0 1 \n    ^"},
      {"out of range", kText + kThree + "3 0 -1 3\n",
       "m.ply:14:5: error: vertex -1 does not exist (there are 3, numbered from 0)\n"
       "    3 0 -1 3\n        ^\n"
       "m.ply:14:8: error: vertex 3 does not exist (there are 3, numbered from 0)\n"
       "    3 0 -1 3\n           ^"},
      {"a short line", kText + kThree + "4 0 1 2\n",
       "m.ply:14:8: error: the number of a vertex must be a whole number, found the end of the "
       "line\n    4 0 1 2\n           ^"},
      {"not finite", kText + "0 0 0\n1 inf 0\n0 1 0.5\n3 0 1 2\n",
       "m.ply:12:3: error: vertex's y must be a finite number, found 'inf'\n    1 inf 0\n      ^"},
  };
  for (const Case& c : cases) EXPECT_EQ(outcome(c.text, "ply"), c.outcome) << c.name;
}

TEST(Ply, SaysWhatIsWrongInBinary) {
  const std::string start = header("binary_little_endian", 3, 1);
  const std::size_t size = start.size();
  const std::string whole = start + body<float>(false);
  std::string nan = whole, two = whole, lying = whole;
  nan.replace(size + 16, 4, bytes_of(std::numeric_limits<float>::quiet_NaN()));
  two[size + 36] = '\2';
  lying[size + 36] = '\xFF';
  const auto byte = [&](std::size_t at) {
    return "m.ply: error: byte " + std::to_string(size + at);
  };
  const Case cases[] = {
      {"cut short", whole.substr(0, whole.size() - 1),
       "m.ply: error: the file ends after 0 of 1 entries of 'face'"},
      {"a long list", lying, "m.ply: error: the file ends after 0 of 1 entries of 'face'"},
      {"NaN", nan, byte(16) + ": y of vertex 1 must be a finite number, found NaN"},
      {"two vertices", two, byte(36) + ": a face needs at least 3 vertices, found 2"},
      {"out of range", start + body<float>(false, 3),
       byte(45) + ": vertex 3 does not exist (there are 3, numbered from 0)"},
  };
  for (const Case& c : cases) EXPECT_EQ(outcome(c.text, "ply"), c.outcome) << c.name;
}

TEST(Ply, TakesNormalsIfVerticesHaveThem) {
  std::vector<Diagnostic> warnings;
  const auto normals = [&](const std::string& third) {
    return read_mesh_text(
               "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
               "property float z\nproperty float nx\nproperty float ny\nproperty float nz\n"
               "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
               "0 0 0 0 0 2\n1 0 0 0 3 4\n0 1 0 " +
                   third + "\n3 2 1 0\n",
               "ply", "m", warnings)
        .polyhedron.corner_normals;
  };
  EXPECT_EQ(normals("-1 0 0"), (std::vector<Vec3>{{-1, 0, 0}, {0, 0.6, 0.8}, {0, 0, 1}}));
  EXPECT_TRUE(normals("0 0 0").empty());
  EXPECT_TRUE(normals("nan nan nan").empty());
}

TEST(Ply, TellsThePrecisionOfItsNumbers) {
  std::vector<Diagnostic> warnings;
  const auto precision = [&](const std::string& text) {
    return read_mesh_text(text, "ply", "m", warnings).precision;
  };
  EXPECT_EQ(precision(header("binary_big_endian", 3, 1) + body<float>(true)), 0x1p-24);
  EXPECT_EQ(precision(header("binary_big_endian", 3, 1, "double") + body<double>(true)), 0);
  EXPECT_EQ(precision(kText + "0 0 0\n1 0.123456 0\n0 1 0.5\n3 0 1 2\n"), 5e-7);
}

}  // namespace
}  // namespace overstrike::mesh_tests
