#pragma once
// Vectors are GLM's, in double precision.
#include <glm/glm.hpp>

namespace overstrike {

using Vec2 = glm::dvec2;
using Vec3 = glm::dvec3;
using Vec4 = glm::dvec4;
using Mat3 = glm::dmat3;  // column-major: m[column][row]
using Mat4 = glm::dmat4;

/// p -> linear * p + offset.
struct Affine {
  Mat3 linear{1.0};
  Vec3 offset{0.0};
  Vec3 operator()(const Vec3& p) const { return linear * p + offset; }
};

/// First `b`, then `a`.
inline Affine operator*(const Affine& a, const Affine& b) {
  return {a.linear * b.linear, a.linear * b.offset + a.offset};
}

}  // namespace overstrike
