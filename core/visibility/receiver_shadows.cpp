#include "core/visibility/receiver_shadows.h"

#include <algorithm>
#include <limits>

#include "core/visibility/far_line.h"
#include "core/visibility/projected_scene.h"
#include "core/visibility/run_source.h"

namespace overstrike {
namespace {

constexpr double kEps = std::numeric_limits<double>::epsilon();
constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// Lines of a receiver that are looked through one by one.
constexpr std::size_t kFew = 32;

Vec2 projected(const View& view, const Vec3& p) {
  const Mat4& m = view.matrix;
  const double x = m[0][0] * p.x + m[1][0] * p.y + m[2][0] * p.z + m[3][0];
  const double y = m[0][1] * p.x + m[1][1] * p.y + m[2][1] * p.z + m[3][1];
  if (!view.perspective) return Vec2(x, y);
  const double w = m[0][2] * p.x + m[1][2] * p.y + m[2][2] * p.z + m[3][2];
  return Vec2(x / w, y / w);
}

/// Sums of the sizes of a point's terms, x^, y^, w^, z^.
Vec4 sizes_of(const View& view, const Vec3& p) {
  Vec4 size = glm::abs(view.matrix[3]);
  for (int column = 0; column < 3; ++column) size += glm::abs(view.matrix[column] * p[column]);
  return size;
}

/// Bound on how far a shadow edge may be from where it was meant, in the picture, as to_grid() has
/// it for points: between its ends no w^ is smaller and no term larger than at one of them.
double edge_error(const View& view, const ShadowEdge& edge, double reach) {
  const Vec4 size = glm::max(sizes_of(view, edge.a), sizes_of(view, edge.b));
  const double w =
      std::min((view.matrix * Vec4(edge.a, 1.0)).z, (view.matrix * Vec4(edge.b, 1.0)).z);
  return kPointRounding * (std::max(size.x, size.y) + size.z * reach) / std::fabs(w);
}

/// The same of all, in a parallel view (w^ = 1), where no coordinate is larger than the sum of its
/// terms' sizes.
double edges_error(const View& view, const std::vector<ShadowEdge>& edges) {
  Vec3 reach(0.0);
  for (const ShadowEdge& e : edges) reach = glm::max(reach, glm::max(glm::abs(e.a), glm::abs(e.b)));
  Vec4 size = glm::abs(view.matrix[3]);
  for (int column = 0; column < 3; ++column) size += glm::abs(view.matrix[column]) * reach[column];
  return 2 * kPointRounding * std::max(size.x, size.y);
}

struct Crossing {
  double x;
  float slack;
  int winding;
};

}  // namespace

ReceiverShadow::ReceiverShadow(const FrontTable& table, const Shadow& shadow)
    : plane_(table.plane_of(shadow.receiver)), base_(shadow.covered) {
  if (shadow.edges.empty()) return;
  const Box receiver = box_of(table, shadow.receiver);
  Error error{0, beside_line(table.columns, table.rows)};
  if (!table.view.perspective) error.point = edges_error(table.view, shadow.edges);
  const double reach = std::max(table.columns, table.rows) + 1;
  for (const ShadowEdge& edge : shadow.edges) {
    if (table.view.perspective) error.point = edge_error(table.view, edge, reach);
    add_line(edge, table.view, receiver, error);
  }
  if (lines_.size() > kFew)
    bands_.emplace(table.rows, lines_.size(),
                   [&](std::size_t i) { return std::pair(lines_[i].line.y0, lines_[i].line.y1); });
}

ReceiverShadow::Box ReceiverShadow::box_of(const FrontTable& table, Index face) {
  if (face == table.ground()) return {Vec2(-1), Vec2(table.columns, table.rows) + 1.0};
  Box box{Vec2(kInfinity), Vec2(-kInfinity)};
  const CanonicalFace& f = table.canonical.faces[face];
  for (Index l = f.first_loop; l < f.end_loop; ++l)
    for (const Index v : table.canonical.loop(l)) {
      box.low = glm::min(box.low, table.points[v]);
      box.high = glm::max(box.high, table.points[v]);
    }
  return box;
}

/// Lines that pass the receiver by on the right count nowhere on it; those that pass by on the
/// left, all along it, everywhere.
void ReceiverShadow::add_line(const ShadowEdge& edge, const View& view, const Box& receiver,
                              const Error& errors) {
  const Vec2 a = projected(view, edge.a), b = projected(view, edge.b);
  if (a.y == b.y) return;
  // A corner that rounding has put into the eye's own plane, of a near plane that stands there.
  if (!std::isfinite(a.x + a.y + b.x + b.y)) return;
  const bool down = a.y < b.y;
  LevelLine line = down ? LevelLine(a, b) : LevelLine(b, a);
  if (is_far_away(a) || is_far_away(b))
    line = far_line(view, down ? edge.a : edge.b, down ? edge.b : edge.a, line);
  if (line.y0 >= receiver.high.y || line.y1 <= receiver.low.y) return;
  const double end = line.x_at(line.y1);
  const double across = std::max(std::fabs(line.x0), std::fabs(end));
  const double tall = std::max(std::fabs(line.y0), std::fabs(line.y1));
  const LineError of_lines{2 * errors.point + 4 * kEps * across, 2 * errors.point + 4 * kEps * tall,
                           errors.beside};
  const double error = of_lines.of(line);
  if (std::min(line.x0, end) > receiver.high.x + error) return;
  const int winding = down ? edge.winding : -edge.winding;
  const bool left = std::max(line.x0, end) < receiver.low.x - error;
  if (left && line.y0 <= receiver.low.y && line.y1 >= receiver.high.y) {
    base_ += winding;
  } else {
    lines_.push_back(
        {line, static_cast<float>(error), winding, error > kSmallSlack ? edge.plane : kNone});
  }
}

/// Not past the border's own ends.
double ReceiverShadow::crossing(const ShadowLine& border, double y, const FaceOrder& order) const {
  const LevelLine& line = border.line;
  const double x = order.crossing_of_planes(border.plane, plane_, y);
  if (std::isnan(x)) return line.x_at(y);
  const auto [low, high] = std::minmax({line.x0, line.x_at(line.y1)});
  return std::clamp(x, low, high);
}

void ReceiverShadow::on_level(double y, const FaceOrder& order,
                              std::vector<ShadowSpan>& spans) const {
  constexpr std::size_t kMost = 64;
  Crossing few[kMost];
  std::vector<Crossing> many;
  std::size_t count = 0;
  const auto meet = [&](const ShadowLine& s) {
    if (!(s.line.y0 <= y && y < s.line.y1)) return;
    const double x = s.plane == kNone ? s.line.x_at(y) : crossing(s, y, order);
    const Crossing crossing{x, s.slack, s.winding};
    if (count < kMost) few[count] = crossing;
    if (count >= kMost) {
      if (count == kMost) many.assign(few, few + kMost);
      many.push_back(crossing);
    }
    ++count;
  };
  if (bands_) {
    for (const LevelBands::Item& item : (*bands_)[bands_->band(y)])
      if (item.meets(y)) meet(lines_[item.number]);
  } else {
    for (const ShadowLine& line : lines_) meet(line);
  }
  Crossing* const crossings = count > kMost ? many.data() : few;
  if (count > 1)
    std::sort(crossings, crossings + count,
              [](const Crossing& a, const Crossing& b) { return a.x < b.x; });
  int winding = base_;
  ShadowSpan span{-kInfinity, kInfinity, 0, 0};
  for (std::size_t i = 0; i < count; ++i) {
    const int before = winding;
    winding += crossings[i].winding;
    if (before == 0 && winding != 0) span.x0 = crossings[i].x, span.slack0 = crossings[i].slack;
    if (before != 0 && winding == 0) {
      span.x1 = crossings[i].x, span.slack1 = crossings[i].slack;
      spans.push_back(span);
    }
  }
  span.x1 = kInfinity, span.slack1 = 0;
  if (winding != 0) spans.push_back(span);
}

const ReceiverShadow ReceiverShadows::kNone;
const ReceiverShadow ReceiverShadows::kAll;

ReceiverShadows::ReceiverShadows(const FrontTable& table, const ShadowCaster* caster)
    : table_(table), caster_(caster), of_face_(caster != nullptr ? table.tones.size() : 0) {}

ReceiverShadows::~ReceiverShadows() {
  for (const auto& shadow : of_face_) {
    const ReceiverShadow* const made = shadow.load();
    if (made != &kNone && made != &kAll) delete made;
  }
}

/// Two threads may cast the same one; the first to be done is kept.
const ReceiverShadow* ReceiverShadows::cast(Index face, ShadowCaster::Scratch& scratch) const {
  const Shadow shadow = caster_->on(face, scratch);
  const ReceiverShadow* made = &kNone;
  if (ReceiverShadow found(table_, shadow); !found.uniform()) {
    made = new ReceiverShadow(std::move(found));
  } else if (found.begins_in_shadow()) {
    made = &kAll;
  }
  const ReceiverShadow* first = nullptr;
  if (of_face_[face].compare_exchange_strong(first, made, std::memory_order_acq_rel)) return made;
  if (made != &kNone && made != &kAll) delete made;
  return first;
}

}  // namespace overstrike
