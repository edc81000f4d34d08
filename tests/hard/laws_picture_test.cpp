// Laws within rounding: other ways to say one scene, which must look the same.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <random>

#include "core/geometry/tessellate.h"
#include "core/visibility/canonical.h"
#include "core/visibility/view.h"
#include "tests/hard/remade.h"
#include "tests/hard/same_picture.h"
#include "tests/hard/variant.h"

namespace overstrike::hard {
namespace {

#ifdef OVERSTRIKE_HARD_LONG
constexpr Sample kSample{1, 1, 64};
#else
constexpr Sample kSample{3, 31, 50};
#endif

const std::vector<Subject>& all() {
  static const std::vector<Subject> made = subjects(kSample);
  return made;
}

/// Those that need no repairs, which hang on the order of faces.
std::vector<Subject> flawless() {
  std::vector<Subject> some = all();
  std::erase_if(some, [](const Subject& s) {
    std::vector<Diagnostic> warnings;
    canonicalize(s.scene, make_view(s.scene, kGrid), kTolerance, warnings);
    return !warnings.empty();
  });
  return some;
}

/// New vertices are rounded where they are. Where the eye stands so close to what it sees that the
/// rounding shows, a scene with new ones is another picture.
std::vector<Subject> bearing_new_vertices(std::vector<Subject> some) {
  std::erase_if(some, [](const Subject& s) {
    const auto& near = s.scene.camera.near_distance;
    return near && size_of(s.scene) * 0x1p-53 > oracle::kEndError * *near;
  });
  return some;
}

Polyhedron as_they_are(const Polyhedron& p) { return p; }

/// Equal places, tones and kinds to the last bit, and numbers that stand for each other.
std::string other_than_numbers(const Runs& a, const Runs& b) {
  if (a.size() != b.size()) return "other numbers of lines";
  std::map<std::uint32_t, std::uint32_t> surfaces, bodies;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i].size() != b[i].size()) return "other runs on line " + std::to_string(i);
    for (std::size_t k = 0; k < a[i].size(); ++k) {
      const DensityRun &r = a[i][k], &s = b[i][k];
      if (r.x0 != s.x0 || r.x1 != s.x1 || r.density0 != s.density0 || r.density1 != s.density1 ||
          r.kind != s.kind)
        return "line " + std::to_string(i) + " differs at " + std::to_string(r.x0);
      if (surfaces.emplace(r.surface, s.surface).first->second != s.surface ||
          bodies.emplace(r.body, s.body).first->second != s.body)
        return "line " + std::to_string(i) + " has other bodies at " + std::to_string(r.x0);
    }
  }
  return {};
}

TEST(Law, TheOrderOfBodiesHasNoSay) {
  expect_law(all(), "order of bodies", [](const Scene& scene) {
    const Runs as_it_is = runs_of(scene, kOddRows);
    Scene other = scene;
    std::reverse(other.bodies.begin(), other.bodies.end());
    std::string what = other_than_numbers(as_it_is, runs_of(other, kOddRows));
    std::mt19937_64 bits(scene.bodies.size());
    for (std::size_t i = other.bodies.size(); i > 1; --i)
      std::swap(other.bodies[i - 1], other.bodies[bits() % i]);
    return what.empty() ? other_than_numbers(as_it_is, runs_of(other, kOddRows)) : what;
  });
}

/// Whose stroke is kept where two lie on one another goes by what the bodies are.
TEST(Law, TheOrderOfBodiesHasNoSayInStrokes) {
  Scene scene;
  const ShapePtr box = std::make_shared<const Shape>(Box{Vec3(3)});
  for (const double factor : {0.9, 0.5, 0.7}) {
    Body body;
    body.shape = box, body.density_factor = factor;
    body.pen = static_cast<int>(10 * factor);
    scene.bodies.push_back(body);
  }
  scene.camera.parallel = true, scene.camera.window_width = 8;
  const auto pens = [](const Scene& s) {
    Drawing drawing = drawn(s);
    std::vector<std::pair<std::vector<Vec2>, int>> all;
    for (const Stroke& stroke : drawing.strokes({})) all.emplace_back(stroke.points, stroke.pen);
    return all;
  };
  const auto as_it_is = pens(scene);
  ASSERT_FALSE(as_it_is.empty());
  for (const auto& [points, pen] : as_it_is) EXPECT_EQ(pen, 9);
  Scene other = scene;
  std::reverse(other.bodies.begin(), other.bodies.end());
  EXPECT_EQ(pens(other), as_it_is);
}

TEST(Law, TheOrderOfFacesHasNoSay) {
  expect_law(all(), "order of faces", [](const Scene& scene) {
    const Runs as_it_is = runs_of(with_meshes(scene, as_they_are), kOddRows);
    return other_than_numbers(as_it_is, runs_of(with_meshes(scene, shuffled), kOddRows));
  });
}

/// Planes and edges are rounded otherwise when they begin elsewhere.
TEST(Law, WhereFacesBeginHasNoSay) {
  expect_law(flawless(), "renumbered", [](const Scene& scene) {
    const SamePicture picture(with_meshes(scene, as_they_are));
    return picture.difference(runs_of(with_meshes(scene, renumbered), kOddRows), oracle::kEndError);
  });
}

/// The picture from right to left.
Runs flipped(Runs runs) {
  for (auto& line : runs) {
    std::reverse(line.begin(), line.end());
    for (DensityRun& r : line) {
      std::swap(r.x0, r.x1), std::swap(r.density0, r.density1);
      r.x0 = kGrid.columns - r.x0, r.x1 = kGrid.columns - r.x1;
    }
  }
  return runs;
}

TEST(Law, MirroredScenesGiveMirroredPictures) {
  expect_law(all(), "mirror", [](const Scene& scene) {
    const SamePicture picture(scene);
    return picture.difference(flipped(runs_of(mirrored(scene), kOddRows)), oracle::kEndError);
  });
}

/// The same canonical input, three rows farther down.
TEST(Law, ShiftingByWholeRowsShiftsThePicture) {
  expect_law(all(), "whole rows", [](const Scene& scene) {
    constexpr int kRows = 3;
    View view = make_view(scene, kGrid);
    std::vector<Diagnostic> warnings;
    auto canonical =
        std::make_shared<const Canonical>(canonicalize(scene, view, kTolerance, warnings));
    for (int column = 0; column < 4; ++column)
      view.matrix[column][1] += kRows * view.matrix[column][2];
    view.grid.rows += kRows;
    DrawOptions options;
    options.tolerance = kTolerance;
    Drawing drawing(canonical, view, options);
    Runs runs = runs_of(drawing, kOddRows);
    runs.erase(runs.begin(), runs.begin() + kRows);
    return SamePicture(scene).difference(runs, oracle::kEndError);
  });
}

TEST(Law, CuttingFacesChangesNothing) {
  expect_law(bearing_new_vertices(flawless()), "cut faces", [](const Scene& scene) {
    const SamePicture picture(with_meshes(scene, as_they_are));
    return picture.difference(runs_of(with_meshes(scene, subdivided), kOddRows), oracle::kEndError);
  });
}

TEST(Law, GluedHalvesAreAWhole) {
  expect_law(bearing_new_vertices(all()), "glued halves", [](const Scene& scene) {
    const SamePicture picture(scene);
    return picture.difference(runs_of(in_halves(scene), kOddRows), oracle::kEndError);
  });
}

}  // namespace
}  // namespace overstrike::hard
