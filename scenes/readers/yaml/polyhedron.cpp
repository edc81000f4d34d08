#include "scenes/readers/yaml/polyhedron.h"

#include <string>
#include <vector>

namespace overstrike::yaml {
namespace {

constexpr int kMostVertices = 1'000'000'000;  // numbers beyond are no slips by one

/// The loop's vertex numbers, checked against the number of vertices.
std::vector<Index> face_loop(Reporter& reporter, const Node& node, std::size_t vertices) {
  std::vector<Index> loop;
  for (const Node* item : list(reporter, node, "a face", "vertex numbers", 3)) {
    const std::size_t errors_before = reporter.errors();
    const int index =
        whole_number(reporter, *item, "a vertex number", -kMostVertices, kMostVertices);
    if (reporter.errors() > errors_before) continue;
    if (vertices > 0 && (index < 0 || static_cast<std::size_t>(index) >= vertices))
      reporter.error(item->mark, "vertex " + std::to_string(index) + " does not exist: there are " +
                                     std::to_string(vertices) + ", numbered from 0");
    loop.push_back(static_cast<Index>(index));
  }
  return loop;
}

}  // namespace

Shape read_polyhedron(const Fields& f) {
  Mesh shape;
  Reporter& reporter = f.reporter();
  if (const Node* vertices = f.need("vertices"))
    shape.polyhedron.vertices = points3(reporter, *vertices, "vertices", 3);
  const std::size_t count = shape.polyhedron.vertices.size();
  const Node* faces = f.need("faces");
  if (!faces) return shape;
  for (const Node* face : list(reporter, *faces, "faces", "faces [a, b, c, ...]", 1)) {
    const Fields face_fields(reporter, *face, kFaceMap);
    shape.lines.push_back(face->mark.line);
    if (const Node* outline = face_fields.need("outline"))
      shape.polyhedron.add_loop(face_loop(reporter, *outline, count));
    if (const Node* holes = face_fields.find("holes"))
      for (const Node* hole : list(reporter, *holes, "holes", "outlines [a, b, c, ...]"))
        shape.polyhedron.add_loop(face_loop(reporter, *hole, count));
    shape.polyhedron.end_face();
  }
  return shape;
}

}  // namespace overstrike::yaml
