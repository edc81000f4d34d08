#pragma once
// What the laws of pictures are tried on, and how two pictures are compared.
#include <functional>
#include <string>
#include <vector>

#include "core/drawing.h"
#include "core/visibility/canonical.h"
#include "core/visibility/view.h"
#include "tests/hard/corpus.h"

namespace overstrike::hard {

/// A scene with a name for messages.
struct Subject {
  std::string name;
  Scene scene;
};

/// One of so many hard cases, those of more bodies left out; and one of so many of the oracle's
/// random scenes under three views.
struct Sample {
  int cases = 1, random_scenes = 1;
  std::size_t most_bodies = 1000;
};
std::vector<Subject> subjects(const Sample& sample);

using Runs = std::vector<std::vector<DensityRun>>;  ///< line after line

Drawing drawn(const Scene& scene, int threads = 1, const Grid& grid = kGrid);
Runs runs_of(Drawing& drawing, const ScanFamily& family);
Runs runs_of(const Scene& scene, const ScanFamily& family);
std::vector<float> cells_of(Drawing& drawing);

/// Empty when both are equal to the last bit; else where they first differ.
std::string first_difference(const Runs& a, const Runs& b);
std::string first_difference(const std::vector<float>& a, const std::vector<float>& b);

/// Where the densities of two lines differ by more than `density_error`, from left to right.
struct Stretch {
  double from, to;
};
std::vector<Stretch> differences(const std::vector<DensityRun>& a, const std::vector<DensityRun>& b,
                                 double density_error);

/// Every subject that breaks the law is reported; the law says what it found, or nothing.
void expect_law(const std::vector<Subject>& all, const std::string& law,
                const std::function<std::string(const Scene&)>& broken);

}  // namespace overstrike::hard
