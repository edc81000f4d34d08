// Laws of the strokes of Boolean solids: what is drawn hangs on the set, not on what else runs
// along its surface.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <string>

#include "core/drawing.h"
#include "core/visibility/intervals.h"
#include "core/visibility/test_scenes.h"

namespace overstrike {
namespace {

constexpr Grid kGrid{40, 40};
/// Grid units: chains leave corners out that are no farther off than this; two drawings may leave
/// out others.
constexpr double kTolerance = 1e-6;
constexpr double kSame = 2 * kTolerance;

using testing::operand_tree;
using testing::tree_of;
using Nodes = std::vector<SolidNode>;

constexpr SetOperation kUnite = SetOperation::unite, kSubtract = SetOperation::subtract,
                       kIntersect = SetOperation::intersect;

struct Line {
  Vec2 a, b;
  StrokeKind kind;
  int pen;
};

double length_of(const Line& line) { return glm::length(line.b - line.a); }

std::vector<Line> lines_of(const std::vector<Stroke>& strokes) {
  std::vector<Line> lines;
  for (const Stroke& s : strokes)
    for (std::size_t i = 0; i + 1 < s.points.size(); ++i)
      lines.push_back({s.points[i], s.points[i + 1], s.kind, s.pen});
  return lines;
}

/// The part of `one` that lies on `other`, which is drawn the same.
Interval covered(const Line& one, const Line& other) {
  const Vec2 along = (one.b - one.a) / glm::length(one.b - one.a);
  const auto at = [&](const Vec2& p) { return glm::dot(p - one.a, along); };
  const Line ordered = at(other.a) < at(other.b) ? other : Line{other.b, other.a, other.kind, 0};
  const double from = at(ordered.a), to = at(ordered.b);
  const double low = std::max(from, 0.0), high = std::min(to, length_of(one));
  if (one.kind != other.kind || one.pen != other.pen || !(low < high)) return {0, 0};
  const auto off = [&](double t) {
    const Vec2 p = ordered.a + (ordered.b - ordered.a) * ((t - from) / (to - from));
    return glm::length(p - (one.a + along * t));
  };
  return off(low) <= kSame && off(high) <= kSame ? Interval{low, high} : Interval{0, 0};
}

/// Where something is drawn in the first drawing only; empty: nowhere. A corner may be cut by so
/// much that short pieces at it are not there.
std::string missing(const std::vector<Line>& lines, const std::vector<Line>& others) {
  constexpr double kCorner = 1e-3;
  for (const Line& line : lines) {
    if (length_of(line) <= kCorner) continue;
    Intervals parts;
    for (const Line& other : others) parts.push_back(covered(line, other));
    unite(parts);
    for (const auto& [from, to] : without({0, length_of(line)}, parts, kCorner)) {
      const Vec2 p = line.a + (line.b - line.a) * ((from + to) / 2 / length_of(line));
      return std::to_string(p.x) + ", " + std::to_string(p.y) + ": kind " +
             std::to_string(static_cast<int>(line.kind)) + ", " + std::to_string(to - from) +
             " long";
    }
  }
  return {};
}

/// Drawings are the same where each lies on the other.
::testing::AssertionResult same(const std::vector<Stroke>& p, const std::vector<Stroke>& q) {
  const std::string too_many = missing(lines_of(p), lines_of(q)),
                    too_few = missing(lines_of(q), lines_of(p));
  if (too_many.empty() && too_few.empty()) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << "too many: " << too_many << "; too few: " << too_few;
}

/// Trees over three round bodies on a lattice: axes in the planes of others' bases, so that facets'
/// edges lie in these.
class Rounds {
 public:
  explicit Rounds(std::uint64_t seed) : random_(seed) {
    for (Body& body : bodies_) body = random_body();
    camera_.from = {static_cast<double>(random_() % 72) * 5, 10 + 10.0 * (random_() % 7)};
    lit_ = random_() % 2 == 0;
  }

  std::vector<Stroke> drawn(const Nodes& nodes, const StrokeOptions& what = {}) const {
    Scene scene;
    testing::add_solid(scene, nodes, bodies_);
    return strokes_of(std::move(scene), what);
  }
  /// The first body by itself.
  std::vector<Stroke> alone() const {
    Scene scene;
    scene.bodies.push_back(bodies_[0]);
    return strokes_of(std::move(scene), {});
  }

 private:
  std::vector<Stroke> strokes_of(Scene scene, const StrokeOptions& what) const {
    scene.camera = camera_;
    if (lit_) scene.light = Direction{75, 35}, scene.ground_z = -1.5;
    DrawOptions options;
    options.threads = 1, options.tolerance = kTolerance;
    Drawing drawing(scene, kGrid, options);
    return drawing.strokes(what);
  }

  double lattice() { return static_cast<double>(random_() % 3) / 2; }

  Shape random_shape() {
    const int sides = 8 + 4 * static_cast<int>(random_() % 3);
    const double radius = 1 + lattice() / 2;
    switch (random_() % 4) {
      case 0:
        return Frustum{radius, radius, 2, sides};
      case 1:
        return Frustum{radius, 0, 2.5, sides};
      case 2:
        return Frustum{radius, radius / 2, 2, sides};
      default:
        return Ellipsoid{Vec3(radius), sides, sides / 2};
    }
  }

  Body random_body() {
    Body body;
    body.shape = std::make_shared<const Shape>(random_shape());
    body.shading = Shading::smooth;
    // Standing, or lying along one of the other axes.
    const std::array<Mat3, 3> turns{Mat3(1.0), Mat3(Vec3(1, 0, 0), Vec3(0, 0, 1), Vec3(0, -1, 0)),
                                    Mat3(Vec3(0, 0, -1), Vec3(0, 1, 0), Vec3(1, 0, 0))};
    body.placement = {turns[random_() % 3], {lattice(), lattice(), lattice()}};
    body.density_factor = 0.25 * static_cast<double>(1 + random_() % 4);
    body.pen = static_cast<int>(random_() % 2);
    return body;
  }

  std::mt19937_64 random_;
  std::array<Body, 3> bodies_;
  Camera camera_{Vec3(0.5, 0.5, 0.5), 20.0, {31, 27}, {}, {}, {0, 0, 1}, true, 9.0, {}, {}};
  bool lit_ = false;
};

Nodes unite(const Nodes& p, const Nodes& q) { return tree_of(kUnite, {p, q}); }
Nodes less(const Nodes& p, const Nodes& q) { return tree_of(kSubtract, {p, q}); }
Nodes both(const Nodes& p, const Nodes& q) { return tree_of(kIntersect, {p, q}); }

TEST(SolidEdges, OfRoundBodiesKeepTheLawsOfSets) {
  const Nodes a = operand_tree(0), b = operand_tree(1), c = operand_tree(2);
  std::size_t strokes = 0;
  for (std::uint64_t n = 0; n < 40; ++n) {
    SCOPED_TRACE(n);
    const Rounds r(n);
    const std::vector<Stroke> whole = r.drawn(a);
    strokes += whole.size();
    EXPECT_TRUE(same(r.alone(), whole));
    EXPECT_TRUE(same(r.drawn(unite(a, both(a, b))), whole)) << "absorption";
    EXPECT_TRUE(same(r.drawn(both(a, unite(a, b))), whole)) << "absorption";
    EXPECT_TRUE(same(r.drawn(unite(less(a, b), both(a, b))), whole)) << "parts";
    EXPECT_TRUE(same(r.drawn(both(a, unite(b, c))), r.drawn(unite(both(a, b), both(a, c)))))
        << "distribution";
    EXPECT_TRUE(same(r.drawn(less(a, unite(b, c))), r.drawn(both(less(a, b), less(a, c)))))
        << "De Morgan";
    EXPECT_TRUE(same(r.drawn(tree_of(kUnite, {a, b, c})), r.drawn(tree_of(kUnite, {c, a, b}))))
        << "order";
  }
  EXPECT_GT(strokes, 80u);
}

/// What is left out is not drawn as something else: an edge along which another operand's surface
/// runs is a crease still.
TEST(SolidEdges, OfOneOperandAreNoIntersections) {
  const Nodes a = operand_tree(0), b = operand_tree(1);
  StrokeOptions what;
  what.contours = what.creases = what.shadow_outlines = false;
  for (std::uint64_t n = 0; n < 40; ++n) {
    SCOPED_TRACE(n);
    EXPECT_TRUE(Rounds(n).drawn(unite(a, both(a, b)), what).empty());
  }
}

/// A lying cone's base runs along two edges between facets of a standing one.
TEST(SolidEdges, ARoundShapeIsSmoothWhereAnotherOperandCutsItAlongAnEdge) {
  Scene scene;
  testing::add(scene, Frustum{1.5, 0, 2.5}, {-0.5, 1.5, -0.5});
  testing::add(scene, Frustum{1.5, 0, 2.5}, {-0.5, 1.5, -0.5});
  testing::add(scene, Frustum{1.5, 0, 2.5}, {0, 1.5, 0.5}).placement.linear =
      Mat3(Vec3(1, 0, 0), Vec3(0, 0, 1), Vec3(0, -1, 0));
  scene.solids.push_back({unite(operand_tree(0), both(operand_tree(1), operand_tree(2))), {}, {}});
  scene.camera = {Vec3(0, 0, 1), 30.0, {-40, 30}, {}, {}, {0, 0, 1}, true, 12.0, {}, {}};
  Drawing drawing(scene, kGrid, {});
  const std::vector<Stroke> strokes = drawing.strokes({});
  ASSERT_EQ(strokes.size(), 1u);
  EXPECT_EQ(strokes[0].kind, StrokeKind::contour);
  EXPECT_EQ(strokes[0].points.front(), strokes[0].points.back());
}

/// Nothing else tells them apart.
TEST(SolidEdges, OfEqualBodiesTheSmallerPenDraws) {
  for (const int first : {1, 2}) {
    Scene scene;
    testing::add(scene, Box{Vec3(1)}).pen = first;
    testing::add(scene, Box{Vec3(1)}).pen = 3 - first;
    scene.solids.push_back({unite(operand_tree(0), operand_tree(1)), {}, {}});
    scene.camera.from = {30, 40};
    Drawing drawing(scene, kGrid, {});
    const std::vector<Stroke> strokes = drawing.strokes({});
    ASSERT_FALSE(strokes.empty());
    for (const Stroke& stroke : strokes) EXPECT_EQ(stroke.pen, 1);
  }
}

}  // namespace
}  // namespace overstrike
