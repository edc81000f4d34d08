#include "core/visibility/receiver_shadows.h"

#include <algorithm>
#include <limits>

#include "core/visibility/projected_scene.h"

namespace overstrike {
namespace {

constexpr double kEps = std::numeric_limits<double>::epsilon();
constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// Lines of a receiver that are looked through one by one.
constexpr std::size_t kFew = 32;

struct Crossing {
  double x;
  float slack;
  int winding;
};

}  // namespace

ReceiverShadow::ReceiverShadow(const FrontTable& table, const Shadow& shadow)
    : covered_(shadow.covered) {
  for (const ShadowEdge& edge : shadow.edges) add_line(edge, table.view);
  if (lines_.size() > kFew)
    bands_.emplace(table.rows, lines_.size(),
                   [&](std::size_t i) { return std::pair(lines_[i].line.y0, lines_[i].line.y1); });
}

void ReceiverShadow::add_line(const ShadowEdge& edge, const View& view) {
  const GridPoint a = to_grid(view, edge.a), b = to_grid(view, edge.b);
  if (a.at.y == b.at.y) return;
  const bool down = a.at.y < b.at.y;
  const LevelLine line = down ? LevelLine(a.xy(), b.xy()) : LevelLine(b.xy(), a.xy());
  const double across = std::max(std::fabs(a.at.x), std::fabs(b.at.x));
  const double tall = std::max(std::fabs(a.at.y), std::fabs(b.at.y));
  const double error = (a.error + b.error) * (1 + std::fabs(line.slope)) +
                       4 * kEps * (across + tall * std::fabs(line.slope));
  lines_.push_back({line, static_cast<float>(error), down ? edge.winding : -edge.winding});
}

void ReceiverShadow::on_level(double y, std::vector<ShadowSpan>& spans) const {
  constexpr std::size_t kMost = 64;
  Crossing few[kMost];
  std::vector<Crossing> many;
  std::size_t count = 0;
  const auto meet = [&](const ShadowLine& s) {
    if (!(s.line.y0 <= y && y < s.line.y1)) return;
    const Crossing crossing{s.line.x_at(y), s.slack, s.winding};
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
  std::sort(crossings, crossings + count,
            [](const Crossing& a, const Crossing& b) { return a.x < b.x; });
  int winding = covered_;
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
  if (!shadow.edges.empty()) {
    made = new ReceiverShadow(table_, shadow);
  } else if (shadow.covered) {
    made = &kAll;
  }
  const ReceiverShadow* found = nullptr;
  if (of_face_[face].compare_exchange_strong(found, made, std::memory_order_acq_rel)) return made;
  if (made != &kNone && made != &kAll) delete made;
  return found;
}

}  // namespace overstrike
