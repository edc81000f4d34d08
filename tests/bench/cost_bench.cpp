// What pictures cost, beside what they cost others: every line with its error (docs/cost.md).
#include "tests/bench/contest.h"
#include "tests/bench/groups.h"
#include "tests/bench/memory.h"

namespace overstrike::bench {
namespace {

/// NN74, Table 1: I + II + III, FACOM 230-60.
const std::vector<std::pair<std::string, double>> kTable1 = {
    {"nn74-a-solids", 0.19 + 0.48 + 0.46},   {"nn74-b-prisms", 0.30 + 0.80 + 0.33},
    {"nn74-c-boxes", 0.62 + 0.63 + 0.31},    {"nn74-d-patterns", 0.65 + 0.80 + 0.44},
    {"nn74-e-hospital", 1.14 + 2.80 + 0.99}, {"nn74-f-hospital", 1.14 + 2.69 + 0.59}};

const std::vector<NamedScene> kBoxes = {
    {"boxes/apart", [] { return many_boxes(Boxes::apart); }},
    {"boxes/anywhere", [] { return many_boxes(Boxes::anywhere); }}};

/// Scene C: its level, and its triangles for the name.
const std::vector<std::pair<int, std::string>> kLevels = {{0, "1600"}, {3, "102400"}};
const std::vector<int> kSizes = {512, 4096};

std::vector<Line> boxes(const NamedScene& scene, int size) {
  std::vector<Line> lines = contest(scene.make(), size, true);
  const Peak peak = peak_of(scene.name, size);
  lines.back().counters["peak_mb"] = peak.all;
  lines.back().counters["drawing_peak_mb"] = peak.drawing;
  return lines;
}

void register_all() {
  for (const auto& [name, seconds] : kTable1)
    register_lines({name, {"overstrike"}, [=] { return nn74_lines(name, seconds); }});
  for (const auto& [level, triangles] : kLevels)
    for (const int size : kSizes) {
      const std::string name = triangles + "/" + std::to_string(size);
      register_lines(
          {"scene_c/" + name, kContestants, [=] { return contest(scene_c(level), size); }});
      register_lines({"light/" + name, {"plain", "lit"}, [=] {
                        return light_lines(scene_c(level), lit_scene_c(level), size);
                      }});
    }
  const std::vector<int> growing = {512, 1024, 2048, 4096};
  for (const int sides : {4, 32})
    register_lines({"scene_b/" + std::to_string(sides), growth_methods(growing),
                    [=] { return growth_lines(scene_b(sides), growing); }});
  register_lines(
      {"threads/102400/4096", kThreadMethods, [] { return thread_lines(scene_c(3), 4096); }});
  for (const NamedScene& scene : kBoxes)
    register_lines({scene.name + "/512", kContestants, [=] { return boxes(scene, 512); }});
}

}  // namespace
}  // namespace overstrike::bench

int main(int argc, char** argv) {
  using namespace overstrike::bench;
  if (answer_peak(argc, argv, kBoxes)) return 0;
  register_all();
  return run_lines(argc, argv);
}
