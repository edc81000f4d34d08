// Laws to the last bit: what must not change a single one of the picture's.
#include <gtest/gtest.h>
#include <xmmintrin.h>

#include <cfenv>
#include <cmath>
#include <random>

#include "core/geometry/direction.h"
#include "core/visibility/camera_frame.h"
#include "core/visibility/canonical.h"
#include "core/visibility/view.h"
#include "tests/hard/laws.h"

namespace overstrike::hard {
namespace {

#ifdef OVERSTRIKE_HARD_LONG
constexpr Sample kSample{1, 1, 64};
constexpr int kNearlyParallel = 400;
#else
constexpr Sample kSample{3, 31, 50};
constexpr int kNearlyParallel = 60;
#endif

constexpr ScanFamily kRows{0, 1, 0.5};
constexpr ScanFamily kSlanted{33, 5.3, 0.71};

const std::vector<Subject>& all() {
  static const std::vector<Subject> made = subjects(kSample);
  return made;
}

/// Rows and slanted lines.
Runs picture_of(Drawing& drawing) {
  Runs runs = runs_of(drawing, kRows);
  for (auto& line : runs_of(drawing, kSlanted)) runs.push_back(std::move(line));
  return runs;
}
Runs picture_of(const Scene& scene) {
  Drawing drawing = drawn(scene);
  return picture_of(drawing);
}

/// Every third line alone, and lines at other offsets in between.
TEST(Law, JumpingToALineIsSteppingToIt) {
  expect_law(all(), "jump", [](const Scene& scene) {
    Drawing drawing = drawn(scene);
    const Runs rows = runs_of(drawing, kRows);
    for (std::size_t i = rows.size(); i-- > 0;) {
      if (i % 3 != 0) continue;
      const Runs alone = runs_of(drawing, {0, 1000, 0.5 + static_cast<double>(i)});
      if (alone.size() != 1) return std::string("not one line");
      const std::string what = first_difference({rows[i]}, alone);
      if (!what.empty()) return "row " + std::to_string(i) + " alone: " + what;
    }
    return std::string();
  });
}

/// What is kept from line to line where lines are close (kept_stretch.h) is what lines far apart
/// find anew.
TEST(Law, LinesAmongCloseLinesAreLinesAmongFarOnes) {
  constexpr int kFine = 32;
  expect_law(all(), "close lines", [](const Scene& scene) {
    Drawing drawing = drawn(scene);
    const Runs close = runs_of(drawing, {0, 1.0 / kFine, 0});
    for (const std::size_t at : {3, 16, 29}) {
      const Runs far = runs_of(drawing, {0, 1, static_cast<double>(at) / kFine});
      for (std::size_t i = 0; i < far.size(); ++i) {
        const std::string what = first_difference({far[i]}, {close.at(kFine * i + at)});
        if (!what.empty())
          return "line " + std::to_string(i) + " + " + std::to_string(at) + "/32: " + what;
      }
    }
    return std::string();
  });
}

/// By Rodrigues' formula; the axis is of unit length.
Mat3 turn_about(const Vec3& axis, double angle) {
  const Mat3 across(0, axis.z, -axis.y, -axis.z, 0, axis.x, axis.y, -axis.x, 0);
  return Mat3(1) + across * std::sin(angle) + across * across * (1 - std::cos(angle));
}

/// Bodies turned by next to nothing against each other, so that certificates are tight: prisms,
/// boxes and plates about one place.
Scene nearly_parallel(std::mt19937_64& bits) {
  const auto within = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(bits);
  };
  const auto any = [&](int n) { return static_cast<int>(bits() % static_cast<unsigned>(n)); };
  Scene scene;
  const Mat3 base =
      any(2) == 0 ? Mat3(1) : turn_about(unit(Vec3(within(-1, 1), within(-1, 1), 1)), within(0, 6));
  for (int count = 2 + any(8); count > 0; --count) {
    Body body;
    const double size = within(0.5, 4);
    const Shape shapes[] = {Box{Vec3(size, within(0.3, 4), within(0.3, 4))}, Box{Vec3(4, 4, 1)},
                            Frustum{within(0.5, 2), within(0, 2), within(0.5, 3), 3 + any(30)}};
    body.shape = std::make_shared<const Shape>(shapes[any(3)]);
    const double angle = std::pow(10, -within(3, 16)) * any(3);
    body.placement.linear = base * turn_about(unit(Vec3(1, any(2), any(2))), angle);
    body.placement.offset = any(3) == 0 ? Vec3(any(3) - 1, any(3) - 1, within(-1, 1) * angle)
                                        : Vec3(within(-1, 1), within(-1, 1), within(-1, 1));
    body.density_factor = 1 - 0.25 * any(3);
    scene.bodies.push_back(body);
  }
  scene.camera.parallel = any(2) == 0;
  scene.camera.window_width = within(4, 10);
  scene.camera.look_at = Vec3(0);
  if (any(3) == 0) scene.light = Direction{within(0, 360), within(10, 80)};
  return scene;
}

TEST(Law, CloseLinesOfNearlyParallelBodiesAreLinesAlone) {
  for (int seed = 0; seed < kNearlyParallel; ++seed) {
    std::mt19937_64 bits(static_cast<unsigned>(seed));
    Drawing drawing = drawn(nearly_parallel(bits));
    const double spacing = std::ldexp(1.0, -2 - static_cast<int>(bits() % 8));
    const Runs close = runs_of(drawing, {0, spacing, 0});
    for (std::size_t i = 0; i < close.size(); i += 1 + bits() % 37) {
      const Runs alone = runs_of(drawing, {0, 1000, static_cast<double>(i) * spacing});
      ASSERT_EQ(alone.size(), 1u);
      ASSERT_EQ(first_difference({close[i]}, alone), "") << "seed " << seed << ", line " << i;
    }
  }
}

/// Grid coordinates and what has no length stay; lengths are multiplied.
Scene scaled(Scene scene, double factor) {
  for (Body& b : scene.bodies) b.placement.linear *= factor, b.placement.offset *= factor;
  for (Segment& s : scene.segments) s.from *= factor, s.to *= factor;
  Camera& c = scene.camera;
  for (auto* p : {&c.look_at, &c.eye, &c.target})
    if (*p) **p *= factor;
  for (auto* length : {&c.distance, &c.window_width, &c.near_distance})
    if (*length) **length *= factor;
  if (scene.ground_z) *scene.ground_z *= factor;
  return scene;
}

TEST(Law, PowersOfTwoChangeNoBit) {
  expect_law(all(), "scale", [](const Scene& scene) {
    const Runs as_it_is = picture_of(scene);
    for (const int power : {1, -3, 30, -30, 101}) {
      const std::string what =
          first_difference(as_it_is, picture_of(scaled(scene, std::ldexp(1, power))));
      if (!what.empty()) return "by 2^" + std::to_string(power) + ": " + what;
    }
    return std::string();
  });
}

/// What stands for the camera's point and its distances when the scene's size gives them: written
/// out, so that they can be moved. The picture is another one by rounding.
Scene with_its_own_camera(Scene scene) {
  const CameraFrame frame = camera_frame(scene.camera, stage_of(scene));
  Camera& c = scene.camera;
  if (c.eye) {
    if (!c.target) c.target = frame.origin + frame.target;
  } else {
    if (!c.look_at) c.look_at = frame.origin;
    c.distance = frame.distance;
  }
  return scene;
}

Scene moved(Scene scene, const Vec3& by) {
  for (Body& b : scene.bodies) b.placement.offset += by;
  for (Segment& s : scene.segments) s.from += by, s.to += by;
  for (auto* p : {&scene.camera.look_at, &scene.camera.eye, &scene.camera.target})
    if (*p) **p += by;
  if (scene.ground_z) *scene.ground_z += by.z;
  return scene;
}

bool moves_exactly(const Vec3& p, const Vec3& by) {
  const Vec3 there = p + by;
  return there - by == p && there - p == by;
}

/// The law's condition: the moved places, camera and ground are exactly representable, and the move
/// is a multiple of the step that origins have (stage_of).
bool moves_exactly(const Scene& scene, const Vec3& by) {
  bool exact = stage_of(moved(scene, by)).origin - stage_of(scene).origin == by;
  for (const Body& b : scene.bodies) exact = exact && moves_exactly(b.placement.offset, by);
  for (const Segment& s : scene.segments)
    exact = exact && moves_exactly(s.from, by) && moves_exactly(s.to, by);
  for (const auto& p : {scene.camera.look_at, scene.camera.eye, scene.camera.target})
    if (p) exact = exact && moves_exactly(*p, by);
  if (scene.ground_z) exact = exact && moves_exactly(Vec3(0, 0, *scene.ground_z), by);
  return exact;
}

/// Which faces share a plane.
std::vector<Index> planes_of(const Scene& scene) {
  std::vector<Diagnostic> warnings;
  std::vector<Index> planes;
  for (const CanonicalFace& f :
       canonicalize(scene, make_view(scene, kGrid), kTolerance, warnings).faces)
    planes.push_back(f.plane);
  return planes;
}

/// To so few places that it stays exact when it is moved.
Vec3 rounded(const Vec3& p) { return glm::roundEven(p * 0x1p10) * 0x1p-10; }

/// Places on 2^-10, so that a million times the size leaves them exact.
Scene on_few_places(Scene scene) {
  for (Body& b : scene.bodies) b.placement.offset = rounded(b.placement.offset);
  for (auto* p : {&scene.camera.look_at, &scene.camera.eye, &scene.camera.target})
    if (*p) **p = rounded(**p);
  if (scene.ground_z) *scene.ground_z = rounded(Vec3(*scene.ground_z)).x;
  return scene;
}

TEST(Law, MovingSceneAndCameraChangesNoBit) {
  int tried = 0;
  expect_law(all(), "move", [&tried](const Scene& read) {
    const Scene scene = on_few_places(with_its_own_camera(read));
    const Runs as_it_is = picture_of(scene);
    for (const Vec3& by : {Vec3(1, -2, 3), Vec3(1024, 2048, -512), Vec3(3e6, 5e6, 7e6)}) {
      // Farther away, more planes are one within the rounding that their vertices may have.
      if (!moves_exactly(scene, by) || planes_of(scene) != planes_of(moved(scene, by))) continue;
      ++tried;
      const std::string what = first_difference(as_it_is, picture_of(moved(scene, by)));
      if (!what.empty()) return "by " + std::to_string(by.x) + " ...: " + what;
    }
    return std::string();
  });
  EXPECT_GT(tried, 2 * static_cast<int>(all().size()));
}

/// The law's condition: vertices on so few places that four rows more or less lose none of them.
bool lies_on_few_places(const Scene& scene, const View& view) {
  std::vector<Diagnostic> warnings;
  const Canonical c = canonicalize(scene, view, kTolerance, warnings);
  return std::all_of(c.vertices.begin(), c.vertices.end(), [&view](const Vec3& v) {
    const Vec3 p = view.project(v) * 0x1p20;
    return p == glm::roundEven(p);
  });
}

TEST(Law, APictureOfMoreRowsHasTheSameRows) {
  int tried = 0;
  expect_law(all(), "more rows", [&tried](Scene scene) {
    scene.light.reset();  // shadows' corners have all the places there are
    if (!scene.camera.window_width || !scene.camera.parallel) return std::string();
    const Grid higher{kGrid.columns, kGrid.rows + 8, 1, 1};
    if (!lies_on_few_places(scene, make_view(scene, kGrid))) return std::string();
    ++tried;
    Drawing low = drawn(scene), high = drawn(scene, 1, higher);
    const Runs rows = runs_of(low, kRows);
    Runs same = runs_of(high, kRows);
    same.erase(same.begin(), same.begin() + 4);
    same.resize(rows.size());
    return first_difference(rows, same);
  });
  EXPECT_GT(tried, 0);
}

TEST(Law, WholeRowsMoveARow) {
  expect_law(all(), "rows", [](const Scene& scene) {
    const Runs rows = runs_of(scene, kRows);
    Drawing drawing = drawn(scene);
    for (const double offset : {-3.5, 5.5}) {
      const Runs shifted = runs_of(drawing, {0, 1, offset});
      const std::string what = first_difference(rows, shifted);
      if (shifted.size() != rows.size()) return std::string("other numbers of rows");
      if (!what.empty()) return what;
    }
    return std::string();
  });
}

TEST(Law, ThreadsChangeNoBit) {
  expect_law(all(), "threads", [](const Scene& scene) {
    Drawing one = drawn(scene, 1), many = drawn(scene, 5);
    std::string what = first_difference(picture_of(one), picture_of(many));
    if (what.empty()) what = first_difference(cells_of(one), cells_of(many));
    if (!what.empty()) return what;
    const auto a = one.strokes({}), b = many.strokes({});
    const bool same =
        std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Stroke& s, const Stroke& t) {
          return s.points == t.points && s.kind == t.kind && s.body == t.body;
        });
    return std::string(same ? "" : "strokes differ");
  });
}

/// Restores the environment when the test is done with it.
class Environment {
 public:
  Environment() { std::fegetenv(&before_), csr_ = _mm_getcsr(); }
  ~Environment() { _mm_setcsr(csr_), std::fesetenv(&before_); }

 private:
  std::fenv_t before_;
  unsigned csr_;
};

constexpr unsigned kFlushToZero = 0x8000, kDenormalsAreZero = 0x0040;

/// Draws in whatever environment is set; what is set stays set.
std::string differs_here(const Scene& scene, const Runs& rows, const std::vector<float>& cells) {
  const int rounding = std::fegetround();
  const unsigned csr = _mm_getcsr() & ~0x3Fu;  // but for the flags that say what happened
  Drawing drawing = drawn(scene, 2);
  const Runs found = picture_of(drawing);
  const std::vector<float> found_cells = cells_of(drawing);
  if (std::fegetround() != rounding || (_mm_getcsr() & ~0x3Fu) != csr) return "it is not restored";
  const std::string what = first_difference(rows, found);
  return what.empty() ? first_difference(cells, found_cells) : what;
}

TEST(Law, TheCallersFloatingPointEnvironmentHasNoSay) {
  expect_law(all(), "environment", [](const Scene& scene) {
    Drawing drawing = drawn(scene);
    const Runs rows = picture_of(drawing);
    const std::vector<float> cells = cells_of(drawing);
    const Environment restored;
    for (const int rounding : {FE_DOWNWARD, FE_UPWARD, FE_TOWARDZERO}) {
      std::fesetround(rounding);
      const std::string what = differs_here(scene, rows, cells);
      if (!what.empty()) return "rounding " + std::to_string(rounding) + ": " + what;
    }
    std::fesetround(FE_TONEAREST);
    _mm_setcsr(_mm_getcsr() | kFlushToZero | kDenormalsAreZero);
    const std::string what = differs_here(scene, rows, cells);
    return what.empty() ? what : "flush to zero: " + what;
  });
}

}  // namespace
}  // namespace overstrike::hard
