#pragma once
// What is seen of bodies and solids that are resolved by their edges, level after level.
#include <memory>
#include <optional>
#include <vector>

#include "core/visibility/loose_edges.h"
#include "core/visibility/solid_rows.h"

namespace overstrike {

/// One a thread.
class LooseRows final : public SolidLines {
 public:
  LooseRows(const FrontTable& table, const LooseEdges& edges, const FaceOrder& faces,
            const SolidOptions& options)
      : table_(table), edges_(edges), faces_(faces), options_(options) {}

  /// Turns to a level. The result: how many bodies and solids may meet it.
  std::size_t turn_to(double y);
  /// The number of one of those, as LooseEdge has it.
  Index body(std::size_t i) const { return edges_[band_[first_edge(i)].number].body; }
  /// What is seen of it alone on the level, from left to right. Good until the next call.

  const std::vector<SpanPiece>& pieces(std::size_t i);
  /// The same of a body of which that was not known before.
  const std::vector<SpanPiece>& pieces_of(Index body);
  /// Of a solid's operand.
  SolidLine line(Index number) const override;
  /// What was cut away of solids on the level (LooseResolver); null where nothing was.
  std::vector<SpanPiece>* cut_away() { return resolver_ ? &resolver_->cut_away() : nullptr; }

 private:
  std::size_t first_edge(std::size_t i) const { return i == 0 ? 0 : ends_[i - 1]; }
  bool may_be_kept(Index body) const;
  SolidRows& rows_of(Index body);
  LooseResolver& resolver();

  const FrontTable& table_;
  const LooseEdges& edges_;
  const FaceOrder& faces_;
  SolidOptions options_;
  double y_ = 0;
  std::optional<LooseResolver> resolver_;
  struct Kept {
    SolidTools tools;
    SolidRows rows;
    Kept(const Canonical& canonical, const SolidOptions& options, const SolidExpression& expression,
         const FaceOrder& faces, const SolidLines& lines, double reach)
        : tools(canonical, options), rows(expression, faces, lines, reach, tools) {}
  };
  std::vector<std::unique_ptr<Kept>> solids_;  ///< each made when it is first met
  std::vector<SpanPiece> pieces_;
  std::span<const LevelBands::Item> band_;  ///< edges near the level, by body
  std::vector<std::size_t> ends_;           ///< of each body's among those
};

}  // namespace overstrike
