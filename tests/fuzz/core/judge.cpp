#include "tests/fuzz/core/judge.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/visibility/clip.h"
#include "tests/fuzz/fuzz.h"

namespace overstrike::fuzz {
namespace {

using oracle::Seen;

/// Narrower stretches are not looked at: twice the radius in which a true edge excuses.
constexpr double kNarrowest = 2 * oracle::kEdgeRadius;
/// Ends are this near to the true crossing, times its condition number, and densities to what the
/// oracle computes (as Trial has them).
constexpr double kEndError = 1e-9, kFlatDensityError = 1e-9, kSmoothDensityError = 0.5 / 255;
/// Light that grazes a face so much does not tell lit, shade and shadow apart.
constexpr double kGrazing = kEndError;

std::string text_of(const Seen& s) {
  if (s.paper()) return "paper";
  return std::string(to_string(s.kind)) + " face " + std::to_string(static_cast<int>(s.face)) +
         " body " + std::to_string(static_cast<int>(s.body)) + " density " +
         std::to_string(s.density);
}

}  // namespace

struct Judge::Stretch {
  double from, to;
  const DensityRun* run;  ///< null: paper
};

Judge::Judge(const Canonical& canonical, const View& view)
    : in_(canonical), view_(view), oracle_(canonical, view), crossings_(canonical, view) {
  clipped_ = view.near_plane && needs_clip(canonical, *view.near_plane);
  const Canonical left = clipped_ ? clip(canonical, *view.near_plane) : Canonical{};
  for (const CanonicalBody& b : left.bodies)
    for (Index i = 0; i < in_.bodies.size(); ++i)
      if (in_.bodies[i].source == b.source) body_of_drawn_.push_back(i);
}

/// Faces are left out where clipping has numbered them anew.
Seen Judge::seen_in(const DensityRun& run) const {
  const bool has_face = !clipped_ && run.kind != Kind::cut && run.kind != Kind::ground_shadow;
  Seen seen{has_face ? run.surface : kNone, run.body, run.kind, 0};
  if (clipped_ && run.body != kNoSurface) {
    expect(run.body < body_of_drawn_.size(), "a run's body exists");
    seen.body = body_of_drawn_[run.body];
  }
  return seen;
}

bool Judge::agree(const Seen& expected, const Seen& found) const {
  const bool smooth = expected.body != kNone && in_.bodies[expected.body].smooth;
  const double allowed = smooth ? kSmoothDensityError : kFlatDensityError;
  if (std::fabs(expected.density - found.density) > allowed) return false;
  if (expected.kind == Kind::cut && found.kind == Kind::cut) return true;
  if (expected.body != found.body) return false;
  if (!clipped_ && expected.face != found.face) return false;
  if (expected.kind == found.kind) return true;
  if (!in_.light || expected.face == kNone) return false;
  const Vec3 normal = in_.outward(in_.faces[expected.face]);
  return std::fabs(glm::dot(normal, *in_.light)) < kGrazing;
}

void Judge::judge(const DrawnLine& line) const {
  double at = line.from;
  std::vector<Stretch> stretches;
  for (const DensityRun& run : line.runs) {
    if (run.x0 > at) stretches.push_back({at, run.x0, nullptr});
    stretches.push_back({run.x0, run.x1, &run});
    at = run.x1;
  }
  if (at < line.to) stretches.push_back({at, line.to, nullptr});
  for (const Stretch& s : stretches) {
    if (!(s.to - s.from > kNarrowest)) continue;
    judge(line, s, s.from + (s.to - s.from) * 0.5);
    if (s.to - s.from > 1) judge(line, s, s.from + (s.to - s.from) * 0.13);
    if (s.to - s.from > 1) judge(line, s, s.from + (s.to - s.from) * 0.81);
  }
}

void Judge::judge(const DrawnLine& line, const Stretch& stretch, double s) const {
  const Vec2 p = line.line.at(s);
  Seen found;
  if (const DensityRun* run = stretch.run) {
    found = seen_in(*run);
    const double t = (s - run->x0) / (run->x1 - run->x0);
    found.density = run->density0 + t * (run->density1 - run->density0);
  }
  const Seen expected = oracle_.at(p.x, p.y);
  if (agree(expected, found) || oracle_.near_edge(p.x, p.y, oracle::kEdgeRadius)) return;
  if (is_uncertain(line, stretch, s)) return;
  broken("the oracle sees what is drawn: at (" + std::to_string(p.x) + ", " + std::to_string(p.y) +
         ") of the stretch from " + std::to_string(stretch.from) + " to " +
         std::to_string(stretch.to) + " along (" + std::to_string(line.line.direction.x) + ", " +
         std::to_string(line.line.direction.y) + ") the oracle sees " + text_of(expected) +
         ", found " + text_of(found));
}

/// True when what ends the stretch is so ill conditioned that it may have ended before `s`.
bool Judge::is_uncertain(const DrawnLine& line, const Stretch& stretch, double s) const {
  const Vec2 p = line.line.at(s);
  const Seen there = oracle_.at(p.x, p.y);
  const Seen drawn = stretch.run ? seen_in(*stretch.run) : Seen{};
  for (const double end : {stretch.from, stretch.to})
    for (const double condition : crossings_.conditions(line.line, end, drawn, there))
      if (kEndError * condition >= std::fabs(s - end)) return true;
  return false;
}

}  // namespace overstrike::fuzz
