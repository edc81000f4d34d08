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

Copies copies_of(const Triangles& all, const Canonical& canonical) {
  const CanonicalBody& body = canonical.bodies.front();
  Copies copies;
  copies.first.vertices.assign(all.vertices.begin(), all.vertices.begin() + body.end_vertex);
  for (std::size_t t = 0; t < all.faces.size() && all.faces[t] < body.end_face; ++t) {
    copies.first.corners.push_back(all.corners[t]);
    copies.first.faces.push_back(all.faces[t]);
    copies.first.shade.push_back(all.shade[t]);
  }
  for (const CanonicalBody& b : canonical.bodies)
    copies.shifts.push_back(canonical.vertices[b.first_vertex] -
                            canonical.vertices[body.first_vertex]);
  return copies;
}

}  // namespace overstrike::bench
