#include "core/visibility/solid_shadow.h"

#include <algorithm>

namespace overstrike {

SolidShadow::SolidShadow(const SolidExpression& expression, std::vector<OperandLine> lines,
                         std::vector<Index> at_left, double rows, double reach)
    : expression_(expression),
      lines_(std::move(lines)),
      at_left_(std::move(at_left)),
      within_{-reach, reach},
      border_(reach + 1) {
  for (const OperandLine& l : lines_)
    if (l.plane != kNone) bent_.push_back({l.line.y0, l.line.y1});
  const auto levels = [&](std::size_t i) {
    return std::pair(lines_[i].line.y0, lines_[i].line.y1);
  };
  if (lines_.size() > kFew) {
    bands_.emplace(rows, lines_.size(), levels);
  } else {
    for (std::size_t i = 0; i < lines_.size(); ++i)
      few_.push_back({levels(i).first, levels(i).second, static_cast<Index>(i)});
  }
}

std::span<const LevelBands::Item> SolidShadow::near(double y) const {
  return bands_ ? (*bands_)[bands_->band(y)] : few_;
}

SolidLine SolidShadow::line(Index number) const {
  const OperandLine& l = lines_[number];
  return {l.line, l.slack, l.faces, &within_};
}

/// False where levels are to be resolved by themselves.
bool SolidShadow::kept_on_level(double y, const CastOrder& order, Scratch& scratch) const {
  const auto meets = [y](const std::pair<double, double>& levels) {
    return levels.first <= y && y < levels.second;
  };
  if (scratch.coherence != Coherence::all || std::any_of(bent_.begin(), bent_.end(), meets))
    return false;
  const auto [found, is_new] =
      scratch.rows.try_emplace(this, expression_, order, *this, border_, scratch.tools);
  SolidRows& rows = found->second;
  if (is_new) rows.begin_at(border_, at_left_);
  if (!rows.is_worth_while()) return false;
  rows.on_level(y, near(y), scratch.pieces);
  return true;
}

void SolidShadow::sweep_passing(double y, const CastOrder& order, Scratch& scratch) const {
  std::vector<Passing>& passing = scratch.passing;
  if (passing.empty() && at_left_.empty()) return;
  passing.push_back({-border_, 0, {kNone, kNone}});
  passing.push_back({border_, 0, {kNone, kNone}});
  sort_passing(passing);
  SolidSweep& sweeping = scratch.tools.sweep;
  sweeping.record_in(nullptr);
  sweeping.begin(expression_, order, y, border_);
  for (const Index face : at_left_) sweeping.pass({face, kNone});
  const auto pass = [&](const std::array<Index, 2>& faces) {
    if (faces[0] != kNone) sweeping.pass(faces);
  };
  sweep(passing, pass, [&](double x0, double x1, double slack0, double slack1) {
    sweeping.span({x0, x1, kNone, static_cast<float>(slack0), static_cast<float>(slack1)},
                  scratch.pieces);
  });
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
