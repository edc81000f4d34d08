#include "core/geometry/sum_of_two.h"

#include <gtest/gtest.h>

#include <random>

#include "core/geometry/expansion.h"

namespace overstrike {
namespace {

/// |over / under - value| <= error, exactly.
bool holds(const SumOfTwo& sum, const Expansion& over, const Expansion& under) {
  const Expansion size = under.sign() < 0 ? -under : under;
  const Expansion off = (under.sign() < 0 ? -over : over) - Expansion(sum.value()) * size;
  const Expansion most = Expansion(sum.error()) * size;
  return (off - most).sign() <= 0 && (off + most).sign() >= 0;
}

/// Few digits, so that differences cancel, or all of them.
double number(std::mt19937_64& random) {
  const double x = static_cast<double>(random() % 17) - 8;
  return random() % 2 == 0 ? x : x + static_cast<double>(random() % 5) * 0x1p-49;
}

TEST(SumOfTwo, TheTrueValueIsWithinItsError) {
  std::mt19937_64 random(3);
  int sure = 0;
  for (int n = 0; n < 20'000; ++n) {
    double x[7];
    for (double& one : x) one = number(random);
    const auto form = [&](auto kind) {
      using T = decltype(kind);
      return (T(x[0]) - T(x[1])) * (T(x[2]) - T(x[3])) - (T(x[4]) - T(x[5])) * T(x[6]);
    };
    const SumOfTwo sum = form(SumOfTwo(0));
    const Expansion exact = form(Expansion(0.0));
    ASSERT_TRUE(holds(sum, exact, Expansion(1.0))) << n;
    const SumOfTwo under = SumOfTwo(x[3]) - SumOfTwo(x[6]);
    const SumOfTwo part = sum / under;
    const Expansion divisor = Expansion(x[3]) - Expansion(x[6]);
    if (divisor.sign() == 0) continue;
    ASSERT_TRUE(holds(part, exact, divisor)) << n;
    sure += part.error() <= 0x1p-52 * (1 + std::fabs(part.value()));
  }
  EXPECT_GT(sure, 15'000);
}

TEST(SumOfTwo, NothingIsSureOverWhatMayBeZero) {
  EXPECT_FALSE(std::isfinite((SumOfTwo(1) / (SumOfTwo(2) - SumOfTwo(2))).error()));
}

}  // namespace
}  // namespace overstrike
