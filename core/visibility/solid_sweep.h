#pragma once
// What is seen of a Boolean solid along one level (TK, ch. 3 and 4).
//
// The faces of all operands that lie over the present span are kept in their order of depth.
// Passing an edge replaces a face by its neighbour, or brings two in or takes two out (TK 4, the
// three patterns); within a span only neighbours in depth can exchange their places, at their exact
// crossing (TK 4.2.2). Along depth each operand has a winding number, and the expression of the
// solid follows it: the first place inside is where the solid is seen.
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/scene/solid_expression.h"
#include "core/visibility/layer_order.h"
#include "core/visibility/solid_options.h"
#include "core/visibility/span_split.h"
#include "core/visibility/tie.h"

namespace overstrike {

/// A face over a span.
struct SolidLayer {
  Index face;
  Index plane, operand;
  int enters;  ///< 1: the operand is entered there along the line of sight, -1: left
  DepthPlane depth;
};

/// What decided in one span what is seen, in its parts from left to right.
struct SpanRecord {
  struct Part {
    /// The layers whose crossing it begins with: the nearer one before that and the farther one;
    /// kNone: it begins with the span.
    std::array<Index, 2> crossing;
    Index seen;  ///< kNone: nothing
    /// Of `layers`: those that decided, from near to far, up to `decided`, and what lies behind
    /// them.
    std::size_t first, decided, end;
  };
  std::vector<Part> parts;
  std::vector<SolidLayer> layers;
  void clear() { parts.clear(), layers.clear(); }
};

/// Goes over one level after the other. One a thread.
class SolidSweep {
 public:
  /// Of `canonical` are the faces.
  explicit SolidSweep(const Canonical& canonical, const SolidOptions& options = {})
      : canonical_(canonical), options_(options), ties_(canonical) {}
  ~SolidSweep();
  SolidSweep(const SolidSweep&) = delete;
  SolidSweep& operator=(const SolidSweep&) = delete;

  /// Goes to the left of all edges of a solid's operands on the level, on which it is not asked
  /// farther than `reach` from the grid's origin. The order must outlive what is asked. `uncut`
  /// (may be null) is the solid with nothing taken from it; what of that was cut away is then
  /// looked for too.
  void begin(const SolidExpression& expression, const LayerOrder& order, double y, double reach,
             const SolidExpression* uncut = nullptr);
  /// From here on what lies behind the layer LayerOrder::kEnd is not looked for.
  void end_at_layer();
  /// Begins where a span from `x0` has ended over which these faces were active, given in any
  /// order. It was put in order up to `x1`, its end less the bound on that one's error. False when
  /// doubles cannot tell their order there: what may cross at a span's end keeps the order from
  /// before it, which the spans on the left know.
  bool resume(std::span<const Index> faces, double x0, double x1);
  /// The active faces.
  void copy_active(std::vector<Index>& faces) const;
  /// Spans are recorded there (null: not).
  void record_in(SpanRecord* record) { record_ = record; }
  /// Passes an edge between two faces (the second may be kNone) from left to right.
  void pass(const std::array<Index, 2>& faces);
  /// Appends what is seen from where edges were passed last to where the next one is. The face of
  /// `over` is not looked at. Where nothing is seen, there is no piece.
  void span(const SpanPiece& over, std::vector<SpanPiece>& pieces) { span(over, pieces, pieces); }
  /// Appends to `cut_away` where the solid with nothing taken from it is seen before what is left.
  void span(const SpanPiece& over, std::vector<SpanPiece>& pieces,
            std::vector<SpanPiece>& cut_away);

 private:
  /// An active face, and its depth on the level: depth.a x + constant, larger is nearer.
  struct Layer : SolidLayer {
    double constant, constant_error;
    bool fresh;  ///< it took the place of another, or met a neighbour where the last span ended,
                 ///< and may be out of order
    std::uint64_t replaced_at = 0;  ///< number of the settling in which it took another's place
    // It stays before that face up to there; kept by next_crossing().
    Index before = kNone;
    double before_until = 0;
  };
  /// A set, and what is seen of it as long as nothing changes among the first `decided` layers,
  /// which decide it.
  struct Candidate {
    const SolidExpression* expression = nullptr;
    std::optional<SolidExpression::State> state;
    bool known = false;
    Index face = kNone;
    std::size_t decided = 0;
  };
  /// A crossing of two neighbours in depth.
  struct Crossing {
    double x;
    std::size_t first;  ///< of the two layers
  };
  void record(const std::array<Index, 2>& crossing);
  void follow(Candidate& candidate, const SolidExpression* expression);
  void stop(Candidate& candidate);
  Layer layer_of(Index face) const;
  Layer on_level(const SolidLayer& layer) const;
  void settle(double low, double high);
  void forget_last_span();
  void forget_seen();
  bool was_before(const Layer& a, const Layer& b, double middle, double end) const;
  bool in_order(double middle, double end);
  bool follows(std::size_t at, double middle, double end);
  void note_doubt(std::size_t at);
  void forget_doubts();
  void replace(std::size_t at, Index face);
  void toggle(Index face);
  void toggle_at_end(Index face);
  void insert(Index face);
  void move_into_order(std::size_t at);
  int compare(const Layer& a, const Layer& b) const;
  int compare_at(const Layer& a, const Layer& b, double x, bool& sharp) const;
  std::optional<Crossing> next_crossing(double from);
  double crossing(const Layer& near, const Layer& far, double from) const;
  double before_until(const Layer& near, const Layer& far) const;
  void exchange(std::size_t first);
  void changed_at(std::size_t at);
  bool ties(std::size_t at) const;
  bool stands_clear(std::size_t at) const;
  Index seen(Candidate& of);
  Index cut_away();
  Index find_seen(Candidate& of);
  Index enter(Candidate& of, std::span<const Layer> group);
  Index choose(SolidExpression::State& state, std::span<const Layer> group);
  bool needed(SolidExpression::State& state, Index operand, std::span<const Index> changed);

  const Canonical& canonical_;
  const LayerOrder* order_ = nullptr;
  SolidOptions options_;
  SolidCounts counts_;
  Candidate solid_, uncut_;  ///< uncut_: of no expression where it is not asked for
  double y_ = 0, reach_ = 0;
  std::uint64_t settlings_ = 0;
  double low_ = 0, high_ = 0;  ///< within the span in hand
  std::vector<Layer> layers_;  ///< from near to far
  int fresh_ = 0;              ///< of them, how many are
  SpanRecord* record_ = nullptr;
  bool ends_ = false;          ///< one of them is kEnd
  std::vector<Layer> at_end_;  ///< faces that lie in it, from near to far beside it
  std::vector<std::array<Index, 2>> passed_;
  std::vector<Index> entering_;
  std::vector<int> winding_;  ///< per operand; 0 between two questions
  std::vector<int> turned_;   ///< of that by the faces of one plane; 0 between two questions
  std::vector<Index> entered_, changed_, operands_, candidates_, others_;
  FirstOfTied ties_;
  std::vector<char> made_;  ///< per one of others_: whether its change is made
};

}  // namespace overstrike
