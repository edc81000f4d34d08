// One hash for every scene's runs, cells and strokes, to the last bit: what two builds of core must
// agree in. Prints a line a scene.
#include <cstdint>
#include <cstdio>
#include <cstring>

#include "core/drawing.h"
#include "tests/hard/corpus.h"
#include "tests/oracle/random_scenes.h"

namespace overstrike::hard {
namespace {

/// FNV-1a (Fowler, Noll, Vo), over values, not over their padding.
class Hash {
 public:
  template <class T>
  void add(const T& value) {
    static_assert(std::is_arithmetic_v<T> || std::is_enum_v<T>);
    unsigned char bytes[sizeof value];
    std::memcpy(bytes, &value, sizeof value);
    for (const unsigned char b : bytes) state_ = (state_ ^ b) * 0x100000001B3u;
  }
  std::uint64_t value() const { return state_; }

 private:
  std::uint64_t state_ = 0xCBF29CE484222325u;
};

void add_runs(Hash& hash, Drawing& drawing, const ScanFamily& family) {
  drawing.runs(family, [&hash](const RunRow& row) {
    hash.add(row.index);
    for (const DensityRun& r : row.runs) {
      for (const double v : {r.x0, r.x1, r.density0, r.density1}) hash.add(v);
      hash.add(r.surface), hash.add(r.body), hash.add(r.kind);
    }
  });
}

void add_strokes(Hash& hash, Drawing& drawing) {
  for (const Stroke& s : drawing.strokes({})) {
    for (const Vec2& p : s.points) hash.add(p.x), hash.add(p.y);
    hash.add(s.kind), hash.add(s.body), hash.add(s.pen);
  }
}

void print(const std::string& name, const Scene& scene) {
  DrawOptions options;
  options.tolerance = kTolerance;
  options.threads = 2;
  Drawing drawing(scene, kGrid, options);
  Hash hash;
  for (const ScanFamily& family :
       {ScanFamily{0, 1, 0.5}, ScanFamily{0, 1, 0}, ScanFamily{33, 5.3, 0.71}})
    add_runs(hash, drawing, family);
  drawing.cells([&hash](const CellRow& row) {
    for (const float density : row.density) hash.add(density);
  });
  add_strokes(hash, drawing);
  std::printf("%016llx %s\n", static_cast<unsigned long long>(hash.value()), name.c_str());
}

}  // namespace
}  // namespace overstrike::hard

int main() {
  using namespace overstrike;
  constexpr std::size_t kMostBodies = 64;
  for (const hard::Case& c : hard::corpus())
    if (c.scene.bodies.size() <= kMostBodies) hard::print(c.name, c.scene);
  for (int n = 0; n < oracle::kRandomScenes; ++n)
    for (int view = 0; view < oracle::kViews; ++view)
      hard::print(oracle::describe(n, view), oracle::seen_from(oracle::random_scene(n), n, view));
}
