#include "tests/oracle/oracle.h"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "tests/oracle/projective.h"

namespace overstrike::oracle {
namespace {

double clamped(double density) { return std::clamp(density, 0.0, 1.0); }

/// Bounds of an outline in two coordinates; infinite until told otherwise.
struct Box2 {
  std::array<double, 2> low{-INFINITY, -INFINITY}, high{INFINITY, INFINITY};
  bool may_hold(const Approx& x, const Approx& y) const {
    return x.high() >= low[0] && x.low() <= high[0] && y.high() >= low[1] && y.low() <= high[1];
  }
};

/// Bounds of the points' two quotients x/w, y/w; infinite when some w may be 0 or negative.
class BoxMaker {
 public:
  void add(const Approx& x, const Approx& y, const Approx& w) {
    if (!(w.value > w.error)) behind_ = true;
    add(0, x / w);
    add(1, y / w);
  }
  Box2 box() const { return behind_ ? Box2{} : box_; }

 private:
  void add(int axis, const Approx& v) {
    box_.low[axis] = std::min(box_.low[axis], v.low());
    box_.high[axis] = std::max(box_.high[axis], v.high());
    if (!std::isfinite(v.error)) behind_ = true;
  }
  Box2 box_{{INFINITY, INFINITY}, {-INFINITY, -INFINITY}};
  bool behind_ = false;
};

/// Two vectors exactly at right angles to L, that span the plane across it.
std::pair<Vec3, Vec3> across(const Vec3& l) {
  const Vec3 a(std::fabs(l.x), std::fabs(l.y), std::fabs(l.z));
  if (a.z >= a.x && a.z >= a.y) return {Vec3(l.z, 0, -l.x), Vec3(0, l.z, -l.y)};
  if (a.y >= a.x) return {Vec3(l.y, -l.x, 0), Vec3(0, -l.z, l.y)};
  return {Vec3(-l.y, l.x, 0), Vec3(-l.z, 0, l.x)};
}

template <class T>
T dot3(const Vec3& a, const Four<T>& p) {
  return T(a.x) * p[0] + T(a.y) * p[1] + T(a.z) * p[2];
}

template <class T>
Four<T> row(const Mat4& m, int r) {
  return four<T>(m[0][r], m[1][r], m[2][r], m[3][r]);
}

/// Rows of View::matrix: x^, y^, w^, z^.
enum Row { kX, kY, kW, kZ };

/// The line of sight through a grid point: where x^ - x w^ and y^ - y w^ vanish.
Sight eye_sight(const View& view, double x, double y) {
  return Sight([&view, x, y]<class T>() {
    const Four<T> w = row<T>(view.matrix, kW);
    Four<T> a = row<T>(view.matrix, kX), b = row<T>(view.matrix, kY);
    for (int i = 0; i < 4; ++i) a[i] = a[i] - T(x) * w[i], b[i] = b[i] - T(y) * w[i];
    return LineOf<T>(a, b);
  });
}

/// The line through Q = P / P.w along L, of which `u` and `v` are across().
Sight light_sight(const Hit& q, const Vec3& u, const Vec3& v) {
  return Sight([&q, u, v]<class T>() {
    const Four<T>& p = q.get<T>();
    const auto through = [&p](const Vec3& n) -> Four<T> {
      return {T(n.x) * p[3], T(n.y) * p[3], T(n.z) * p[3], -dot3<T>(n, p)};
    };
    return LineOf<T>(through(u), through(v));
  });
}

int side_of(const Plane& plane, const Vec4& p) {
  return sign_of([&]<class T>() { return dot(covector<T>(plane), four<T>(p.x, p.y, p.z, p.w)); });
}

}  // namespace

/// What never changes from point to point, and the steps of the law.
struct Oracle::Impl {
  const Canonical& in;
  const View& view;
  struct Face {
    int eye_side = 0;    ///< of the outward normal: 1 front, -1 behind, 0 edge-on
    int light_side = 0;  ///< of the outward normal
    Box2 eye_box, light_box;
    std::vector<Vec3> sorted;  ///< vertices, for law 5
  };
  std::vector<Face> faces;
  Vec3 u{0}, v{0};  ///< across the light
  bool ground_seen = false;
  Plane ground{Vec3(0, 0, 1), 0};

  /// A face, ground or near plane met by the line of sight, in front of the eye and kept.
  struct Meeting {
    Index face;
    Hit at;
  };

  Impl(const Canonical& c, const View& w) : in(c), view(w) {
    if (in.light) std::tie(u, v) = across(*in.light);
    for (const CanonicalFace& f : in.faces) faces.push_back(prepare(f));
    if (!in.ground_z) return;
    ground.offset = *in.ground_z;
    ground_seen = side_of(ground, view.eye) > 0;
  }

  template <class Visit>
  void for_each_edge(const CanonicalFace& f, const Visit& visit) const {
    for (Index l = f.first_loop; l < f.end_loop; ++l) {
      const auto loop = in.loop(l);
      for (std::size_t i = 0; i < loop.size(); ++i)
        visit(in.vertices[loop[i]], in.vertices[loop[i + 1 == loop.size() ? 0 : i + 1]]);
    }
  }

  Face prepare(const CanonicalFace& f) const {
    Face made;
    const Plane& plane = in.planes[f.plane];
    const int outward = f.flipped ? -1 : 1;
    made.eye_side = outward * side_of(plane, view.eye);
    if (in.light) made.light_side = outward * side_of({plane.normal, 0}, Vec4(*in.light, 0));
    BoxMaker eye, light;
    for_each_edge(f, [&](const Vec3& p, const Vec3&) {
      const auto h = point<Approx>(p);
      const auto in_row = [&](Row r) { return dot(row<Approx>(view.matrix, r), h); };
      eye.add(in_row(kX), in_row(kY), in_row(kW));
      light.add(dot3<Approx>(u, h), dot3<Approx>(v, h), Approx(1));
      made.sorted.push_back(p);
    });
    made.eye_box = eye.box(), made.light_box = light.box();
    std::sort(made.sorted.begin(), made.sorted.end(), less);
    return made;
  }

  static bool less(const Vec3& a, const Vec3& b) {
    return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
  }

  /// Even-odd: how many edges cross the half-plane y = 0, x > 0 of the line's two covectors. It
  /// meets the face's plane in a half-line from the point asked about.
  bool covers(const CanonicalFace& f, const Sight& s) const {
    bool inside = false;
    for_each_edge(f, [&](const Vec3& a, const Vec3& b) {
      const auto y_sign = [&](const Vec3& p) {
        return sign_of([&]<class T>() { return dot(s.get<T>().y, point<T>(p)); });
      };
      const bool a_above = y_sign(a) > 0, b_above = y_sign(b) > 0;
      if (a_above == b_above) return;
      const int crossing = sign_of([&]<class T>() {
        const LineOf<T>& l = s.get<T>();
        const auto pa = point<T>(a), pb = point<T>(b);
        return dot(l.y, pb) * dot(l.x, pa) - dot(l.y, pa) * dot(l.x, pb);
      });
      if (crossing * (b_above ? 1 : -1) > 0) inside = !inside;
    });
    return inside;
  }

  int sign_at(const Hit& h, const Plane& plane) const {
    const int w = sign_of([&]<class T>() { return h.get<T>()[3]; });
    return w * sign_of([&]<class T>() { return dot(covector<T>(plane), h.get<T>()); });
  }
  int w_sign(const Hit& h) const {
    return sign_of([&]<class T>() { return dot(row<T>(view.matrix, kW), h.get<T>()); });
  }

  /// Laws 1 and 3: a finite point in front of the eye and not cut away. `end`: where a closed body
  /// is left.
  bool is_there(const Hit& h, bool end = false) const {
    const int finite = sign_of([&]<class T>() { return h.get<T>()[3]; });
    if (finite == 0 || finite * w_sign(h) <= 0) return false;
    return !view.near_plane || sign_at(h, *view.near_plane) >= (end ? 1 : 0);
  }

  std::vector<Meeting> meetings(const Sight& sight, double x, double y) const {
    std::vector<Meeting> met;
    for (Index i = 0; i < faces.size(); ++i) {
      const Face& face = faces[i];
      const CanonicalFace& f = in.faces[i];
      const bool closed = in.bodies[f.body].closed;
      const bool operand = in.membership(f.body).solid != kNone;
      if (face.eye_side == 0) continue;
      if (face.eye_side < 0 && closed && !view.near_plane && !operand) continue;
      if (!face.eye_box.may_hold(Approx(x), Approx(y)) || !covers(f, sight)) continue;
      Hit h = hit(sight, in.planes[f.plane]);
      if (is_there(h, closed && face.eye_side < 0)) met.push_back({i, std::move(h)});
    }
    return met;
  }

  /// Law 3. Faces are left from behind and entered from the front, so that the winding number at
  /// the near plane is the number left beyond it less the number entered.
  std::optional<Seen> cut_face(const std::vector<Meeting>& met) const {
    if (!view.near_plane) return {};
    std::vector<int> winding(in.bodies.size(), 0);
    for (const Meeting& m : met) winding[in.faces[m.face].body] -= faces[m.face].eye_side;
    std::optional<Seen> best;
    const auto consider = [&](Index b) {
      const double d = clamped(in.law.cut_factor * in.law.hmax * in.bodies[b].density_factor);
      if (!best || d > best->density) best = Seen{kNone, b, Kind::cut, d};
    };
    for (Index s = 0; s < in.solids.size(); ++s) {
      const auto is_in = [&](Index operand) {
        const Index b = body_of(s, operand);
        return b != kNone && winding[b] != 0;
      };
      if (!holds(in.solids[s]->nodes, 0, is_in)) continue;
      std::vector<Index> changed;
      for (Index b = 0; b < in.bodies.size(); ++b)
        if (in.membership(b).solid == s && winding[b] != 0)
          changed.push_back(in.membership(b).operand);
      for (const Index operand : changed)
        if (matters(in.solids[s]->nodes, operand, changed, is_in)) consider(body_of(s, operand));
    }
    for (Index b = 0; b < in.bodies.size(); ++b) {
      if (!in.bodies[b].closed || winding[b] == 0 || in.membership(b).solid != kNone) continue;
      consider(b);
    }
    return best;
  }

  /// The sign of depth(a) - depth(b) (law 5).
  int compare_depth(const Hit& a, const Hit& b) const {
    const int difference = sign_of([&]<class T>() {
      const auto z = row<T>(view.matrix, kZ), w = row<T>(view.matrix, kW);
      const auto &p = a.get<T>(), &q = b.get<T>();
      return dot(z, p) * dot(w, q) - dot(z, q) * dot(w, p);
    });
    return difference * w_sign(a) * w_sign(b);
  }

  bool visible(const Meeting& m) const {
    if (in.membership(in.faces[m.face].body).solid != kNone) return false;
    return faces[m.face].eye_side > 0 || !in.bodies[in.faces[m.face].body].closed;
  }

  Seen see(double x, double y) const {
    const Sight sight = eye_sight(view, x, y);
    std::vector<Meeting> met = meetings(sight, x, y);
    if (const auto cut = cut_face(met)) return *cut;
    const std::vector<Index> of_solids = seen_of_solids(met);
    std::erase_if(met, [&](const Meeting& m) {
      return !visible(m) &&
             std::find(of_solids.begin(), of_solids.end(), m.face) == of_solids.end();
    });
    std::vector<const Meeting*> nearest;
    for (const Meeting& m : met) {
      const int order = nearest.empty() ? 1 : compare(m, *nearest.front());
      if (order > 0) nearest.clear();
      if (order >= 0) nearest.push_back(&m);
    }
    if (!ground_seen) return first_of(nearest);
    const Hit h = hit(sight, ground);
    if (!is_there(h)) return first_of(nearest);
    const int order = nearest.empty() ? 1 : compare_depth(h, nearest.front()->at);
    return order > 0 ? ground_at(h) : first_of(nearest);
  }

  /// The faces that the solids show.
  std::vector<Index> seen_of_solids(const std::vector<Meeting>& met) const {
    std::vector<Index> seen;
    for (Index s = 0; s < in.solids.size(); ++s) {
      std::vector<const Meeting*> of_solid;
      for (const Meeting& m : met)
        if (in.membership(in.faces[m.face].body).solid == s) of_solid.push_back(&m);
      std::sort(of_solid.begin(), of_solid.end(),
                [&](const Meeting* a, const Meeting* b) { return compare(*a, *b) > 0; });
      if (const Index face = seen_of_solid(*in.solids[s], of_solid); face != kNone)
        seen.push_back(face);
    }
    return seen;
  }

  Index seen_of_solid(const CanonicalSolid& solid, const std::vector<const Meeting*>& met) const {
    // At the near plane, or before everything.
    std::map<Index, int> winding;
    for (const Meeting* m : met)
      winding[in.membership(in.faces[m->face].body).operand] -= faces[m->face].eye_side;
    const auto is_in = [&](Index operand) { return winding[operand] != 0; };
    for (std::size_t first = 0, end = 0; first < met.size(); first = end) {
      std::map<Index, int> before;
      for (end = first; end < met.size() && compare(*met[first], *met[end]) == 0; ++end) {
        const Index operand = in.membership(in.faces[met[end]->face].body).operand;
        before.try_emplace(operand, winding[operand]);
        winding[operand] += faces[met[end]->face].eye_side;
      }
      if (!holds(solid.nodes, 0, is_in)) continue;
      std::vector<Index> changed;
      for (const auto& [operand, was] : before)
        if ((was != 0) != is_in(operand)) changed.push_back(operand);
      Index best = kNone;
      for (std::size_t i = first; i < end; ++i) {
        const Index face = met[i]->face;
        const Index operand = in.membership(in.faces[face].body).operand;
        const bool turns_it = (winding[operand] - before[operand]) * faces[face].eye_side > 0 &&
                              std::find(changed.begin(), changed.end(), operand) != changed.end();
        if (turns_it && (best == kNone || precedes(face, best)) &&
            matters(solid.nodes, operand, changed, is_in))
          best = face;
      }
      return best;
    }
    return kNone;
  }

  Index body_of(Index solid, Index operand) const {
    for (Index b = 0; b < in.bodies.size(); ++b)
      if (in.membership(b).solid == solid && in.membership(b).operand == operand) return b;
    return kNone;
  }

  /// By trying all of the other changes.
  template <class IsIn>
  bool matters(const std::vector<SolidNode>& nodes, Index operand,
               const std::vector<Index>& changed, const IsIn& is_in) const {
    for (std::size_t made = 0; made < std::size_t{1} << changed.size(); ++made) {
      const auto with = [&](bool own) {
        return holds(nodes, 0, [&](Index other) {
          for (std::size_t i = 0; i < changed.size(); ++i)
            if (changed[i] == other)
              return (other == operand ? own : (made >> i & 1) != 0) == is_in(other);
          return is_in(other);
        });
      };
      if (!with(false) && with(true)) return true;
    }
    return false;
  }

  template <class IsIn>
  bool holds(const std::vector<SolidNode>& nodes, Index at, const IsIn& is_in) const {
    const SolidNode& node = nodes[at];
    if (node.operation == SetOperation::operand) return is_in(node.body);
    bool result = false;
    for (Index i = at + 1; i < node.end; i = nodes[i].end) {
      const bool value = holds(nodes, i, is_in);
      if (i == at + 1) result = value;
      if (node.operation == SetOperation::unite) result = result || value;
      if (node.operation == SetOperation::intersect) result = result && value;
      if (node.operation == SetOperation::subtract && i != at + 1) result = result && !value;
    }
    return result;
  }

  int compare(const Meeting& a, const Meeting& b) const {
    if (in.faces[a.face].plane == in.faces[b.face].plane) return 0;
    return compare_depth(a.at, b.at);
  }

  /// Law 5, at one depth.
  Seen first_of(const std::vector<const Meeting*>& tied) const {
    const Meeting* best = nullptr;
    for (const Meeting* m : tied)
      if (best == nullptr || precedes(m->face, best->face)) best = m;
    return best != nullptr ? face_at(*best) : Seen{};
  }

  bool precedes(Index a, Index b) const {
    const CanonicalBody &c = in.bodies[in.faces[a].body], &d = in.bodies[in.faces[b].body];
    if (c.density_factor != d.density_factor) return c.density_factor > d.density_factor;
    if (c.smooth != d.smooth) return d.smooth;
    const Plane &p = in.planes[in.faces[a].plane], &q = in.planes[in.faces[b].plane];
    if (less(p.normal, q.normal) || less(q.normal, p.normal)) return less(p.normal, q.normal);
    if (p.offset != q.offset) return p.offset < q.offset;
    const auto &s = faces[a].sorted, &t = faces[b].sorted;
    return std::lexicographical_compare(s.begin(), s.end(), t.begin(), t.end(), less);
  }

  /// Law 6, for a point of a face of plane `own` (kNone: the ground).
  bool shadowed(const Hit& q, Index own) const {
    const Sight ray = light_sight(q, u, v);
    const Four<Approx>& p = q.get<Approx>();
    const Approx across_u = dot3<Approx>(u, p) / p[3], across_v = dot3<Approx>(v, p) / p[3];
    for (Index i = 0; i < faces.size(); ++i) {
      const CanonicalFace& f = in.faces[i];
      if (f.plane == own || faces[i].light_side == 0) continue;
      if (in.membership(f.body).solid != kNone) continue;
      if (in.bodies[f.body].closed && faces[i].light_side < 0) continue;
      if (!faces[i].light_box.may_hold(across_u, across_v)) continue;
      // t = (offset - n.Q) / (n.L); the stored normal's side of the light is light_side, unflipped.
      const int stored_side = f.flipped ? -faces[i].light_side : faces[i].light_side;
      if (-sign_at(q, in.planes[f.plane]) * stored_side > 0 && covers(f, ray)) return true;
    }
    for (Index s = 0; s < in.solids.size(); ++s)
      if (shadowed_by(s, q, own, ray, across_u, across_v)) return true;
    return false;
  }

  /// The same of a solid: whether the way from the light to Q enters it. Faces of Q's own plane are
  /// not on it.
  bool shadowed_by(Index s, const Hit& q, Index own, const Sight& ray, const Approx& across_u,
                   const Approx& across_v) const {
    std::vector<Meeting> met;
    for (Index i = 0; i < faces.size(); ++i) {
      const CanonicalFace& f = in.faces[i];
      if (in.membership(f.body).solid != s || f.plane == own || faces[i].light_side == 0) continue;
      if (!faces[i].light_box.may_hold(across_u, across_v)) continue;
      const int stored_side = f.flipped ? -faces[i].light_side : faces[i].light_side;
      if (-sign_at(q, in.planes[f.plane]) * stored_side > 0 && covers(f, ray))
        met.push_back({i, hit(ray, in.planes[f.plane])});
    }
    const auto order = [&](const Meeting& a, const Meeting& b) {
      if (in.faces[a.face].plane == in.faces[b.face].plane) return 0;
      return compare_along_light(a.at, b.at);
    };
    std::sort(met.begin(), met.end(),
              [&](const Meeting& a, const Meeting& b) { return order(a, b) > 0; });
    std::map<Index, int> winding;
    const auto is_in = [&](Index operand) { return winding[operand] != 0; };
    for (std::size_t i = 0; i < met.size(); ++i) {
      winding[in.membership(in.faces[met[i].face].body).operand] += faces[met[i].face].light_side;
      const bool group_ends = i + 1 == met.size() || order(met[i], met[i + 1]) != 0;
      if (group_ends && holds(in.solids[s]->nodes, 0, is_in)) return true;
    }
    return false;
  }

  /// 1 when a is nearer to the light.
  int compare_along_light(const Hit& a, const Hit& b) const {
    const int difference = sign_of([&]<class T>() {
      const auto &p = a.get<T>(), &q = b.get<T>();
      return dot3<T>(*in.light, p) * q[3] - dot3<T>(*in.light, q) * p[3];
    });
    const auto w = [](const Hit& h) { return sign_of([&]<class T>() { return h.get<T>()[3]; }); };
    return difference * w(a) * w(b);
  }

  Seen ground_at(const Hit& h) const {
    if (!in.light || !(in.light->z > 0) || !shadowed(h, kNone)) return {};
    const double d = clamped(in.law.hmax * in.law.ground_shadow_factor);
    return {kNone, kNone, Kind::ground_shadow, d};
  }

  /// Law 6.
  Seen face_at(const Meeting& m) const {
    const CanonicalFace& f = in.faces[m.face];
    Seen s{m.face, f.body, Kind::lit};
    s.density = s.away_from_shadow = density_away_from_shadow(m);
    s.in_shadow = clamped(in.law.hmax * in.bodies[f.body].density_factor);
    if (!in.light) return s;
    if (faces[m.face].light_side * faces[m.face].eye_side <= 0) {
      s.kind = Kind::shade;
    } else if (shadowed(m.at, f.plane)) {
      s.kind = Kind::shadow;
      s.density = s.in_shadow;
    }
    return s;
  }

  /// Law 7.
  double density_away_from_shadow(const Meeting& m) const {
    const CanonicalFace& f = in.faces[m.face];
    const double factor = in.bodies[f.body].density_factor;
    const int seen_side = faces[m.face].eye_side;
    if (!in.light) return shade(1, factor);
    return is_smooth(f) ? smooth(f, m.at, seen_side)
                        : shade(seen_side * glm::dot(in.outward(f), *in.light), factor);
  }

  /// NN74 (15); cos a below 0 is shade.
  double shade(double cosine, double factor) const {
    return clamped(in.law.hmax * (1 - in.law.k * std::max(0.0, cosine)) * factor);
  }

  bool is_smooth(const CanonicalFace& f) const {
    return in.bodies[f.body].smooth && !in.corner_normals.empty() && f.end_loop - f.first_loop == 1;
  }

  double smooth(const CanonicalFace& f, const Hit& h, int seen_side) const {
    const Four<Approx>& p = h.get<Approx>();
    const Vec3 q = Vec3(p[0].value, p[1].value, p[2].value) / p[3].value;
    const Index first = f.first_loop == 0 ? 0 : in.loop_ends[f.first_loop - 1];
    const Index end = in.loop_ends[f.first_loop];
    const auto corner = [&](Index i) {
      return shade(seen_side * glm::dot(in.corner_normals[i], *in.light),
                   in.bodies[f.body].density_factor);
    };
    // Equal corners are not interpolated: their density is that to the last bit.
    double best_inside = -INFINITY, best = corner(first);
    for (Index i = first + 1; i + 1 < end; ++i) {
      const Vec3 b = barycentric(q, first, i, i + 1);
      const double inside = std::min({b.x, b.y, b.z});
      if (!(inside > best_inside)) continue;
      best_inside = inside;
      if (corner(i) == corner(first) && corner(i + 1) == corner(first)) {
        best = corner(first);
        continue;
      }
      best = b.x * corner(first) + b.y * corner(i) + b.z * corner(i + 1);
    }
    return best;
  }

  Vec3 barycentric(const Vec3& q, Index i, Index j, Index k) const {
    const Vec3 &a = in.vertices[in.corners[i]], &b = in.vertices[in.corners[j]],
               &c = in.vertices[in.corners[k]];
    const Vec3 n = glm::cross(b - a, c - a);
    const double area = glm::dot(n, n);
    const double y = glm::dot(glm::cross(q - a, c - a), n) / area;
    const double z = glm::dot(glm::cross(b - a, q - a), n) / area;
    return {1 - y - z, y, z};
  }
};

Oracle::Oracle(const Canonical& canonical, const View& view)
    : impl_(std::make_unique<Impl>(canonical, view)) {}
Oracle::~Oracle() = default;

Seen Oracle::at(double x, double y) const { return impl_->see(x, y); }

bool Oracle::near_edge(double x, double y, double radius) const {
  const Seen here = at(x, y);
  const double r = radius * std::sqrt(0.5);
  const std::array<Vec2, 8> around{Vec2(radius, 0),  Vec2(r, r),   Vec2(0, radius),  Vec2(-r, r),
                                   Vec2(-radius, 0), Vec2(-r, -r), Vec2(0, -radius), Vec2(r, -r)};
  return std::any_of(around.begin(), around.end(),
                     [&](const Vec2& d) { return !here.same(at(x + d.x, y + d.y)); });
}

}  // namespace overstrike::oracle
