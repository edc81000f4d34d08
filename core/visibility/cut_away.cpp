#include "core/visibility/cut_away.h"

#include <algorithm>

namespace overstrike {
namespace {

/// As FaceOrder, but what is seen goes before what was cut away at the same depth.
struct SeenFirst {
  const FaceOrder& order;
  Index seen;

  int compare(Index f, Index g, double x, double y) const { return order.compare(f, g, x, y); }
  double crossing(Index f, Index g, double y) const { return order.crossing(f, g, y); }
  bool in_front(Index f, Index g, double x, double y) const {
    if (f != seen && g != seen) return order.in_front(f, g, x, y);
    const int side = order.compare(f, g, x, y);
    return side != 0 ? side > 0 : f == seen;
  }
};

/// A run from x0 to x1.
DensityRun part(const DensityRun& run, double x0, double x1) {
  const auto at = [&](double x) {
    if (x == run.x0 || run.density0 == run.density1) return run.density0;
    if (x == run.x1) return run.density1;
    return run.density0 + (run.density1 - run.density0) * ((x - run.x0) / (run.x1 - run.x0));
  };
  DensityRun result = run;
  result.x0 = x0, result.x1 = x1;
  result.density0 = at(x0), result.density1 = at(x1);
  return result;
}

}  // namespace

void CutAway::mix(double y, const std::vector<SpanPiece>& seen, std::vector<SpanPiece>& cut_away,
                  std::vector<DensityRun>& runs, std::size_t first) {
  std::sort(cut_away.begin(), cut_away.end(), [](const SpanPiece& a, const SpanPiece& b) {
    return a.x0 != b.x0 ? a.x0 < b.x0 : a.face < b.face;
  });
  find_first(y, seen, cut_away);
  before_.clear(), mixed_.clear();
  shader_.shade_away_from_shadows(y, first_, before_);
  merge(std::span(runs).subspan(first), mixed_);
  runs.resize(first);
  runs.insert(runs.end(), mixed_.begin(), mixed_.end());
}

/// Leaves in `first_` where something that was cut away lies before what is seen.
void CutAway::find_first(double y, const std::vector<SpanPiece>& seen,
                         const std::vector<SpanPiece>& cut_away) {
  first_.clear(), ends_.clear();
  const auto end_at = [&](double x, float slack) {
    if (x > 0 && x < columns_) ends_.push_back({x, slack});
  };
  for (const SpanPiece& piece : cut_away)
    end_at(piece.x0, piece.slack0), end_at(piece.x1, piece.slack1);
  for (const SpanPiece& piece : seen)
    end_at(piece.x0, piece.slack0), end_at(piece.x1, piece.slack1);
  ends_.push_back({0, 0}), ends_.push_back({columns_, 0});
  std::sort(ends_.begin(), ends_.end(),
            [](const End& a, const End& b) { return a.x != b.x ? a.x < b.x : a.slack > b.slack; });
  std::size_t entering = 0, at_seen = 0;
  std::vector<const SpanPiece*> open;
  for (std::size_t i = 0; i + 1 < ends_.size(); ++i) {
    const SpanPiece over{ends_[i].x, ends_[i + 1].x, kNone, ends_[i].slack, ends_[i + 1].slack};
    if (!(over.x0 < over.x1)) continue;
    std::erase_if(open, [&](const SpanPiece* piece) { return piece->x1 <= over.x0; });
    for (; entering < cut_away.size() && cut_away[entering].x0 <= over.x0; ++entering)
      if (cut_away[entering].x1 > over.x0) open.push_back(&cut_away[entering]);
    while (at_seen < seen.size() && seen[at_seen].x1 <= over.x0) ++at_seen;
    if (open.empty()) continue;
    const bool covered = at_seen < seen.size() && seen[at_seen].x0 <= over.x0;
    active_.clear();
    for (const SpanPiece* piece : open) active_.push_back(piece->face);
    compare(y, over, covered ? seen[at_seen].face : kNone);
  }
}

void CutAway::compare(double y, const SpanPiece& over, Index seen) {
  if (seen != kNone) active_.push_back(seen);
  split_.clear();
  split_at_crossings(SeenFirst{order_, seen}, active_, over.x0, over.x1, y, over.slack0,
                     over.slack1, split_);
  for (const SpanPiece& piece : split_) {
    if (piece.face == seen) continue;
    if (!first_.empty() && first_.back().x1 == piece.x0 && first_.back().face == piece.face) {
      first_.back().x1 = piece.x1, first_.back().slack1 = piece.slack1;
    } else {
      first_.push_back(piece);
    }
  }
}

double CutAway::factor_of(const DensityRun& run) const {
  const Canonical& c = table_.canonical;
  return c.solids[c.memberships[run.body].solid]->translucent;
}

/// Goes over both from left to right. Runs that nothing lies before stay as they are.
void CutAway::merge(std::span<const DensityRun> runs, std::vector<DensityRun>& mixed) const {
  const auto mix_in = [&](DensityRun run, double of_run, const DensityRun& before) {
    const double factor = factor_of(before);
    run.density0 = of_run * (1 - factor) * run.density0 + factor * before.density0;
    run.density1 = of_run * (1 - factor) * run.density1 + factor * before.density1;
    mixed.push_back(run);
  };
  std::size_t b = 0;
  double x = 0;  // up to there all is mixed
  const auto alone_until = [&](double end) {
    for (; b < before_.size() && before_[b].x0 < end; ++b) {
      const double x0 = std::max(before_[b].x0, x), x1 = std::min(before_[b].x1, end);
      if (x0 < x1) {
        const DensityRun over_paper = part(before_[b], x0, x1);
        mix_in(over_paper, 0, over_paper);
      }
      if (before_[b].x1 > end) break;
    }
    x = std::max(x, end);
  };
  for (const DensityRun& run : runs) {
    alone_until(run.x0);
    x = run.x0;
    for (; b < before_.size() && before_[b].x0 < run.x1; ++b) {
      const double x0 = std::max(before_[b].x0, x), x1 = std::min(before_[b].x1, run.x1);
      if (x0 > x) mixed.push_back(part(run, x, x0));
      if (x0 < x1) {
        mix_in(part(run, x0, x1), 1, part(before_[b], x0, x1));
        x = x1;
      }
      if (before_[b].x1 > run.x1) break;
    }
    if (x < run.x1) mixed.push_back(part(run, x, run.x1));
    x = run.x1;
  }
  alone_until(columns_);
}

}  // namespace overstrike
