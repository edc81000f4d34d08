#include "tests/fuzz/core/judge.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/visibility/clip.h"
#include "tests/fuzz/fuzz.h"

namespace overstrike::fuzz {
namespace {

using oracle::Seen;

using oracle::kEndError;

/// Narrower stretches are not looked at: both ends may be off by kEndError.
constexpr double kNarrowest = 2 * kEndError;
/// Just within an end: so far that the error of a sound end does not reach there.
constexpr double kWithin = 2 * kEndError;
/// Densities of flat faces differ by rounding only: those of a few products below 1, and of a
/// normal that is of unit length but for rounding.
constexpr double kFlatDensityError = 0x1p-44;
/// Half a step of 8 bits: runs keep to half of that (density_tolerance_of), and a triangle seen
/// nearly edge-on has a gradient of few digits.
constexpr double kSmoothDensityError = 0.5 / 255;
/// |n.L| below which a shadow's border on the face may be off by a grid unit and more, kEndError
/// times its condition number 1 / |n.L| (crossings.h): what is lit there and what is in shadow is
/// not told apart. Which side light falls on is, always: that is decided by an exact sign.
constexpr double kGrazing = kEndError;

std::string text_of(const Seen& s) {
  if (s.paper()) return "paper";
  return std::string(to_string(s.kind)) + " face " + std::to_string(static_cast<int>(s.face)) +
         " body " + std::to_string(static_cast<int>(s.body)) + " density " +
         std::to_string(s.density);
}

}  // namespace

/// A run, or a gap between two.
struct Judge::Stretch {
  double from, to;
  const DensityRun* run;  ///< null: paper
};

Judge::Judge(const Canonical& canonical, const View& view)
    : in_(canonical),
      view_(view),
      place_error_(std::max(kEndError, place_error_of(canonical, view))),
      oracle_(canonical, view),
      crossings_(canonical, view) {
  clipped_ = view.near_plane && needs_clip(canonical, *view.near_plane);
  if (clipped_) left_ = clip(canonical, *view.near_plane, view.eye);
  for (const CanonicalBody& b : left_.bodies)
    for (Index i = 0; i < in_.bodies.size(); ++i)
      if (in_.bodies[i].source == b.source) body_of_drawn_.push_back(i);
}

/// The face keeps the number of what is drawn.
Seen Judge::seen_in(const DensityRun& run) const {
  const bool has_face = run.kind != Kind::cut && run.kind != Kind::ground_shadow;
  Seen seen{has_face ? run.surface : kNone, run.body, run.kind, 0};
  if (clipped_ && run.body != kNoSurface) {
    expect(run.body < body_of_drawn_.size(), "a run's body exists");
    seen.body = body_of_drawn_[run.body];
  }
  return seen;
}

Seen Judge::shown(const Stretch& stretch, double s) const {
  if (!stretch.run) return {};
  const DensityRun& run = *stretch.run;
  Seen seen = seen_in(run);
  const double t = std::clamp((s - run.x0) / (run.x1 - run.x0), 0.0, 1.0);
  seen.density = run.density0 + t * (run.density1 - run.density0);
  return seen;
}

bool Judge::grazed(Index face) const {
  if (!in_.light || face == kNone) return false;
  const Vec3 normal = in_.outward(in_.faces[face]);
  return std::fabs(glm::dot(normal, *in_.light)) < kGrazing;
}

/// Clipping numbers faces anew; they keep their planes. Of those in one plane a tie may hang on the
/// corners, which clipping changes.
bool Judge::same_face(Index expected, Index drawn) const {
  if (!clipped_ || expected == kNone || drawn == kNone) return expected == drawn;
  const CanonicalFace &f = in_.faces[expected], &g = left_.faces[drawn];
  const Plane &p = in_.planes[f.plane], &q = left_.planes[g.plane];
  return p.normal == q.normal && p.offset == q.offset;
}

/// For the same reason any body does that is as good but for them.
bool Judge::same_body(const Seen& expected, const Seen& found) const {
  if (!clipped_ || expected.face == kNone || found.body == kNone)
    return expected.body == found.body;
  const CanonicalBody &a = in_.bodies[expected.body], &b = in_.bodies[found.body];
  return a.density_factor == b.density_factor && a.smooth == b.smooth;
}

/// Of bodies that are cut at one place any.
bool Judge::same(const Seen& expected, const Seen& found) const {
  if (expected.kind == Kind::cut && found.kind == Kind::cut) return true;
  if (!same_body(expected, found) || !same_face(expected.face, found.face)) return false;
  const auto in_light = [](Kind kind) { return kind == Kind::lit || kind == Kind::shadow; };
  return expected.kind == found.kind ||
         (grazed(expected.face) && in_light(expected.kind) && in_light(found.kind));
}

bool Judge::agree(const Seen& expected, const Seen& found) const {
  if (!same(expected, found)) return false;
  const bool smooth = expected.body != kNone && in_.bodies[expected.body].smooth;
  const double allowed = smooth ? kSmoothDensityError : kFlatDensityError;
  const double density = expected.kind == found.kind  ? expected.density
                         : found.kind == Kind::shadow ? expected.in_shadow
                                                      : expected.away_from_shadow;
  return std::fabs(density - found.density) <= allowed;
}

std::vector<Judge::Stretch> Judge::stretches_of(const DrawnLine& line) const {
  double at = line.from;
  std::vector<Stretch> stretches;
  const auto add = [&](double from, double to, const DensityRun* run) {
    if (to - from > kNarrowest) stretches.push_back({from, to, run});
  };
  for (const DensityRun& run : line.runs) {
    add(at, run.x0, nullptr);
    add(run.x0, run.x1, &run);
    at = run.x1;
  }
  add(at, line.to, nullptr);
  return stretches;
}

void Judge::judge(const DrawnLine& line) const {
  if (place_error_ > 1) return;  // a cell: nothing has a place
  const std::vector<Stretch> all = stretches_of(line);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const double from = all[i].from, width = all[i].to - from;
    judge(line, all, i, from + width * 0.5);
    if (width > 4 * kWithin) judge(line, all, i, from + kWithin);
    if (width > 4 * kWithin) judge(line, all, i, all[i].to - kWithin);
    if (width > 1) judge(line, all, i, from + width * 0.13);
    if (width > 1) judge(line, all, i, from + width * 0.81);
  }
}

/// What is found is seen here, or at one of eight points round it: on one side of a border that
/// runs there, along the line or not. The nearer eight are for what is thinner than the farther
/// ones are away.
bool Judge::is_right(const DrawnLine& line, double s, const Seen& found) const {
  const Vec2 p = line.line.at(s);
  if (agree(oracle_.at(p.x, p.y), found)) return true;
  for (const double away : {line.beside / 4, kEndError, place_error_})
    for (const int i : {-1, 0, 1})
      for (const int j : {-1, 0, 1})
        if ((i != 0 || j != 0) && agree(oracle_.at(p.x + i * away, p.y + j * away), found))
          return true;
  return false;
}

void Judge::judge(const DrawnLine& line, const std::vector<Stretch>& all, std::size_t i,
                  double s) const {
  const Vec2 p = line.line.at(s);
  const Seen found = shown(all[i], s);
  if (is_right(line, s, found) || is_uncertain(line, all, i, s)) return;
  broken("the oracle sees what is drawn: at (" + std::to_string(p.x) + ", " + std::to_string(p.y) +
         ") of the stretch from " + std::to_string(all[i].from) + " to " +
         std::to_string(all[i].to) + " along (" + std::to_string(line.line.direction.x) + ", " +
         std::to_string(line.line.direction.y) + ") the oracle sees " +
         text_of(oracle_.at(p.x, p.y)) + ", found " + text_of(found));
}

/// True when what ends the stretch is so ill conditioned that it may have ended before `s`, where
/// what is drawn beyond that end is right.
bool Judge::is_uncertain(const DrawnLine& line, const std::vector<Stretch>& all, std::size_t i,
                         double s) const {
  const Seen drawn = shown(all[i], s);
  for (const int step : {-1, 1}) {
    const std::size_t next = i + static_cast<std::size_t>(step);
    if (next >= all.size()) continue;  // also below 0
    const Seen beyond = shown(all[next], s);
    if (!is_right(line, s, beyond)) continue;
    const double end = step < 0 ? all[i].from : all[i].to;
    for (const double condition : crossings_.conditions(line.line, end, drawn, beyond))
      if (kEndError * condition >= std::fabs(s - end)) return true;
  }
  return false;
}

}  // namespace overstrike::fuzz
