#pragma once
// Seeded random scenes for the tests that compare with the oracle.
#include <string>

#include "core/scene/scene.h"

namespace overstrike::oracle {

constexpr int kRandomScenes = 100;
constexpr int kViews = 3;

/// What a scene is made to try; scene n is of family n % kFamilies.
enum class Family { convex, non_convex, interpenetrating, cyclic, touching, flat, mixed };
constexpr int kFamilies = 7;

/// Scene number `n`: always the same one. Light, ground, smooth shading and density factors vary
/// with n. Its camera is that of view 0.
Scene random_scene(int n);

/// The scene under one of kViews cameras: 0 from above in perspective, fitted; 1 from anywhere
/// (also from below) in parallel; 2 from near, wide, with the eye among the bodies every other
/// time.
Scene seen_from(Scene scene, int n, int view);

std::string describe(int n, int view);

}  // namespace overstrike::oracle
