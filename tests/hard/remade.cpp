#include "tests/hard/remade.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <random>

#include "core/geometry/plane_fit.h"
#include "core/geometry/tessellate.h"

namespace overstrike::hard {
namespace {

/// The faces to remake, and with what precision; none for bodies that stay as they are.
std::optional<Mesh> mesh_of(const Body& body) {
  if (body.shape == nullptr || body.shading == Shading::smooth) return {};
  if (const auto* mesh = std::get_if<Mesh>(body.shape.get()))
    return mesh->polyhedron.corner_normals.empty() ? std::optional(*mesh) : std::nullopt;
  if (is_curved(*body.shape) || std::holds_alternative<FlatPolygon>(*body.shape)) return {};
  Mesh made;
  made.polyhedron = tessellate(*body.shape, 0, false);
  made.polyhedron.plane_groups.clear();
  return made;
}

std::vector<Index> permutation(std::size_t n, std::mt19937_64& bits) {
  std::vector<Index> order(n);
  std::iota(order.begin(), order.end(), 0);
  for (std::size_t i = n; i > 1; --i) std::swap(order[i - 1], order[bits() % i]);
  return order;
}

bool is_convex(const Polyhedron& p, Index face) {
  const PlaneFit fit = fit_plane(p, face);
  const auto loop = p.loop(p.first_loop(face));
  const std::size_t n = loop.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vec3 &a = p.vertices[loop[i]], &b = p.vertices[loop[(i + 1) % n]],
               &c = p.vertices[loop[(i + 2) % n]];
    if (!(glm::dot(glm::cross(b - a, c - b), fit.normal) > 0)) return false;
  }
  return true;
}

class Subdivider {
 public:
  explicit Subdivider(const Polyhedron& p) : in_(p) { out_.vertices = p.vertices; }

  Polyhedron subdivide() {
    for (Index f = 0; f < in_.face_count(); ++f) {
      const Index first = in_.first_loop(f);
      if (in_.face_ends[f] - first == 1 && is_convex(in_, f)) {
        add_fan(halved(in_.loop(first)));
        continue;
      }
      for (Index l = first; l < in_.face_ends[f]; ++l) out_.add_loop(halved(in_.loop(l)));
      out_.end_face();
    }
    return std::move(out_);
  }

 private:
  std::vector<Index> halved(std::span<const Index> loop) {
    std::vector<Index> made;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Index a = loop[i], b = loop[(i + 1) % loop.size()];
      const auto [it, fresh] = middles_.try_emplace(std::minmax(a, b), 0);
      if (fresh) it->second = out_.add_vertex((in_.vertices[a] + in_.vertices[b]) * 0.5);
      made.push_back(a), made.push_back(it->second);
    }
    return made;
  }

  void add_fan(const std::vector<Index>& loop) {
    Vec3 sum(0.0);
    for (const Index v : loop) sum += out_.vertices[v];
    const Index middle = out_.add_vertex(sum / static_cast<double>(loop.size()));
    for (std::size_t i = 0; i < loop.size(); ++i)
      out_.add_face({loop[i], loop[(i + 1) % loop.size()], middle});
  }

  const Polyhedron& in_;
  Polyhedron out_;
  std::map<std::pair<Index, Index>, Index> middles_;
};

}  // namespace

Scene with_meshes(const Scene& scene, const Remake& remake) {
  Scene result = scene;
  for (Body& body : result.bodies) {
    std::optional<Mesh> mesh = mesh_of(body);
    if (!mesh) continue;
    mesh->polyhedron = remake(mesh->polyhedron);
    mesh->lines.clear();
    body.shape = std::make_shared<const Shape>(std::move(*mesh));
  }
  return result;
}

Polyhedron shuffled(const Polyhedron& p) {
  std::mt19937_64 bits(p.indices.size());
  Polyhedron made;
  made.vertices = p.vertices;
  for (const Index f : permutation(p.face_count(), bits)) {
    for (Index l = p.first_loop(f); l < p.face_ends[f]; ++l) made.add_loop(p.loop(l));
    made.end_face();
  }
  return made;
}

Polyhedron renumbered(const Polyhedron& p) {
  std::mt19937_64 bits(p.indices.size());
  Polyhedron made;
  const std::vector<Index> faces = permutation(p.face_count(), bits);
  const std::vector<Index> places = permutation(p.vertices.size(), bits);
  made.vertices.resize(p.vertices.size());
  for (std::size_t v = 0; v < places.size(); ++v) made.vertices[places[v]] = p.vertices[v];
  for (const Index f : faces) {
    for (Index l = p.first_loop(f); l < p.face_ends[f]; ++l) {
      std::vector<Index> loop;
      for (const Index v : p.loop(l)) loop.push_back(places[v]);
      std::rotate(loop.begin(), loop.begin() + static_cast<std::ptrdiff_t>(bits() % loop.size()),
                  loop.end());
      made.add_loop(loop);
    }
    made.end_face();
  }
  return made;
}

Polyhedron subdivided(const Polyhedron& p) { return Subdivider(p).subdivide(); }

Scene in_halves(const Scene& scene) {
  Scene result = scene;
  result.bodies.clear();
  for (const Body& body : scene.bodies) {
    result.bodies.push_back(body);
    const Box* box = body.shape ? std::get_if<Box>(body.shape.get()) : nullptr;
    if (box == nullptr) continue;
    const Box half{Vec3(box->size.x / 2, box->size.y, box->size.z)};
    const auto shape = std::make_shared<const Shape>(half);
    result.bodies.push_back(body);
    for (const int side : {0, 1}) {
      Body& part = result.bodies[result.bodies.size() - 1 - static_cast<std::size_t>(side)];
      part.shape = shape;
      part.placement =
          body.placement * Affine{Mat3(1), Vec3((side == 0 ? 1 : -1) * half.size.x / 2, 0, 0)};
    }
  }
  return result;
}

Scene mirrored(const Scene& scene) {
  const Affine mirror{Mat3(-1, 0, 0, 0, 1, 0, 0, 0, 1), Vec3(0)};
  Scene result = scene;
  for (Body& body : result.bodies) body.placement = mirror * body.placement;
  for (Segment& s : result.segments) s.from = mirror(s.from), s.to = mirror(s.to);
  Camera& c = result.camera;
  for (auto* p : {&c.look_at, &c.eye, &c.target})
    if (*p) **p = mirror(**p);
  c.up = mirror(c.up);
  c.from.azimuth_deg = 180 - c.from.azimuth_deg;
  if (result.light) result.light->azimuth_deg = 180 - result.light->azimuth_deg;
  return result;
}

}  // namespace overstrike::hard
