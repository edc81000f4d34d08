#include "core/visibility/run_shader.h"

#include <algorithm>
#include <cmath>

#include "core/shading/density_law.h"

namespace overstrike {

double density_tolerance_of(double tolerance) { return std::min(tolerance / 100, 1.0 / 1024); }

void RunShader::shade(double y, const std::vector<SpanPiece>& pieces,
                      std::vector<DensityRun>& runs) {
  if (shadows_.none()) {
    for (const SpanPiece& piece : pieces) toned(y, piece, runs);
    return;
  }
  ground_spans_known_ = false;
  for (const SpanPiece& piece : pieces) {
    const ReceiverShadow* shadow = nullptr;
    auto extent = ReceiverShadows::Extent::none;
    if (table_.tones[piece.face].kind == Kind::lit)
      extent = shadows_.on(piece.face, scratch_, shadow);
    if (extent == ReceiverShadows::Extent::part) {
      shaded(y, piece, *shadow, runs);
    } else {
      part(y, piece, extent == ReceiverShadows::Extent::all, runs);
    }
  }
}

/// Splits a piece where shadow begins and ends on it. Parts no wider than their ends are uncertain
/// are left to their neighbours.
void RunShader::shaded(double y, const SpanPiece& piece, const ReceiverShadow& shadow,
                       std::vector<DensityRun>& runs) {
  // The ground comes again and again between the bodies of one level.
  const bool ground = piece.face == table_.ground();
  std::vector<ShadowSpan>& spans = ground ? ground_spans_ : spans_;
  if (!ground || !ground_spans_known_) {
    shadow.on_level(y, order_, shadows_.coherence(), solids_, spans);
    ground_spans_known_ |= ground;
  }
  SpanPiece left = piece;
  bool shadowed = false;
  const auto change = [&](double x, float slack, bool to) {
    if (x > left.x0 && x < piece.x1) {
      if (x - left.x0 > left.slack0 + slack && piece.x1 - x > slack + piece.slack1) {
        left.x1 = x, left.slack1 = slack;
        part(y, left, shadowed, runs);
        left.x0 = x, left.slack0 = slack;
      } else if (piece.x1 - x <= slack + piece.slack1) {
        return;
      }
    }
    if (x < piece.x1) shadowed = to;
  };
  for (const ShadowSpan& span : spans) {
    if (span.x1 <= piece.x0) continue;
    if (span.x0 >= piece.x1) break;
    change(span.x0, span.slack0, true);
    change(span.x1, span.slack1, false);
  }
  left.x1 = piece.x1, left.slack1 = piece.slack1;
  part(y, left, shadowed, runs);
}

void RunShader::part(double y, const SpanPiece& piece, bool shadowed,
                     std::vector<DensityRun>& runs) {
  if (!shadowed) return toned(y, piece, runs);
  const DensityLaw& law = table_.canonical.law;
  if (piece.face == table_.ground()) {
    const double density = std::clamp(law.hmax * law.ground_shadow_factor, 0.0, 1.0);
    runs.push_back(
        {piece.x0, piece.x1, density, density, kNoSurface, kNoSurface, Kind::ground_shadow});
    return;
  }
  const Index body = table_.tones[piece.face].body;
  const double density = shade_density(table_.canonical, table_.canonical.bodies[body]);
  runs.push_back({piece.x0, piece.x1, density, density, piece.face, body, Kind::shadow});
}

void RunShader::toned(double y, const SpanPiece& piece, std::vector<DensityRun>& runs) {
  const FaceTone& tone = table_.tones[piece.face];
  if (tone.smooth) return smooth(y, piece, runs);
  if (tone.body == kNone) return;  // the ground: bare paper
  runs.push_back(
      {piece.x0, piece.x1, tone.density, tone.density, piece.face, tone.body, tone.kind});
}

/// Density times 1/w^ and 1/w^ itself are linear over the grid on a triangle of the face's fan (the
/// first corner, `corner` and the next): solve for the three corners. False where it has no area.
bool RunShader::gradient_of(Index face, Index corner, Gradient& out) const {
  const Canonical& c = table_.canonical;
  const CanonicalFace& f = c.faces[face];
  const FaceTone& tone = table_.tones[face];
  const Index corners[3] = {c.first_corner(f.first_loop), corner, corner + 1};
  const bool behind = table_.from_behind(face);
  Vec3 density, over_w, x, y;
  for (int i = 0; i < 3; ++i) {
    const Vec3& p = c.vertices[c.corners[corners[i]]];
    const Vec3& normal = c.corner_normals[corners[i]];
    x[i] = table_.points[c.corners[corners[i]]].x, y[i] = table_.points[c.corners[corners[i]]].y;
    over_w[i] = 1 / (table_.view.matrix * Vec4(p, 1.0)).z;
    density[i] = lit_density(c, c.bodies[tone.body], behind ? -normal : normal);
  }
  const Mat3 matrix(x, y, Vec3(1.0));
  if (glm::determinant(matrix) == 0) return false;
  const Mat3 solve = glm::inverse(matrix);
  out = {solve * (density * over_w), solve * over_w, std::min({density.x, density.y, density.z}),
         std::max({density.x, density.y, density.z})};
  return true;
}

/// A face is shaded as a fan of triangles from its first corner: split where the level meets ribs.
void RunShader::smooth(double y, const SpanPiece& piece, std::vector<DensityRun>& runs) {
  const Canonical& c = table_.canonical;
  const CanonicalFace& f = c.faces[piece.face];
  const Index first = c.first_corner(f.first_loop), end = c.loop_ends[f.first_loop];
  const Vec2& hub = table_.points[c.corners[first]];
  const FaceTone& tone = table_.tones[piece.face];
  const bool behind = table_.from_behind(piece.face);
  double x = piece.x0;
  const auto triangle_at = [&](double at) {
    // The last triangle whose rib the point has passed, turning round the hub.
    const Vec2 p(at - hub.x, y - hub.y);
    Index corner = first + 1;
    for (Index i = first + 2; i + 1 < end; ++i) {
      const Vec2 rib = table_.points[c.corners[i]] - hub;
      const double side = rib.x * p.y - rib.y * p.x;
      if (behind ? side > 0 : side < 0) corner = i;
    }
    return corner;
  };
  ribs_.clear();
  for (Index i = first + 2; i + 1 < end; ++i) {
    const Vec2& tip = table_.points[c.corners[i]];
    if ((hub.y <= y) == (tip.y <= y)) continue;
    const LevelLine rib = hub.y < tip.y ? LevelLine(hub, tip) : LevelLine(tip, hub);
    const double at = rib.x_at(y);
    if (at > piece.x0 && at < piece.x1) ribs_.push_back(at);
  }
  std::sort(ribs_.begin(), ribs_.end());
  ribs_.push_back(piece.x1);
  for (const double to : ribs_) {
    if (!(to > x)) continue;
    Gradient gradient;
    DensityRun run{x, to, tone.density, tone.density, piece.face, tone.body, tone.kind};
    const double middle = x + (to - x) / 2;
    if (gradient_of(piece.face, triangle_at(middle), gradient)) {
      run.density0 = gradient.at(x, y), run.density1 = gradient.at(to, y);
      bent(run, gradient, y, 0, runs);
    } else {
      runs.push_back(run);
    }
    x = to;
  }
}

/// Halves the run until its middle lies on the chord; a perspective picture of a linear density
/// bends but one way, so that the middle tells.
void RunShader::bent(DensityRun run, const Gradient& gradient, double y, int depth,
                     std::vector<DensityRun>& runs) const {
  constexpr int kMostHalvings = 16;
  const double middle = run.x0 + (run.x1 - run.x0) / 2;
  const double density = gradient.at(middle, y);
  const bool straight =
      std::fabs(density - (run.density0 + run.density1) / 2) <= density_tolerance_;
  if (straight || depth == kMostHalvings || !(run.x0 < middle && middle < run.x1)) {
    runs.push_back(run);
    return;
  }
  DensityRun left = run, right = run;
  left.x1 = right.x0 = middle;
  left.density1 = right.density0 = density;
  bent(left, gradient, y, depth + 1, runs);
  bent(right, gradient, y, depth + 1, runs);
}

}  // namespace overstrike
