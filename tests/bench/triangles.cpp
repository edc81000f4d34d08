#include "tests/bench/triangles.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace overstrike::bench {

Triangles triangles_of(const Canonical& canonical) {
  const Vec3 light = Vec3(1.0) / std::sqrt(3.0);
  Triangles result;
  result.vertices = canonical.vertices;
  for (Index f = 0; f < canonical.faces.size(); ++f) {
    const CanonicalFace& face = canonical.faces[f];
    assert(face.end_loop - face.first_loop == 1);
    const std::span<const Index> loop = canonical.loop(face.first_loop);
    const double lambert = std::max(0.0, glm::dot(canonical.outward(face), light));
    for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
      result.corners.push_back({loop[0], loop[i], loop[i + 1]});
      result.faces.push_back(f);
      result.shade.push_back(static_cast<std::uint32_t>(25 + 225 * lambert));
    }
  }
  return result;
}

}  // namespace overstrike::bench
