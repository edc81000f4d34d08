#include "core/geometry/plane_fit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace overstrike {
namespace {

/// The law: the plane of a triangle passes its corners, however narrow it is. Down to a sine of
/// 2^-10 products are rounded, which turns the normal by 2 roundings' 2^-53 * 2^10 at the most in
/// each of 3 coordinates; corners are less than 2 sqrt(3) + 1 apart. Rounded in full, rest and
/// differences of coordinates stay below one more.
constexpr double kBound = (2 * 3 * 4.5 + 1) * 0x1p10 * 0x1p-53;

TEST(PlaneFit, TheNarrowestTrianglesLieInTheirPlanes) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> u(-1, 1);
  const auto any = [&] { return Vec3(u(random), u(random), u(random)); };
  for (double width = 1; width > 1e-14; width /= 10)
    for (int i = 0; i < 200; ++i) {
      // Two near corners, and one between the far ends.
      const Vec3 a = any(), b = any();
      const Vec3 corners[] = {a, b, a + (b - a) * 0.4 + any() * width};
      PlaneFitter fitter;
      fitter.add(3, [&](std::size_t k) { return corners[k]; });
      const PlaneFit fit = fitter.fit();
      if (fit.area == 0) continue;
      for (const Vec3& p : corners)
        EXPECT_LE(std::fabs(glm::dot(fit.normal, p) - fit.offset), kBound) << width;
    }
}

}  // namespace
}  // namespace overstrike
