#pragma once
// Shadow borders on their receivers as the eye's levels meet them.
#include <atomic>
#include <memory>
#include <optional>
#include <vector>

#include "core/visibility/face_order.h"
#include "core/visibility/front_table.h"
#include "core/visibility/level_bands.h"
#include "core/visibility/shadows.h"
#include "core/visibility/solid_shadow.h"

namespace overstrike {

/// A border of a shadow: passing it from left to right adds `winding` to the count.
struct ShadowLine {
  LevelLine line;
  float slack;
  int winding;
  /// Of the caster, where it passes through the receiver's nearly along the levels: kSmallSlack
  /// does not bound the line's error there. What is seen ends where the two planes cross, too, and
  /// the shadow ends there to the bit. Else kNone.
  Index plane;
};

/// The shadow on one receiver.
class ReceiverShadow {
 public:
  ReceiverShadow() = default;
  /// `casting`: the input that casts.
  ReceiverShadow(const FrontTable& table, const Canonical& casting, const Shadow& shadow);
  /// What one thread needs; of the solids, where there are some.
  using Scratch = std::optional<SolidShadow::Scratch>;
  /// Sets where the level is in shadow on the receiver's plane, from left to right; right over
  /// the receiver itself only.
  void on_level(double y, const FaceOrder& order, Coherence coherence, Scratch& scratch,
                std::vector<ShadowSpan>& spans) const;
  /// No border passes over the receiver: it is in shadow all over, or not at all.
  bool uniform() const { return lines_.empty() && solids_.empty(); }
  bool begins_in_shadow() const { return base_ != 0; }

 private:
  /// The receiver's bounds in the grid.
  struct Box {
    Vec2 low, high;
  };
  static Box box_of(const FrontTable& table, Index face);
  /// How far a border's ends may be from where they were meant, and the height beside its line at
  /// which a level is looked at.
  struct Error {
    double point, beside;
  };
  /// Where the levels meet an edge.
  struct PlacedLine {
    LevelLine line;
    double error;
    bool down;  ///< it begins at the edge's `a`
    bool left;  ///< of all of the receiver, at all its levels
  };
  static std::optional<PlacedLine> placed(const View& view, const Vec3& a, const Vec3& b,
                                          const Box& receiver, const Error& error);
  void add_line(const ShadowEdge& edge, const View& view, const Box& receiver, const Error& error);
  void add_solids(const FrontTable& table, const Canonical& casting, const Shadow& shadow);
  void plain_on_level(double y, const FaceOrder& order, std::vector<ShadowSpan>& spans) const;

  /// Where the level meets a ShadowLine or an OperandLine.
  template <class Line>
  double x_of(const Line& line, double y, const FaceOrder& order) const {
    return line.plane == kNone ? line.line.x_at(y) : crossing(line.line, line.plane, y, order);
  }
  double crossing(const LevelLine& line, Index plane, double y, const FaceOrder& order) const;

  Index plane_ = kNone;  ///< the receiver's
  int base_ = 0;         ///< the count to the left of all lines
  std::vector<ShadowLine> lines_;
  std::optional<LevelBands> bands_;  ///< where there are many lines
  // Of solids.
  const Canonical* casting_ = nullptr;
  std::unique_ptr<const CastOrder> cast_order_;
  std::vector<SolidShadow> solids_;
};

/// The shadows of a picture, each cast when its receiver is first seen. Any number of threads.
class ReceiverShadows {
 public:
  /// Both must outlive this; no shadows when there is no caster.
  ReceiverShadows(const FrontTable& table, const ShadowCaster* caster, Coherence coherence);
  ~ReceiverShadows();

  bool none() const { return of_face_.empty(); }
  /// What is kept of solids' shadows.
  Coherence coherence() const { return coherence_; }
  enum class Extent { none, all, part };
  /// How much of the face is in shadow; `part` is set to its shadow when that is but a part.
  Extent on(Index face, ShadowCaster::Scratch& scratch, const ReceiverShadow*& part) const {
    if (of_face_.empty()) return Extent::none;
    const ReceiverShadow* shadow = of_face_[face].load(std::memory_order_acquire);
    if (shadow == nullptr) shadow = cast(face, scratch);
    part = shadow;
    return shadow == &kNone ? Extent::none : shadow == &kAll ? Extent::all : Extent::part;
  }

 private:
  const ReceiverShadow* cast(Index face, ShadowCaster::Scratch& scratch) const;

  static const ReceiverShadow kNone, kAll;
  const FrontTable& table_;
  const ShadowCaster* caster_;
  Coherence coherence_;
  mutable std::vector<std::atomic<const ReceiverShadow*>> of_face_;
};

}  // namespace overstrike
