#include "core/scene/scene.h"

#include "core/geometry/trig.h"

namespace overstrike {

Vec3 unit_vector(const Direction& d) {
  const double flat = cos_deg(d.elevation_deg);
  return {cos_deg(d.azimuth_deg) * flat, sin_deg(d.azimuth_deg) * flat, sin_deg(d.elevation_deg)};
}

}  // namespace overstrike
