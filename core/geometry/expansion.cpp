#include "core/geometry/expansion.h"

#include <cmath>

namespace overstrike {
namespace {

struct Pair {
  double high, low;
};

Pair two_sum(double a, double b) {
  const double sum = a + b;
  const double b_part = sum - a;
  const double a_part = sum - b_part;
  return {sum, (a - a_part) + (b - b_part)};
}

// std::fma is exact by definition, in hardware or in software.
Pair two_product(double a, double b) {
  const double product = a * b;
  return {product, std::fma(a, b, -product)};
}

}  // namespace

void Expansion::add(double value) {
  double carry = value;
  std::size_t out = 0;
  for (const double part : parts_) {
    const Pair s = two_sum(carry, part);
    carry = s.high;
    if (s.low != 0) parts_[out++] = s.low;
  }
  parts_.resize(out);
  if (carry != 0) parts_.push_back(carry);
}

void Expansion::add_product(double a, double b) {
  const Pair p = two_product(a, b);
  if (p.low != 0) add(p.low);
  add(p.high);
}

Expansion Expansion::operator-() const {
  Expansion result = *this;
  for (double& part : result.parts_) part = -part;
  return result;
}

double Expansion::approximate() const {
  double sum = 0;
  for (const double part : parts_) sum += part;
  return sum;
}

Expansion operator+(const Expansion& a, const Expansion& b) {
  Expansion result = a;
  for (const double part : b.parts_) result.add(part);
  return result;
}

Expansion operator*(const Expansion& a, const Expansion& b) {
  Expansion result;
  for (const double x : a.parts_)
    for (const double y : b.parts_) result.add_product(x, y);
  return result;
}

}  // namespace overstrike
