#include "core/visibility/plane_gap.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace overstrike {
namespace {

using Big = __int128;

/// A number of few places, and itself times 2^places.
struct Exact {
  double value;
  Big whole;
};
template <int places>
Exact exact(double value) {
  return {value, static_cast<Big>(std::ldexp(value, places))};
}

/// Whole numbers of eighths for normals and light, whole numbers for points and offsets, which are
/// now and then off by 2^-46: many gaps are zero, or all but.
class Draw {
 public:
  explicit Draw(unsigned seed) : bits_(seed) {}
  int whole(int most) { return static_cast<int>(bits_() % (2 * most + 1)) - most; }
  /// Of length 1 at most.
  Vec3 direction() { return Vec3(whole(4), whole(4), whole(4)) / 8.0; }
  Vec3 point() { return Vec3(whole(3), whole(3), whole(3)); }
  /// Every other plane goes through p, or all but.
  double offset(const Vec3& normal, const Vec3& p) {
    const double through = glm::dot(normal, bits_() % 2 == 0 ? p : point());
    return through + whole(1) * (bits_() % 2 == 0 ? 0x1p-46 : 0.0);
  }

 private:
  std::mt19937_64 bits_;
};

Big dot(const Vec3& a, const Vec3& b) {
  Big sum = 0;
  for (int i = 0; i < 3; ++i) sum += exact<3>(a[i]).whole * exact<3>(b[i]).whole;
  return sum;
}

int sign(Big x) { return (x > 0) - (x < 0); }

/// Of the formula of the header, in whole numbers.
int sign_of_gap(const Plane& upper, const Plane& lower, const Vec3& light, const Vec3& p) {
  const auto height = [&p](const Plane& plane) {
    return (dot(plane.normal, p) << 40) - exact<46>(plane.offset).whole;
  };
  const Big up = dot(upper.normal, light), low = dot(lower.normal, light);
  return sign(height(lower) * up - height(upper) * low) * sign(up) * sign(low);
}

int sign(double x) { return (x > 0) - (x < 0); }

TEST(PlaneGap, HasTheRightSignHoweverSmall) {
  Draw draw(1);
  int zero = 0, tiny = 0, tried = 0;
  while (tried < 20'000) {
    const Vec3 light = draw.direction(), n = draw.direction(), m = draw.direction();
    if (dot(n, light) == 0 || dot(m, light) == 0) continue;
    ++tried;
    const Vec3 p = draw.point();
    const Plane upper{n, draw.offset(n, p)}, lower{m, draw.offset(m, p)};
    const double gap = PlaneGap(upper, lower, light, 9).at(p);
    EXPECT_EQ(sign(gap), sign_of_gap(upper, lower, light, p));
    zero += gap == 0, tiny += gap != 0 && std::fabs(gap) < 0x1p-40;
  }
  EXPECT_GT(zero, 500);
  EXPECT_GT(tiny, 500);
}

/// Doubles alone leave it a millionth off at 2^-33, and anywhere at 2^-50. The points lie off both
/// planes, as rounded vertices do.
TEST(PlaneGap, CrossesWherePlanesDoHoweverFlatly) {
  const Vec3 light(0.6, 0, 0.8);
  const Plane lower{Vec3(0, 0, 1), 0};
  std::mt19937_64 bits(2);
  std::uniform_real_distribution<double> u(0, 1);
  for (const double slope : {0x1p-10, 0x1p-33, 0x1p-50}) {
    for (int i = 0; i < 200; ++i) {
      const double x = u(bits);
      const Plane upper{Vec3(-slope, 0, 1), -slope * x};
      const Vec3 a(-u(bits), u(bits), (u(bits) - 0.5) * 0x1p-52),
          b(1 + u(bits), u(bits), (u(bits) - 0.5) * 0x1p-52);
      const PlaneGap gap(upper, lower, light, 3);
      EXPECT_LT(gap.at(a), 0);
      EXPECT_GT(gap.at(b), 0);
      const double t = gap.crossing(a, b, gap.at(a), gap.at(b));
      // The points' own heights move it by as much, times the light's slope; t has few roundings.
      EXPECT_NEAR(t, (x - a.x) / (b.x - a.x), slope < 0x1p-20 ? 0x1p-50 : 0x1p-42);
    }
  }
}

TEST(PlaneGap, IsTheSameFromEitherSideOfThePlanes) {
  const Vec3 light(0.6, 0, 0.8), p(0.1, 0.2, 0.7);
  const Plane upper{Vec3(0.6, 0.8, 0), 0.3}, lower{Vec3(0, 0, 1), 0.1};
  const auto turned = [](const Plane& q) { return Plane{-q.normal, -q.offset}; };
  const double gap = PlaneGap(upper, lower, light, 3).at(p);
  EXPECT_GT(std::fabs(gap), 0.01);
  EXPECT_EQ(PlaneGap(turned(upper), lower, light, 3).at(p), gap);
  EXPECT_EQ(PlaneGap(upper, turned(lower), light, 3).at(p), gap);
}

}  // namespace
}  // namespace overstrike
