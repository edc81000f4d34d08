#pragma once
// What the readers of meshes share: limits, and equal vertices made one.
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "core/scene/shapes.h"

namespace overstrike {

/// Coordinates beyond this are refused, as core refuses them.
constexpr double kLargestCoordinate = 1e100;

/// An Index counts corners; the last one is kept for "none".
constexpr std::uint64_t kMostCorners = 0xFFFF'FFFE;

/// Gives equal points one number, in the order in which they come. -0 must have become 0.
class Welder {
 public:
  /// `expected` different points or so.
  explicit Welder(std::size_t expected);
  Index add(const Vec3& p);
  /// The different points; the welder is empty afterwards.
  std::vector<Vec3> take_points();

 private:
  void grow();
  void insert(Index number);

  std::vector<Vec3> points_;
  std::vector<Index> slots_;  ///< open addressing; a power of two, at most half full
};

/// Equal vertices become one, and those that no face uses go.
void weld_vertices(Polyhedron& polyhedron);

/// Half a unit of the last place of a float as large as the largest coordinate.
double float_precision(const Polyhedron& polyhedron);

/// Half a unit of the last place of a float as large as `largest`; 0 for 0.
double float_precision(double largest);

/// A warning of the file as a whole.
void warn_of_mesh(std::vector<Diagnostic>& warnings, const std::string& name, std::string message);

/// An error of the file as a whole.
[[noreturn]] void fail_mesh(const std::string& name, std::string message, std::string hint = {});

}  // namespace overstrike
