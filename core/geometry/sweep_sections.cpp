#include "core/geometry/sweep_sections.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/trig.h"

namespace overstrike {
namespace {

/// A turn of the frame on a closed path below this, in degrees for each path point, is rounding: a
/// step of transport errs by some 10 units of 2^-53 rad, times 2^7 for corners sharper than 170
/// degrees. It moves no corner by more than 2^-40 of the profile's size.
constexpr double kClosingTurnDeg = 0x1p-36;

/// Right and up across a direction; right x up points back along the path.
struct Frame {
  Vec3 right, up;
};

Frame frame_along(const Vec3& direction, const Vec3& right) {
  const Vec3 across = glm::normalize(right - direction * glm::dot(right, direction));
  return {across, glm::cross(across, direction)};
}

Frame first_frame(const Vec3& direction) {
  const bool upright = direction.x == 0 && direction.y == 0;
  const Vec3 up = upright ? Vec3{0, 1, 0} : Vec3{0, 0, 1};
  return frame_along(direction, glm::cross(direction, up));
}

/// The minimal rotation that takes one direction to the next, applied to the frame.
Frame carried(const Frame& frame, const Vec3& from, const Vec3& to) {
  const Vec3 right =
      frame.right - (from + to) * (glm::dot(to, frame.right) / (1 + glm::dot(from, to)));
  return frame_along(to, right);
}

Frame turned(const Frame& frame, double degrees) {
  if (degrees == 0) return frame;
  const double c = cos_deg(degrees), s = sin_deg(degrees);
  return {frame.right * c + frame.up * s, frame.up * c - frame.right * s};
}

double degrees_between(const Frame& from, const Frame& to) {
  return atan2_deg(glm::dot(to.right, from.up), glm::dot(to.right, from.right));
}

/// The profile in a frame across `along`, slid along it into the plane that halves the corner with
/// `other` (equal directions: not at all).
std::vector<Vec3> section(const Loop2& profile, const Vec3& at, const Frame& frame,
                          const Vec3& along, const Vec3& other) {
  std::vector<Vec3> points;
  for (const Vec2& q : profile) {
    const Vec3 offset = frame.right * q.x + frame.up * q.y;
    const double slide =
        along == other ? 0 : -glm::dot(offset, other) / (1 + glm::dot(along, other));
    points.push_back(at + offset + along * slide);
  }
  return points;
}

std::vector<double> lengths_to(const Sweep& sweep) {
  std::vector<double> lengths{0};
  for (std::size_t i = 0; i < sweep.path.size(); ++i)
    lengths.push_back(lengths.back() +
                      glm::length(sweep.path[(i + 1) % sweep.path.size()] - sweep.path[i]));
  return lengths;
}

}  // namespace

std::vector<Vec3> path_directions(const Sweep& sweep) {
  const std::size_t points = sweep.path.size();
  std::vector<Vec3> directions;
  for (std::size_t i = 0; i + (sweep.closed_path ? 0 : 1) < points; ++i)
    directions.push_back(glm::normalize(sweep.path[(i + 1) % points] - sweep.path[i]));
  return directions;
}

SweepSections sections_of(const Sweep& sweep) {
  SweepSections s;
  s.profile = without_repeats(sweep.profile);
  if (!is_counter_clockwise(s.profile)) std::reverse(s.profile.begin(), s.profile.end());
  s.directions = path_directions(sweep);
  const std::vector<Vec3>& d = s.directions;

  std::vector<Frame> frames{first_frame(d[0])};
  for (std::size_t i = 1; i < d.size(); ++i)
    frames.push_back(carried(frames[i - 1], d[i - 1], d[i]));
  double turn = 0;
  if (sweep.closed_path) {
    turn = degrees_between(carried(frames.back(), d.back(), d[0]), frames[0]);
    s.twisted = std::fabs(turn) > kClosingTurnDeg * static_cast<double>(sweep.path.size());
    if (!s.twisted) turn = 0;
  }
  const std::vector<double> lengths = lengths_to(sweep);
  for (std::size_t j = 0; j < sweep.path.size(); ++j) {
    const std::size_t along = j == 0 ? 0 : j - 1;
    const std::size_t other =
        j == 0 ? (sweep.closed_path ? d.size() - 1 : 0) : std::min(j, d.size() - 1);
    const Frame frame = turned(frames[along], turn * (lengths[j] / lengths.back()));
    s.sections.push_back(section(s.profile, sweep.path[j], frame, d[along], d[other]));
  }
  return s;
}

}  // namespace overstrike
