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

ReceiverShadows::ReceiverShadows(const FrontTable& table, const std::vector<Shadow>& shadows) {
  if (shadows.empty()) return;
  of_face_.assign(table.tones.size(), kNone);
  for (const Shadow& shadow : shadows) {
    if (!table.seen(shadow.receiver)) continue;
    of_face_[shadow.receiver] = static_cast<Index>(receivers_.size());
    Receiver receiver{shadow.covered, lines_.size(), 0, kNoBands};
    for (const ShadowEdge& edge : shadow.edges) add_line(edge, table.view);
    receiver.end = lines_.size();
    const auto first = lines_.begin() + static_cast<std::ptrdiff_t>(receiver.first);
    if (receiver.end - receiver.first > kFew) {
      receiver.bands = bands_.size();
      bands_.emplace_back(table.rows, receiver.end - receiver.first, [&](std::size_t i) {
        return std::pair(first[static_cast<std::ptrdiff_t>(i)].line.y0,
                         first[static_cast<std::ptrdiff_t>(i)].line.y1);
      });
    }
    receivers_.push_back(receiver);
  }
}

void ReceiverShadows::add_line(const ShadowEdge& edge, const View& view) {
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

void ReceiverShadows::on_level(Index face, double y, std::vector<ShadowSpan>& spans) const {
  const Receiver& receiver = receivers_[of_face_[face]];
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
  if (receiver.bands == kNoBands) {
    for (std::size_t i = receiver.first; i < receiver.end; ++i) meet(lines_[i]);
  } else {
    const LevelBands& bands = bands_[receiver.bands];
    for (const Index i : bands[bands.band(y)]) meet(lines_[receiver.first + i]);
  }
  Crossing* const crossings = count > kMost ? many.data() : few;
  std::sort(crossings, crossings + count,
            [](const Crossing& a, const Crossing& b) { return a.x < b.x; });
  int winding = receiver.covered;
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

}  // namespace overstrike
