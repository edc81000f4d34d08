#include "core/geometry/cut_polyhedron.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "core/geometry/direction.h"
#include "core/geometry/polygon.h"
#include "core/geometry/winged_edges.h"

namespace overstrike {
namespace {

double signed_volume(const Polyhedron& p) {
  double six = 0;
  for (Index l = 0; l < p.loop_ends.size(); ++l) {
    const std::span<const Index> loop = p.loop(l);
    for (std::size_t i = 1; i + 1 < loop.size(); ++i)
      six +=
          glm::dot(p.vertices[loop[0]], glm::cross(p.vertices[loop[i]], p.vertices[loop[i + 1]]));
  }
  return six / 6;
}

std::size_t borders(const Polyhedron& p) {
  std::size_t count = 0;
  for (const EdgePair& e : pair_edges(p)) count += e.right == kNoFace;
  return count;
}

/// Right prism over a counter-clockwise polygon, with holes clockwise.
Polyhedron prism(const std::vector<std::vector<Vec2>>& loops, double height) {
  Polyhedron p;
  std::vector<std::vector<Index>> low, high;
  for (const auto& loop : loops) {
    low.emplace_back(), high.emplace_back();
    for (const Vec2& q : loop) {
      low.back().push_back(p.add_vertex(Vec3(q, 0)));
      high.back().push_back(p.add_vertex(Vec3(q, height)));
    }
  }
  for (const auto& loop : high) p.add_loop(loop);
  p.end_face();
  for (const auto& loop : low) p.add_loop(std::vector<Index>(loop.rbegin(), loop.rend()));
  p.end_face();
  for (std::size_t k = 0; k < low.size(); ++k)
    for (std::size_t i = 0, n = low[k].size(); i < n; ++i)
      p.add_face({low[k][i], low[k][(i + 1) % n], high[k][(i + 1) % n], high[k][i]});
  return p;
}

/// A comb of four teeth with a hole in its back.
Polyhedron comb() {
  std::vector<Vec2> outline{{0, 0}, {8, 0}, {8, 5}};
  for (int tooth = 3; tooth >= 0; --tooth) {
    outline.push_back({2.0 * tooth + 1, 5});
    outline.push_back({2.0 * tooth + 1, 2});
    if (tooth > 0) outline.push_back({2.0 * tooth, 2}), outline.push_back({2.0 * tooth, 5});
  }
  outline.push_back({0, 2});
  return prism({outline, {{1, 0.5}, {1, 1.5}, {7, 1.5}, {7, 0.5}}}, 3);
}

Polyhedron cube() { return prism({{{0, 0}, {1, 0}, {1, 1}, {0, 1}}}, 1); }

CutPolyhedron cut(const Polyhedron& p, const Vec3& normal, double offset) {
  return cut_polyhedron(p, normal, offset, true);
}

TEST(CutPolyhedron, HalvesOfRandomCutsAddUpAndAreClosed) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> u(-1, 1);
  for (const Polyhedron& p : {cube(), comb()}) {
    ASSERT_EQ(borders(p), 0u);
    const double whole = signed_volume(p);
    for (int i = 0; i < 300; ++i) {
      const Vec3 normal = unit(Vec3(u(random), u(random), u(random)));
      const Vec3 through = p.vertices[i % p.vertices.size()] * 0.5 + Vec3(0.1, 0.2, 0.3);
      const double offset = glm::dot(normal, through);
      const CutPolyhedron a = cut(p, normal, offset), b = cut(p, -normal, -offset);
      EXPECT_EQ(borders(a.polyhedron), 0u) << i;
      EXPECT_EQ(borders(b.polyhedron), 0u) << i;
      EXPECT_NEAR(signed_volume(a.polyhedron) + signed_volume(b.polyhedron), whole, 1e-12 * whole);
      EXPECT_GT(signed_volume(a.polyhedron), 0);
      EXPECT_EQ(std::count(a.face_source.begin(), a.face_source.end(), kCap), 1);
    }
  }
}

TEST(CutPolyhedron, PlanesThroughVerticesAndFacesLeaveClosedHalves) {
  const Polyhedron p = comb();
  const double whole = signed_volume(p);
  for (const Vec3 normal : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)})
    for (double offset = 0.5; offset < 8; offset += 0.5) {
      const CutPolyhedron a = cut(p, normal, offset), b = cut(p, -normal, -offset);
      EXPECT_EQ(borders(a.polyhedron), 0u) << offset;
      EXPECT_EQ(borders(b.polyhedron), 0u) << offset;
      EXPECT_NEAR(signed_volume(a.polyhedron) + signed_volume(b.polyhedron), whole, 1e-12 * whole);
    }
}

TEST(CutPolyhedron, CubeInHalf) {
  const CutPolyhedron half = cut(cube(), {1, 0, 0}, 0.25);
  EXPECT_EQ(half.polyhedron.face_count(), 6u);
  EXPECT_EQ(half.polyhedron.vertices.size(), 8u);
  EXPECT_DOUBLE_EQ(signed_volume(half.polyhedron), 0.75);
}

/// A shell of several, that goes round what lies in it once: forwards or backwards.
struct BoxShell {
  Vec3 low, high;
  bool inside_out = false;
  int winding(const Vec3& p) const {
    const bool in = glm::all(glm::lessThan(low, p)) && glm::all(glm::lessThan(p, high));
    return in ? (inside_out ? -1 : 1) : 0;
  }
};

Polyhedron mesh_of(const std::vector<BoxShell>& shells) {
  Polyhedron p;
  for (const BoxShell& s : shells) {
    const Index first = static_cast<Index>(p.vertices.size());
    const Polyhedron box = prism({{{0, 0}, {1, 0}, {1, 1}, {0, 1}}}, 1);
    for (const Vec3& v : box.vertices) p.add_vertex(s.low + (s.high - s.low) * v);
    for (Index f = 0; f < box.face_count(); ++f) {
      std::vector<Index> loop;
      for (const Index v : box.loop(f)) loop.push_back(first + v);
      if (s.inside_out) std::reverse(loop.begin(), loop.end());
      p.add_face(std::span<const Index>(loop));
    }
  }
  return p;
}

/// A cap's faces, each by even and odd, at a point (x, y) of a plane z = const.
bool capped_at(const CutPolyhedron& part, const Vec2& at) {
  const Polyhedron& p = part.polyhedron;
  for (Index f = 0; f < p.face_count(); ++f) {
    bool inside = false;
    for (Index l = p.first_loop(f); is_cap(part.face_source[f]) && l < p.face_ends[f]; ++l) {
      Loop2 loop;
      for (const Index v : p.loop(l)) loop.push_back(Vec2(p.vertices[v]));
      inside = inside != contains(loop, at);
    }
    if (inside) return true;
  }
  return false;
}

std::vector<Index> caps(const CutPolyhedron& part) {
  std::vector<Index> found;
  for (const Index source : part.face_source)
    if (is_cap(source)) found.push_back(source);
  return found;
}

TEST(CutPolyhedron, ShellsOverAndInOneAnotherAreCappedOnceForEachTimeRound) {
  const BoxShell whole{{0, 0, 0}, {4, 4, 4}}, over{{2, 2, 0}, {6, 6, 4}},
      within{{1, 1, 1}, {3, 3, 3}};
  const BoxShell hollow{within.low, within.high, true};
  const auto part_of = [](const std::vector<BoxShell>& shells) {
    CutPolyhedron part = cut(mesh_of(shells), {0, 0, 1}, 2);
    EXPECT_EQ(borders(part.polyhedron), 0u);
    return part;
  };
  const CutPolyhedron overlapping = part_of({whole, over}), nested = part_of({whole, within});
  EXPECT_EQ(caps(overlapping), std::vector<Index>({kCap, kCap}));
  EXPECT_TRUE(capped_at(overlapping, {3, 3}));
  EXPECT_FALSE(capped_at(overlapping, {1, 5}));
  EXPECT_EQ(caps(nested), std::vector<Index>({kCap, kCap}));
  EXPECT_TRUE(capped_at(nested, {2, 2}));
  const CutPolyhedron cavity = part_of({whole, hollow}), turned = part_of({hollow});
  EXPECT_EQ(caps(cavity), std::vector<Index>({kCap}));
  EXPECT_FALSE(capped_at(cavity, {2, 2}));
  EXPECT_EQ(caps(turned), std::vector<Index>({kTurnedCap}));
  EXPECT_TRUE(capped_at(turned, {2, 2}));
}

/// Corners on a lattice, so that cuts touch, lie on one another and cancel; or anywhere.
TEST(CutPolyhedron, RandomShellsAreCappedWhereTheyGoRound) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> u(0, 1);
  for (int i = 0; i < 1000; ++i) {
    const bool lattice = i % 2 == 0;
    const auto place = [&](double low, double high) {
      const Vec3 p = Vec3(low) + Vec3(u(random), u(random), u(random)) * (high - low);
      return lattice ? glm::floor(p) : p;
    };
    std::vector<BoxShell> shells;
    for (std::size_t n = 2 + random() % 4; n > 0; --n) {
      const Vec3 low = place(0, 4);
      shells.push_back({low, low + place(1, 5), u(random) < 0.3});
    }
    const double z = lattice ? 3.5 : 1 + 4 * u(random);
    const CutPolyhedron part = cut(mesh_of(shells), {0, 0, 1}, z);
    EXPECT_EQ(borders(part.polyhedron), 0u) << i;
    for (int k = 0; k < 30; ++k) {
      const Vec3 at(9 * u(random), 9 * u(random), z);
      int winding = 0;
      for (const BoxShell& s : shells) winding += s.winding(at);
      EXPECT_EQ(capped_at(part, Vec2(at)), winding != 0) << i << " at " << at.x << ", " << at.y;
    }
    if (HasFailure()) return;
  }
}

TEST(CutPolyhedron, OpenFacesGetNoCap) {
  Polyhedron square;
  for (const Vec2 q : {Vec2(0, 0), Vec2(1, 0), Vec2(1, 1), Vec2(0, 1)})
    square.add_vertex(Vec3(q, 0));
  square.add_face({0, 1, 2, 3});
  const CutPolyhedron part = cut_polyhedron(square, {-1, 0, 0}, -0.5, false);
  ASSERT_EQ(part.polyhedron.face_count(), 1u);
  EXPECT_EQ(part.polyhedron.loop(0).size(), 4u);
  EXPECT_EQ(part.face_source[0], 0u);
}

/// With a solid on the removed side it would be that solid's end; it has none.
TEST(CutPolyhedron, OpenFacesInThePlaneStay) {
  Polyhedron triangle;
  for (const Vec3 v : {Vec3(0, 0, 0), Vec3(2, 0, 0), Vec3(0, 1, 0)}) triangle.add_vertex(v);
  triangle.add_face({0, 1, 2});
  for (const double side : {1.0, -1.0})
    EXPECT_EQ(cut_polyhedron(triangle, {0, 0, side}, 0, false).polyhedron.face_count(), 1u);
}

TEST(CutPolyhedron, NormalsAreInterpolatedOnAStraightLine) {
  Polyhedron triangle;
  for (const Vec3 v : {Vec3(0, 0, 0), Vec3(2, 0, 0), Vec3(0, 1, 0)}) triangle.add_vertex(v);
  triangle.add_face({0, 1, 2});
  triangle.corner_normals = {{0, 0, 1}, {1, 0, 0}, {0, 0, 1}};
  const CutPolyhedron part = cut_polyhedron(triangle, {-1, 0, 0}, -1, false);
  const Vec3 middle(0.5, 0, 0.5);  // not of unit length: tones are linear in normals
  int found = 0;
  for (const Vec3& n : part.polyhedron.corner_normals) found += max_norm(n - middle) < 1e-15;
  EXPECT_EQ(found, 2);
}

/// Tilted by the last places of its normal the plane meets edges that almost lie in it in their
/// middles, which heights in doubles are a thousandth off.
TEST(CutPolyhedron, EdgesNearlyInThePlaneAreCutWhereTheyMeetIt) {
  const Vec3 normal(0, -1, 0x1p-42);
  Polyhedron triangle;
  for (const Vec3 v : {Vec3(0.3, 2, -2.9), Vec3(0.3, 2, 1.1), Vec3(1, 2, -2.9)})
    triangle.add_vertex(v);
  triangle.add_face({0, 1, 2});
  for (const double level : {-0.7, 0.1, 0.9}) {
    const double offset = -2 + 0x1p-42 * level;  // rounded, to a place that is no end's
    const double exact = (offset + 2) * 0x1p42;
    const CutPolyhedron part = cut_polyhedron(triangle, normal, offset, false);
    int found = 0;
    for (Index v = 0; v < part.polyhedron.vertices.size(); ++v) {
      if (part.origin[v].low == part.origin[v].high) continue;
      EXPECT_NEAR(part.polyhedron.vertices[v].z, exact, 1e-12) << level;
      ++found;
    }
    EXPECT_EQ(found, 2);
  }
}

/// Of an edge of a million units a millionth from its middle, to a few last places of that.
TEST(CutPolyhedron, VerticesOfLongEdgesKeepTheirOwnDigits) {
  constexpr double kFar = 1e6 / 3, kNear = 1e-6;
  Polyhedron triangle;
  for (const Vec3 v : {Vec3(-kFar, -kFar, 0), Vec3(kFar, kFar + kNear, 0), Vec3(kFar, -kFar, 0)})
    triangle.add_vertex(v);
  triangle.add_face({0, 1, 2});
  const CutPolyhedron part = cut_polyhedron(triangle, {-1, 0, 0}, -kNear, false);
  // y + kFar = (x + kFar) (2 kFar + kNear as stored) / (2 kFar), at x = kNear.
  const long double top = kFar + kNear, far = kFar, x = kNear;
  const long double y = (x + far) * (top + far) / (2 * far) - far;
  int found = 0;
  for (const Vec3& v : part.polyhedron.vertices)
    if (max_norm(v) < 1) {
      ++found;
      EXPECT_NEAR(v.x, kNear, 4 * 0x1p-53 * kNear);
      // The long doubles of the expected place have 2^-64 of kFar.
      EXPECT_NEAR(v.y, static_cast<double>(y), 8 * 0x1p-64 * kFar);
    }
  EXPECT_EQ(found, 1);
}

}  // namespace
}  // namespace overstrike
