// Why a shape cannot be drawn. Texts name the first fault found, in the scene format's words.
#include <charconv>
#include <cmath>
#include <string>

#include "core/geometry/circle.h"
#include "core/geometry/polygon.h"
#include "core/geometry/region_sets.h"
#include "core/geometry/shape_faces.h"
#include "core/geometry/sweep_sections.h"
#include "core/geometry/tessellate.h"

namespace overstrike {
namespace {

using std::string;

/// Lengths beyond these make products overflow or vanish further on.
constexpr double kLargest = 1e100;
constexpr double kSmallest = 1e-100;
/// More vertices than this (3 GB of them) come of a slip of the pen.
constexpr double kMostVertices = 0x1p27;

string text(double x) {
  char buffer[32];
  return {buffer, std::to_chars(buffer, buffer + sizeof buffer, x).ptr};
}

string text(const Vec2& p) { return "(" + text(p.x) + ", " + text(p.y) + ")"; }

/// The first text that is not empty.
template <class... Texts>
string first(const string& head, const Texts&... rest) {
  if constexpr (sizeof...(rest) == 0)
    return head;
  else
    return head.empty() ? first(rest...) : head;
}

string number_fault(const string& name, double x) {
  if (!std::isfinite(x)) return name + " must be a finite number, found " + text(x);
  if (std::fabs(x) > kLargest) return name + " must be at most 1e+100, found " + text(x);
  return {};
}

string positive_fault(const string& name, double x) {
  const string fault = number_fault(name, x);
  if (!fault.empty()) return fault;
  if (x <= 0) return name + " must be positive, found " + text(x);
  if (x < kSmallest) return name + " must be at least 1e-100, found " + text(x);
  return {};
}

string negative_fault(const string& name, double x) {
  if (x < 0 && std::isfinite(x)) return name + " must not be negative, found " + text(x);
  return x == 0 ? string{} : positive_fault(name, x);
}

template <class Vector>
string point_fault(const string& name, const Vector& p) {
  for (int i = 0; i < Vector::length(); ++i) {
    const string fault = number_fault(name, p[i]);
    if (!fault.empty()) return fault;
  }
  return {};
}

template <class Vector>
string points_fault(const string& name, const std::vector<Vector>& points) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    const string fault = point_fault(name + " point " + std::to_string(i + 1), points[i]);
    if (!fault.empty()) return fault;
  }
  return {};
}

string count_fault(const string& name, int count, int fewest, int most) {
  if (count == 0 || (fewest <= count && count <= most)) return {};
  return name + " must be " + std::to_string(fewest) + " to " + std::to_string(most) +
         ", or 0 for round, found " + std::to_string(count);
}

string size_fault(const Vec3& size) {
  return first(positive_fault("size x", size.x), positive_fault("size y", size.y),
               positive_fault("size z", size.z));
}

string fault_of(const Box& s) { return size_fault(s.size); }

string fault_of(const Frustum& s) {
  string radii;
  if (s.bottom_radius == s.top_radius || s.top_radius == 0)
    radii = positive_fault("radius", s.bottom_radius);
  else
    radii = first(negative_fault("bottom radius", s.bottom_radius),
                  negative_fault("top radius", s.top_radius));
  return first(radii, positive_fault("height", s.height),
               count_fault("sides", s.sides, kFewestSides, kMostSides));
}

string fault_of(const Wedge& s) {
  return first(size_fault(s.size), negative_fault("top", s.top),
               number_fault("top_shift", s.top_shift));
}

string fault_of(const Tetrahedron& s) {
  for (int i = 0; i < 4; ++i) {
    const string fault = point_fault("vertex " + std::to_string(i + 1), s.vertices[i]);
    if (!fault.empty()) return fault;
  }
  const Vec3 a = s.vertices[1] - s.vertices[0], b = s.vertices[2] - s.vertices[0];
  const Vec3 c = s.vertices[3] - s.vertices[0];
  // The triple product of rounded differences errs by less than 16 units of 2^-53 of the sizes'
  // product: below that there is no telling its sign.
  const double size = glm::length(a) * glm::length(b) * glm::length(c);
  if (std::fabs(glm::dot(glm::cross(a, b), c)) <= 16 * 0x1p-53 * size)
    return "the four vertices must not lie in one plane";
  return {};
}

string fault_of(const Ellipsoid& s) {
  const Vec3& r = s.radii;
  const string radii = r.x == r.y && r.y == r.z ? positive_fault("radius", r.x)
                                                : first(positive_fault("radius in x", r.x),
                                                        positive_fault("radius in y", r.y),
                                                        positive_fault("radius in z", r.z));
  return first(radii, count_fault("sides", s.sides, kFewestSides, kMostSides),
               count_fault("rings", s.rings, 2, kMostSides / 2));
}

string fault_of(const Torus& s) {
  const string radii =
      first(positive_fault("major radius", s.major), positive_fault("minor radius", s.minor));
  if (!radii.empty() || s.minor <= s.major) return radii;
  return "minor radius must be at most the major radius " + text(s.major) + ", found " +
         text(s.minor);
}

string loop_name(std::size_t loop) { return "loop " + std::to_string(loop + 1); }

/// `name` is that of a single loop, or empty: they are numbered then.
string loops_fault(const string& name, const std::vector<Loop2>& loops) {
  std::vector<Loop2> clean;
  for (std::size_t i = 0; i < loops.size(); ++i) {
    const string loop = name.empty() ? loop_name(i) : name;
    const string fault = points_fault(loop, loops[i]);
    if (!fault.empty()) return fault;
    clean.push_back(without_repeats(loops[i]));
    if (clean.back().size() < 3)
      return loop + " needs at least 3 different points, found " +
             std::to_string(clean.back().size());
  }
  const std::optional<Contact> contact = find_contact(clean);
  if (!contact || (clean.size() > 1 && is_tidy({clean}))) return {};
  const string near = " near " + text(contact->near);
  if (contact->first == contact->second)
    return (name.empty() ? loop_name(contact->first) : name) + " crosses or touches itself" + near;
  return loop_name(contact->first) + " and " + loop_name(contact->second) + " cross or touch" +
         near;
}

string fault_of(const Extrusion& s) {
  if (s.region.loops.empty()) return "an extrusion needs at least one loop";
  return first(positive_fault("height", s.height), loops_fault("", s.region.loops));
}

/// All of the profile.
std::vector<Loop2> loops_of(const Revolution& s) {
  std::vector<Loop2> loops{s.profile};
  loops.insert(loops.end(), s.more_loops.begin(), s.more_loops.end());
  return loops;
}

string radii_fault(const string& name, const Loop2& loop) {
  for (std::size_t i = 0; i < loop.size(); ++i) {
    string fault = negative_fault(name + " point " + std::to_string(i + 1) + " radius", loop[i].x);
    if (!fault.empty()) return fault;
  }
  return {};
}

string fault_of(const Revolution& s) {
  const std::vector<Loop2> loops = loops_of(s);
  string fault = loops_fault(loops.size() == 1 ? "profile" : "", loops);
  std::size_t points = 0;
  for (std::size_t i = 0; i < loops.size() && fault.empty(); ++i) {
    fault = radii_fault(loops.size() == 1 ? "profile" : loop_name(i), loops[i]);
    points += loops[i].size();
  }
  if (!fault.empty()) return fault;
  if (!(0 < s.angle_deg && s.angle_deg <= 360))
    return "angle must be above 0 and at most 360 degrees, found " + text(s.angle_deg);
  const int fewest = s.angle_deg == 360 ? kFewestSides : s.angle_deg < 180 ? 1 : 2;
  if (static_cast<double>(points) * s.sides > kMostVertices)
    return "the revolution would have more than " + text(kMostVertices) + " vertices";
  return count_fault("sides", s.sides, fewest, kMostSides);
}

string path_name(std::size_t point) { return "path point " + std::to_string(point + 1); }

string corners_fault(const Sweep& s) {
  const std::vector<Vec3> directions = path_directions(s);
  for (std::size_t i = s.closed_path ? 0 : 1; i < directions.size(); ++i) {
    const Vec3& before = directions[(i + directions.size() - 1) % directions.size()];
    if (glm::dot(before, directions[i]) <= kTurnsBack)
      return "the path turns back on itself at " + path_name(i);
  }
  return {};
}

string path_fault(const Sweep& s) {
  const std::size_t fewest = s.closed_path ? 3 : 2, count = s.path.size();
  if (count < fewest)
    return string(s.closed_path ? "a closed path" : "path") + " needs at least " +
           std::to_string(fewest) + " points, found " + std::to_string(count);
  const string fault = points_fault("path", s.path);
  if (!fault.empty()) return fault;
  for (std::size_t i = 1; i < count; ++i)
    if (s.path[i] == s.path[i - 1]) return path_name(i) + " repeats the one before";
  if (s.closed_path && s.path.front() == s.path.back())
    return "the last point of a closed path must not repeat the first";
  return corners_fault(s);
}

/// Mitred sections that pass each other would turn faces inside out.
string mitre_fault(const Sweep& s) {
  const SweepSections swept = sections_of(s);
  const std::size_t count = s.path.size();
  for (std::size_t i = 0; i < swept.directions.size(); ++i)
    for (std::size_t c = 0; c < swept.profile.size(); ++c)
      if (!(glm::dot(swept.sections[(i + 1) % count][c] - swept.sections[i][c],
                     swept.directions[i]) > 0))
        return "the path is too short between points " + std::to_string(i + 1) + " and " +
               std::to_string((i + 1) % count + 1) + " for the profile to turn its corners";
  return {};
}

string fault_of(const Sweep& s) {
  const string fault = first(loops_fault("profile", {s.profile}), path_fault(s));
  if (!fault.empty()) return fault;
  if (static_cast<double>(s.profile.size()) * static_cast<double>(s.path.size()) > kMostVertices)
    return "the sweep would have more than " + text(kMostVertices) + " vertices";
  return mitre_fault(s);
}

string face_name(const Mesh& s, std::size_t face) {
  string name = "face " + std::to_string(face + 1);
  if (face < s.lines.size()) name += " (line " + std::to_string(s.lines[face]) + ")";
  return name;
}

bool fits_together(const Polyhedron& p) {
  const auto grows = [](const std::vector<Index>& ends, std::size_t last) {
    for (std::size_t i = 1; i < ends.size(); ++i)
      if (ends[i] < ends[i - 1]) return false;
    return ends.empty() ? last == 0 : ends.back() == last;
  };
  return grows(p.loop_ends, p.indices.size()) && grows(p.face_ends, p.loop_ends.size()) &&
         (p.corner_normals.empty() || p.corner_normals.size() == p.indices.size()) &&
         (p.plane_groups.empty() || p.plane_groups.size() == p.face_count());
}

string face_fault(const Mesh& s, Index face) {
  const Polyhedron& p = s.polyhedron;
  if (p.first_loop(face) == p.face_ends[face]) return face_name(s, face) + " has no vertices";
  for (Index l = p.first_loop(face); l < p.face_ends[face]; ++l) {
    const std::span<const Index> loop = p.loop(l);
    if (loop.size() < 3)
      return face_name(s, face) + " needs at least 3 vertices, found " +
             std::to_string(loop.size());
    for (Index vertex : loop)
      if (vertex >= p.vertices.size())
        return face_name(s, face) + " names vertex " + std::to_string(vertex) +
               ", but there are only " + std::to_string(p.vertices.size()) + " (from 0)";
  }
  return {};
}

string fault_of(const Mesh& s) {
  const Polyhedron& p = s.polyhedron;
  if (p.face_ends.empty()) return "the mesh has no faces";
  if (!fits_together(p)) return "the mesh's lists of faces, loops and corners do not fit together";
  for (std::size_t i = 0; i < p.vertices.size(); ++i) {
    const string fault = point_fault("vertex " + std::to_string(i) + " (from 0)", p.vertices[i]);
    if (!fault.empty()) return fault;
  }
  for (Index face = 0; face < p.face_count(); ++face) {
    const string fault = face_fault(s, face);
    if (!fault.empty()) return fault;
  }
  return {};
}

/// Sizes of the loop's shadows along the axes; unlike its area none that crosses itself cancels.
Vec3 shadow_sizes(const std::vector<Vec3>& loop) {
  Vec3 sum{0};
  for (std::size_t i = 1; i + 1 < loop.size(); ++i)
    sum += glm::abs(glm::cross(loop[i] - loop[0], loop[i + 1] - loop[0]));
  return sum;
}

/// Seen along the axis nearest to the polygon's normal; dropping a coordinate is exact.
std::vector<Loop2> seen_flat(const FlatPolygon& s) {
  const Vec3 size = shadow_sizes(s.loops.front());
  const int drop = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  std::vector<Loop2> loops;
  for (const std::vector<Vec3>& loop : s.loops) {
    Loop2 flat;
    for (const Vec3& p : loop) flat.push_back({p[(drop + 1) % 3], p[(drop + 2) % 3]});
    loops.push_back(std::move(flat));
  }
  return loops;
}

string fault_of(const FlatPolygon& s) {
  if (s.loops.empty()) return "a polygon needs at least one loop";
  for (std::size_t i = 0; i < s.loops.size(); ++i) {
    const string fault = points_fault(loop_name(i), s.loops[i]);
    if (!fault.empty()) return fault;
    if (s.loops[i].size() < 3)
      return loop_name(i) + " needs at least 3 points, found " + std::to_string(s.loops[i].size());
  }
  if (shadow_sizes(s.loops.front()) == Vec3{0}) return "loop 1 has no area";
  const std::vector<Loop2> flat = seen_flat(s);
  std::vector<Loop2> clean;
  for (const Loop2& loop : flat) {
    clean.push_back(without_repeats(loop));
    if (clean.back().size() < 3)
      return loop_name(clean.size() - 1) + " needs at least 3 different points, found " +
             std::to_string(clean.back().size());
  }
  if (find_contact(clean))
    return {};  // drawn by the even-odd rule, with a warning where it crosses
  const OrderedRegion region = in_order(flat);
  if (region.pieces.size() != 1 || region.pieces.front().outline != 0)
    return "every loop after the first must be a hole in it and in no other";
  return {};
}

}  // namespace

std::string validate(const Shape& shape) {
  return std::visit([](const auto& s) { return fault_of(s); }, shape);
}

}  // namespace overstrike
