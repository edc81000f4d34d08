#include "tests/bench/levels.h"

#include <cmath>
#include <cstdlib>

#include "tests/bench/judge.h"
#include "tests/oracle/oracle.h"

namespace overstrike::bench {

Levels levels_of(const Prepared& prepared, const FacesOfRow& faces) {
  const Canonical& canonical = *prepared.canonical;
  const Vec3 sight(prepared.view.eye);
  const double length = std::sqrt(glm::dot(sight, sight));
  Levels levels;
  for (int row = 0; row < static_cast<int>(prepared.view.grid.rows); ++row)
    for (const Index face : faces(row)) {
      const double cosine =
          face == kNone ? 0 : glm::dot(canonical.outward(canonical.faces[face]), sight) / length;
      levels.push_back(static_cast<std::uint8_t>(face == kNone ? 0 : 25 + 230 * std::fabs(cosine)));
    }
  return levels;
}

Levels drawn_levels(const Prepared& prepared, int threads) {
  std::vector<int> all(static_cast<std::size_t>(prepared.view.grid.rows));
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<int>(i);
  const auto rows = runs_of_rows(prepared, all, threads);
  return levels_of(prepared, [&](int row) {
    return shown_by(rows[static_cast<std::size_t>(row)],
                    static_cast<int>(prepared.view.grid.columns));
  });
}

Levels true_levels(const Prepared& prepared) {
  const oracle::Oracle oracle(*prepared.canonical, prepared.view);
  return levels_of(prepared, [&](int row) {
    std::vector<Index> faces;
    for (int x = 0; x < static_cast<int>(prepared.view.grid.columns); ++x)
      faces.push_back(oracle.at(x + 0.5, row + 0.5).face);
    return faces;
  });
}

int wrong_pixels(const Levels& truth, const Levels& found) {
  constexpr int kTolerated = 2;
  int wrong = 0;
  for (std::size_t i = 0; i < truth.size(); ++i)
    wrong += std::abs(static_cast<int>(truth[i]) - static_cast<int>(found[i])) > kTolerated;
  return wrong;
}

}  // namespace overstrike::bench
