// The law: strokes of Boolean solids run where what is seen changes its plane, and nowhere else;
// nor where it goes on to the next facet of a curved surface.
// Runs and strokes come from two resolvers; what lies beside a stroke the oracle says.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "core/drawing.h"
#include "core/visibility/projected_scene.h"
#include "tests/oracle/oracle.h"
#include "tests/oracle/random_trees.h"

namespace overstrike::oracle {
namespace {

#ifdef OVERSTRIKE_ORACLE_LONG
constexpr int kTrees = 3000;
#else
constexpr int kTrees = 200;
#endif

/// Grid units: strokes' corners that a simplification leaves out may be half as far off.
constexpr double kTolerance = 1e-6;
/// Beside a stroke is farther than that, and nearer than what else is there but for chance.
constexpr double kBeside = 16 * kTolerance;

struct Picture {
  explicit Picture(const Scene& scene) {
    const Grid grid{32, 40};
    view = make_view(scene, grid);
    std::vector<Diagnostic> warnings;
    canonical = std::make_shared<const Canonical>(canonicalize(scene, view, 0.05, warnings));
    projected = std::make_unique<const ProjectedScene>(*canonical, view);
    DrawOptions options;
    options.threads = 1, options.tolerance = kTolerance;
    Drawing drawing(canonical, view, options);
    strokes = drawing.strokes({});
    drawing.runs({0, 1, 0.37}, [&](const RunRow& row) {
      rows.emplace_back(static_cast<double>(row.index) + 0.37,
                        std::vector<DensityRun>(row.runs.begin(), row.runs.end()));
    });
  }

  View view;
  std::shared_ptr<const Canonical> canonical;
  std::unique_ptr<const ProjectedScene> projected;
  std::vector<Stroke> strokes;
  std::vector<std::pair<double, std::vector<DensityRun>>> rows;
};

double distance(const Vec2& p, const Vec2& a, const Vec2& b) {
  const Vec2 d = b - a;
  const double square = glm::dot(d, d);
  const double t = square > 0 ? std::clamp(glm::dot(p - a, d) / square, 0.0, 1.0) : 0;
  return glm::length(p - (a + d * t));
}

bool on_a_stroke(const Picture& picture, const Vec2& p, double reach) {
  for (const Stroke& stroke : picture.strokes)
    for (std::size_t i = 0; i + 1 < stroke.points.size(); ++i)
      if (distance(p, stroke.points[i], stroke.points[i + 1]) <= reach) return true;
  return false;
}

/// One of the bodies has facets of one curved surface in the faces' planes, which are neighbours.
bool smooth_between(const Canonical& c, Index f, Index g) {
  const auto planes_of = [&](Index p, Index q) {
    return std::pair(std::min(c.faces[p].plane, c.faces[q].plane),
                     std::max(c.faces[p].plane, c.faces[q].plane));
  };
  for (const WingedEdge& edge : c.edges) {
    if (edge.crease || edge.right == kNone) continue;
    const Index body = c.faces[edge.left].body;
    if (body != c.faces[f].body && body != c.faces[g].body) continue;
    if (planes_of(edge.left, edge.right) == planes_of(f, g)) return true;
  }
  return false;
}

/// The plane that is seen; kNone: paper.
Index plane_of(const Picture& picture, const Seen& seen) {
  if (seen.kind == Kind::cut) return kNone - 1;
  return seen.face == kNone ? kNone : picture.canonical->faces[seen.face].plane;
}

enum class Between { nothing, facets, bend };

/// The faces' planes meet beside the point; copies have theirs in common far from each other too.
bool meet_beside(const Picture& picture, Index f, Index g, const Vec2& p) {
  const DepthPlane &one = picture.projected->depth(picture.canonical->faces[f].plane),
                   &other = picture.projected->depth(picture.canonical->faces[g].plane);
  const double slope = std::fabs(one.a - other.a) + std::fabs(one.b - other.b);
  return std::fabs(one.at(p.x, p.y) - other.at(p.x, p.y)) <= 4 * kBeside * slope;
}

/// What is between two things that are seen beside one another.
Between between(const Picture& picture, const Seen& here, const Seen& there, const Vec2& p) {
  if (plane_of(picture, here) == plane_of(picture, there)) return Between::nothing;
  const bool faces = here.face != kNone && there.face != kNone;
  return faces && smooth_between(*picture.canonical, here.face, there.face) &&
                 meet_beside(picture, here.face, there.face, p)
             ? Between::facets
             : Between::bend;
}

/// Of two points. Near a tip a facet may lie between them.
Between between(const Picture& picture, const Oracle& oracle, const Vec2& p, const Vec2& q) {
  const Vec2 middle = (p + q) / 2.0;
  const Seen here = oracle.at(p.x, p.y), there = oracle.at(q.x, q.y);
  const Between whole = between(picture, here, there, p);
  if (whole != Between::bend) return whole;
  const Seen halfway = oracle.at(middle.x, middle.y);
  const bool bends = between(picture, here, halfway, p) == Between::bend ||
                     between(picture, halfway, there, p) == Between::bend;
  return bends ? Between::bend : Between::facets;
}

/// Calls visit(x, y, between) for what is beside the ends of runs.
template <class Visit>
void each_end(const Picture& picture, const Oracle& oracle, const Visit& visit) {
  for (const auto& [y, runs] : picture.rows)
    for (const DensityRun& run : runs)
      for (const double x : {run.x0, run.x1})
        if (x > 0 && x < 32)
          visit(x, y, between(picture, oracle, {x - kBeside, y}, {x + kBeside, y}));
}

/// Where a level shows another surface than a little further on, there is a stroke.
int runs_without_strokes(const Picture& picture, const Oracle& oracle, std::string& where) {
  int missing = 0;
  each_end(picture, oracle, [&](double x, double y, Between what) {
    if (what != Between::bend || on_a_stroke(picture, {x, y}, kBeside)) return;
    ++missing;
    where = std::to_string(x) + ", " + std::to_string(y);
  });
  return missing;
}

int facets_along_levels(const Picture& picture, const Oracle& oracle) {
  int facets = 0;
  each_end(picture, oracle,
           [&](double, double, Between what) { facets += what == Between::facets; });
  return facets;
}

/// On the two sides of a stroke two planes are seen, or one of them and none; and not two facets
/// of one curved surface.
int strokes_on_nothing(const Picture& picture, const Oracle& oracle, std::string& where) {
  int wrong = 0;
  for (const Stroke& stroke : picture.strokes)
    for (std::size_t i = 0; i + 1 < stroke.points.size(); ++i) {
      const Vec2 a = stroke.points[i], b = stroke.points[i + 1], along = b - a;
      const double length = glm::length(along);
      if (length < 64 * kBeside) continue;
      const Vec2 middle = a + along * 0.381966, across = Vec2(-along.y, along.x) / length * kBeside;
      const Vec2 p = middle + across, q = middle - across;
      if (std::min({p.x, q.x, p.y, q.y}) < 0 || std::max(p.x, q.x) > 32 || std::max(p.y, q.y) > 40)
        continue;
      if (between(picture, oracle, p, q) == Between::bend) continue;
      ++wrong;
      where = std::to_string(middle.x) + ", " + std::to_string(middle.y) + " of kind " +
              std::to_string(static_cast<int>(stroke.kind));
    }
  return wrong;
}

/// An edge of which no coordinate has an error: its faces reach as near as it does, and no nearer.
TEST(SolidStrokes, AnEdgeAtTheOriginIsSeen) {
  const Picture picture(TreeMaker(1825).make());
  const Oracle oracle(*picture.canonical, picture.view);
  std::string where;
  EXPECT_EQ(runs_without_strokes(picture, oracle, where), 0) << where;
}

TEST(SolidStrokes, RunWhereWhatIsSeenChangesItsPlane) {
  std::size_t strokes = 0;
  for (int n = 0; n < kTrees; ++n) {
    const Scene scene = TreeMaker(static_cast<std::uint64_t>(n) + 1).make();
    const Picture picture(scene);
    const Oracle oracle(*picture.canonical, picture.view);
    strokes += picture.strokes.size();
    std::string where;
    EXPECT_EQ(runs_without_strokes(picture, oracle, where), 0) << "tree " << n << " at " << where;
    EXPECT_EQ(strokes_on_nothing(picture, oracle, where), 0) << "tree " << n << " at " << where;
  }
  EXPECT_GT(strokes, 4u * kTrees);
}

TEST(SolidStrokes, LeaveRoundSurfacesSmooth) {
  int facets = 0;
  std::size_t strokes = 0;
  for (int n = 0; n < kTrees; ++n) {
    const Picture picture(TreeMaker(static_cast<std::uint64_t>(n) + 1).make_round());
    const Oracle oracle(*picture.canonical, picture.view);
    facets += facets_along_levels(picture, oracle);
    strokes += picture.strokes.size();
    std::string where;
    EXPECT_EQ(runs_without_strokes(picture, oracle, where), 0) << "tree " << n << " at " << where;
    EXPECT_EQ(strokes_on_nothing(picture, oracle, where), 0) << "tree " << n << " at " << where;
  }
  EXPECT_GT(facets, 10 * kTrees);
  EXPECT_GT(strokes, 3u * kTrees);
}

/// What is in shadow: on a plane of the input, or on the ground.
struct Shade {
  Index plane;
  bool shadow;
};

Shade shade_of(const Picture& picture, const Seen& seen) {
  if (seen.kind == Kind::cut) return {kNone - 1, false};
  const bool shadow = seen.kind == Kind::shadow || seen.kind == Kind::ground_shadow;
  return {seen.face == kNone ? kNone : picture.canonical->faces[seen.face].plane, shadow};
}

/// Of two points beside one another: one is in shadow, and the other on the same plane is not.
bool shadow_ends_between(const Picture& picture, const Oracle& oracle, const Vec2& p,
                         const Vec2& q) {
  const Shade here = shade_of(picture, oracle.at(p.x, p.y)),
              there = shade_of(picture, oracle.at(q.x, q.y));
  return here.plane == there.plane && here.shadow != there.shadow;
}

/// Where shadow ends on a plane along a level, there is a stroke.
int shadows_without_strokes(const Picture& picture, const Oracle& oracle, int& ends,
                            std::string& where) {
  int missing = 0;
  for (const auto& [y, runs] : picture.rows)
    for (const DensityRun& run : runs)
      for (const double x : {run.x0, run.x1}) {
        if (x <= kBeside || x >= 32 - kBeside) continue;
        if (!shadow_ends_between(picture, oracle, {x - kBeside, y}, {x + kBeside, y})) continue;
        ++ends;
        if (on_a_stroke(picture, {x, y}, kBeside)) continue;
        ++missing;
        where = std::to_string(x) + ", " + std::to_string(y);
      }
  return missing;
}

/// Along a shadow's outline shadow ends on the plane that it lies on.
int outlines_of_nothing(const Picture& picture, const Oracle& oracle, int& outlines,
                        std::string& where) {
  int wrong = 0;
  for (const Stroke& stroke : picture.strokes) {
    if (stroke.kind != StrokeKind::shadow_outline) continue;
    for (std::size_t i = 0; i + 1 < stroke.points.size(); ++i) {
      const Vec2 a = stroke.points[i], along = stroke.points[i + 1] - a;
      const double length = glm::length(along);
      if (length < 64 * kBeside) continue;
      const Vec2 middle = a + along * 0.381966, across = Vec2(-along.y, along.x) / length * kBeside;
      const Vec2 p = middle + across, q = middle - across;
      if (std::min({p.x, q.x, p.y, q.y}) < 0 || std::max(p.x, q.x) > 32 || std::max(p.y, q.y) > 40)
        continue;
      ++outlines;
      if (shadow_ends_between(picture, oracle, p, q)) continue;
      ++wrong;
      where = std::to_string(middle.x) + ", " + std::to_string(middle.y);
    }
  }
  return wrong;
}

TEST(SolidStrokes, OutlineShadowsWhereTheyEndOnAPlane) {
  int ends = 0, outlines = 0;
  for (int n = 0; n < kTrees; ++n) {
    const Scene scene = TreeMaker(static_cast<std::uint64_t>(n) + 1).make_lit();
    const Picture picture(scene);
    const Oracle oracle(*picture.canonical, picture.view);
    std::string where;
    EXPECT_EQ(shadows_without_strokes(picture, oracle, ends, where), 0)
        << "tree " << n << " at " << where;
    EXPECT_EQ(outlines_of_nothing(picture, oracle, outlines, where), 0)
        << "tree " << n << " at " << where;
  }
  EXPECT_GT(ends, 3 * kTrees);
  EXPECT_GT(outlines, kTrees);
}

}  // namespace
}  // namespace overstrike::oracle
