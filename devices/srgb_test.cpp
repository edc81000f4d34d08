#include "devices/srgb.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace overstrike {
namespace {

/// The standard's own formula; libm is good enough to judge by.
double encoded(double linear) {
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

TEST(Srgb, DecodesAsTheStandardSays) {
  for (int i = 0; i <= 100000; ++i) {
    const double v = i / 100000.0;
    const double u = (v + 0.055) / 1.055;
    const double expected = v <= 0.04045 ? v / 12.92 : std::pow(u, 2.4);
    ASSERT_NEAR(srgb_to_linear(v), expected, 4e-16) << v;
  }
  EXPECT_EQ(srgb_to_linear(0), 0);
  EXPECT_EQ(srgb_to_linear(1), 1);
}

TEST(Srgb, KnownCodes) {
  const SrgbEncoder eight(255), sixteen(65535);
  // Middle grey of 18 %, half and quarter light: 0.46136, 0.73536, 0.53710 encoded.
  EXPECT_EQ(eight(0.18f), 118);
  EXPECT_EQ(eight(0.5f), 188);
  EXPECT_EQ(eight(0.25f), 137);
  EXPECT_EQ(sixteen(0.5f), 48192);
  EXPECT_EQ(eight(0.001f), 3);
}

TEST(Srgb, EncodingIsTheNearestCode) {
  std::mt19937 random(7);
  for (int most : {255, 65535}) {
    const SrgbEncoder encode(most);
    for (int i = 0; i < 200000; ++i) {
      const double linear = std::ldexp(static_cast<double>(random()), -32);
      const float value = static_cast<float>(i % 2 == 0 ? linear : linear * linear * linear);
      // The two pieces of the standard's curve miss each other by 3e-8 of full scale, 0.002 codes.
      ASSERT_LE(std::abs(encoded(value) * most - encode(value)), 0.5 + 0.01) << value;
    }
  }
}

TEST(Srgb, EveryCodeComesBack) {
  for (int most : {255, 65535}) {
    const SrgbEncoder encode(most);
    for (int code = 0; code <= most; ++code)
      ASSERT_EQ(encode(static_cast<float>(srgb_to_linear(static_cast<double>(code) / most))), code);
  }
}

TEST(Srgb, OddValuesAreClamped) {
  const SrgbEncoder encode(255);
  EXPECT_EQ(encode(-1), 0);
  EXPECT_EQ(encode(std::numeric_limits<float>::quiet_NaN()), 0);
  EXPECT_EQ(encode(2), 255);
  EXPECT_EQ(encode(std::numeric_limits<float>::infinity()), 255);
  EXPECT_EQ(encode(std::nextafter(1.0f, 0.0f)), 255);
  EXPECT_EQ(encode(std::numeric_limits<float>::denorm_min()), 0);
}

}  // namespace
}  // namespace overstrike
