// A polyhedron of random numbers, written in every format, comes back as it was.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "core/geometry/tessellate.h"
#include "scenes/readers/mesh_test_files.h"

namespace overstrike::mesh_tests {
namespace {

using Outline = std::vector<Vec3>;

/// A ball of triangles and quadrilaterals; its vertices are numbers of floats.
Polyhedron random_ball(std::mt19937_64& random) {
  const int sides = 3 + static_cast<int>(random() % 6), rings = 2 + static_cast<int>(random() % 5);
  Polyhedron ball = tessellate(Ellipsoid{Vec3(1), sides, rings}, 1, false);
  std::uniform_real_distribution<double> scale(-1000, 1000);
  for (Vec3& v : ball.vertices)
    for (int i = 0; i < 3; ++i) v[i] = static_cast<float>((v[i] + 2) * scale(random));
  return ball;
}

std::vector<Outline> outlines(const Polyhedron& p) {
  std::vector<Outline> all;
  for (Index f = 0; f < p.face_count(); ++f) {
    Outline& outline = all.emplace_back();
    for (const Index v : p.loop(p.first_loop(f))) outline.push_back(p.vertices[v]);
  }
  return all;
}

/// Fans of triangles, as STL needs them.
std::vector<Outline> triangles(const Polyhedron& p) {
  std::vector<Outline> all;
  for (const Outline& o : outlines(p))
    for (std::size_t i = 2; i < o.size(); ++i) all.push_back({o[0], o[i - 1], o[i]});
  return all;
}

std::string numbers(const Vec3& v) { return fmt::format("{} {} {}\n", v.x, v.y, v.z); }

std::string obj(const Polyhedron& p) {
  std::string text;
  for (const Vec3& v : p.vertices) text += "v " + numbers(v);
  for (Index f = 0; f < p.face_count(); ++f) {
    text += "f";
    for (const Index v : p.loop(f)) text += fmt::format(" {}", v + 1);
    text += '\n';
  }
  return text;
}

/// As OFF and PLY have it.
std::string lists(const Polyhedron& p) {
  std::string text;
  for (const Vec3& v : p.vertices) text += numbers(v);
  for (Index f = 0; f < p.face_count(); ++f)
    text += fmt::format("{} {}\n", p.loop(f).size(), fmt::join(p.loop(f), " "));
  return text;
}

std::string off(const Polyhedron& p) {
  return fmt::format("OFF\n{} {} 0\n", p.vertices.size(), p.face_count()) + lists(p);
}

std::string ply(const Polyhedron& p, const std::string& encoding, bool doubles) {
  const char* const type = doubles ? "double" : "float";
  std::string bytes = fmt::format(
      "ply\nformat {0} 1.0\nelement vertex {1}\nproperty {2} x\nproperty {2} y\nproperty {2} z\n"
      "element face {3}\nproperty list uchar uint vertex_indices\nend_header\n",
      encoding, p.vertices.size(), type, p.face_count());
  if (encoding == "ascii") return bytes + lists(p);
  const bool big = encoding == "binary_big_endian";
  for (const Vec3& v : p.vertices)
    for (int i = 0; i < 3; ++i)
      bytes += doubles ? bytes_of(v[i], big) : bytes_of(static_cast<float>(v[i]), big);
  for (Index f = 0; f < p.face_count(); ++f) {
    bytes += static_cast<char>(p.loop(f).size());
    for (const Index v : p.loop(f)) bytes += bytes_of(v, big);
  }
  return bytes;
}

std::string ascii_stl(const Polyhedron& p) {
  std::string text = "solid ball\n";
  for (const Outline& t : triangles(p)) {
    text += "facet normal 0 0 0\nouter loop\n";
    for (const Vec3& v : t) text += "vertex " + numbers(v);
    text += "endloop\nendfacet\n";
  }
  return text + "endsolid ball\n";
}

std::string stl_of_floats(const Polyhedron& p) {
  std::vector<float> corners;
  const std::vector<Outline> all = triangles(p);
  for (const Outline& t : all)
    for (const Vec3& v : t)
      for (int i = 0; i < 3; ++i) corners.push_back(static_cast<float>(v[i]));
  return binary_stl(corners, static_cast<std::uint32_t>(all.size()));
}

Polyhedron read(const std::string& bytes, const std::string& format) {
  std::vector<Diagnostic> warnings;
  Polyhedron p = read_mesh_text(bytes, format, "m", warnings).polyhedron;
  EXPECT_TRUE(warnings.empty());
  return p;
}

TEST(MeshRoundTrip, EveryFormatKeepsEveryBit) {
  std::mt19937_64 random(1974);
  for (int i = 0; i < 50; ++i) {
    const Polyhedron ball = random_ball(random);
    const std::vector<Outline> faces = outlines(ball);
    EXPECT_EQ(outlines(read(obj(ball), "obj")), faces);
    EXPECT_EQ(outlines(read(off(ball), "off")), faces);
    for (const char* encoding : {"ascii", "binary_little_endian", "binary_big_endian"})
      for (const bool doubles : {false, true})
        EXPECT_EQ(outlines(read(ply(ball, encoding, doubles), "ply")), faces) << encoding;
    const Polyhedron text = read(ascii_stl(ball), "stl"), binary = read(stl_of_floats(ball), "stl");
    EXPECT_EQ(outlines(text), triangles(ball));
    EXPECT_EQ(outlines(binary), triangles(ball));
    EXPECT_EQ(text.vertices.size(), ball.vertices.size());
    EXPECT_EQ(binary.vertices.size(), ball.vertices.size());
  }
}

// Whatever is cut off or damaged: an error or a mesh, nothing else.
TEST(MeshRoundTrip, DamagedFilesAreReadWithoutHarm) {
  std::mt19937_64 random(41);
  const Polyhedron ball = random_ball(random);
  const std::pair<const char*, std::string> files[] = {
      {"obj", obj(ball)},
      {"off", off(ball)},
      {"ply", ply(ball, "ascii", true)},
      {"ply", ply(ball, "binary_little_endian", false)},
      {"ply", ply(ball, "binary_big_endian", true)},
      {"stl", ascii_stl(ball)},
      {"stl", stl_of_floats(ball)},
  };
  std::size_t refused = 0;
  for (const auto& [format, whole] : files)
    for (int i = 0; i < 300; ++i) {
      std::string bytes = whole.substr(0, i % 2 ? whole.size() : random() % whole.size());
      for (std::size_t k = random() % 4; k > 0 && !bytes.empty(); --k)
        bytes[random() % bytes.size()] = static_cast<char>(random());
      std::vector<Diagnostic> warnings;
      try {
        const Polyhedron p = read_mesh_text(bytes, format, "m", warnings).polyhedron;
        ASSERT_GT(p.face_count(), 0u);
        ASSERT_LT(*std::max_element(p.indices.begin(), p.indices.end()), p.vertices.size());
      } catch (const InputError&) {
        ++refused;
      }
    }
  EXPECT_GT(refused, 900u);
  EXPECT_LT(refused, 2100u);
}

}  // namespace
}  // namespace overstrike::mesh_tests
