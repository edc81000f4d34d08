// NN74's method and the line resolver draw the same of the six scenes of the paper's table 1.
#include <gtest/gtest.h>

#include "core/visibility/nn74/compare.h"
#include "scenes/readers/read.h"

namespace overstrike {
namespace {

class Nn74Method : public testing::TestWithParam<const char*> {};

TEST_P(Nn74Method, AgreesWithTheLineResolver) {
  const Scene scene =
      read_scene(std::string(OVERSTRIKE_SOURCE_DIR) + "/scenes/" + GetParam() + ".yaml").scene;
  nn74::testing::expect_agreement(scene, Grid{}, {});
  nn74::testing::expect_agreement(scene, Grid{}, {45, 1.5, 0.3});
}

INSTANTIATE_TEST_SUITE_P(Scenes, Nn74Method,
                         testing::Values("nn74-a-solids", "nn74-b-prisms", "nn74-c-boxes",
                                         "nn74-d-patterns", "nn74-e-hospital", "nn74-f-hospital",
                                         "cyclic"));

}  // namespace
}  // namespace overstrike
