#include "tests/oracle/trial.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <map>
#include <sstream>
#include <utility>

#include "core/visibility/clip.h"

namespace overstrike::oracle {
namespace {

/// Failures of one view that are reported in full.
constexpr std::size_t kReported = 3;

std::string to_text(const Seen& s) {
  if (s.paper()) return "paper";
  const auto number = [](Index i) { return i == kNone ? std::string("-") : std::to_string(i); };
  return std::string(to_string(s.kind)) + " face " + number(s.face) + " body " + number(s.body) +
         " density " + std::to_string(s.density);
}

std::string place(const Vec2& p) {
  std::ostringstream text;
  text << std::setprecision(12) << "at (" << p.x << ", " << p.y << "): ";
  return text.str();
}

Line line_of(const ScanFamily& family, std::int64_t index) {
  const double angle = family.angle_deg * (3.14159265358979323846 / 180);
  const Vec2 direction(std::cos(angle), std::sin(angle));
  const double offset = family.offset + static_cast<double>(index) * family.spacing;
  return {offset * Vec2(-direction.y, direction.x), direction};
}

/// The part of a line in the grid; from > to when there is none.
std::pair<double, double> clip(const Line& line, const Grid& grid) {
  double from = -INFINITY, to = INFINITY;
  for (int axis = 0; axis < 2; ++axis) {
    const double size = axis == 0 ? grid.columns : grid.rows;
    const double o = line.origin[axis], d = line.direction[axis];
    if (d == 0) {
      if (o < 0 || o > size) to = -INFINITY;
      continue;
    }
    from = std::max(from, std::min(-o / d, (size - o) / d));
    to = std::min(to, std::max(-o / d, (size - o) / d));
  }
  return {from, to};
}

}  // namespace

Seen Stretch::seen(double s) const {
  if (!run) return {};
  const double t = (s - run->x0) / (run->x1 - run->x0);
  const double density = run->density0 + t * (run->density1 - run->density0);
  const bool has_face = run->kind != Kind::cut && run->kind != Kind::ground_shadow;
  return {has_face ? run->surface : kNone, run->body, run->kind, density};
}

std::vector<Stretch> ScannedLine::stretches() const {
  std::vector<Stretch> made;
  double s = from;
  const auto add = [&](double until, const DensityRun* run) {
    if (until > s) made.push_back({s, until, run});
    s = until;
  };
  for (const DensityRun& r : runs) add(r.x0, nullptr), add(r.x1, &r);
  add(to, nullptr);
  return made;
}

namespace {

std::shared_ptr<const Canonical> canonical_of(const Scene& scene, const View& view,
                                              double tolerance, std::vector<Diagnostic>& warnings) {
  return std::make_shared<const Canonical>(canonicalize(scene, view, tolerance, warnings));
}

constexpr ScanFamily kUsual[] = {{0, 1, 0.5}, {0, 3.7, 0.2937}, {33, 5.3, 0.71}};

}  // namespace

Trial::Trial(const Scene& scene, const Grid& grid, double tolerance, std::string name)
    : Trial(scene, grid, tolerance, std::move(name), kUsual, 0) {}

Trial::Trial(const Scene& scene, const Grid& grid, double tolerance, std::string name,
             std::span<const ScanFamily> families, int through_vertices)
    : grid_(grid),
      name_(std::move(name)),
      view_(make_view(scene, grid)),
      canonical_(canonical_of(scene, view_, tolerance, warnings_)),
      oracle_(*canonical_, view_),
      crossings_(*canonical_, view_) {
  std::seed_seq seed(name_.begin(), name_.end());
  bits_.seed(seed);
  learn_numbers();
  DrawOptions options;
  options.tolerance = tolerance;
  options.threads = 1;
  Drawing drawing(canonical_, view_, options);
  for (const ScanFamily& family : families) scan(drawing, family);
  for (const ScanFamily& family : lines_through_vertices(through_vertices)) scan(drawing, family);
}

void Trial::judge(int points, int ends) {
  for (const std::string& failure : judge(Effort{points, ends, 0, 0})) ADD_FAILURE() << failure;
}

const std::vector<std::string>& Trial::judge(const Effort& effort) {
  for (int i = 0; i < effort.points; ++i) judge_point();
  for (int i = 0; i < effort.gaps; ++i) judge_gap();
  for (int i = 0; i < effort.beside; ++i) judge_beside();
  judge_ends(effort.ends);
  return failures_;
}

/// One line each, at the y of a vertex: its spacing takes the next out of the grid.
std::vector<ScanFamily> Trial::lines_through_vertices(int count) {
  std::vector<ScanFamily> families;
  const auto& vertices = canonical_->vertices;
  for (int i = 0; i < count && !vertices.empty(); ++i) {
    const Vec3& p = vertices[bits_() % vertices.size()];
    if (!((view_.matrix * Vec4(p, 1)).z > 0)) continue;
    const double y = view_.project(p).y;
    if (y > 0 && y < grid_.rows) families.push_back({0, 2 * grid_.rows, y});
  }
  return families;
}

Index Trial::first_in_plane(Index body, const Plane& plane, bool flipped) const {
  for (Index f = canonical_->bodies[body].first_face; f < canonical_->bodies[body].end_face; ++f) {
    const CanonicalFace& face = canonical_->faces[f];
    const Plane& p = canonical_->planes[face.plane];
    if (p.normal == plane.normal && p.offset == plane.offset && face.flipped == flipped) return f;
  }
  return kNone;
}

void Trial::learn_numbers() {
  if (!view_.near_plane || !needs_clip(*canonical_, *view_.near_plane)) return;
  const Canonical drawn = clip(*canonical_, *view_.near_plane, view_.eye);
  std::map<Index, Index> body_of_source;
  for (Index b = 0; b < canonical_->bodies.size(); ++b)
    body_of_source[canonical_->bodies[b].source] = b;
  for (const CanonicalBody& b : drawn.bodies) body_of_drawn_.push_back(body_of_source.at(b.source));
  for (const CanonicalFace& f : drawn.faces)
    face_of_drawn_.push_back(
        first_in_plane(body_of_drawn_[f.body], drawn.planes[f.plane], f.flipped));
  for (const CanonicalFace& f : canonical_->faces)
    face_of_input_.push_back(first_in_plane(f.body, canonical_->planes[f.plane], f.flipped));
}

Kind Trial::told_apart(Kind kind, Index face) const {
  if (!canonical_->light || face == kNone) return kind;
  const Vec3 normal = canonical_->outward(canonical_->faces[face]);
  return std::fabs(glm::dot(normal, *canonical_->light)) < kGrazing ? Kind::shade : kind;
}

DensityRun Trial::in_numbers_of_input(DensityRun run) const {
  if (!face_of_input_.empty()) {
    if (run.surface != kNoSurface) run.surface = face_of_drawn_.at(run.surface);
    if (run.body != kNoSurface) run.body = body_of_drawn_.at(run.body);
  }
  if (run.kind != Kind::cut && run.kind != Kind::ground_shadow)
    run.kind = told_apart(run.kind, run.surface);
  return run;
}

Seen Trial::oracle_at(const Vec2& p) const {
  Seen seen = oracle_.at(p.x, p.y);
  if (!face_of_input_.empty() && seen.face != kNone) seen.face = face_of_input_[seen.face];
  seen.kind = told_apart(seen.kind, seen.face);
  return seen;
}

void Trial::scan(Drawing& drawing, const ScanFamily& family) {
  const std::size_t before = lines_.size();
  drawing.runs(family, [&](const RunRow& row) {
    const Line line = line_of(family, row.index);
    const auto [from, to] = clip(line, grid_);
    if (!(from < to)) return;
    lines_.push_back({line, from, to, {}});
    for (const DensityRun& run : row.runs) lines_.back().runs.push_back(in_numbers_of_input(run));
    for (std::size_t i = 0; i < row.runs.size(); ++i) {
      if (!(row.runs[i].x0 < row.runs[i].x1)) fail("an empty run");
      if (i > 0 && row.runs[i].x0 < row.runs[i - 1].x1) fail("runs overlap");
    }
  });
  if (lines_.size() == before) fail("no scan lines");
}

void Trial::fail(const std::string& what) {
  if (failures_.size() < kReported) failures_.push_back(name_ + ": " + what);
}

double Trial::uniform(double low, double high) {
  return low + (high - low) * (static_cast<double>(bits_() >> 11) * 0x1p-53);
}

void Trial::judge_point() {
  const ScannedLine& scanned = any_line();
  judge_at(scanned, uniform(scanned.from, scanned.to));
}

/// Of a random line: where the scene's edges cross it, and what may change on one of the planes
/// seen. Those that lie together count once, with the worst of their condition numbers.
std::vector<Crossings::Place> Trial::places(const ScannedLine& scanned) {
  const Seen seen = oracle_at(scanned.line.at(uniform(scanned.from, scanned.to)));
  std::vector<Crossings::Place> kept;
  for (const Crossings::Place& p : crossings_.places(scanned.line, seen)) {
    if (p.s <= scanned.from || p.s >= scanned.to) continue;
    if (!kept.empty() && p.s - kept.back().s <= kBeside * kept.back().condition)
      kept.back().condition = std::max(kept.back().condition, p.condition);
    else
      kept.push_back(p);
  }
  return kept;
}

void Trial::judge_gap() {
  const ScannedLine& scanned = any_line();
  const auto at = places(scanned);
  if (at.size() < 2) return;
  const std::size_t i = bits_() % (at.size() - 1);
  judge_at(scanned, (at[i].s + at[i + 1].s) / 2);
}

void Trial::judge_beside() {
  const ScannedLine& scanned = any_line();
  const auto at = places(scanned);
  if (at.empty()) return;
  const Crossings::Place& place = at[bits_() % at.size()];
  const double s = place.s + (bits_() % 2 == 0 ? 1 : -1) * kBeside * place.condition;
  if (scanned.from < s && s < scanned.to) judge_at(scanned, s);
}

void Trial::judge_at(const ScannedLine& scanned, double s) {
  const Vec2 p = scanned.line.at(s);
  const Seen expected = oracle_at(p);
  Seen found;
  for (const Stretch& stretch : scanned.stretches())
    if (stretch.from <= s && s < stretch.to) found = stretch.seen(s);
  const bool smooth = found.body != kNone && canonical_->bodies[found.body].smooth;
  const double allowed = smooth ? kSmoothDensityError : kFlatDensityError;
  if (expected.same(found) && std::fabs(expected.density - found.density) <= allowed) return;
  if (!expected.same(found) && is_right(scanned.line, s, found))
    ++skipped_;
  else
    fail(place(p) + "expected " + to_text(expected) + ", found " + to_text(found));
}

/// `found` is right to within kEndError: it is seen here or that near, or where it would be seen a
/// border is that near, times its condition number.
bool Trial::is_right(const Line& line, double s, const Seen& found) const {
  const Vec2 p = line.at(s), along = line.direction * kEndError, across(-along.y, along.x);
  for (const Vec2& d : {Vec2(0), along, -along, across, -across, along + across, along - across,
                        across - along, -along - across}) {
    const Seen expected = oracle_at(p + d);
    if (expected.same(found) || crossings_.may_be_off(p + d, expected, found, kEndError) ||
        crossings_.on_both_borders(p, expected, found, kEndError))
      return true;
  }
  return false;
}

void Trial::judge_ends(int count) {
  constexpr int kTries = 20;  // for one end that is a true change and not the grid's
  for (int tries = 0; tries < kTries * count && count > 0; ++tries) {
    const ScannedLine& scanned = any_line();
    const auto stretches = scanned.stretches();
    if (stretches.size() < 2) continue;
    const std::size_t i = bits_() % (stretches.size() - 1);
    const double s = stretches[i].to;
    if (stretches[i].width() < kThinnest || stretches[i + 1].width() < kThinnest) continue;
    if (stretches[i].seen(s).same(stretches[i + 1].seen(s))) continue;
    judge_end(scanned.line, stretches[i], stretches[i + 1]);
    --count;
  }
}

/// Something crosses here, and within its conditioned error the oracle sees the neighbours.
void Trial::judge_end(const Line& line, const Stretch& left, const Stretch& right) {
  const double s = left.to;
  const Seen l = left.seen(s), r = right.seen(s);
  std::string seen;
  // An edge along the line crosses it nowhere, or anywhere.
  std::vector<double> conditions = crossings_.conditions(line, s, l, r);
  conditions.insert(conditions.begin(), 1.0);
  for (const double condition : conditions) {
    const double reach = kEndError * std::max(1.0, condition);
    const double before = std::max(s - reach, (left.from + s) / 2),
                 after = std::min(s + reach, (right.to + s) / 2);
    if (is_right(line, before, l) && is_right(line, after, r)) return;
    const Seen was = oracle_at(line.at(before)), is = oracle_at(line.at(after));
    seen +=
        "; conditioned " + std::to_string(condition) + ": " + to_text(was) + " | " + to_text(is);
  }
  fail(place(line.at(s)) + "a run ends between " + to_text(l) + " | " + to_text(r) +
       ", the oracle sees" + seen);
}

}  // namespace overstrike::oracle
