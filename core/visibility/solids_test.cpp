// Laws of Boolean solids that need no oracle: both sides draw the same.
#include <gtest/gtest.h>

#include <array>
#include <random>

#include "core/drawing.h"
#include "core/visibility/canonical.h"
#include "core/visibility/run_shader.h"
#include "core/visibility/test_scenes.h"
#include "core/visibility/view.h"

namespace overstrike {
namespace {

constexpr Grid kGrid{40, 40};

using testing::operand_tree;
using testing::tree_of;
using Nodes = std::vector<SolidNode>;

/// Trees over three bodies; a body that stands in a tree twice has two copies.
class Trees {
 public:
  explicit Trees(std::uint64_t seed) : random_(seed) {
    for (Body& body : bodies_) body = random_body();
  }

  Nodes a() { return operand_tree(0); }
  Nodes b() { return operand_tree(1); }
  Nodes c() { return operand_tree(2); }

  /// Ends and tones, line after line, of the tree as a picture.
  std::vector<double> drawn(const Nodes& nodes, int threads = 1) const {
    Scene scene;
    testing::add_solid(scene, nodes, bodies_);
    scene.camera = camera_;
    DrawOptions options;
    options.threads = threads;
    Drawing drawing(scene, kGrid, options);
    std::vector<double> result;
    drawing.runs({0, 1, 0.5}, [&](const RunRow& row) {
      result.push_back(static_cast<double>(row.index));
      for (const DensityRun& run : row.runs)
        for (const double value : {run.x0, run.x1, run.density0, run.density1})
          result.push_back(value);
    });
    return result;
  }
  bool is_bare(const Nodes& nodes) const { return drawn(nodes).size() == kGrid.rows; }

 private:
  double lattice() { return static_cast<double>(random_() % 4); }
  Body random_body() {
    Body body;
    const double height = 1 + lattice();
    if (random_() % 2 == 0)
      body.shape = std::make_shared<Shape>(Box{{2, 1 + lattice(), height}});
    else
      body.shape = std::make_shared<Shape>(Frustum{2, 1 + lattice() / 2, height, 5});
    body.placement.offset = {lattice(), lattice(), lattice() / 2};
    body.density_factor = 0.25 * (1 + lattice());
    return body;
  }

  std::mt19937_64 random_;
  std::array<Body, 3> bodies_;
  Camera camera_{Vec3(2, 2, 2), 20.0, {31, 27}, {}, {}, {0, 0, 1}, true, 9.0, {}, {}};
};

constexpr SetOperation kUnite = SetOperation::unite, kSubtract = SetOperation::subtract,
                       kIntersect = SetOperation::intersect;

TEST(Solids, KeepTheLawsOfSets) {
  int bare = 0;
  for (std::uint64_t n = 0; n < 60; ++n) {
    SCOPED_TRACE(n);
    Trees t(n);
    const Nodes a = t.a(), b = t.b(), c = t.c();
    const auto unite = [](const Nodes& p, const Nodes& q) { return tree_of(kUnite, {p, q}); };
    const auto less = [](const Nodes& p, const Nodes& q) { return tree_of(kSubtract, {p, q}); };
    const auto both = [](const Nodes& p, const Nodes& q) { return tree_of(kIntersect, {p, q}); };
    const auto same = [&](const Nodes& p, const Nodes& q) { return t.drawn(p) == t.drawn(q); };
    EXPECT_TRUE(same(unite(a, a), a));
    EXPECT_TRUE(same(both(a, a), a));
    EXPECT_TRUE(t.is_bare(less(a, a)));
    EXPECT_TRUE(same(unite(a, both(a, b)), a)) << "absorption";
    EXPECT_TRUE(same(both(a, unite(a, b)), a)) << "absorption";
    EXPECT_TRUE(same(less(a, unite(b, c)), both(less(a, b), less(a, c)))) << "De Morgan";
    EXPECT_TRUE(same(less(a, both(b, c)), unite(less(a, b), less(a, c)))) << "De Morgan";
    EXPECT_TRUE(same(both(a, unite(b, c)), unite(both(a, b), both(a, c)))) << "distribution";
    EXPECT_TRUE(same(unite(a, both(b, c)), both(unite(a, b), unite(a, c)))) << "distribution";
    EXPECT_TRUE(same(unite(less(a, b), both(a, b)), a));
    EXPECT_TRUE(same(tree_of(kUnite, {a, b, c}), tree_of(kUnite, {c, a, b}))) << "order";
    EXPECT_TRUE(same(tree_of(kSubtract, {a, b, c}), tree_of(kSubtract, {a, c, b}))) << "order";
    EXPECT_EQ(t.drawn(less(a, b), 2), t.drawn(less(a, b), 1)) << "threads";
    bare += t.is_bare(both(a, b));
  }
  EXPECT_LT(bare, 40);
}

/// What OpenSCAD's preview and POV-Ray draw closed.
TEST(Solids, AHoleThatEndsFlushWithBothFacesIsOpen) {
  Scene scene;
  for (const double size : {10.0, 6.0}) {
    Body body;
    body.shape = std::make_shared<Shape>(Box{{size, size, 10}});
    scene.bodies.push_back(body);
  }
  scene.solids.push_back(
      {{{kSubtract, 0, 3}, {SetOperation::operand, 0, 2}, {SetOperation::operand, 1, 3}},
       {},
       {},
       0});
  scene.camera = {Vec3(0), 50.0, {0, 90}, {}, {}, {0, 0, 1}, true, 20.0, {}, {}};
  Drawing drawing(scene, kGrid, {});
  drawing.runs({0, 100, 20.25}, [&](const RunRow& row) {
    ASSERT_EQ(row.runs.size(), 2u);
    EXPECT_DOUBLE_EQ(row.runs[0].x0, 10);
    EXPECT_DOUBLE_EQ(row.runs[0].x1, 14);
    EXPECT_DOUBLE_EQ(row.runs[1].x0, 26);
    EXPECT_DOUBLE_EQ(row.runs[1].x1, 30);
  });
}

/// A file may write a mesh out once for every place in which it stands in a tree.
TEST(Solids, EqualMeshesInOnePlaceAreOneOperand) {
  Mesh tetrahedron;
  tetrahedron.polyhedron.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (const auto& face : {std::array<Index, 3>{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}})
    tetrahedron.polyhedron.add_face(face);
  Mesh larger = tetrahedron;
  larger.polyhedron.vertices[3].z = 2;
  Scene scene;
  for (const Mesh& mesh : {tetrahedron, tetrahedron, larger}) testing::add(scene, mesh);
  const auto of = [](std::uint32_t body) { return operand_tree(body); };
  scene.solids.push_back({tree_of(kUnite, {of(0), of(1), of(2)}), {}, {}});
  std::vector<Diagnostic> warnings;
  const Canonical canonical = canonicalize(scene, make_view(scene, kGrid), 1, warnings);
  EXPECT_EQ(canonical.bodies.size(), 2u);
  EXPECT_EQ(canonical.solids[0]->expression.operands(), 2u);
}

/// A block with a smooth bore, seen along it and lit from where it is seen.
Scene bored_block(double near_distance) {
  Scene scene;
  testing::add(scene, Box{{4, 4, 8}}, {0, 0, -4});
  testing::add(scene, Frustum{1, 1, 10}, {0, 0, -5}).shading = Shading::smooth;
  scene.solids.push_back(
      {tree_of(SetOperation::subtract, {operand_tree(0), operand_tree(1)}), {}, {}});
  scene.camera.eye = Vec3(0, 0, 10);
  scene.camera.target = Vec3(0.0);
  scene.camera.up = Vec3(0, 1, 0);
  scene.camera.fov_deg = 20;
  scene.camera.near_distance = near_distance;
  scene.light = Direction{30, 70};
  return scene;
}

TEST(Solids, TheInsideOfABoreHasItsToneWhereTheSolidIsCutBeforeTheEye) {
  const auto rows = [](double near_distance) {
    std::vector<std::vector<DensityRun>> result;
    Drawing drawing(bored_block(near_distance), kGrid, {});
    drawing.runs({},
                 [&](const RunRow& row) { result.emplace_back(row.runs.begin(), row.runs.end()); });
    return result;
  };
  const auto at = [](const std::vector<DensityRun>& runs, double x) {
    for (const DensityRun& r : runs)
      if (r.x0 <= x && x < r.x1)
        return std::pair(r.kind,
                         r.density0 + (r.density1 - r.density0) * ((x - r.x0) / (r.x1 - r.x0)));
    return std::pair(Kind::cut, 0.0);
  };
  const auto whole = rows(0.1), cut = rows(6.5);
  // Each bends by so much between its ends at most.
  const double tolerance = 2 * density_tolerance_of(DrawOptions{}.tolerance);
  int lit = 0;
  for (std::size_t row = 0; row < whole.size(); ++row)
    for (double x = 0.25; x < kGrid.columns; x += 0.5) {
      const auto [kind, density] = at(whole[row], x);
      const auto [kind_cut, density_cut] = at(cut[row], x);
      if (kind != Kind::lit || kind_cut == Kind::cut) continue;
      EXPECT_EQ(kind_cut, Kind::lit);
      EXPECT_NEAR(density_cut, density, tolerance) << row << " " << x;
      ++lit;
    }
  EXPECT_GT(lit, 50);
}

/// Six quadrilaterals over any eight points, as a solid.
Scene twisted(const std::vector<Vec3>& vertices, const Vec3& at, double turn_deg) {
  Mesh mesh;
  mesh.polyhedron.vertices = vertices;
  for (const auto& face : {std::array<Index, 4>{0, 2, 3, 1},
                           {4, 5, 7, 6},
                           {0, 1, 5, 4},
                           {2, 6, 7, 3},
                           {0, 4, 6, 2},
                           {1, 3, 7, 5}})
    mesh.polyhedron.add_face(face);
  Scene scene;
  testing::add(scene, std::move(mesh), at, turn_deg);
  scene.solids.push_back({operand_tree(0), {}, {}, 0});
  scene.camera.parallel = true;
  return scene;
}

/// Faces and ends on lines a sixteenth of a cell apart.
std::vector<double> drawn_closely(const Scene& scene, Coherence coherence) {
  DrawOptions options;
  options.coherence = coherence;
  Drawing drawing(scene, {16, 12, 1, 1}, options);
  std::vector<double> result;
  drawing.runs({0, 1.0 / 16, 1.0 / 32}, [&](const RunRow& row) {
    for (const DensityRun& run : row.runs)
      for (const double value : {run.x0, run.x1, static_cast<double>(run.surface)})
        result.push_back(value);
  });
  return result;
}

/// Of a mesh that passes through itself two planes cross as near to the end of a span as that is
/// uncertain. What goes on from a kept span must not know more of it than a level by itself does.
TEST(Solids, KeptSpansGoOnAsALevelByItselfDoes) {
  Scene scene = twisted({{2, 1, -1},
                         {-1, -1, 1},
                         {2, -1, -1.000000000001},
                         {0, 2, -2},
                         {0, -2, 1},
                         {0, -1, -2},
                         {-2, 2.0000000000000004, -1e-12},
                         {0, 0, 0}},
                        {0, -1, 0}, 180);
  scene.camera.from = {180, 45};
  scene.camera.look_at = Vec3(0.5, 0.5, 0);
  scene.camera.window_width = 16;
  EXPECT_EQ(drawn_closely(scene, Coherence::all), drawn_closely(scene, Coherence::span_and_behind));
}

/// Four planes cross within the doubt of three edges. Faces that come next to one another when what
/// lay between them ends there are put in order as if they had been in none.
TEST(Solids, FacesThatMeetWhereASpanEndsAreInOrderInTheNext) {
  Scene scene = twisted({{1, 1, 2},
                         {-1, 1.999999999999, 2},
                         {1.0000000000000002, 1.000000000001, -1},
                         {-2, -2, 1},
                         {-2, -1, 0},
                         {-1e-12, 2, -1},
                         {1, 1.000000000001, -1e-12},
                         {-2.000000000001, 1, -1.999999999999}},
                        {0, 2.0000000000000004, 0}, 0);
  scene.camera.from = {0, 0};
  scene.camera.look_at = Vec3(0.0);
  scene.camera.window_width = 8;
  const std::vector<double> anew = drawn_closely(scene, Coherence::none);
  EXPECT_EQ(drawn_closely(scene, Coherence::span_and_behind), anew);
  EXPECT_EQ(drawn_closely(scene, Coherence::all), anew);
}

/// A box and a sheet, united.
Scene with_open_operand() {
  Scene scene;
  Body box, sheet;
  box.shape = std::make_shared<Shape>(Box{});
  sheet.shape = std::make_shared<Shape>(FlatPolygon{{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0.5}}}});
  sheet.name = "lid";
  scene.bodies = {box, sheet};
  scene.solids.push_back({tree_of(kUnite, {operand_tree(0), operand_tree(1)}), {}, {}});
  return scene;
}
constexpr const char* kOpen =
    "polygon 'lid' is not closed, so that it has no inside to unite, subtract or "
    "intersect: 3 of its edges have one face only: (0, 0, 0) to (1, 0, 0), (0, 1, 0.5) "
    "to (0, 0, 0), (1, 0, 0) to (0, 1, 0.5)";

TEST(Solids, AnOperandThatIsOpenIsRefusedByItsEdges) {
  try {
    const Drawing drawing(with_open_operand(), kGrid, {});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.diagnostics().front().message, kOpen);
  }
}

TEST(Solids, ABackgroundGoesWithoutWhatIsOpen) {
  Scene scene = with_open_operand();
  scene.solids[0].background = true;
  scene.solids[0].translucent = 0.5;
  Drawing drawing(scene, kGrid, {});
  ASSERT_EQ(drawing.warnings().size(), 1u);
  EXPECT_EQ(drawing.warnings().front().message, std::string(kOpen) + ": not drawn");
  double drawn = 0;
  drawing.runs({}, [&](const RunRow& row) {
    for (const DensityRun& run : row.runs) drawn += run.x1 - run.x0;
  });
  EXPECT_GT(drawn, 0);
}

}  // namespace
}  // namespace overstrike
