// The law for a near plane through bodies that lie within themselves: one mesh of several shells,
// over one another, in one another, touching, or turned inside out to be hollows.
#include <gtest/gtest.h>

#include "tests/oracle/random.h"
#include "tests/oracle/trial.h"

namespace overstrike::oracle {
namespace {

/// Appends a box with corners on a lattice, or anywhere.
void add_shell(Polyhedron& p, Random& random, bool lattice, bool inside_out) {
  const auto place = [&](double low, double high) {
    const Vec3 at = random.within(Vec3(low), Vec3(high));
    return lattice ? glm::roundEven(at) : at;
  };
  const Vec3 low = place(-4, 2), size = place(2.5, 6);
  const Index first = static_cast<Index>(p.vertices.size());
  for (int i = 0; i < 8; ++i) p.add_vertex(low + size * Vec3(i & 1, i >> 1 & 1, i >> 2 & 1));
  constexpr Index kFaces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                  {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  for (const auto& face : kFaces) {
    std::vector<Index> loop;
    for (const Index v : face) loop.push_back(first + v);
    if (inside_out) std::reverse(loop.begin(), loop.end());
    p.add_face(loop);
  }
}

Scene shells(int seed) {
  Random random(static_cast<std::uint64_t>(seed));
  const bool lattice = random.chance(0.5);
  Mesh mesh;
  const int count = 2 + random.below(3);
  for (int i = 0; i < count; ++i)
    add_shell(mesh.polyhedron, random, lattice, i > 0 && random.chance(0.3));
  Body body;
  body.shape = std::make_shared<const Shape>(std::move(mesh));
  if (!lattice) body.placement.linear = turn(random);
  Scene scene;
  scene.bodies.push_back(std::move(body));
  scene.light = Direction{-30, 40};
  scene.camera.eye = Vec3(0, -20, 0);
  scene.camera.target = Vec3(0, 0, 0);
  if (random.chance(0.5)) scene.camera.eye = Vec3(6, -20, 9);
  scene.camera.fov_deg = 30;
  scene.camera.near_distance = random.chance(0.5) ? 19.5 : 20;
  return scene;
}

TEST(CutShells, AreCutWhereTheyGoRound) {
#ifdef OVERSTRIKE_ORACLE_LONG
  constexpr int kScenes = 400;
#else
  constexpr int kScenes = 100;
#endif
  for (int n = 0; n < kScenes; ++n) {
    Trial trial(shells(n), Grid{48, 60}, 1, "shells " + std::to_string(n));
    trial.judge(kPoints, kEnds);
  }
}

}  // namespace
}  // namespace overstrike::oracle
