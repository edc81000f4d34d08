#pragma once
// For how long a span of a Boolean solid surely shows what it shows (a certificate, as kinetic data
// structures have them).
//
// Edges move along straight lines from level to level, and so do depth differences along them and
// along the lines in which planes cross: what is sure at one level and at another is so between.
#include <vector>

#include "core/visibility/depth_difference.h"
#include "core/visibility/layer_order.h"
#include "core/visibility/solid_sweep.h"

namespace overstrike {

/// One a thread.
class SpanCertifier {
 public:
  /// `reach`: bounds |x| where it is asked.
  SpanCertifier(const LayerOrder& order, double reach) : order_(order), reach_(reach) {}

  /// Brings `sure.until` nearer to where, between the two lines, those that decided in the parts of
  /// the record surely stay in their order and before all that lies behind them. `from.slack`: also
  /// of the other lines that meet the level there. False when that is not worth while.
  bool certify(const SlackLine& from, const SlackLine& to, const SpanRecord& record,
               SureLevels& sure);

 private:
  /// Where parts of a span meet, or where it ends.
  struct Border {
    const SlackLine* line;        ///< null: a crossing
    const DepthDifference* zero;  ///< of two depths
    std::array<Index, 2> crossing;
    double offset, slack;  ///< into the span, and what the place may be off by
    double into;           ///< 1: the span is on its right, -1: on its left
    double now, then;      ///< where depths are compared on the first level and on the last one

    void look(const SureLevels& sure) { now = x_at(sure.y), then = x_at(sure.until); }
    double x_at(double y) const {
      return line != nullptr ? line->x_at(y) + offset : zero->zero_at(y);
    }
    bool is_of(Index f, Index g) const {
      return (f == crossing[0] && g == crossing[1]) || (f == crossing[1] && g == crossing[0]);
    }
  };
  bool certify_part(const SpanRecord& record, const SpanRecord::Part& part, SureLevels& sure);
  bool stays_before(const SolidLayer& layer, const SolidLayer& other, SureLevels& sure);
  static bool leads_at_once(const DepthDifference& d, const Border& at, const SureLevels& sure);
  bool leads(const DepthDifference& d, const Border& at, Index face, Index other,
             SureLevels& sure) const;
  bool parts_in_edge(const DepthDifference& d, const Border& at, Index face, Index other,
                     const SureLevels& sure) const;

  const LayerOrder& order_;
  double reach_;
  // Of the span in hand.
  double levels_ = 0;                       ///< how far its levels reach
  std::vector<DepthDifference> crossings_;  ///< at which the parts of the record begin
  Border from_{}, to_{};                    ///< of the part in hand
};

}  // namespace overstrike
