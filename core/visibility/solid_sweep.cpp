#include "core/visibility/solid_sweep.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "core/visibility/tie.h"

namespace overstrike {

SolidSweep::~SolidSweep() {
  if (options_.tally == nullptr) return;
  stop(solid_), stop(uncut_);
  options_.tally->add(counts_);
}

/// Takes over what the state has counted.
void SolidSweep::stop(Candidate& candidate) {
  if (candidate.state) counts_.updates += candidate.state->updates();
  candidate.state.reset();
}

void SolidSweep::follow(Candidate& candidate, const SolidExpression* expression) {
  candidate.known = false;
  if (candidate.expression == expression) return;
  stop(candidate);
  candidate.expression = expression;
  if (expression != nullptr) candidate.state.emplace(*expression);
}

void SolidSweep::begin(const SolidExpression& expression, const LayerOrder& order, double y,
                       double reach, const SolidExpression* uncut) {
  if (solid_.expression != &expression) {
    winding_.assign(expression.operands(), 0);
    turned_.assign(expression.operands(), 0);
  }
  follow(solid_, &expression), follow(uncut_, uncut);
  order_ = &order;
  y_ = y, reach_ = reach;
  layers_.clear(), passed_.clear(), at_end_.clear();
  ends_ = false, fresh_ = 0;
}

void SolidSweep::end_at_layer() {
  layers_.push_back(
      on_level({LayerOrder::kEnd, LayerOrder::kEnd, 0, 0, order_->depth_of(LayerOrder::kEnd)}));
  layers_.back().fresh = false;
  ends_ = true;
}

bool SolidSweep::resume(std::span<const Index> faces, double x0, double x1) {
  // So wide that what crosses within an end's doubt does not reach the middle.
  constexpr double kWide = 4 * kCrossingError;
  const double middle = x1 - x0 > kWide ? x0 + (x1 - x0) / 2 : x1;
  layers_.clear(), fresh_ = 0;
  for (const Index face : faces) {
    layers_.push_back(layer_of(face));
    layers_.back().fresh = false;
  }
  if (in_order(middle, x1)) return true;
  forget_doubts();
  for (std::size_t i = 1; i < layers_.size(); ++i)
    for (std::size_t at = i; at > 0 && was_before(layers_[at], layers_[at - 1], middle, x1); --at)
      std::swap(layers_[at], layers_[at - 1]);
  return in_order(middle, x1);
}

bool SolidSweep::in_order(double middle, double end) {
  for (std::size_t i = 1; i < layers_.size(); ++i)
    if (!follows(i, middle, end)) return false;
  return true;
}

/// Whether a layer surely lay behind the one before it, or lies in its plane.
bool SolidSweep::follows(std::size_t at, double middle, double end) {
  const Layer &near = layers_[at - 1], &far = layers_[at];
  if (near.plane == far.plane) return true;
  bool sharp = false;
  const int side = compare_at(near, far, end, sharp);
  if (side != 0 || !sharp) return side > 0;
  note_doubt(at - 1);
  return compare_at(near, far, middle, sharp) > 0;
}

/// The plane of a layer meets that of the next one at the end of the span in hand. Whether they
/// have crossed is looked at in the next span, where their faces may have other neighbours.
void SolidSweep::note_doubt(std::size_t at) {
  Layer *near = &layers_[at], *far = near + 1;
  Layer *const first = layers_.data(), *const last = first + layers_.size() - 1;
  fresh_ += !near->fresh + !far->fresh;
  near->fresh = far->fresh = true;
  for (; near != first && near[-1].plane == near->plane; --near)
    fresh_ += !near[-1].fresh, near[-1].fresh = true;
  for (; far != last && far[1].plane == far->plane; ++far)
    fresh_ += !far[1].fresh, far[1].fresh = true;
}

void SolidSweep::forget_doubts() {
  if (fresh_ == 0) return;
  for (Layer& layer : layers_) layer.fresh = false;
  fresh_ = 0;
}

/// Surely so at the end of a span, or where that is in doubt, in its middle.
bool SolidSweep::was_before(const Layer& a, const Layer& b, double middle, double end) const {
  if (a.plane == b.plane) return false;
  bool sharp = false;
  const int side = compare_at(a, b, end, sharp);
  return side > 0 || (side == 0 && sharp && compare_at(a, b, middle, sharp) > 0);
}

void SolidSweep::copy_active(std::vector<Index>& faces) const {
  faces.resize(layers_.size());
  for (std::size_t i = 0; i < layers_.size(); ++i) faces[i] = layers_[i].face;
}

void SolidSweep::pass(const std::array<Index, 2>& faces) { passed_.push_back(faces); }

SolidSweep::Layer SolidSweep::layer_of(Index face) const {
  const CanonicalFace& f = canonical_.faces[face];
  return on_level({face, f.plane, canonical_.memberships[f.body].operand, order_->enters(face),
                   order_->depth_of(face)});
}

SolidSweep::Layer SolidSweep::on_level(const SolidLayer& layer) const {
  const DepthPlane& d = layer.depth;
  return {layer, d.b * y_ + d.c, d.eb * std::fabs(y_) + d.ec, true};
}

/// Sign of how much nearer a is at x, or 0 where doubles cannot tell. Then it is `sharp` when they
/// can nearer to x than anybody tells: where the two cross there, it is known where.
int SolidSweep::compare_at(const Layer& a, const Layer& b, double x, bool& sharp) const {
  const double slope = a.depth.a - b.depth.a;
  const double difference = (a.depth.a * x + a.constant) - (b.depth.a * x + b.constant);
  const double error =
      (a.depth.ea + b.depth.ea) * std::fabs(x) + (a.constant_error + b.constant_error);
  sharp = error <= kCrossingError * std::fabs(slope);
  return (difference > error) - (difference < -error);
}

/// Sign of how much nearer a is in the present span: at its beginning, and where they are equal
/// there, right of it. 0 in one plane, or along the whole span.
int SolidSweep::compare(const Layer& a, const Layer& b) const {
  if (a.plane == b.plane) return 0;
  bool sharp = false;
  if (const int side = compare_at(a, b, low_, sharp); side != 0) return side;
  if (sharp && a.depth.a != b.depth.a) return a.depth.a > b.depth.a ? 1 : -1;
  const int side = order_->compare(a.face, b.face, low_, y_);
  return side != 0 ? side : order_->compare(a.face, b.face, high_, y_);
}

/// Whether a layer lies in one plane with the one before it or after it.
bool SolidSweep::ties(std::size_t at) const {
  const auto same = [&](std::size_t i) { return layers_[i].plane == layers_[i + 1].plane; };
  return (at > 0 && same(at - 1)) || (at + 1 < layers_.size() && same(at));
}

/// Whether doubles can tell at the span's beginning that a layer is behind the one before it, and
/// before the one after it.
bool SolidSweep::stands_clear(std::size_t at) const {
  bool sharp = false;
  const auto in_order = [&](std::size_t i) {
    return compare_at(layers_[i], layers_[i + 1], low_, sharp) > 0;
  };
  return (at == 0 || in_order(at - 1)) && (at + 1 == layers_.size() || in_order(at));
}

/// What is seen is as it was while this is behind what decided it; but one that has come next to
/// another of its plane decides with that.
void SolidSweep::changed_at(std::size_t at) {
  const bool joins = at > 0 && at < layers_.size() && layers_[at - 1].plane == layers_[at].plane;
  const std::size_t first = joins ? at - 1 : at;
  solid_.known = solid_.known && first >= solid_.decided;
  uncut_.known = uncut_.known && first >= uncut_.decided;
}

void SolidSweep::forget_seen() { solid_.known = uncut_.known = false; }

/// What it decided it decides on, if it is alone in its plane, before and after.
void SolidSweep::replace(std::size_t at, Index face) {
  const Layer before = layers_[at];
  const bool tied = ties(at);
  layers_[at] = layer_of(face);
  const bool ties_now = ties(at);
  layers_[at].replaced_at = settlings_;
  // Through a face that is seen edge-on, from one of its sides to the other, depth leaps. Elsewhere
  // it is where the other was, or crosses its neighbours here; but stored planes do not meet in
  // their edge exactly, which counts where a neighbour is as near as that.
  layers_[at].fresh = tied || ties_now || before.replaced_at == settlings_ || !stands_clear(at);
  fresh_ += layers_[at].fresh - before.fresh;
  const bool alike = layers_[at].enters == before.enters && !tied && !ties_now;
  if (!alike) return changed_at(at);
  for (Candidate* const c : {&solid_, &uncut_})
    if (c->known && c->face == before.face) c->face = face;
}

void SolidSweep::toggle(Index face) {
  if (ends_ && order_->at_end(face)) return toggle_at_end(face);
  const auto layer =
      std::find_if(layers_.begin(), layers_.end(), [&](const Layer& l) { return l.face == face; });
  if (layer != layers_.end()) {
    const auto at = static_cast<std::size_t>(layer - layers_.begin());
    fresh_ -= layer->fresh;
    layers_.erase(layer);
    changed_at(at);
  } else if (const auto there = std::find(entering_.begin(), entering_.end(), face);
             there != entering_.end()) {
    entering_.erase(there);
  } else {
    entering_.push_back(face);
  }
}

void SolidSweep::toggle_at_end(Index face) {
  forget_seen();
  if (std::erase_if(at_end_, [&](const Layer& l) { return l.face == face; }) > 0) return;
  const auto behind = std::partition_point(at_end_.begin(), at_end_.end(), [&](const Layer& other) {
    return canonical_.faces[face].plane == other.plane ||
           order_->compare(other.face, face, low_, y_) >= 0;
  });
  at_end_.insert(behind, layer_of(face));
}

/// Passes the edges since the last span. A face that takes the place of its neighbour in an edge is
/// as near as that was; where it was among faces of one plane it may not be.
void SolidSweep::settle(double low, double high) {
  low_ = low, high_ = high, ++settlings_;
  entering_.clear();
  for (const auto& [f, g] : passed_) {
    if (g == kNone) {
      toggle(f);
      continue;
    }
    std::size_t at_f = layers_.size(), at_g = layers_.size();
    for (std::size_t i = 0; i < layers_.size(); ++i) {
      if (layers_[i].face == f) at_f = i;
      if (layers_[i].face == g) at_g = i;
    }
    const bool has_f = at_f < layers_.size(), has_g = at_g < layers_.size();
    const Index other = has_f ? g : f;
    if (has_f != has_g && std::find(entering_.begin(), entering_.end(), other) == entering_.end()) {
      replace(has_f ? at_f : at_g, other);
      continue;
    }
    toggle(f), toggle(g);
  }
  passed_.clear();
  if (fresh_ > 0) {
    for (std::size_t i = 1; i < layers_.size(); ++i)
      if (layers_[i].fresh || layers_[i - 1].fresh) move_into_order(i);
    forget_doubts();
  }
  for (const Index face : entering_) insert(face);
  if (options_.coherence == Coherence::none) forget_last_span();
}

/// For comparison: the layers are put in order as if they had been in none.
void SolidSweep::forget_last_span() {
  forget_seen();
  for (Layer& layer : layers_) layer.before = kNone;
  for (std::size_t i = 1; i < layers_.size(); ++i) move_into_order(i);
}

/// Layers before it are in order.
void SolidSweep::move_into_order(std::size_t at) {
  for (; at > 0 && compare(layers_[at], layers_[at - 1]) > 0; --at) {
    std::swap(layers_[at], layers_[at - 1]);
    changed_at(at - 1);
    ++counts_.resorts;
  }
}

/// In front of what it is nearer than; beside faces of its plane.
void SolidSweep::insert(Index face) {
  Layer layer = layer_of(face);
  layer.fresh = false;
  const auto behind = std::partition_point(layers_.begin(), layers_.end(), [&](const Layer& other) {
    return compare(other, layer) >= 0;
  });
  const auto at = static_cast<std::size_t>(behind - layers_.begin());
  layers_.insert(behind, layer);
  changed_at(at);
}

/// Up to where a layer that is before another at high_ stays so, whatever rounding does; high_
/// where that is not sure.
double SolidSweep::before_until(const Layer& near, const Layer& far) const {
  const double slope = near.depth.a - far.depth.a;
  const double reach = std::max(reach_, std::fabs(low_));
  const double error =
      (near.depth.ea + far.depth.ea) * reach + (near.constant_error + far.constant_error);
  const double lead =
      (near.depth.a * high_ + near.constant) - (far.depth.a * high_ + far.constant) - error;
  if (!(lead > 0)) return high_;
  return slope < 0 ? high_ + 0.999 * lead / -slope : HUGE_VAL;
}

/// Where two layers that are the wrong way round at the span's end have become so. They may have
/// been all along: three layers that cross within what is asked for are put in order pair by pair.
double SolidSweep::crossing(const Layer& near, const Layer& far, double from) const {
  const double x = order_->crossing(near.face, far.face, y_);
  const bool within = x < high_;
  if (!within && order_->compare(near.face, far.face, from, y_) < 0) return from;
  return within ? std::max(x, from) : high_;
}

/// The first place right of `from` where two neighbours in depth are at one depth and go on the
/// other way round. What may cross at the very end may as well do so in the next span.
std::optional<SolidSweep::Crossing> SolidSweep::next_crossing(double from) {
  std::optional<Crossing> next;
  for (std::size_t i = 0; i + 1 < layers_.size(); ++i) {
    Layer& near = layers_[i];
    const Layer& far = layers_[i + 1];
    if (near.before == far.face && high_ <= near.before_until) continue;
    if (near.plane == far.plane) continue;
    bool sharp = false;
    int side = compare_at(near, far, high_, sharp);
    if (side > 0) {
      // For how long is asked for where they are together once more.
      near.before_until = near.before == far.face ? before_until(near, far) : high_;
      near.before = far.face;
    }
    if (side == 0 && sharp) note_doubt(i);
    if (side > 0 || (side == 0 && sharp)) continue;
    if (side == 0) side = order_->compare(near.face, far.face, high_, y_);
    if (side >= 0) continue;
    const double at = crossing(near, far, from);
    if (!next || at < next->x) next = {at, i};
  }
  return next;
}

/// Two neighbours in depth cross.
void SolidSweep::exchange(std::size_t first) {
  std::swap(layers_[first], layers_[first + 1]);
  changed_at(first);
  forget_doubts();
  if (options_.coherence < Coherence::span_and_behind) forget_seen();
  ++counts_.crossings;
}

namespace {

/// The face that is seen from somewhere in a span on, until another is.
class Showing {
 public:
  Showing(const SpanPiece& over, Index face, std::vector<SpanPiece>& pieces)
      : piece_{over.x0, over.x1, face, over.slack0, 0}, pieces_(pieces) {}
  void end_at(double x, float slack) {
    if (!(x > piece_.x0)) return;
    if (piece_.face != kNone) pieces_.push_back({piece_.x0, x, piece_.face, piece_.slack0, slack});
    piece_.x0 = x, piece_.slack0 = slack;
  }
  /// `low`: where the span begins for sure; before that nothing ends.
  void change_at(double x, double low, Index face) {
    if (face == piece_.face) return;
    if (x > low) end_at(x, 0);
    piece_.face = face;
  }

 private:
  SpanPiece piece_;
  std::vector<SpanPiece>& pieces_;
};

}  // namespace

void SolidSweep::span(const SpanPiece& over, std::vector<SpanPiece>& pieces,
                      std::vector<SpanPiece>& cut_away_pieces) {
  ++counts_.spans;
  double low = over.x0 + over.slack0, high = over.x1 - over.slack1;
  if (!(low < high)) low = high = over.x0 + (over.x1 - over.x0) / 2;
  settle(low, high);
  Showing solid(over, seen(solid_), pieces), before(over, cut_away(), cut_away_pieces);
  if (record_ != nullptr) record({kNone, kNone});
  for (double x = low; const std::optional<Crossing> next = next_crossing(x);) {
    x = next->x;
    const std::array<Index, 2> crossing{layers_[next->first].face, layers_[next->first + 1].face};
    exchange(next->first);
    const bool decides = !solid_.known;
    solid.change_at(x, low, seen(solid_));
    before.change_at(x, low, cut_away());
    if (decides && record_ != nullptr) record(crossing);
  }
  solid.end_at(over.x1, over.slack1);
  before.end_at(over.x1, over.slack1);
}

void SolidSweep::record(const std::array<Index, 2>& crossing) {
  std::vector<SolidLayer>& layers = record_->layers;
  const std::size_t first = layers.size(), end = first + layers_.size();
  layers.insert(layers.end(), layers_.begin(), layers_.end());
  record_->parts.push_back(
      {crossing, solid_.face, first, std::min(first + solid_.decided, end), end});
}

/// What is seen of the uncut solid where that lies before what is seen of the solid, or kNone.
Index SolidSweep::cut_away() {
  if (uncut_.expression == nullptr) return kNone;
  const Index face = seen(uncut_);
  // The solid lies within the uncut one, so that it never begins before that.
  return solid_.face == kNone || uncut_.decided < solid_.decided ? face : kNone;
}

Index SolidSweep::seen(Candidate& of) {
  if (!of.known) of.face = find_seen(of);
  of.known = true;
  return of.face;
}

/// The face of the solid that is nearest, or kNone.
Index SolidSweep::find_seen(Candidate& of) {
  SolidExpression::State& state = *of.state;
  ++counts_.decisions;
  Index found = kNone;
  entered_.clear();
  of.decided = layers_.size() + 1;
  // Calls for one group of faces in one plane after the other, until the solid begins in one.
  const auto look_through = [&](const std::vector<Layer>& layers) {
    std::size_t first = 0;
    while (first < layers.size() && found == kNone && layers[first].face != LayerOrder::kEnd) {
      std::size_t end = first + 1;
      while (end < layers.size() && layers[end].plane == layers[first].plane) ++end;
      found = enter(of, {layers.data() + first, end - first});
      first = end;
    }
    return first;
  };
  const std::size_t first = look_through(layers_);
  if (found != kNone) {
    of.decided = first;
  } else if (first < layers_.size()) {
    of.decided = first + 1;
    look_through(at_end_);
  }
  for (std::size_t i = 0; i < first; ++i) winding_[layers_[i].operand] = 0;
  for (const Layer& layer : at_end_) winding_[layer.operand] = 0;
  counts_.flips += entered_.size();
  for (auto operand = entered_.rbegin(); operand != entered_.rend(); ++operand)
    if (state.in(*operand)) state.flip(*operand);
  return found;
}

/// Passes faces of one plane, which are counted together before it is decided whether the solid
/// begins there (TK 3.3.4, step 5). The one that is seen if it does, or kNone.
Index SolidSweep::enter(Candidate& of, std::span<const Layer> group) {
  SolidExpression::State& state = *of.state;
  changed_.clear();
  for (const Layer& layer : group) {
    const bool was_in = winding_[layer.operand] != 0;
    winding_[layer.operand] += layer.enters;
    if (was_in != (winding_[layer.operand] != 0)) changed_.push_back(layer.operand);
  }
  for (const Index operand : changed_) state.flip(operand);
  entered_.insert(entered_.end(), changed_.begin(), changed_.end());
  if (!state.inside()) return kNone;
  return group.size() == 1 ? group.front().face : choose(state, group);
}

/// Which of the faces in one plane in which the solid begins: the first by the rule of ties whose
/// operand makes the solid begin there, alone or with others. That hangs on what is united and
/// intersected, and not on how the expression is written.
Index SolidSweep::choose(SolidExpression::State& state, std::span<const Layer> group) {
  operands_.clear(), candidates_.clear();
  std::sort(changed_.begin(), changed_.end());
  for (auto same = changed_.begin(); same != changed_.end();) {
    const auto end = std::find_if(same, changed_.end(), [&](Index o) { return o != *same; });
    // What was flipped back did not change.
    if ((end - same) % 2 != 0) operands_.push_back(*same);
    same = end;
  }
  for (const Layer& layer : group) turned_[layer.operand] += layer.enters;
  for (const Layer& layer : group) {
    if (std::binary_search(operands_.begin(), operands_.end(), layer.operand) &&
        turned_[layer.operand] * layer.enters > 0)
      candidates_.push_back(layer.face);
  }
  for (const Layer& layer : group) turned_[layer.operand] = 0;
  const Canonical& c = canonical_;
  Index first = kNone;
  while (!candidates_.empty()) {
    const Index face = ties_.of(candidates_);
    if (needed(state, c.memberships[c.faces[face].body].operand, operands_)) return face;
    if (first == kNone) first = face;
    std::erase(candidates_, face);
  }
  return first == kNone ? group.front().face : first;
}

/// True when there are changes with which the solid does not begin without the operand's, and does
/// with it. All are tried where they are few, each one flip from the one before (a Gray code);
/// where they are many, the others one after the other taken back until it does not.
bool SolidSweep::needed(SolidExpression::State& state, Index operand,
                        std::span<const Index> changed) {
  constexpr std::size_t kFew = 10;
  // With all others made it began there: without this one it does not.
  state.flip(operand);
  if (!state.inside()) return state.flip(operand), true;
  others_.clear();
  for (const Index other : changed)
    if (other != operand) others_.push_back(other);
  const auto flips_the_solid = [&] {
    if (state.inside()) return false;
    state.flip(operand);
    const bool result = state.inside();
    state.flip(operand);
    return result;
  };
  made_.assign(others_.size(), 1);
  const auto flip_other = [&](std::size_t i) { state.flip(others_[i]), made_[i] ^= 1; };
  bool result = false;
  if (others_.size() <= kFew) {
    for (std::size_t step = 1; !result && step < std::size_t{1} << others_.size(); ++step) {
      flip_other(static_cast<std::size_t>(std::countr_zero(step)));
      result = flips_the_solid();
    }
  } else {
    for (std::size_t i = 0; i < others_.size() && state.inside(); ++i) flip_other(i);
    result = flips_the_solid();
  }
  state.flip(operand);
  for (std::size_t i = 0; i < others_.size(); ++i)
    if (made_[i] == 0) flip_other(i);
  return result;
}

}  // namespace overstrike
