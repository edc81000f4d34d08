#pragma once
// What the peers start from: the canonical input as triangles.
#include <array>
#include <cstdint>
#include <vector>

#include "core/visibility/canonical.h"
#include "core/visibility/view.h"

namespace overstrike::bench {

/// No surface at a pixel.
constexpr std::uint32_t kNothing = 0xFFFFFFFFu;

struct Triangles {
  std::vector<Vec3> vertices;  ///< world
  std::vector<std::array<Index, 3>> corners;
  std::vector<Index> faces;          ///< of each triangle, in the canonical input
  std::vector<std::uint32_t> shade;  ///< 0..255, flat Lambert by face
};

/// Faces of one convex loop, fanned. Precondition: there are no others.
Triangles triangles_of(const Canonical&);

/// The triangles of the first body, and how far each body is moved from it. Precondition: all
/// bodies are moved copies of one.
struct Copies {
  Triangles first;
  std::vector<Vec3> shifts;
};
Copies copies_of(const Triangles&, const Canonical&);

}  // namespace overstrike::bench
