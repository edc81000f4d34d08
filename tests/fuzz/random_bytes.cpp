// Inputs of random bytes for a fuzz target, without libFuzzer: a release build tries many times as
// many. Inputs are tried in child processes, so that one that breaks something is kept and the
// others go on.
//
//     fuzz_core_random SEED COUNT FOLDER
//
// Input i is the same for one SEED whatever COUNT is. What broke goes to FOLDER/SEED-i.
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <new>
#include <string>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

constexpr std::size_t kLongest = 160;

/// In memory that parent and child share.
using Counter = std::atomic<std::uint64_t>;

/// splitmix64.
std::vector<std::uint8_t> input(std::uint64_t seed, std::uint64_t i) {
  std::uint64_t state = seed * 0x9E3779B97F4A7C15 + (i << 32);
  const auto next = [&state] {
    std::uint64_t z = state += 0x9E3779B97F4A7C15;
    z = (z ^ z >> 30) * 0xBF58476D1CE4E5B9;
    z = (z ^ z >> 27) * 0x94D049BB133111EB;
    return z ^ z >> 31;
  };
  std::vector<std::uint8_t> bytes(kLongest / 4 + next() % (kLongest * 3 / 4));
  for (std::uint8_t& b : bytes) b = static_cast<std::uint8_t>(next() >> 56);
  return bytes;
}

/// Tries inputs from `at` on, which is the one in hand.
bool child_ends_well(std::uint64_t seed, std::uint64_t count, Counter& at) {
  const pid_t child = fork();
  if (child < 0) return false;
  if (child == 0) {
    for (; at < count; ++at) {
      alarm(60);  // a scene takes milliseconds
      const std::vector<std::uint8_t> bytes = input(seed, at);
      LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
    }
    _exit(0);
  }
  int status = 0;
  return waitpid(child, &status, 0) == child && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) {
    std::fputs("usage: random SEED COUNT FOLDER\n", stderr);
    return 2;
  }
  const std::uint64_t seed = std::strtoull(argv[1], nullptr, 10);
  const std::uint64_t count = std::strtoull(argv[2], nullptr, 10);
  void* const shared =
      mmap(nullptr, sizeof(Counter), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (shared == MAP_FAILED) return 1;
  Counter& at = *new (shared) Counter(0);
  int broken = 0;
  for (; !child_ends_well(seed, count, at); ++at) {
    const std::uint64_t i = at;
    const std::string name =
        std::string(argv[3]) + "/" + std::to_string(seed) + "-" + std::to_string(i);
    std::fprintf(stderr, "kept as %s\n", name.c_str());
    const std::vector<std::uint8_t> bytes = input(seed, i);
    std::ofstream(name, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()),
               static_cast<std::streamsize>(bytes.size()));
    ++broken;
  }
  std::printf("%llu inputs, %d broke something\n", static_cast<unsigned long long>(count), broken);
  return broken == 0 ? 0 : 1;
}
