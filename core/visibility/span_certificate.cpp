#include "core/visibility/span_certificate.h"

#include <algorithm>
#include <cmath>

namespace overstrike {

bool SpanCertifier::certify(const SlackLine& from, const SlackLine& to, const SpanRecord& record,
                            SureLevels& sure) {
  levels_ = std::max(std::fabs(sure.y), std::fabs(sure.until));
  crossings_.clear();
  for (const SpanRecord::Part& part : record.parts)
    if (part.crossing[0] != kNone) {
      const DepthPlane p = order_.depth_of(part.crossing[0]);
      crossings_.emplace_back(p, order_.depth_of(part.crossing[1]), reach_, levels_);
    }
  constexpr std::array<Index, 2> kLine{kNone, kNone};
  from_ = {&from, nullptr, kLine, from.slack, from.slack, 1, 0, 0};
  for (std::size_t i = 0; i < record.parts.size(); ++i) {
    to_ = {&to, nullptr, kLine, -to.slack, to.slack, -1, 0, 0};
    if (i + 1 < record.parts.size()) {
      const DepthDifference& d = crossings_[i];
      const double slack = 2 * kCrossingError + d.error / std::fabs(d.a);
      to_ = {nullptr, &d, record.parts[i + 1].crossing, 0, slack, -1, 0, 0};
    }
    from_.look(sure), to_.look(sure);
    if (!certify_part(record, record.parts[i], sure)) return false;
    from_ = to_, from_.into = 1;
  }
  return true;
}

/// Those that decided stay in their order, and the last one before all that lies behind them.
bool SpanCertifier::certify_part(const SpanRecord& record, const SpanRecord::Part& part,
                                 SureLevels& sure) {
  if (part.decided == part.first) return true;
  const SolidLayer* const layers = record.layers.data();
  for (std::size_t i = part.first + 1; i < part.end; ++i) {
    const std::size_t before = std::min(i, part.decided) - 1;
    if (!stays_before(layers[before], layers[i], sure)) return false;
  }
  return true;
}

bool SpanCertifier::stays_before(const SolidLayer& layer, const SolidLayer& other,
                                 SureLevels& sure) {
  if (layer.plane == other.plane) return true;
  const DepthDifference d(layer.depth, other.depth, reach_, levels_);
  if (leads_at_once(d, from_, sure) && leads_at_once(d, to_, sure)) return true;
  const double until = sure.until;
  if (!leads(d, from_, layer.face, other.face, sure) ||
      !leads(d, to_, layer.face, other.face, sure))
    return false;
  if (sure.until != until) from_.look(sure), to_.look(sure);
  return true;
}

bool SpanCertifier::leads_at_once(const DepthDifference& d, const Border& at,
                                  const SureLevels& sure) {
  const double margin = d.margin(at.slack);
  return d.at(at.now, sure.y) >= margin && d.at(at.then, sure.until) >= margin;
}

/// `face` lies before `other` at the border and beyond it, within the span. Where the border is
/// where the two cross, it is enough that they do so in that sense.
bool SpanCertifier::leads(const DepthDifference& d, const Border& at, Index face, Index other,
                          SureLevels& sure) const {
  if (at.is_of(face, other)) return d.a * at.into > 0;
  SureLevels rough = sure;
  const bool is_sure =
      rough.certify(d.margin(at.slack), [&](double y) { return d.at(at.x_at(y), y); });
  if (!is_sure) return at.line != nullptr && parts_in_edge(d, at, face, other, sure);
  sure = rough;
  return true;
}

/// At an edge in which two faces touch a level asks doubles whether they are the wrong way round
/// there, and where those cannot tell, which way they part (SolidSweep::compare). What is so half
/// as far from the edge as levels look is so everywhere farther, the rounding of x_at being less
/// than a quarter of the slack. What is computed is off by less than a quarter of the error that
/// levels allow for (DepthMap::depth has 16 u of each term, and it takes 4 u). Along a line that
/// does not pass an axis that error is linear: so what is no less than 0 at both levels is more
/// than minus half of it between them. Exact arithmetic tells the rest.
bool SpanCertifier::parts_in_edge(const DepthDifference& d, const Border& at, Index face,
                                  Index other, const SureLevels& sure) const {
  if (!(d.a * at.into > 0 && d.error <= kCrossingError * std::fabs(d.a))) return false;
  const double now = at.x_at(sure.y) - at.offset / 2, then = at.x_at(sure.until) - at.offset / 2;
  const bool is_linear = now * then >= 0 && sure.y * sure.until >= 0;
  if (is_linear && d.at(now, sure.y) >= 0 && d.at(then, sure.until) >= 0) return true;
  return order_.compare(face, other, now, sure.y) > 0 &&
         order_.compare(face, other, then, sure.until) > 0;
}

}  // namespace overstrike
