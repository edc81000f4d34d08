#include "cli/openscad_camera.h"

#include <algorithm>

#include "cli/numbers.h"
#include "core/geometry/trig.h"

namespace overstrike {
namespace {

constexpr double kFieldOfView = 22.5;  // degrees, of height

constexpr std::string_view kExpected =
    "X,Y,Z,ROTX,ROTY,ROTZ,DISTANCE or EYEX,EYEY,EYEZ,X,Y,Z as OpenSCAD writes them";

Vec3 turned_x(const Vec3& p, double degrees) {
  const double s = sin_deg(degrees), c = cos_deg(degrees);
  return {p.x, c * p.y - s * p.z, s * p.y + c * p.z};
}
Vec3 turned_y(const Vec3& p, double degrees) {
  const double s = sin_deg(degrees), c = cos_deg(degrees);
  return {c * p.x + s * p.z, p.y, c * p.z - s * p.x};
}
Vec3 turned_z(const Vec3& p, double degrees) {
  const double s = sin_deg(degrees), c = cos_deg(degrees);
  return {c * p.x - s * p.y, s * p.x + c * p.y, p.z};
}

}  // namespace

Camera read_openscad_camera(const std::string& text, bool parallel) {
  const bool turns = std::count(text.begin(), text.end(), ',') != 5;
  const NumberRule rule{"--camera", kExpected, turns ? std::size_t{7} : std::size_t{6}};
  const std::vector<double> n = read_numbers(rule, text);
  Camera camera;
  camera.parallel = parallel;
  camera.fov_deg = kFieldOfView;
  if (turns) {
    if (!(n[6] > 0)) refuse(rule, text);
    const auto turned = [&](const Vec3& p) {
      return turned_z(turned_y(turned_x(p, n[3] - 90), n[4]), n[5]);
    };
    camera.target = Vec3(n[0], n[1], n[2]);
    camera.eye = *camera.target + turned(Vec3(0, -n[6], 0));
    camera.up = turned(Vec3(0, 0, 1));
    return camera;
  }
  camera.eye = Vec3(n[0], n[1], n[2]);
  camera.target = Vec3(n[3], n[4], n[5]);
  if (*camera.eye == *camera.target) refuse(rule, text);
  // From straight above, y is up.
  if (n[0] == n[3] && n[1] == n[4]) camera.up = Vec3(0, n[2] > n[5] ? 1 : -1, 0);
  return camera;
}

}  // namespace overstrike
