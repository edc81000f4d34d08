// What pictures cost, beside what they cost others: every line with its error.
#include "tests/bench/contest.h"

namespace overstrike::bench {
namespace {

void register_contests() {
  const auto add = [](const std::string& name, const std::function<Scene()>& scene, int size) {
    register_lines(
        {name + "/" + std::to_string(size), kContestants, [=] { return contest(scene(), size); }});
  };
  add(
      "scene_c/1600", [] { return scene_c(0); }, 512);
  add(
      "scene_c/1600", [] { return scene_c(0); }, 4096);
  add(
      "scene_c/102400", [] { return scene_c(3); }, 512);
  add(
      "scene_c/102400", [] { return scene_c(3); }, 4096);
  add(
      "boxes/apart", [] { return many_boxes(Boxes::apart); }, 512);
  add(
      "boxes/anywhere", [] { return many_boxes(Boxes::anywhere); }, 512);
}

}  // namespace
}  // namespace overstrike::bench

int main(int argc, char** argv) {
  overstrike::bench::register_contests();
  return overstrike::bench::run_lines(argc, argv);
}
