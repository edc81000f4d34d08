#include "scenes/readers/openscad/resize.h"

#include <cmath>

namespace overstrike::openscad {

Affine resizing(const Vec3& size, int dimension, const Arguments& arguments) {
  const Vec3 wanted = arguments.sizes("newsize", dimension, 0);
  Vec3 scale(1.0);
  double most = 1;
  for (int axis = 0; axis < 3; ++axis)
    if (wanted[axis] > 0 && size[axis] > 0) {
      scale[axis] = wanted[axis] / size[axis];
      most = most == 1 ? scale[axis] : std::fmax(most, scale[axis]);
    }
  const Vec3 follow = arguments.flags("auto");
  for (int axis = 0; axis < 3; ++axis)
    if (!(wanted[axis] > 0) && follow[axis] != 0) scale[axis] = most;
  return {Mat3({scale.x, 0, 0}, {0, scale.y, 0}, {0, 0, scale.z}), Vec3(0.0)};
}

}  // namespace overstrike::openscad
