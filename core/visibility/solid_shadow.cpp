#include "core/visibility/solid_shadow.h"

#include <algorithm>

namespace overstrike {

SolidShadow::SolidShadow(const SolidExpression& expression, std::vector<OperandLine> lines,
                         std::vector<Index> at_left, double rows, double reach)
    : expression_(expression),
      lines_(std::move(lines)),
      at_left_(std::move(at_left)),
      reach_(reach) {
  if (lines_.size() > kFew)
    bands_.emplace(rows, lines_.size(),
                   [&](std::size_t i) { return std::pair(lines_[i].line.y0, lines_[i].line.y1); });
}

void SolidShadow::sweep_passing(double y, const CastOrder& order, Scratch& scratch,
                                std::vector<ShadowSpan>& spans) const {
  std::vector<Passing>& passing = scratch.passing;
  if (passing.empty() && at_left_.empty()) return;
  sort_passing(passing);
  // From beyond the first line to beyond the last: what lies over the receiver there may go on.
  double first = -reach_, last = reach_;
  if (!passing.empty())
    first = std::min(first, passing.front().x - 1), last = std::max(last, passing.back().x + 1);
  passing.insert(passing.begin(), {first, 0, {kNone, kNone}});
  passing.push_back({last, 0, {kNone, kNone}});
  scratch.pieces.clear();
  scratch.solid.begin(expression_, order, y, std::max(-first, last));
  for (const Index face : at_left_) scratch.solid.pass({face, kNone});
  const auto pass = [&](const std::array<Index, 2>& faces) {
    if (faces[0] != kNone) scratch.solid.pass(faces);
  };
  sweep(passing, pass, [&](double x0, double x1, double slack0, double slack1) {
    scratch.solid.span({x0, x1, kNone, static_cast<float>(slack0), static_cast<float>(slack1)},
                       scratch.pieces);
  });
  for (const SpanPiece& piece : scratch.pieces)
    spans.push_back({piece.x0, piece.x1, piece.slack0, piece.slack1});
}

void unite(std::vector<ShadowSpan>& spans) {
  std::sort(spans.begin(), spans.end(),
            [](const ShadowSpan& a, const ShadowSpan& b) { return a.x0 < b.x0; });
  std::size_t kept = 0;
  for (std::size_t i = 0; i < spans.size(); ++i) {
    if (kept > 0 && spans[i].x0 <= spans[kept - 1].x1) {
      ShadowSpan& before = spans[kept - 1];
      if (spans[i].x1 > before.x1) before.x1 = spans[i].x1, before.slack1 = spans[i].slack1;
    } else {
      spans[kept++] = spans[i];
    }
  }
  spans.resize(kept);
}

}  // namespace overstrike
