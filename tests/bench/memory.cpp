#include "tests/bench/memory.h"

#include <malloc.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <memory>
#include <sstream>

#include "tests/bench/contest.h"
#include "tests/bench/scenes.h"

namespace overstrike::bench {
namespace {

constexpr const char* kAsk = "--peak-of";

/// VmHWM: the largest size so far, or since forget_peak().
double peak_mb() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with("VmHWM:")) return std::strtod(line.c_str() + 6, nullptr) * 1024e-6;
  return 0;
}

void forget_peak() {
  malloc_trim(0);
  std::ofstream("/proc/self/clear_refs") << "5";
}

}  // namespace

Peak peak_of(const std::string& name, int size) {
  std::ostringstream command;
  command << std::quoted(std::filesystem::read_symlink("/proc/self/exe").string()) << ' ' << kAsk
          << ' ' << name << ' ' << size;
  Peak peak;
  const std::unique_ptr<FILE, int (*)(FILE*)> answer(popen(command.str().c_str(), "r"), pclose);
  if (!answer || std::fscanf(answer.get(), "%lf %lf", &peak.all, &peak.drawing) != 2) return {};
  return peak;
}

bool answer_peak(int argc, char** argv, const std::vector<NamedScene>& scenes) {
  if (argc != 4 || std::string(argv[1]) != kAsk) return false;
  for (const NamedScene& scene : scenes) {
    if (scene.name != argv[2]) continue;
    const Prepared prepared = prepare(scene.make(), square_grid(std::atoi(argv[3])));
    const double before = peak_mb();
    forget_peak();
    draw_runs(prepared, 1);
    const double drawing = peak_mb();
    std::printf("%g %g\n", std::max(before, drawing), drawing);
  }
  return true;
}

}  // namespace overstrike::bench
