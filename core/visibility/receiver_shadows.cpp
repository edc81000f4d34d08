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

/// Bound on how far an edge's ends may be from where they were meant, in the picture, as to_grid()
/// has it for points: between its ends no w^ is smaller and no term larger than at one of them.
double edge_error(const View& view, const Vec3& a, const Vec3& b, double reach) {
  const Vec4 size = glm::max(sizes_of(view, a), sizes_of(view, b));
  const double w = std::min((view.matrix * Vec4(a, 1.0)).z, (view.matrix * Vec4(b, 1.0)).z);
  return kPointRounding * (std::max(size.x, size.y) + size.z * reach) / std::fabs(w);
}

/// The same of all, in a parallel view (w^ = 1), where no coordinate is larger than the sum of its
/// terms' sizes.
template <class Edge>
double edges_error(const View& view, const std::vector<Edge>& edges) {
  Vec3 reach(0.0);
  for (const Edge& e : edges) reach = glm::max(reach, glm::max(glm::abs(e.a), glm::abs(e.b)));
  Vec4 size = glm::abs(view.matrix[3]);
  for (int column = 0; column < 3; ++column) size += glm::abs(view.matrix[column]) * reach[column];
  return 2 * kPointRounding * std::max(size.x, size.y);
}

/// Calls visit(edge, error) for all.
template <class Edge, class Visit>
void with_errors(const FrontTable& table, const std::vector<Edge>& edges, const Visit& visit) {
  double error = table.view.perspective ? 0 : edges_error(table.view, edges);
  const double reach = std::max(table.columns, table.rows) + 1;
  for (const Edge& edge : edges) {
    if (table.view.perspective) error = edge_error(table.view, edge.a, edge.b, reach);
    visit(edge, error);
  }
}

struct Crossing {
  double x;
  float slack;
  int winding;
};

}  // namespace

ReceiverShadow::ReceiverShadow(const FrontTable& table, const Canonical& casting,
                               const Shadow& shadow)
    : plane_(table.plane_of(shadow.receiver)), base_(shadow.covered) {
  if (!shadow.edges.empty()) {
    const Box receiver = box_of(table, shadow.receiver);
    const double beside = beside_line(table.columns, table.rows);
    with_errors(table, shadow.edges, [&](const ShadowEdge& edge, double error) {
      add_line(edge, table.view, receiver, {error, beside});
    });
    if (lines_.size() > kFew)
      bands_.emplace(table.rows, lines_.size(), [&](std::size_t i) {
        return std::pair(lines_[i].line.y0, lines_[i].line.y1);
      });
  }
  if (!shadow.operands.empty()) add_solids(table, casting, shadow);
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

/// Nothing for what is level, or passes the receiver by on the right, above or below.
std::optional<ReceiverShadow::PlacedLine> ReceiverShadow::placed(const View& view, const Vec3& from,
                                                                 const Vec3& to,
                                                                 const Box& receiver,
                                                                 const Error& errors) {
  const Vec2 a = projected(view, from), b = projected(view, to);
  if (a.y == b.y) return {};
  // A corner that rounding has put into the eye's own plane, of a near plane that stands there.
  if (!std::isfinite(a.x + a.y + b.x + b.y)) return {};
  const bool down = a.y < b.y;
  LevelLine line = down ? LevelLine(a, b) : LevelLine(b, a);
  if (is_far_away(a) || is_far_away(b))
    line = far_line(view, down ? from : to, down ? to : from, line);
  if (line.y0 >= receiver.high.y || line.y1 <= receiver.low.y) return {};
  const double end = line.x_at(line.y1);
  const double across = std::max(std::fabs(line.x0), std::fabs(end));
  const double tall = std::max(std::fabs(line.y0), std::fabs(line.y1));
  const LineError of_lines{2 * errors.point + 4 * kEps * across, 2 * errors.point + 4 * kEps * tall,
                           errors.beside};
  const double error = of_lines.of(line);
  if (std::min(line.x0, end) > receiver.high.x + error) return {};
  const bool left = std::max(line.x0, end) < receiver.low.x - error && line.y0 <= receiver.low.y &&
                    line.y1 >= receiver.high.y;
  return PlacedLine{line, error, down, left};
}

/// Lines that pass the receiver by on the right count nowhere on it; those that pass by on the
/// left, all along it, everywhere.
void ReceiverShadow::add_line(const ShadowEdge& edge, const View& view, const Box& receiver,
                              const Error& errors) {
  const std::optional<PlacedLine> p = placed(view, edge.a, edge.b, receiver, errors);
  if (!p) return;
  const int winding = p->down ? edge.winding : -edge.winding;
  if (p->left) {
    base_ += winding;
  } else {
    lines_.push_back({p->line, static_cast<float>(p->error), winding,
                      p->error > kSmallSlack ? edge.plane : kNone});
  }
}

/// The receiver is looked at within the picture.
void ReceiverShadow::add_solids(const FrontTable& table, const Canonical& casting,
                                const Shadow& shadow) {
  Box receiver = box_of(table, shadow.receiver);
  receiver.low = glm::max(receiver.low, Vec2(-1));
  receiver.high = glm::min(receiver.high, Vec2(table.columns, table.rows) + 1.0);
  const double beside = beside_line(table.columns, table.rows);
  std::vector<Index> faces, at_left;
  std::vector<OperandLine> lines;
  Index solid = kNone;
  const auto toggle = [&](Index face) {
    if (face == kNone) return;
    const auto there = std::find(at_left.begin(), at_left.end(), face);
    there == at_left.end() ? at_left.push_back(face) : static_cast<void>(at_left.erase(there));
  };
  const auto end_solid = [&] {
    if (!lines.empty() || !at_left.empty())
      solids_.emplace_back(casting.solids[solid]->expression, std::move(lines), std::move(at_left),
                           table.rows, table.columns + 1);
    lines.clear(), at_left.clear();
  };
  with_errors(table, shadow.operands, [&](const OperandEdge& edge, double error) {
    if (edge.solid != solid && solid != kNone) end_solid();
    solid = edge.solid;
    const std::optional<PlacedLine> p =
        placed(table.view, edge.a, edge.b, receiver, {error, beside});
    if (!p) return;
    for (const Index face : edge.faces)
      if (face != kNone) faces.push_back(face);
    if (p->left) {
      for (const Index face : edge.faces) toggle(face);
    } else {
      lines.push_back({p->line, static_cast<float>(p->error),
                       p->error > kSmallSlack ? edge.plane : kNone, edge.faces});
    }
  });
  end_solid();
  if (solids_.empty()) return;
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  casting_ = &casting;
  cast_order_ = std::make_unique<const CastOrder>(table.depths, casting, table.depths.plane(plane_),
                                                  std::move(faces));
}

/// Not past the border's own ends.
double ReceiverShadow::crossing(const LevelLine& line, Index plane, double y,
                                const FaceOrder& order) const {
  const double x = order.crossing_of_planes(plane, plane_, y);
  if (std::isnan(x)) return line.x_at(y);
  const auto [low, high] = std::minmax({line.x0, line.x_at(line.y1)});
  return std::clamp(x, low, high);
}

void ReceiverShadow::on_level(double y, const FaceOrder& order, Coherence coherence,
                              Scratch& scratch, std::vector<ShadowSpan>& spans) const {
  spans.clear();
  plain_on_level(y, order, spans);
  if (solids_.empty()) return;
  if (!scratch) scratch.emplace(*casting_, coherence);
  for (const SolidShadow& solid : solids_)
    solid.on_level(
        y, *cast_order_, [&](const OperandLine& line) { return x_of(line, y, order); }, *scratch,
        spans);
  unite(spans);
}

void ReceiverShadow::plain_on_level(double y, const FaceOrder& order,
                                    std::vector<ShadowSpan>& spans) const {
  constexpr std::size_t kMost = 64;
  Crossing few[kMost];
  std::vector<Crossing> many;
  std::size_t count = 0;
  const auto meet = [&](const ShadowLine& s) {
    if (!(s.line.y0 <= y && y < s.line.y1)) return;
    const Crossing crossing{x_of(s, y, order), s.slack, s.winding};
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

ReceiverShadows::ReceiverShadows(const FrontTable& table, const ShadowCaster* caster,
                                 Coherence coherence)
    : table_(table),
      caster_(caster),
      coherence_(coherence),
      of_face_(caster != nullptr ? table.tones.size() : 0) {}

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
  if (ReceiverShadow found(table_, caster_->casting(), shadow); !found.uniform()) {
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
