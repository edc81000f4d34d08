#include "core/visibility/tie.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "core/visibility/view.h"

namespace overstrike {
namespace {

/// Boxes about one axis with their bottoms in one plane; several of a size, and of a density.
Canonical nested_boxes(int count, std::mt19937_64& random) {
  Scene scene;
  for (int i = 0; i < count; ++i) {
    Body body;
    const double width = 1.0 + static_cast<double>(random() % 12);
    body.shape = std::make_shared<const Shape>(Box{{width, width, 1}});
    body.density_factor = random() % 2 == 0 ? 1 : 0.5;
    scene.bodies.push_back(body);
  }
  std::vector<Diagnostic> warnings;
  return canonicalize(scene, make_view(scene, {}), 0.1, warnings);
}

TEST(FirstOfTied, IsTheFirstOneOfAnySubsetWhateverWasAskedBefore) {
  std::mt19937_64 random(5);
  const Canonical canonical = nested_boxes(40, random);
  std::vector<Index> faces;
  for (Index f = 0; f < canonical.faces.size(); ++f) faces.push_back(f);
  const auto wins = [&](Index f, Index g) { return wins_tie(canonical, f, g); };
  FirstOfTied tied(canonical);
  for (int n = 0; n < 2000; ++n) {
    if (n % 20 == 0) std::shuffle(faces.begin(), faces.end(), random);
    // Most of the faces of the question before, and a few others.
    std::swap(faces[random() % 60], faces[random() % faces.size()]);
    const std::span<const Index> asked(faces.data(), 1 + random() % 60);
    ASSERT_EQ(tied.of(asked), *std::min_element(asked.begin(), asked.end(), wins)) << n;
  }
}

}  // namespace
}  // namespace overstrike
