#include "core/visibility/view.h"

#include <cmath>

#include "core/float_environment.h"
#include "core/geometry/direction.h"
#include "core/geometry/trig.h"
#include "core/visibility/camera_frame.h"
#include "core/visibility/fit.h"

namespace overstrike {
namespace {

/// Vertical field of view when the scene stands round the eye; and the widest that a fit may ask
/// for: beyond it a picture is all distortion.
constexpr double kFallbackFov = 60;
constexpr double kWidestFov = 120;
/// A scene that is one point in the picture gets a window of this part of the distance.
constexpr double kPointWindow = 1.0 / 3;
/// A fit asks for no more cells a unit than this many over the reach of what goes into the ground
/// (Window): of a tip that only just comes out of it, a picture would show what rounding made of
/// it. A grid coordinate is a sum of four products, each at most sqrt(3) reaches times the scale,
/// which costs four roundings: 4 sqrt(3) 2^-53 of the reach for the body and as much for the
/// target. That stays below a billionth of a cell.
constexpr double kMostCellsOverReach = 1e-9 / (16 * 0x1p-53);

/// Cells per world unit at the target's depth, and the grid point of the target.
struct Scale {
  double x, y;
  Vec2 centre;
};

Scale centred(const Grid& grid, double cells_x, const Vec2& shown_middle) {
  const double cells_y = cells_x * (grid.pitch_x_mm / grid.pitch_y_mm);
  return {cells_x,
          cells_y,
          {grid.columns / 2 - shown_middle.x * cells_x, grid.rows / 2 + shown_middle.y * cells_y}};
}

Scale by_fov(const Grid& grid, double fov_deg, double distance) {
  const double height = 2 * distance * tan_deg(fov_deg / 2);
  return centred(grid, grid.rows / height * (grid.pitch_y_mm / grid.pitch_x_mm), Vec2(0.0));
}

Scale by_fit(const Grid& grid, const Window& window, double margin) {
  const Vec2 size = window.high - window.low;
  const double part = 1 - 2 * margin;
  const double by_x = grid.columns * part / size.x;
  const double by_y = grid.rows * part / size.y * (grid.pitch_y_mm / grid.pitch_x_mm);
  const double sharpest =
      kMostCellsOverReach / window.reach;  // infinite where nothing reaches down
  return centred(grid, std::fmin(std::fmin(by_x, by_y), sharpest), window.low + size * 0.5);
}

Scale choose_scale(const Scene& scene, const Grid& grid, const CameraFrame& frame, double margin) {
  const Camera& camera = scene.camera;
  if (camera.window_width) return centred(grid, grid.columns / *camera.window_width, Vec2(0.0));
  if (camera.fov_deg) return by_fov(grid, *camera.fov_deg, frame.distance);
  const std::optional<Window> window = fitted_window(scene, frame);
  if (!window) return by_fov(grid, kFallbackFov, frame.distance);
  if (window->empty()) return by_fit(grid, {Vec2(-0.5), Vec2(0.5)}, margin);
  const Vec2 size = window->high - window->low;
  if (!(size.x > 0 || size.y > 0)) {
    const Vec2 half(frame.distance * kPointWindow / 2);
    return by_fit(grid, {window->low - half, window->low + half}, margin);
  }
  const double widest = 2 * frame.distance * tan_deg(kWidestFov / 2);
  if (!frame.parallel && !(std::fmax(size.x, size.y) <= widest))
    return by_fov(grid, kFallbackFov, frame.distance);
  return by_fit(grid, *window, margin);
}

void set_row(Mat4& m, int row, const Vec4& value) {
  for (int column = 0; column < 4; ++column) m[column][row] = value[column];
}

Vec4 row_of(const Mat4& m, int row) { return {m[0][row], m[1][row], m[2][row], m[3][row]}; }

/// The depth that gets z = 0: the middle of the scene, so that depths there are small numbers and
/// keep their last places; the target when the middle is not before the eye.
double zero_depth(const CameraFrame& frame, const Bounds& bounds) {
  if (bounds.empty()) return 0;
  const double middle = frame.place(bounds.low + (bounds.high - bounds.low) * 0.5).z;
  return frame.parallel || middle < frame.distance - frame.near_distance ? middle : 0;
}

/// In perspective all is counted from the eye, whose place the planes of the view know, too: an eye
/// that is far from its target would otherwise see from as far beside it as the target is rounded.
Mat4 matrix_of(const CameraFrame& frame, const Scale& scale, double world_per_cell, double zero) {
  const Vec3& from = frame.parallel ? frame.target : frame.eye;
  const Vec4 right(frame.right, -glm::dot(frame.right, from));
  const Vec4 up(frame.up, -glm::dot(frame.up, from));
  const Vec4 back(frame.back, -glm::dot(frame.back, from));
  const Vec4 one(0, 0, 0, 1);
  const Vec4 w = frame.parallel ? one : -back / frame.distance;
  if (!frame.parallel) zero -= frame.distance;  // of the eye, from the target
  Mat4 m{0.0};
  set_row(m, 0, right * scale.x + w * scale.centre.x);
  set_row(m, 1, w * scale.centre.y - up * scale.y);
  set_row(m, 2, w);
  set_row(m, 3, (back - one * zero) / world_per_cell);
  return m;
}

}  // namespace

View make_view(const Scene& scene, const Grid& grid, double margin) {
  const FloatEnvironment ours;
  const Stage stage = stage_of(scene);
  const CameraFrame frame = camera_frame(scene.camera, stage);
  const Scale scale = choose_scale(scene, grid, frame, margin);

  View view;
  view.origin = stage.origin;
  view.grid = grid;
  view.perspective = !frame.parallel;
  view.world_per_cell = 1 / std::fmax(scale.x, scale.y);
  view.matrix = matrix_of(frame, scale, view.world_per_cell, zero_depth(frame, stage.bounds));
  view.eye = frame.parallel ? Vec4(frame.back, 0) : Vec4(frame.eye, 1);
  if (view.perspective || scene.camera.near_distance)
    view.near_plane = Plane{-frame.back, frame.near_distance - glm::dot(frame.back, frame.eye)};
  return view;
}

View turned(const View& view, double angle_deg, Vec2 origin, double scale) {
  const TurnBack turn(angle_deg);
  const Vec4 w = row_of(view.matrix, 2);
  const Vec4 x = row_of(view.matrix, 0) - w * origin.x;
  const Vec4 y = row_of(view.matrix, 1) - w * origin.y;
  View result = view;
  set_row(result.matrix, 0, (x * turn.cosine + y * turn.sine) * scale);
  set_row(result.matrix, 1, (y * turn.cosine + x * turn.minus_sine) * scale);
  result.world_per_cell = view.world_per_cell / scale;
  return result;
}

}  // namespace overstrike
