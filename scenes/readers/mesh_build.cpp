#include "scenes/readers/mesh_build.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

namespace overstrike {
namespace {

constexpr Index kNone = 0xFFFF'FFFF;
constexpr std::size_t kFewestSlots = 64;

/// Mixes all bits of x into all bits (Stafford's variant 13, as in SplitMix64).
std::uint64_t mixed(std::uint64_t x) {
  x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9u;
  x = (x ^ (x >> 27)) * 0x94D049BB133111EBu;
  return x ^ (x >> 31);
}

std::uint64_t hash_of(const Vec3& p) {
  const auto bits = [](double v) { return std::bit_cast<std::uint64_t>(v); };
  return mixed(bits(p.x) + mixed(bits(p.y) + mixed(bits(p.z))));
}

}  // namespace

Welder::Welder(std::size_t expected) {
  points_.reserve(expected);
  slots_.assign(std::max(kFewestSlots, std::bit_ceil(2 * expected)), kNone);
}

void Welder::insert(Index number) {
  const std::size_t mask = slots_.size() - 1;
  std::size_t slot = hash_of(points_[number]) & mask;
  while (slots_[slot] != kNone) slot = (slot + 1) & mask;
  slots_[slot] = number;
}

void Welder::grow() {
  slots_.assign(2 * slots_.size(), kNone);
  for (std::size_t i = 0; i < points_.size(); ++i) insert(static_cast<Index>(i));
}

Index Welder::add(const Vec3& p) {
  const std::size_t mask = slots_.size() - 1;
  std::size_t slot = hash_of(p) & mask;
  for (; slots_[slot] != kNone; slot = (slot + 1) & mask)
    if (points_[slots_[slot]] == p) return slots_[slot];
  const Index number = static_cast<Index>(points_.size());
  points_.push_back(p);
  slots_[slot] = number;
  if (2 * points_.size() > slots_.size()) grow();
  return number;
}

std::vector<Vec3> Welder::take_points() {
  std::fill(slots_.begin(), slots_.end(), kNone);
  return std::exchange(points_, {});
}

void weld_vertices(Polyhedron& polyhedron) {
  std::vector<bool> used(polyhedron.vertices.size());
  for (const Index v : polyhedron.indices) used[v] = true;
  Welder welder(polyhedron.vertices.size());
  std::vector<Index> number(polyhedron.vertices.size(), kNone);
  for (std::size_t v = 0; v < number.size(); ++v)
    if (used[v]) number[v] = welder.add(polyhedron.vertices[v]);
  for (Index& v : polyhedron.indices) v = number[v];
  polyhedron.vertices = welder.take_points();
}

double float_precision(double largest) {
  constexpr int kFloatDigits = 24;
  return largest > 0 ? std::ldexp(1, std::ilogb(largest) - kFloatDigits) : 0;
}

double float_precision(const Polyhedron& polyhedron) {
  double largest = 0;
  for (const Vec3& v : polyhedron.vertices)
    largest = std::max({largest, std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
  return float_precision(largest);
}

void warn_of_mesh(std::vector<Diagnostic>& warnings, const std::string& name, std::string message) {
  Diagnostic& warning = warnings.emplace_back();
  warning.severity = Severity::warning;
  warning.place.file = name;
  warning.message = std::move(message);
}

void fail_mesh(const std::string& name, std::string message, std::string hint) {
  throw InputError(Place{name, 0, 0}, std::move(message), std::move(hint));
}

}  // namespace overstrike
