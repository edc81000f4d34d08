#include "core/visibility/edge_resolver.h"

#include <gtest/gtest.h>

#include <random>

#include "core/visibility/candidate_lines.h"

namespace overstrike {
namespace {

/// Rays in space against every face, one after the other: the same question asked without
/// projection, index or identity of planes.
class BruteForce {
 public:
  /// `eye` as View::eye has it; the light is one too.
  BruteForce(const Canonical& c, const Vec4& eye) : c_(c), eye_(eye) {}

  enum class Answer { seen, hidden, close };

  /// `close` when some face's border or plane is nearer than what the comparison can bear.
  Answer look_from(const Vec3& p) const {
    const Vec3 to_eye = Vec3(eye_) - p * eye_.w;
    Answer answer = Answer::seen;
    if (c_.ground_z && eye_.z > *c_.ground_z * eye_.w) {
      if (std::fabs(p.z - *c_.ground_z) < kClose) return Answer::close;
      if (p.z < *c_.ground_z) answer = Answer::hidden;
    }
    for (const CanonicalFace& f : c_.faces) {
      const Plane& plane = c_.planes[f.plane];
      const double speed = glm::dot(plane.normal, to_eye);
      const double height = plane.offset - glm::dot(plane.normal, p);
      if (std::fabs(height) < 1e-12) continue;  // in its plane
      const double u = height / speed;
      if (!(u > 0) || (eye_.w != 0 && u >= 1)) continue;
      const Answer at = meets(f, p + to_eye * u, plane.normal);
      if (at == Answer::close || std::fabs(height) < kClose) {
        if (at != Answer::seen) return Answer::close;
      } else if (at == Answer::hidden) {
        answer = Answer::hidden;
      }
    }
    return answer;
  }

 private:
  static constexpr double kClose = 1e-7;

  Answer meets(const CanonicalFace& f, const Vec3& q, const Vec3& normal) const {
    const Vec3 size = glm::abs(normal);
    const int drop = size.x > size.y && size.x > size.z ? 0 : size.y > size.z ? 1 : 2;
    const auto flat = [&](const Vec3& v) {
      return drop == 0 ? Vec2(v.y, v.z) : drop == 1 ? Vec2(v.z, v.x) : Vec2(v.x, v.y);
    };
    const Vec2 at = flat(q);
    bool in = false;
    for (Index l = f.first_loop; l < f.end_loop; ++l) {
      const auto loop = c_.loop(l);
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const Vec2 a = flat(c_.vertices[loop[i]]) - at;
        const Vec2 b = flat(c_.vertices[loop[(i + 1) % loop.size()]]) - at;
        const Vec2 along = b - a;
        const double t = std::clamp(-glm::dot(a, along) / glm::dot(along, along), 0.0, 1.0);
        if (glm::length(a + along * t) < kClose) return Answer::close;
        if ((a.y > 0) != (b.y > 0) && (a.x * b.y - a.y * b.x > 0) == (b.y > a.y)) in = !in;
      }
    }
    return in ? Answer::hidden : Answer::seen;
  }

  const Canonical& c_;
  const Vec4 eye_;
};

ShapePtr some_shape(int i, const std::function<double()>& u) {
  if (i % 4 == 1) return std::make_shared<const Shape>(Frustum{1, 0.3, 1.2, 5});
  if (i % 4 == 2) return std::make_shared<const Shape>(Torus{1, 0.3});
  if (i % 4 == 3) {
    const Region frame{{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}, {{-.5, -.5}, {.5, -.5}, {0, .5}}}};
    return std::make_shared<const Shape>(Extrusion{frame, 0.4});
  }
  return std::make_shared<const Shape>(Box{Vec3(1.2 + u(), 1.2 + u(), 1.2 + u())});
}

Scene random_scene(unsigned seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const auto u = [&] { return uniform(random); };
  Scene scene;
  for (int i = 0; i < 12; ++i) {
    Body body;
    body.shape = some_shape(i, u);
    const Vec3 x = glm::normalize(Vec3(u(), u(), u())),
               y = glm::normalize(glm::cross(x, Vec3(u(), u(), u())));
    body.placement = {Mat3(x, y, glm::cross(x, y)), Vec3(u(), u(), u()) * 2.0};
    scene.bodies.push_back(body);
  }
  for (int i = 0; i < 20; ++i)
    scene.segments.push_back({Vec3(u(), u(), u()) * 3.0, Vec3(u(), u(), u()) * 3.0, 0});
  scene.camera.parallel = seed % 2 == 0;
  scene.camera.from = {180 * u(), 80 * u()};
  scene.light = Direction{30, 50};
  if (seed % 3 == 0) scene.ground_z = -1;
  return scene;
}

class AgainstBruteForce : public testing::TestWithParam<unsigned> {};

/// Every line, visible or not, at many points: what the resolver says, rays say too.
TEST_P(AgainstBruteForce, Agrees) {
  const Scene scene = random_scene(GetParam());
  const Grid grid{120, 90, 1, 1};
  const View view = make_view(scene, grid);
  std::vector<Diagnostic> warnings;
  const Canonical seen = canonicalize(scene, view, 0.2, warnings);
  const ProjectedScene projected(seen, view);
  const FaceIndex index(projected);
  std::vector<SightLine> lines;
  add_edges(projected, {}, lines);
  add_intersections(projected, index, lines);
  add_shadow_outlines(projected, index, seen, cast_shadows(seen, seen, view), lines);
  add_segments(projected, lines);
  EdgeResolver resolver(projected, index);
  const BruteForce brute(seen, view.eye);
  std::mt19937_64 random(GetParam());
  std::uniform_real_distribution<double> uniform(0, 1);
  std::size_t compared[2] = {0, 0}, close = 0;
  for (const SightLine& line : lines) {
    const Ruler ruler(line.a.grid, line.b.grid);
    Intervals visible;
    for (const VisiblePart& part : resolver.visible(line)) visible.push_back(part.over);
    for (int i = 0; i < 6; ++i) {
      const Interval& part = line.within[static_cast<std::size_t>(i) % line.within.size()];
      if (ruler.length() * (part.second - part.first) < 1e-6) continue;  // rounding decides
      const double t = part.first + (part.second - part.first) * uniform(random);
      const Vec2 at = line.at(t);
      if (at.x < 0 || at.y < 0 || at.x > grid.columns || at.y > grid.rows) continue;
      const double s = t * line.a.grid.w / ((1 - t) * line.b.grid.w + t * line.a.grid.w);
      const auto answer = brute.look_from(line.a.world + (line.b.world - line.a.world) * s);
      if (answer == BruteForce::Answer::close) {
        ++close;
        continue;
      }
      const bool drawn = std::any_of(visible.begin(), visible.end(), [&](const Interval& v) {
        return v.first <= t && t <= v.second;
      });
      ++compared[drawn ? 1 : 0];
      EXPECT_EQ(drawn, answer == BruteForce::Answer::seen)
          << to_string(line.kind) << " at " << at.x << ", " << at.y;
    }
  }
  EXPECT_GT(compared[0], 100u);
  EXPECT_GT(compared[1], 100u);
  RecordProperty("close", static_cast<int>(close));
}

/// On one side of a shadow's outline light falls, on the other it does not.
TEST_P(AgainstBruteForce, ShadowEndsAtItsOutline) {
  const Scene scene = random_scene(GetParam());
  const View view = make_view(scene, {120, 90, 1, 1});
  std::vector<Diagnostic> warnings;
  const Canonical seen = canonicalize(scene, view, 0.2, warnings);
  const ProjectedScene projected(seen, view);
  std::vector<SightLine> lines;
  add_shadow_outlines(projected, FaceIndex(projected), seen, cast_shadows(seen, seen, view), lines);
  Canonical casters = seen;
  casters.ground_z.reset();
  const BruteForce light(casters, Vec4(*seen.light, 0));
  std::size_t compared = 0;
  for (const SightLine& line : lines)
    for (const Interval& part : line.within) {
      const double t = part.first + 0.4 * (part.second - part.first);
      const double s = t * line.a.grid.w / ((1 - t) * line.b.grid.w + t * line.a.grid.w);
      const Vec3 along = line.b.world - line.a.world;
      const Vec3 aside = glm::cross(along, projected.plane(line.planes[0]).normal);
      constexpr double kStep = 1e-5;  // well above what is close, well below the scene's details
      if (!(glm::length(along) * (part.second - part.first) > kStep)) continue;
      const Vec3 at = line.a.world + along * s, step = aside * (kStep / glm::length(aside));
      const auto here = light.look_from(at + step), there = light.look_from(at - step);
      if (here == BruteForce::Answer::close || there == BruteForce::Answer::close) continue;
      ++compared;
      EXPECT_NE(here, there) << line.at(t).x << ", " << line.at(t).y;
    }
  EXPECT_GT(compared, 5u);
}

INSTANTIATE_TEST_SUITE_P(Seeds, AgainstBruteForce, testing::Range(1u, 7u));

TEST(Intervals, AreUnitedAndLeaveGaps) {
  Intervals holes{{0.5, 0.7}, {0.1, 0.2}, {0.6, 0.8}, {0.9, 0.9}};
  unite(holes);
  EXPECT_EQ(holes, (Intervals{{0.1, 0.2}, {0.5, 0.8}}));
  EXPECT_EQ(without({0, 1}, holes, 0), (Intervals{{0, 0.1}, {0.2, 0.5}, {0.8, 1}}));
  EXPECT_EQ(without({0, 1}, holes, 0.15), (Intervals{{0, 0.5}, {0.8, 1}}));
  EXPECT_EQ(without({0.3, 0.4}, {{0, 1}}, 0), Intervals{});
  EXPECT_EQ(common(holes, {{0.15, 0.6}, {0.7, 2}}),
            (Intervals{{0.15, 0.2}, {0.5, 0.6}, {0.7, 0.8}}));
}

}  // namespace
}  // namespace overstrike
