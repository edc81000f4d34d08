#pragma once
// Points of a circle, and how many of them a tolerance asks for.
#include "core/geometry/vec.h"

namespace overstrike {

constexpr int kFewestSides = 3;
constexpr int kMostSides = 4096;

/// (cos, sin) of k/n of a full turn, k >= 0. Mirror images in the axes are exact: of the points of
/// one n, those that have equal coordinates by symmetry have them bit for bit.
Vec2 turn(int k, int n);

/// (cos, sin) of k/n of `angle_deg`.
Vec2 part_of_turn(int k, int n, double angle_deg);

/// How far the middle of a chord lies from its arc: r (1 - cos(angle/2n)) for n chords over
/// `angle_deg`.
double sagitta(double radius, int n, double angle_deg);

/// The fewest chords over `angle_deg` (0..360] whose sagitta is at most `chord`: at least as many
/// as make 3 of a full circle, at most as make 4096.
int chords_for(double radius, double chord, double angle_deg);

}  // namespace overstrike
