// Welding, apart from the oracle: rounding on the way in moves coincident faces apart, and every
// pose of a case must still be the picture of the case as it stands. And flawed bodies, whose
// damage must be theirs alone.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "core/visibility/camera_frame.h"
#include "tests/hard/same_picture.h"
#include "tests/hard/variant.h"

namespace overstrike::hard {
namespace {

#ifdef OVERSTRIKE_HARD_LONG
constexpr std::size_t kPosesOfCase = 96;
#else
constexpr std::size_t kPosesOfCase = 2;
#endif
constexpr std::size_t kMostBodies = 64;

/// What a coordinate may lose when a pose is made: of a place some products and sums more than
/// canonicalize allows for (kPlacementRoundings there), in units of half the last place.
constexpr double kPoseRoundings = 72;

/// In sizes of the scene.
double rounding_of(const Variant& v) { return kPoseRoundings * 0x1p-53 * (1 + v.move); }

std::vector<Variant> poses_for(const Case& hard) {
  std::vector<Variant> poses = all_variants();
  std::erase_if(poses, [&hard](const Variant& v) { return !(rounding_of(v) < hard.finest); });
  std::seed_seq seed(hard.name.begin(), hard.name.end());
  std::mt19937_64 bits(seed);
  std::shuffle(poses.begin(), poses.end(), bits);
  poses.resize(std::min(poses.size(), kPosesOfCase));
  return poses;
}

TEST(Welding, EveryPoseIsThePictureAsItStands) {
  std::vector<Subject> cases;
  for (const Case& c : corpus())
    if (c.scene.bodies.size() <= kMostBodies) cases.push_back({c.name, c.scene});
  auto hard = corpus().begin();
  expect_law(cases, "welding", [&hard](const Scene& scene) {
    while (hard->scene.bodies.size() > kMostBodies) ++hard;
    const Case& c = *hard++;
    const SamePicture picture(scene);
    for (const Variant& pose : poses_for(c)) {
      const double error =
          oracle::kEndError + rounding_of(pose) * size_of(scene) * picture.magnification();
      const std::string what = picture.difference(runs_of(posed(scene, pose), kOddRows), error);
      if (!what.empty()) return describe(pose) + ": " + what;
    }
    return std::string();
  });
}

bool is_flawed(const Case& hard, const Body& body) {
  return std::find(hard.apart.begin(), hard.apart.end(), body.name) != hard.apart.end();
}

/// The columns that the flawed bodies' corners cover.
std::pair<double, double> columns_of_flawed(const Case& hard, const View& view) {
  std::vector<Diagnostic> warnings;
  const Canonical c = canonicalize(hard.scene, view, kTolerance, warnings);
  double from = INFINITY, to = -INFINITY;
  for (const CanonicalBody& b : c.bodies) {
    if (!is_flawed(hard, hard.scene.bodies[b.source])) continue;
    for (Index v = b.first_vertex; v < b.end_vertex; ++v) {
      const double x = view.project(c.vertices[v]).x;
      from = std::min(from, x), to = std::max(to, x);
    }
  }
  return {from, to};
}

void expect_bounded_damage(const Case& hard) {
  Scene with = hard.scene;
  const CameraFrame frame = camera_frame(with.camera, stage_of(with));
  with.camera.eye = frame.origin + frame.eye;
  with.camera.target = frame.origin + frame.target;
  Scene without = with;
  std::erase_if(without.bodies, [&hard](const Body& b) { return is_flawed(hard, b); });
  ASSERT_LT(without.bodies.size(), with.bodies.size()) << hard.name;
  const auto [from, to] = columns_of_flawed(hard, make_view(with, kGrid));
  ASSERT_LT(to - from, kGrid.columns);
  const Runs a = runs_of(with, kOddRows), b = runs_of(without, kOddRows);
  for (std::size_t i = 0; i < a.size(); ++i)
    for (const Stretch& s : differences(a[i], b[i], 0)) {
      EXPECT_GE(s.from, from - oracle::kEndError) << hard.name << ", row " << i;
      EXPECT_LE(s.to, to + oracle::kEndError) << hard.name << ", row " << i;
    }
}

void expect_named(const Case& hard) {
  std::vector<Diagnostic> warnings;
  canonicalize(hard.scene, make_view(hard.scene, kGrid), kTolerance, warnings);
  for (const std::string& name : hard.apart)
    EXPECT_TRUE(std::any_of(warnings.begin(), warnings.end(),
                            [&name](const Diagnostic& d) {
                              return d.message.find("'" + name + "'") != std::string::npos;
                            }))
        << hard.name << ": no warning names '" << name << "'";
}

TEST(Flaws, DamageIsBoundedAndNamed) {
  int flawed = 0;
  for (const Case& hard : corpus()) {
    if (hard.apart.empty()) continue;
    ++flawed;
    expect_bounded_damage(hard);
    expect_named(hard);
  }
  EXPECT_GT(flawed, 1);
}

}  // namespace
}  // namespace overstrike::hard
