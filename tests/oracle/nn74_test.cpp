// NN74's table 1: the scenes have its counts of bodies, vertices and faces, and stand as they
// should.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "core/visibility/canonical.h"
#include "core/visibility/view.h"
#include "scenes/readers/read.h"

namespace overstrike {
namespace {

struct Row {
  std::string file;
  std::size_t bodies, vertices, faces;
};

void PrintTo(const Row& row, std::ostream* out) { *out << row.file; }

class Table1 : public testing::TestWithParam<Row> {
 protected:
  Scene scene_ =
      read_scene(std::string(OVERSTRIKE_SOURCE_DIR) + "/scenes/" + GetParam().file + ".yaml").scene;
  std::vector<Diagnostic> warnings_;
  Canonical canonical_ = canonicalize(scene_, make_view(scene_, Grid{}), 0.05, warnings_);
};

TEST_P(Table1, HasTheCountsOfThePaper) {
  EXPECT_EQ(canonical_.bodies.size(), GetParam().bodies);
  EXPECT_EQ(canonical_.vertices.size(), GetParam().vertices);
  EXPECT_EQ(canonical_.faces.size(), GetParam().faces);
  EXPECT_TRUE(warnings_.empty());
}

TEST_P(Table1, LiesOnTheGroundOrAbove) {
  ASSERT_TRUE(canonical_.ground_z.has_value());
  for (const Vec3& p : canonical_.vertices) EXPECT_GE(p.z, *canonical_.ground_z);
}

/// NN74 draws convex polyhedra and polygons: nothing of a body lies before one of its faces.
TEST_P(Table1, BodiesAreConvex) {
  constexpr double kRounding = 1e-5;  // profiles are written with six decimals
  for (const CanonicalFace& f : canonical_.faces) {
    const CanonicalBody& body = canonical_.bodies[f.body];
    for (Index v = body.first_vertex; v < body.end_vertex; ++v) {
      const double offset = canonical_.planes[f.plane].offset * (f.flipped ? -1 : 1);
      EXPECT_LE(glm::dot(canonical_.outward(f), canonical_.vertices[v]) - offset, kRounding);
    }
  }
}

/// Convex bodies do not interpenetrate when a plane has them on its two sides: that of a face, or
/// one along an edge of each.
bool apart(const Canonical& c, const CanonicalBody& a, const CanonicalBody& b) {
  constexpr double kRounding = 1e-9;
  const auto range = [&c](const CanonicalBody& body, const Vec3& n) {
    std::pair<double, double> r{1e300, -1e300};
    for (Index v = body.first_vertex; v < body.end_vertex; ++v) {
      const double d = glm::dot(n, c.vertices[v]);
      r = {std::min(r.first, d), std::max(r.second, d)};
    }
    return r;
  };
  const auto separates = [&](const Vec3& n) {
    const auto ra = range(a, n), rb = range(b, n);
    return ra.second <= rb.first + kRounding || rb.second <= ra.first + kRounding;
  };
  for (const CanonicalBody* body : {&a, &b})
    for (Index f = body->first_face; f < body->end_face; ++f)
      if (separates(c.outward(c.faces[f]))) return true;
  const auto along = [&c](Index e) {
    return c.vertices[c.edges[e].to] - c.vertices[c.edges[e].from];
  };
  for (Index i = a.first_edge; i < a.end_edge; ++i)
    for (Index j = b.first_edge; j < b.end_edge; ++j) {
      const Vec3 n = glm::cross(along(i), along(j));
      if (glm::length(n) > kRounding && separates(glm::normalize(n))) return true;
    }
  return false;
}

TEST_P(Table1, BodiesDoNotInterpenetrate) {
  for (std::size_t i = 0; i < canonical_.bodies.size(); ++i)
    for (std::size_t j = i + 1; j < canonical_.bodies.size(); ++j)
      EXPECT_TRUE(apart(canonical_, canonical_.bodies[i], canonical_.bodies[j]))
          << scene_.bodies[i].name << " and " << scene_.bodies[j].name;
}

INSTANTIATE_TEST_SUITE_P(
    NN74, Table1,
    testing::Values(Row{"nn74-a-solids", 3, 122, 118}, Row{"nn74-b-prisms", 5, 120, 70},
                    Row{"nn74-c-boxes", 13, 104, 78}, Row{"nn74-d-patterns", 15, 76, 50},
                    Row{"nn74-e-hospital", 27, 218, 163}, Row{"nn74-f-hospital", 27, 218, 163}));

}  // namespace
}  // namespace overstrike
