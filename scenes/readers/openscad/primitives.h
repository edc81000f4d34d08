#pragma once
// OpenSCAD's own shapes, vertex by vertex as it makes them. What is empty (a size of 0) has no
// parts; what is wrong is reported.
#include "scenes/readers/openscad/arguments.h"
#include "scenes/readers/openscad/part.h"

namespace overstrike::openscad {

std::vector<Part> cube(const Arguments& arguments);
/// Rings of facets between flat ends, at angles half a ring from the poles: it has no poles.
std::vector<Part> sphere(const Arguments& arguments);
std::vector<Part> cylinder(const Arguments& arguments);
/// Faces are clockwise seen from outside, and are turned.
std::vector<Part> polyhedron(const Arguments& arguments);

Flat square(const Arguments& arguments);
Flat circle(const Arguments& arguments);
/// Without paths, the points are one; several are a region by even and odd.
Flat polygon(const Arguments& arguments);

}  // namespace overstrike::openscad
