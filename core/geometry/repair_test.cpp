#include "core/geometry/repair.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "core/geometry/plane_fit.h"
#include "core/geometry/split_face.h"

namespace overstrike {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;
using testing::StartsWith;

Polyhedron cube(const Vec3& low = Vec3(0.0), double size = 1) {
  Polyhedron p;
  for (int i = 0; i < 8; ++i) p.add_vertex(low + Vec3(i & 1, i >> 1 & 1, i >> 2 & 1) * size);
  for (const auto& f : std::vector<std::vector<Index>>{
           {0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}})
    p.add_face(f);
  return p;
}

Polyhedron reversed(const Polyhedron& p, std::vector<Index> which) {
  Polyhedron out;
  out.vertices = p.vertices;
  for (Index f = 0; f < p.face_count(); ++f) {
    std::vector<Index> loop(p.loop(f).begin(), p.loop(f).end());
    if (std::find(which.begin(), which.end(), f) != which.end())
      std::reverse(loop.begin(), loop.end());
    out.add_face(loop);
  }
  return out;
}

Polyhedron joined(Polyhedron a, const Polyhedron& b) {
  const Index first = static_cast<Index>(a.vertices.size());
  a.vertices.insert(a.vertices.end(), b.vertices.begin(), b.vertices.end());
  for (Index l = 0; l < b.loop_ends.size(); ++l) {
    std::vector<Index> loop;
    for (const Index v : b.loop(l)) loop.push_back(first + v);
    a.add_face(loop);
  }
  return a;
}

std::vector<std::string> flaws_of(const Polyhedron& p, const RepairOptions& options = {},
                                  Polyhedron* result = nullptr) {
  std::vector<std::string> flaws;
  const Polyhedron out = repaired(p, options, flaws).polyhedron;
  if (result != nullptr) *result = out;
  return flaws;
}

double volume(const Polyhedron& p) {
  double six = 0;
  for (Index l = 0; l < p.loop_ends.size(); ++l)
    for (std::size_t i = 1; i + 1 < p.loop(l).size(); ++i)
      six += glm::dot(p.vertices[p.loop(l)[0]],
                      glm::cross(p.vertices[p.loop(l)[i]], p.vertices[p.loop(l)[i + 1]]));
  return six / 6;
}

TEST(Repair, LeavesASoundSolidAlone) {
  Polyhedron out;
  EXPECT_THAT(flaws_of(cube(), {}, &out), IsEmpty());
  EXPECT_EQ(out.indices, cube().indices);
}

TEST(Repair, OneVertexForOnePosition) {
  Polyhedron soup;
  const Polyhedron solid = cube();
  for (Index f = 0; f < 6; ++f) {
    std::vector<Index> loop;
    for (const Index v : solid.loop(f)) loop.push_back(soup.add_vertex(solid.vertices[v]));
    soup.add_face(loop);
  }
  Polyhedron out;
  EXPECT_THAT(flaws_of(soup, {}, &out), IsEmpty());
  EXPECT_EQ(out.vertices.size(), 8u);
}

TEST(Repair, NamesDegenerateFacesAndCopies) {
  Polyhedron p = cube();
  p.add_face({0, 0, 1});
  p.vertices.push_back({0.5, 0, 0});
  p.add_face({0, 8, 1});
  p.add_face({3, 1, 0, 2});
  Polyhedron out;
  EXPECT_THAT(flaws_of(p, {0, false, {1, 2, 3, 4, 5, 6, 7, 8, 9}}, &out),
              ElementsAre("face 6 (line 7) has fewer than three different vertices: left out",
                          "face 7 (line 8) has no area: left out",
                          "face 8 (line 9) is a copy of another: left out"));
  EXPECT_EQ(out.face_count(), 6u);
  EXPECT_EQ(out.vertices.size(), 8u);
}

TEST(Repair, CountsFlawsOfOneKindInOneSentence) {
  Polyhedron p = cube();
  for (int i = 0; i < 5; ++i) p.add_face({0, 0, 1});
  EXPECT_THAT(flaws_of(p), ElementsAre("faces 6, 7, 8 and 2 more have fewer than three different "
                                       "vertices: left out"));
}

TEST(Repair, SplitsWhatIsNotPlanar) {
  Polyhedron p = cube();
  p.vertices[7].z = 1.25;
  Polyhedron out;
  EXPECT_THAT(flaws_of(p, {}, &out),
              ElementsAre("face 1 is not planar (a vertex is 0.0615 off): split"));
  EXPECT_EQ(out.face_count(), 7u);
  EXPECT_NEAR(volume(out), volume(p), 0.1);
  std::vector<std::string> none;
  EXPECT_THAT(flaws_of(p, {0.25, false, {}}), IsEmpty());
}

TEST(Repair, RoundingIsPlanar) {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> u(-1, 1);
  for (int i = 0; i < 300; ++i) {
    const double a = u(random) * 3, b = u(random) * 3;
    Polyhedron p = cube();
    for (Vec3& v : p.vertices) {
      v = {v.x * std::cos(a) - v.y * std::sin(a), v.x * std::sin(a) + v.y * std::cos(a), v.z};
      v = {v.x, v.y * std::cos(b) - v.z * std::sin(b), v.y * std::sin(b) + v.z * std::cos(b)};
      v += Vec3(100, 0, -5);
    }
    EXPECT_THAT(flaws_of(p), IsEmpty());
    p.vertices[static_cast<std::size_t>(i) % 8] += Vec3(1e-10, 2e-10, -1e-10);
    EXPECT_EQ(flaws_of(p).size(), 1u);
  }
}

TEST(Repair, NamesFacesThatCrossThemselves) {
  Polyhedron p;
  for (const Vec3 v : {Vec3(0, 0, 0), Vec3(2, 1, 0), Vec3(2, 0, 0), Vec3(0, 2, 0)}) p.add_vertex(v);
  p.add_face({0, 1, 2, 3});
  EXPECT_THAT(flaws_of(p, {0, true, {}}),
              ElementsAre("face 0 crosses itself: drawn by the even-odd rule"));
}

TEST(Repair, KeepsCrossingFacesWhosePartsCancel) {
  Polyhedron p;
  p.vertices = {{0, 0, 2}, {2, 2, 2}, {2, 0, 2}, {0, 2, 2}};
  p.add_face({0, 1, 2, 3});
  Polyhedron out;
  EXPECT_THAT(flaws_of(p, {0, true, {}}, &out),
              ElementsAre("face 0 crosses itself: drawn by the even-odd rule"));
  ASSERT_EQ(out.face_count(), 1u);
  EXPECT_EQ(std::abs(fit_plane(out, 0).normal.z), 1);
  EXPECT_EQ(fit_plane(out, 0).offset * fit_plane(out, 0).normal.z, 2);
  Polyhedron back;
  back.vertices = {{0, 0, 2}, {2, 2, 2}, {2, 0, 2}};
  back.add_face({0, 1, 2, 1});
  EXPECT_THAT(flaws_of(back, {0, true, {}}), ElementsAre("face 0 has no area: left out"));
}

/// Such a face was once taken for planar, with a plane far from its corners.
TEST(Repair, SplitsCrossingFacesThatAreNotPlanar) {
  Polyhedron p;
  p.vertices = {{-3, -3, -2}, {0, -3, -3}, {-4, -4, -4}, {-1, -4, -4}};
  p.add_face({0, 1, 2, 3});
  const std::vector<std::vector<Vec3>> loops{p.vertices};
  ASSERT_TRUE(crosses_itself(loops, fit_plane(p, 0).normal));
  std::vector<std::string> flaws;
  const Repaired mended = repaired(p, {0, true, {}}, flaws);
  EXPECT_EQ(mended.polyhedron.face_count(), 2u);
  EXPECT_FALSE(mended.crosses_itself);
  ASSERT_THAT(flaws, SizeIs(1));
  EXPECT_THAT(flaws[0], StartsWith("face 0 is not planar"));
}

TEST(Repair, TurnsFacesThatDisagree) {
  Polyhedron out;
  EXPECT_THAT(flaws_of(reversed(cube(), {1, 3}), {}, &out),
              ElementsAre("faces 1 and 3 look the other way than their neighbours: turned"));
  EXPECT_DOUBLE_EQ(volume(out), 1);
}

TEST(Repair, TurnsWhatIsInsideOut) {
  Polyhedron out;
  const std::vector<Index> all{0, 1, 2, 3, 4, 5};
  EXPECT_THAT(flaws_of(reversed(cube(), all), {}, &out), ElementsAre("inside out: turned"));
  EXPECT_DOUBLE_EQ(volume(out), 1);
  const Polyhedron apart = joined(cube({5, 5, 5}, 2), reversed(cube(), all));
  EXPECT_THAT(flaws_of(apart, {}, &out), ElementsAre("a part of 6 faces is inside out: turned"));
  EXPECT_DOUBLE_EQ(volume(out), 9);
  const Polyhedron hollow = joined(cube({-1, -1, -1}, 3), reversed(cube(), all));
  EXPECT_THAT(flaws_of(hollow, {}, &out), IsEmpty());
  EXPECT_DOUBLE_EQ(volume(out), 26);
}

TEST(Repair, NamesOpenEdges) {
  Polyhedron p;
  p.vertices = cube().vertices;
  for (Index f = 0; f < 5; ++f) p.add_face(cube().loop(f));
  EXPECT_THAT(flaws_of(p),
              ElementsAre("open: 4 edges have one face only: (1, 1, 0) to (1, 0, 0), (1, 0, 0) to "
                          "(1, 0, 1), (1, 1, 1) to (1, 1, 0), ..."));
}

TEST(Repair, AMoebiusStripHasNoSide) {
  Polyhedron p;
  const int n = 6;
  for (int i = 0; i < n; ++i) {
    const double a = 2 * M_PI * i / n, b = a / 2;
    const Vec3 round(std::cos(a), std::sin(a), 0);
    p.add_vertex(round * (3 + std::cos(b)) + Vec3(0, 0, std::sin(b)));
    p.add_vertex(round * (3 - std::cos(b)) - Vec3(0, 0, std::sin(b)));
  }
  for (Index i = 0; i < n; ++i) {
    const bool last = i == n - 1;
    const Index a = 2 * i, b = 2 * i + 1, c = last ? 1 : a + 2, d = last ? 0 : b + 2;
    p.add_face({a, c, d});
    p.add_face({a, d, b});
  }
  const std::vector<std::string> flaws = flaws_of(p);
  ASSERT_EQ(flaws.size(), 2u);
  EXPECT_EQ(flaws[0], "its faces have no consistent inside and outside");
}

TEST(SplitFace, DoesNotDependOnTheStartAndKeepsTheArea) {
  std::vector<Vec3> comb{{0, 0, 0}, {5, 0, 1}, {5, 3, 0}, {4, 3, 1}, {4, 1, 0},
                         {3, 1, 1}, {3, 3, 0}, {2, 3, 0}, {2, 1, 1}, {0, 1, 0}};
  std::vector<std::array<Vec3, 3>> first;
  for (std::size_t start = 0; start < comb.size(); ++start) {
    std::vector<std::array<Vec3, 3>> triangles;
    double area = 0;
    for (const auto& t : triangles_of(comb, {0, 0, 1})) {
      triangles.push_back({comb[t[0]], comb[t[1]], comb[t[2]]});
      area += glm::cross(comb[t[1]] - comb[t[0]], comb[t[2]] - comb[t[0]]).z / 2;
    }
    EXPECT_EQ(triangles.size(), comb.size() - 2);
    EXPECT_DOUBLE_EQ(area, 9);
    if (start == 0) first = triangles;
    EXPECT_EQ(triangles, first);
    std::rotate(comb.begin(), comb.begin() + 1, comb.end());
  }
}

TEST(SplitFace, BridgesHoles) {
  const std::vector<std::vector<Vec3>> loops{{{0, 0, 0}, {6, 0, 0}, {6, 4, 1}, {0, 4, 0}},
                                             {{1, 1, 0}, {1, 3, 0}, {2, 3, 0}, {2, 1, 0}},
                                             {{4, 1, 0}, {4, 3, 0}, {5, 3, 0}, {5, 1, 0}}};
  std::vector<Vec3> all, joined_loop;
  for (const auto& loop : loops) all.insert(all.end(), loop.begin(), loop.end());
  for (const Index c : bridged(loops, {0, 0, 1})) joined_loop.push_back(all[c]);
  EXPECT_EQ(joined_loop.size(), 16u);
  double area = 0;
  for (const auto& t : triangles_of(joined_loop, {0, 0, 1})) {
    const double z =
        glm::cross(joined_loop[t[1]] - joined_loop[t[0]], joined_loop[t[2]] - joined_loop[t[0]]).z;
    EXPECT_GE(z, 0);
    area += z / 2;
  }
  EXPECT_DOUBLE_EQ(area, 20);
}

}  // namespace
}  // namespace overstrike
