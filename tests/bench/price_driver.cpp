// Draws one priced scene once, for price.py to count the instructions of price_region(); or tells
// how many times as long the scene with the feature takes.
//
//   price_driver FEATURE without|with|alone|time
#include <algorithm>
#include <cstdio>
#include <string_view>

#include "tests/bench/price_scenes.h"
#include "tests/bench/timing.h"

namespace {

using namespace overstrike::bench;

constexpr int kSize = 512;
constexpr double kTimeMs = 1000;

Prepared prepared(Feature feature, bool with) {
  return prepare(priced_scene(feature, with), square_grid(kSize));
}

/// How many times as long.
double time_ratio(Feature feature) {
  const Prepared without = prepared(feature, false), with = prepared(feature, true);
  const std::vector<Times> times = interleaved(
      {[&] { draw_priced(without, feature, false); }, [&] { draw_priced(with, feature, true); }},
      kTimeMs);
  return ratio(times[1].cpu, times[0].cpu);
}

}  // namespace

/// What is counted.
extern "C" __attribute__((noinline)) std::size_t price_region(const Prepared& scene,
                                                              Feature feature,
                                                              std::string_view what) {
  return what == "alone" ? scan_alone(scene) : draw_priced(scene, feature, what == "with");
}

int main(int argc, char** argv) {
  const std::string_view name = argc == 3 ? argv[1] : "", what = argc == 3 ? argv[2] : "";
  const auto at = std::find(kFeatureNames.begin(), kFeatureNames.end(), name);
  if (at == kFeatureNames.end()) {
    std::fputs("usage: price_driver FEATURE without|with|alone|time\n", stderr);
    return 2;
  }
  const Feature feature = static_cast<Feature>(at - kFeatureNames.begin());
  if (what == "time") {
    std::printf("%.3g\n", time_ratio(feature));
    return 0;
  }
  std::printf("%zu\n", price_region(prepared(feature, what == "with"), feature, what));
}
