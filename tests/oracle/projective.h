#pragma once
// Homogeneous points, covectors (planes) and lines over either number of exact.h.
#include <array>
#include <functional>
#include <optional>

#include "core/geometry/vec.h"
#include "core/visibility/canonical.h"
#include "tests/oracle/exact.h"

namespace overstrike::oracle {

template <class T>
using Four = std::array<T, 4>;

template <class T>
Four<T> four(double a, double b, double c, double d) {
  return {T(a), T(b), T(c), T(d)};
}
template <class T>
Four<T> point(const Vec3& p) {
  return four<T>(p.x, p.y, p.z, 1);
}
template <class T>
Four<T> covector(const Plane& p) {
  return four<T>(p.normal.x, p.normal.y, p.normal.z, -p.offset);
}
template <class T>
T dot(const Four<T>& a, const Four<T>& b) {
  return a[0] * b[0] + a[1] * b[1] + (a[2] * b[2] + a[3] * b[3]);
}

/// The points where two covectors vanish. `minors` are its Pluecker coordinates p01 p02 p03 p12 p13
/// p23 of the pair.
template <class T>
struct LineOf {
  Four<T> x, y;
  std::array<T, 6> minors;

  LineOf(const Four<T>& a, const Four<T>& b) : x(a), y(b) {
    int k = 0;
    for (int i = 0; i < 4; ++i)
      for (int j = i + 1; j < 4; ++j) minors[k++] = a[i] * b[j] - a[j] * b[i];
  }
  /// Where the line meets a plane: the P with dot(P, R) = det(x, y, n, R) for every R.
  Four<T> meet(const Four<T>& n) const {
    const auto& [p01, p02, p03, p12, p13, p23] = minors;
    return {n[2] * p13 - n[3] * p12 - n[1] * p23, n[3] * p02 - n[2] * p03 + n[0] * p23,
            n[1] * p03 - n[3] * p01 - n[0] * p13, n[2] * p01 - n[1] * p02 + n[0] * p12};
  }
};

/// A value in both numbers; the exact one is made when it is first asked for.
template <template <class> class Value>
class Both {
 public:
  /// `make.operator()<T>()` gives a Value<T>.
  template <class Make>
  explicit Both(const Make& make)
      : approx_(make.template operator()<Approx>()),
        make_([make] { return make.template operator()<Exact>(); }) {}
  template <class T>
  const Value<T>& get() const {
    if constexpr (std::is_same_v<T, Approx>) {
      return approx_;
    } else {
      if (!exact_) exact_.emplace(make_());
      return *exact_;
    }
  }

 private:
  Value<Approx> approx_;
  std::function<Value<Exact>()> make_;
  mutable std::optional<Value<Exact>> exact_;
};
using Sight = Both<LineOf>;
using Hit = Both<Four>;

/// Where the line of sight meets the plane. The sight must outlive the hit.
inline Hit hit(const Sight& sight, const Plane& plane) {
  return Hit([&sight, plane]<class T>() { return sight.get<T>().meet(covector<T>(plane)); });
}

}  // namespace overstrike::oracle
