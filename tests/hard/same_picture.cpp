#include "tests/hard/same_picture.h"

#include <algorithm>
#include <cmath>

namespace overstrike::hard {
namespace {

std::shared_ptr<const Canonical> canonical_of(const Scene& scene, const View& view) {
  std::vector<Diagnostic> warnings;
  return std::make_shared<const Canonical>(canonicalize(scene, view, kTolerance, warnings));
}

/// Two drawings of one scene may shade it by other normals, as far as they are rounded; smooth
/// tones are linear along a run to within half a step of 8 bits in each.
constexpr double kFlatError = 1e-6, kSmoothError = 1.0 / 255;

/// Borders this far from a place may have to do with it (grid units).
constexpr double kNear = 1e-3;

}  // namespace

SamePicture::SamePicture(const Scene& scene)
    : view_(make_view(scene, kGrid)),
      canonical_(canonical_of(scene, view_)),
      oracle_(*canonical_, view_),
      crossings_(*canonical_, view_),
      rows_(runs_of(scene, kOddRows)) {}

double SamePicture::magnification() const {
  double least_w = 1;
  for (const Vec3& p : canonical_->vertices) {
    const double w = (view_.matrix * Vec4(p, 1)).z;
    const bool kept =
        !view_.near_plane || glm::dot(view_.near_plane->normal, p) >= view_.near_plane->offset;
    if (w > 0 && kept) least_w = std::min(least_w, w);
  }
  return 1 / (view_.world_per_cell * least_w);
}

/// The worst of what may change in the stretch.
double SamePicture::condition(const oracle::Line& line, double from, double to) const {
  double worst = 1;
  for (const double s : {from - kNear, from + (to - from) / 2, to + kNear}) {
    const Vec2 p = line.at(s);
    for (const auto& place : crossings_.places(line, oracle_.at(p.x, p.y)))
      if (place.s > from - kNear && place.s < to + kNear) worst = std::max(worst, place.condition);
  }
  return worst;
}

std::string SamePicture::difference(const Runs& other, double error) const {
  if (other.size() != rows_.size()) return "other numbers of rows";
  const double tone_error = canonical_->corner_normals.empty() ? kFlatError : kSmoothError;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const oracle::Line line{{0, kOddRows.offset + static_cast<double>(i)}, {1, 0}};
    for (const Stretch& s : differences(rows_[i], other[i], tone_error)) {
      const double width = s.to - s.from;
      if (width <= 2 * error || width <= 2 * error * condition(line, s.from, s.to)) continue;
      return "row " + std::to_string(i) + " differs for " + std::to_string(width) + " from " +
             std::to_string(s.from);
    }
  }
  return {};
}

}  // namespace overstrike::hard
