#include "core/visibility/nn74/paint.h"

#include <algorithm>
#include <cmath>

namespace overstrike::nn74 {
namespace {

/// Grid units: few bodies pass a band that do not matter to its lines.
constexpr double kBandHeight = 8;

std::size_t band_at(double y, std::size_t count) {
  return static_cast<std::size_t>(
      std::clamp(std::floor(y / kBandHeight), 0.0, static_cast<double>(count - 1)));
}

}  // namespace

bool PaintedLine::keeps(const Piece& old, Index face) const {
  if (old.face == kNone || old.face == face) return false;
  return picture_.faces[old.face].plane == picture_.faces[face].plane &&
         picture_.wins_tie(old.face, face);
}

void PaintedLine::paint(double x0, double x1, Index face, bool shadowed) {
  x0 = std::max(x0, 0.0), x1 = std::min(x1, picture_.columns);
  if (!(x0 < x1)) return;
  const auto first = std::partition_point(pieces_.begin(), pieces_.end(),
                                          [&](const Piece& p) { return p.x1 <= x0; });
  const auto last =
      std::partition_point(first, pieces_.end(), [&](const Piece& p) { return p.x0 < x1; });
  painted_.clear();
  double at = x0;
  const auto fill = [&](double to) {
    if (at < to) painted_.push_back({at, to, face, shadowed});
  };
  for (auto old = first; old != last; ++old) {
    if (old->x0 < x0) painted_.push_back({old->x0, x0, old->face, old->shadowed});
    if (face != kNone && keeps(*old, face)) {
      const double from = std::max(old->x0, x0), to = std::min(old->x1, x1);
      fill(from);
      painted_.push_back({from, to, old->face, old->shadowed});
      at = to;
    }
  }
  fill(x1);
  if (first != last && (last - 1)->x1 > x1)
    painted_.push_back({x1, (last - 1)->x1, (last - 1)->face, (last - 1)->shadowed});
  const auto place = pieces_.erase(first, last);
  pieces_.insert(place, painted_.begin(), painted_.end());
}

DensityRun PaintedLine::run_of(const Piece& p) const {
  if (p.face == kNone) {
    const double ground = picture_.ground_density;
    return {p.x0, p.x1, ground, ground, kNoSurface, kNoSurface, Kind::ground_shadow};
  }
  const PictureFace& f = picture_.faces[p.face];
  const double density = p.shadowed ? f.in_shadow : f.density;
  return {p.x0, p.x1, density, density, f.face, f.body, p.shadowed ? Kind::shadow : f.kind};
}

void PaintedLine::append_to(std::vector<DensityRun>& runs) const {
  const std::size_t start = runs.size();
  for (const Piece& piece : pieces_) {
    const DensityRun run = run_of(piece);
    const bool continues = runs.size() > start && runs.back().x1 == run.x0 &&
                           runs.back().surface == run.surface && runs.back().kind == run.kind;
    if (continues) {
      runs.back().x1 = run.x1;
    } else {
      runs.push_back(run);
    }
  }
}

Painter::Painter(const Picture& picture, const std::vector<std::vector<Index>>& bands)
    : picture_(picture), bands_(bands), line_(picture) {}

void Painter::resolve(double y, std::vector<DensityRun>& runs) {
  y += beside_line(picture_.columns, picture_.rows);
  line_.clear();
  for (const Outline& shadow : picture_.ground_shadows) {
    const Border* left = active(shadow.left, y);
    const Border* right = active(shadow.right, y);
    if (left != nullptr && right != nullptr)
      line_.paint(left->x_at(y), right->x_at(y), kNone, true);
  }
  gather(y);
  order();
  for (const Index i : far_to_near_) paint_body(on_line_[i], y);
  line_.append_to(runs);
}

/// Step 2, by the left end.
void Painter::gather(double y) {
  on_line_.clear();
  for (const Index body : bands_[band_at(y, bands_.size())]) {
    const Outline& outline = picture_.bodies[body].outline;
    const Border* left = active(outline.left, y);
    const Border* right = active(outline.right, y);
    if (left == nullptr || right == nullptr) continue;
    const double x0 = left->x_at(y), x1 = right->x_at(y);
    if (x0 < x1 && x0 < picture_.columns && x1 > 0) on_line_.push_back({x0, x1, body});
  }
  std::sort(on_line_.begin(), on_line_.end(), [](const Interval& a, const Interval& b) {
    return a.x0 != b.x0 ? a.x0 < b.x0 : a.body < b.body;
  });
}

/// Step 3: repeatedly a body with nothing left behind it.
void Painter::order() {
  const std::size_t n = on_line_.size();
  if (nearer_.size() < n) nearer_.resize(n);
  farther_count_.assign(n, 0);
  for (std::size_t i = 0; i < n; ++i) nearer_[i].clear();
  for (Index i = 0; i < n; ++i)
    for (Index j = i + 1; j < n && on_line_[j].x0 < on_line_[i].x1; ++j) {
      const int front = picture_.front(on_line_[i].body, on_line_[j].body);
      if (front == 0) continue;
      nearer_[front > 0 ? j : i].push_back(front > 0 ? i : j);
      ++farther_count_[front > 0 ? i : j];
    }
  far_to_near_.clear();
  for (Index i = 0; i < n; ++i)
    if (farther_count_[i] == 0) far_to_near_.push_back(i);
  for (std::size_t next = 0; next < far_to_near_.size(); ++next)
    for (const Index i : nearer_[far_to_near_[next]])
      if (--farther_count_[i] == 0) far_to_near_.push_back(i);
  // Overlaps no wider than rounding may make a cycle all the same: any order draws them.
  for (Index i = 0; i < n; ++i)
    if (farther_count_[i] != 0) far_to_near_.push_back(i);
}

/// Step 4.
void Painter::paint_body(const Interval& body, double y) {
  const Border* left = active(picture_.bodies[body.body].outline.left, y);
  double x = body.x0;
  std::size_t walked = 0;
  for (Index face = left->face; face != kNone && walked < picture_.faces.size(); ++walked) {
    const Border* right = active(picture_.faces[face].outline.right, y);
    const bool last = right == nullptr || right->face == kNone;
    const double end = last ? body.x1 : std::clamp(right->x_at(y), x, body.x1);
    const bool covered = picture_.faces[face].covered;
    line_.paint(x, end, face, covered);
    if (!covered) paint_shadows(face, x, end, y);
    x = end;
    face = last ? kNone : right->face;
  }
}

/// Step 5. Where a shadow ends on the face's own outline it ends with the face.
void Painter::paint_shadows(Index face, double x0, double x1, double y) {
  for (const Outline& shadow : picture_.faces[face].shadows) {
    const Border* left = active(shadow.left, y);
    const Border* right = active(shadow.right, y);
    if (left == nullptr || right == nullptr) continue;
    line_.paint(left->own ? x0 : std::max(x0, left->x_at(y)),
                right->own ? x1 : std::min(x1, right->x_at(y)), face, true);
  }
}

PaintSource::PaintSource(const Canonical& seen, const View& view, const LightPhase& light)
    : picture_(look(seen, view, light)) {
  bands_.resize(
      std::max<std::size_t>(1, static_cast<std::size_t>(std::ceil(picture_.rows / kBandHeight))));
  for (const PictureBody& body : picture_.bodies) {
    const Outline& outline = body.outline;
    if (!(outline.top < outline.bottom) || outline.bottom < 0) continue;
    if (outline.top > picture_.rows) continue;
    for (std::size_t b = band_at(outline.top, bands_.size());
         b <= band_at(outline.bottom, bands_.size()); ++b)
      bands_[b].push_back(body.number);
  }
}

std::unique_ptr<RunScanner> PaintSource::scanner() const {
  return std::make_unique<Painter>(picture_, bands_);
}

}  // namespace overstrike::nn74
