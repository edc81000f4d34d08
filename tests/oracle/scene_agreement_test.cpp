// The law: what is drawn of every scene of scenes/ is what the oracle sees.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "scenes/readers/read.h"
#include "tests/oracle/trial.h"

namespace overstrike::oracle {
namespace {

constexpr int kSceneViews = 3;

/// The scene's own camera, then another side, then in parallel from low down.
Camera camera_of(const Scene& scene, int view) {
  if (view == 0) return scene.camera;
  Camera camera;
  camera.from = view == 1 ? Direction{127, 48} : Direction{21, 9};
  camera.parallel = view == 2;
  return camera;
}

TEST(Agreement, EverySceneFileUnderThreeViews) {
  const auto folder = std::filesystem::path(OVERSTRIKE_SOURCE_DIR) / "scenes";
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".yaml" || entry.path().extension() == ".csg")
      files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  ASSERT_FALSE(files.empty());
  int skipped = 0;
  for (const auto& file : files) {
    Scene scene = read_scene(file).scene;
    // The oracle sees what is there; what was cut away is judged by solids_methods_test.
    for (Solid& solid : scene.solids) solid.translucent = 0;
    const Scene as_read = scene;
    for (int view = 0; view < kSceneViews; ++view) {
      scene.camera = camera_of(as_read, view);
      Trial trial(scene, Grid{}, DrawOptions{}.tolerance,
                  file.filename().string() + ", view " + std::to_string(view));
      trial.judge(kPoints, kEnds);
      skipped += trial.skipped();
    }
  }
  EXPECT_LE(skipped, kMaxSkipped * kPoints * kSceneViews * static_cast<double>(files.size()));
}

}  // namespace
}  // namespace overstrike::oracle
