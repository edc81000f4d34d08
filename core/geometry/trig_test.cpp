#include "core/geometry/trig.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace overstrike {
namespace {

constexpr int kAngles = 1000000;
constexpr long double kPi = 3.14159265358979323846264338327950288L;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Distance in units of the last place of the double nearest to the truth.
double error_in_ulps(double found, long double truth) {
  const double nearest = std::fabs(static_cast<double>(truth));
  const double ulp = std::nextafter(nearest, kInfinity) - nearest;
  return static_cast<double>(std::fabs(static_cast<long double>(found) - truth) / ulp);
}

long double reference_sine(double degrees) {
  long double rest = std::fmod(static_cast<long double>(degrees), 360.0L);
  if (std::fabs(rest) > 180) rest -= std::copysign(360.0L, rest);
  if (std::fabs(rest) > 90) rest = std::copysign(180.0L, rest) - rest;
  if (std::fabs(rest) <= 45) return std::sin(rest * (kPi / 180));
  return std::copysign(std::cos((90 - std::fabs(rest)) * (kPi / 180)), rest);
}

long double reference_cosine(double degrees) {
  long double rest = std::fabs(std::fmod(static_cast<long double>(degrees), 360.0L));
  if (rest > 180) rest = 360 - rest;
  const long double sign = rest > 90 ? -1 : 1;
  if (rest > 90) rest = 180 - rest;
  if (rest <= 45) return sign * std::cos(rest * (kPi / 180));
  return sign * std::sin((90 - rest) * (kPi / 180));
}

/// Angles of every size: near zero, within a turn, and many turns away.
class Angles {
 public:
  double next() {
    const double unit = std::uniform_real_distribution<double>(-1, 1)(random_);
    switch (count_++ % 4) {
      case 0:
        return 360 * unit;
      case 1:
        return 90 * std::round(40 * unit) + 1e-3 * unit * unit * unit;
      case 2:
        return std::ldexp(unit, std::uniform_int_distribution<int>(-900, 8)(random_));
      default:
        return 1e9 * unit;
    }
  }

 private:
  std::mt19937_64 random_{7};
  int count_ = 0;
};

TEST(Trig, SineAndCosineAreWithinOneUlp) {
  Angles angles;
  double worst_sine = 0, worst_cosine = 0, worst_tangent = 0;
  for (int i = 0; i < kAngles; ++i) {
    const double a = angles.next();
    const long double s = reference_sine(a), c = reference_cosine(a);
    worst_sine = std::max(worst_sine, error_in_ulps(sin_deg(a), s));
    worst_cosine = std::max(worst_cosine, error_in_ulps(cos_deg(a), c));
    if (c != 0) worst_tangent = std::max(worst_tangent, error_in_ulps(tan_deg(a), s / c));
  }
  RecordProperty("worst_sine_ulps", std::to_string(worst_sine));
  RecordProperty("worst_cosine_ulps", std::to_string(worst_cosine));
  RecordProperty("worst_tangent_ulps", std::to_string(worst_tangent));
  EXPECT_LT(worst_sine, 0.8);
  EXPECT_LT(worst_cosine, 0.8);
  EXPECT_LT(worst_tangent, 1.25);
}

TEST(Trig, MultiplesOf30And45AreCorrectlyRounded) {
  const double cos30 = std::sqrt(3.0L) / 2, cos45 = std::sqrt(0.5L);
  const double sines[] = {0, 0.5, cos45, cos30, 1, cos30, cos45, 0.5};
  const int angles[] = {0, 30, 45, 60, 90, 120, 135, 150};
  for (int turn = -720; turn <= 720; turn += 360) {
    for (int i = 0; i < 8; ++i) {
      EXPECT_EQ(sin_deg(turn + angles[i]), sines[i]) << turn + angles[i];
      EXPECT_EQ(sin_deg(turn + angles[i] + 180), -sines[i]);
      EXPECT_EQ(cos_deg(turn + angles[i] - 90), sines[i]);
      EXPECT_EQ(cos_deg(turn + angles[i] + 90), -sines[i]);
    }
  }
  EXPECT_EQ(tan_deg(45), 1);
  EXPECT_EQ(tan_deg(135), -1);
  EXPECT_EQ(tan_deg(60), static_cast<double>(std::sqrt(3.0L)));
  EXPECT_EQ(tan_deg(30), static_cast<double>(1 / std::sqrt(3.0L)));
  EXPECT_EQ(tan_deg(180), 0);
  EXPECT_EQ(tan_deg(90), kInfinity);
  EXPECT_EQ(tan_deg(-90), -kInfinity);
}

TEST(Trig, SymmetriesHoldBitForBit) {
  std::mt19937_64 random(11);
  for (int i = 0; i < kAngles / 10; ++i) {
    // Multiples of 2^-40 below 360: sums with quarter turns are exact.
    const double a = std::ldexp(static_cast<double>(random() % (360ull << 40)), -40);
    EXPECT_EQ(sin_deg(-a), -sin_deg(a));
    EXPECT_EQ(cos_deg(-a), cos_deg(a));
    EXPECT_EQ(tan_deg(-a), -tan_deg(a));
    EXPECT_EQ(sin_deg(a + 90), cos_deg(a));
    EXPECT_EQ(cos_deg(a + 90), -sin_deg(a));
    EXPECT_EQ(sin_deg(180 - a), sin_deg(a));
    EXPECT_EQ(sin_deg(a - 360), sin_deg(a));
    EXPECT_EQ(cos_deg(a + 720), cos_deg(a));
    ASSERT_FALSE(HasFailure()) << a;
  }
}

TEST(Trig, ZerosAreSignedAsTheAngle) {
  EXPECT_FALSE(std::signbit(sin_deg(0.0)));
  EXPECT_TRUE(std::signbit(sin_deg(-0.0)));
  EXPECT_FALSE(std::signbit(sin_deg(180)));
  EXPECT_TRUE(std::signbit(sin_deg(-180)));
  EXPECT_FALSE(std::signbit(cos_deg(90)));
  EXPECT_FALSE(std::signbit(cos_deg(-270)));
}

TEST(Trig, SmallestAnglesKeepTheirSign) {
  EXPECT_EQ(sin_deg(1e-320), 1e-320 * static_cast<double>(kPi / 180));
  EXPECT_EQ(cos_deg(1e-320), 1);
  EXPECT_LT(sin_deg(-1e-300), 0);
}

TEST(Trig, ArcTangentIsWithinFourParts) {
  std::mt19937_64 random(13);
  std::uniform_real_distribution<double> unit(-1, 1);
  std::uniform_int_distribution<int> exponent(-300, 300);
  double worst = 0;
  for (int i = 0; i < kAngles; ++i) {
    const int scale = exponent(random);
    const int offset = i % 2 == 0 ? 0 : exponent(random) / 5;
    const double y = std::ldexp(unit(random), scale), x = std::ldexp(unit(random), scale + offset);
    const long double truth =
        std::atan2(static_cast<long double>(y), static_cast<long double>(x)) * (180 / kPi);
    const long double error = std::fabs((atan2_deg(y, x) - truth) / truth);
    worst = std::max(worst, static_cast<double>(error));
  }
  RecordProperty("worst_relative_error", std::to_string(worst * 1e16) + "e-16");
  EXPECT_LT(worst, 2e-16);
}

TEST(Trig, ArcTangentOfKnownDirections) {
  EXPECT_EQ(atan2_deg(0, 1), 0);
  EXPECT_EQ(atan2_deg(1, 1), 45);
  EXPECT_EQ(atan2_deg(1, 0), 90);
  EXPECT_EQ(atan2_deg(1, -1), 135);
  EXPECT_EQ(atan2_deg(0.0, -1), 180);
  EXPECT_EQ(atan2_deg(-0.0, -1), -180);
  EXPECT_EQ(atan2_deg(-1, -1), -135);
  EXPECT_EQ(atan2_deg(-1, 0), -90);
  EXPECT_EQ(atan2_deg(0, 0), 0);
  EXPECT_EQ(atan2_deg(kInfinity, 3), 90);
  EXPECT_EQ(atan2_deg(kInfinity, -kInfinity), 135);
  EXPECT_EQ(atan2_deg(3, kInfinity), 0);
  for (int a = -180; a <= 180; ++a) EXPECT_NEAR(atan2_deg(sin_deg(a), cos_deg(a)), a, 3e-14);
}

TEST(Trig, ArcCosine) {
  EXPECT_EQ(acos_deg(1), 0);
  EXPECT_EQ(acos_deg(0), 90);
  EXPECT_EQ(acos_deg(-1), 180);
  EXPECT_EQ(acos_deg(0.5), 60);
  std::mt19937_64 random(17);
  std::uniform_real_distribution<double> unit(-1, 1);
  double worst = 0;
  for (int i = 0; i < kAngles / 4; ++i) {
    double c = unit(random);
    if (i % 2 == 0) c = std::copysign(1 - std::fabs(c) * c * c * 1e-6, c);
    const long double truth = std::acos(static_cast<long double>(c)) * (180 / kPi);
    if (truth == 0) continue;
    worst = std::max(worst, static_cast<double>(std::fabs((acos_deg(c) - truth) / truth)));
  }
  RecordProperty("worst_relative_error", std::to_string(worst * 1e16) + "e-16");
  EXPECT_LT(worst, 1e-15);
}

TEST(Trig, NotANumberWhereThereIsNoAnswer) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (double a : {kInfinity, -kInfinity, nan}) {
    EXPECT_TRUE(std::isnan(sin_deg(a)));
    EXPECT_TRUE(std::isnan(cos_deg(a)));
    EXPECT_TRUE(std::isnan(tan_deg(a)));
  }
  EXPECT_TRUE(std::isnan(atan2_deg(nan, 1)));
  EXPECT_TRUE(std::isnan(atan2_deg(1, nan)));
  EXPECT_TRUE(std::isnan(acos_deg(1.0000001)));
  EXPECT_TRUE(std::isnan(acos_deg(nan)));
}

}  // namespace
}  // namespace overstrike
