#include "core/visibility/solid_sweep.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "core/visibility/tie.h"

namespace overstrike {

void SolidSweep::begin(const SolidExpression& expression, double y) {
  if (expression_ != &expression) {
    expression_ = &expression;
    state_.emplace(expression);
    winding_.assign(expression.operands(), 0);
  }
  y_ = y;
  layers_.clear(), passed_.clear();
}

void SolidSweep::pass(const std::array<Index, 2>& faces) { passed_.push_back(faces); }

SolidSweep::Layer SolidSweep::layer_of(Index face) const {
  const Canonical& c = table_.canonical;
  return {face, c.faces[face].plane, c.memberships[c.faces[face].body].operand,
          table_.from_behind(face) ? -1 : 1, order_.depth_of(face)};
}

/// Sign of how much nearer a is in the present span: at its beginning, and where they are equal
/// there, at its end. 0 in one plane, or along the whole span.
int SolidSweep::compare(const Layer& a, const Layer& b) const {
  if (a.plane == b.plane) return 0;
  for (const double x : {low_, high_}) {
    int side = compare_roughly(a.depth, b.depth, x, y_);
    if (side == 0) side = order_.compare(a.face, b.face, x, y_);
    if (side != 0) return side;
  }
  return 0;
}

/// Passes the edges since the last span. A face that takes the place of its neighbour in an edge is
/// as near as that was; where it was among faces of one plane it may not be.
void SolidSweep::settle(double low, double high) {
  low_ = low, high_ = high;
  entering_.clear(), replaced_.clear();
  const auto at = [&](Index face) {
    return std::find_if(layers_.begin(), layers_.end(),
                        [&](const Layer& l) { return l.face == face; });
  };
  const auto toggle = [&](Index face) {
    if (const auto layer = at(face); layer != layers_.end()) {
      layers_.erase(layer);
    } else if (const auto there = std::find(entering_.begin(), entering_.end(), face);
               there != entering_.end()) {
      entering_.erase(there);
    } else {
      entering_.push_back(face);
    }
  };
  for (const std::array<Index, 2>& faces : passed_) {
    const auto [f, g] = faces;
    const auto of_f = at(f);
    const auto of_g = g == kNone ? layers_.end() : at(g);
    const bool entering =
        std::find_if(entering_.begin(), entering_.end(),
                     [&, a = f, b = g](Index i) { return i == a || i == b; }) != entering_.end();
    if (g != kNone && !entering && (of_f == layers_.end()) != (of_g == layers_.end())) {
      const auto layer = of_f == layers_.end() ? of_g : of_f;
      *layer = layer_of(of_f == layers_.end() ? f : g);
      continue;
    }
    toggle(f);
    if (g != kNone) toggle(g);
  }
  passed_.clear();
  for (std::size_t i = 0; i < layers_.size(); ++i) move_into_order(i);
  for (const Index face : entering_) insert(face);
}

/// Layers before it are in order.
void SolidSweep::move_into_order(std::size_t at) {
  for (; at > 0 && compare(layers_[at], layers_[at - 1]) > 0; --at)
    std::swap(layers_[at], layers_[at - 1]);
}

/// In front of what it is nearer than; beside faces of its plane.
void SolidSweep::insert(Index face) {
  const Layer layer = layer_of(face);
  const auto behind = std::partition_point(layers_.begin(), layers_.end(), [&](const Layer& other) {
    return compare(other, layer) >= 0;
  });
  layers_.insert(behind, layer);
}

/// The first place right of `from` where two neighbours in depth are at one depth and go on the
/// other way round.
std::optional<SolidSweep::Crossing> SolidSweep::next_crossing(double from) const {
  std::optional<Crossing> next;
  for (std::size_t i = 0; i + 1 < layers_.size(); ++i) {
    const Layer &near = layers_[i], &far = layers_[i + 1];
    if (near.plane == far.plane) continue;
    int side = compare_roughly(near.depth, far.depth, high_, y_);
    if (side == 0) side = order_.compare(near.face, far.face, high_, y_);
    if (side >= 0) continue;
    const double x = order_.crossing(near.face, far.face, y_);
    if (std::isnan(x)) continue;
    const double at = std::clamp(x, from, high_);
    if (!next || at < next->x) next = {at, i};
  }
  return next;
}

void SolidSweep::span(const SpanPiece& over, std::vector<SpanPiece>& pieces) {
  double low = over.x0 + over.slack0, high = over.x1 - over.slack1;
  if (!(low < high)) low = high = over.x0 + (over.x1 - over.x0) / 2;
  settle(low, high);
  SpanPiece piece{over.x0, over.x1, seen(), over.slack0, 0};
  const auto show_to = [&](double x, float slack) {
    if (piece.face != kNone && x > piece.x0)
      pieces.push_back({piece.x0, x, piece.face, piece.slack0, slack});
    if (x > piece.x0) piece.x0 = x, piece.slack0 = slack;
  };
  for (double x = low; const std::optional<Crossing> next = next_crossing(x);) {
    x = next->x;
    std::swap(layers_[next->first], layers_[next->first + 1]);
    const Index now = seen();
    if (now == piece.face) continue;
    show_to(x, 0);
    piece.face = now;
  }
  show_to(over.x1, over.slack1);
}

/// The face of the solid that is nearest, or kNone. Faces of one plane are counted together before
/// it is decided whether the solid begins there (TK 3.3.4, step 5).
Index SolidSweep::seen() {
  Index found = kNone;
  entered_.clear();
  for (std::size_t first = 0, end = 0; first < layers_.size() && found == kNone; first = end) {
    changed_.clear();
    for (end = first; end < layers_.size() && layers_[end].plane == layers_[first].plane; ++end) {
      const Layer& layer = layers_[end];
      const bool was_in = winding_[layer.operand] != 0;
      winding_[layer.operand] += layer.enters;
      if (was_in == (winding_[layer.operand] != 0)) continue;
      state_->flip(layer.operand);
      changed_.push_back(layer.operand);
    }
    entered_.insert(entered_.end(), changed_.begin(), changed_.end());
    if (state_->inside()) found = end - first == 1 ? layers_[first].face : choose(first, end);
  }
  for (std::size_t i = 0; i < layers_.size(); ++i) winding_[layers_[i].operand] = 0;
  for (const Index operand : entered_)
    if (state_->in(operand)) state_->flip(operand);
  return found;
}

/// Which of the faces in one plane in which the solid begins: the first by the rule of ties whose
/// operand makes the solid begin there, alone or with others. That hangs on what is united and
/// intersected, and not on how the expression is written.
Index SolidSweep::choose(std::size_t first, std::size_t end) {
  operands_.clear(), candidates_.clear();
  std::sort(changed_.begin(), changed_.end());
  for (std::size_t i = 0; i < changed_.size(); ++i) {
    // What was flipped back did not change.
    const auto times = std::count(changed_.begin(), changed_.end(), changed_[i]);
    if (times % 2 != 0 && (i == 0 || changed_[i] != changed_[i - 1]))
      operands_.push_back(changed_[i]);
  }
  for (std::size_t i = first; i < end; ++i) {
    const Layer& layer = layers_[i];
    const bool enters = layer.enters > 0;
    if (std::binary_search(operands_.begin(), operands_.end(), layer.operand) &&
        enters == state_->in(layer.operand))
      candidates_.push_back(layer.face);
  }
  const Canonical& c = table_.canonical;
  std::sort(candidates_.begin(), candidates_.end(),
            [&](Index f, Index g) { return wins_tie(c, f, g); });
  for (const Index face : candidates_)
    if (needed(c.memberships[c.faces[face].body].operand, operands_)) return face;
  return candidates_.empty() ? layers_[first].face : candidates_.front();
}

/// True when there are changes with which the solid does not begin without the operand's, and does
/// with it. All are tried where they are few, each one flip from the one before (a Gray code);
/// where they are many, the others one after the other taken back until it does not.
bool SolidSweep::needed(Index operand, std::span<const Index> changed) {
  constexpr std::size_t kFew = 10;
  others_.clear();
  for (const Index other : changed)
    if (other != operand) others_.push_back(other);
  const auto flips_the_solid = [&] {
    if (state_->inside()) return false;
    state_->flip(operand);
    const bool result = state_->inside();
    state_->flip(operand);
    return result;
  };
  made_.assign(others_.size(), 1);
  const auto flip_other = [&](std::size_t i) { state_->flip(others_[i]), made_[i] ^= 1; };
  state_->flip(operand);
  bool result = flips_the_solid();
  if (others_.size() <= kFew) {
    for (std::size_t step = 1; !result && step < std::size_t{1} << others_.size(); ++step) {
      flip_other(static_cast<std::size_t>(std::countr_zero(step)));
      result = flips_the_solid();
    }
  } else {
    for (std::size_t i = 0; i < others_.size() && state_->inside(); ++i) flip_other(i);
    result = flips_the_solid();
  }
  state_->flip(operand);
  for (std::size_t i = 0; i < others_.size(); ++i)
    if (made_[i] == 0) flip_other(i);
  return result;
}

}  // namespace overstrike
