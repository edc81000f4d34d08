#include "core/geometry/expansion.h"

#include <gtest/gtest.h>

#include <random>

namespace overstrike {
namespace {

TEST(Expansion, SumsThatRoundingLoses) {
  const Expansion sum = Expansion(1e30) + Expansion(1) - Expansion(1e30);
  EXPECT_EQ(sum.sign(), 1);
  EXPECT_EQ(sum.approximate(), 1);
}

TEST(Expansion, ProductsThatCancel) {
  const double a = 1 + 0x1p-52, b = 1 - 0x1p-52;
  // a b = 1 - 2^-104, which a double cannot hold.
  EXPECT_EQ((Expansion(a) * Expansion(b) - Expansion(1)).approximate(), -0x1p-104);
  EXPECT_EQ((Expansion(a) * Expansion(b) - Expansion(1) + Expansion(0x1p-104)).sign(), 0);
}

TEST(Expansion, AgreesWithIntegers) {
  std::mt19937_64 random(7);
  std::uniform_int_distribution<std::int64_t> any(-(1LL << 30), 1LL << 30);
  for (int i = 0; i < 10000; ++i) {
    const std::int64_t a = any(random), b = any(random), c = any(random), d = any(random);
    const __int128 exact = static_cast<__int128>(a) * b * 3 - static_cast<__int128>(c) * d * 3;
    const auto e = [](std::int64_t v) { return Expansion(static_cast<double>(v)); };
    const Expansion value = (e(a) * e(b) - e(c) * e(d)) * Expansion(3);
    EXPECT_EQ(value.sign(), (exact > 0) - (exact < 0));
    EXPECT_EQ((e(a) * e(b) - e(b) * e(a)).sign(), 0);
  }
}

}  // namespace
}  // namespace overstrike
