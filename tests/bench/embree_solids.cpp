#include "tests/bench/embree_solids.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <cassert>
#include <cmath>

#include "tests/bench/triangles.h"

namespace overstrike::bench {
namespace {

struct NotedHit {
  float distance;
  std::uint32_t triangle;
  bool enters;
};

/// The context of a ray, with what its filter notes.
struct NotingContext {
  RTCIntersectContext context;
  std::vector<NotedHit>* hits;
};

void note_and_refuse(const RTCFilterFunctionNArguments* args) {
  assert(args->N == 1);
  const auto* ray = reinterpret_cast<const RTCRay*>(args->ray);
  const auto* hit = reinterpret_cast<const RTCHit*>(args->hit);
  const float along = hit->Ng_x * ray->dir_x + hit->Ng_y * ray->dir_y + hit->Ng_z * ray->dir_z;
  reinterpret_cast<NotingContext*>(args->context)
      ->hits->push_back({ray->tfar, hit->primID, along < 0});
  args->valid[0] = 0;
}

/// What the tree says of a set of operands.
bool holds(const std::vector<SolidNode>& nodes, Index at, unsigned bits) {
  const SolidNode& node = nodes[at];
  if (node.operation == SetOperation::operand) return (bits >> node.body & 1) != 0;
  bool result = false;
  for (Index i = at + 1; i < node.end; i = nodes[i].end) {
    const bool value = holds(nodes, i, bits);
    const bool first = i == at + 1;
    if (node.operation == SetOperation::unite) result = result || value;
    if (node.operation == SetOperation::intersect) result = first ? value : result && value;
    if (node.operation == SetOperation::subtract) result = first ? value : result && !value;
  }
  return result;
}

}  // namespace

struct EmbreeSolids::Impl {
  explicit Impl(const Prepared& prepared)
      : canonical(*prepared.canonical),
        triangles(triangles_of(canonical)),
        shift(prepared.view.origin),
        columns(static_cast<int>(prepared.view.grid.columns)),
        rows(static_cast<int>(prepared.view.grid.rows)),
        device(rtcNewDevice("threads=1,set_affinity=0")) {
    const CanonicalSolid& solid = *canonical.solids.front();
    assert(solid.expression.operands() <= kMostOperands);
    for (unsigned bits = 0; bits < 1U << solid.expression.operands(); ++bits)
      table.push_back(holds(solid.nodes, 0, bits));
    // Columns of the inverse take (x, y, 1, depth) back to the world.
    const Mat4 back = glm::inverse(prepared.view.matrix);
    double front = -HUGE_VAL;
    for (const Vec3& p : canonical.vertices) front = std::max(front, prepared.view.project(p).z);
    across = Vec3(back[0]), down = Vec3(back[1]);
    origin = Vec3(back[2]) + Vec3(back[3]) * (front + 1) + shift;
    direction = -Vec3(back[3]) / std::sqrt(glm::dot(Vec3(back[3]), Vec3(back[3])));
  }
  ~Impl() {
    if (scene != nullptr) rtcReleaseScene(scene);
    rtcReleaseDevice(device);
  }

  Index seen(int x, int y);
  Index first_inside();

  const Canonical& canonical;
  Triangles triangles;
  Vec3 shift;
  int columns, rows;
  RTCDevice device;
  RTCScene scene = nullptr;
  std::vector<char> table;
  std::vector<NotedHit> hits;
  std::vector<Index> picture;
  Vec3 origin{0.0}, across{0.0}, down{0.0}, direction{0.0};
};

/// Along the noted hits. Twice the same side of an operand changes nothing.
Index EmbreeSolids::Impl::first_inside() {
  std::sort(hits.begin(), hits.end(),
            [](const NotedHit& a, const NotedHit& b) { return a.distance < b.distance; });
  unsigned bits = 0;
  for (const NotedHit& hit : hits) {
    const Index face = triangles.faces[hit.triangle];
    const unsigned bit = 1U << canonical.membership(canonical.faces[face].body).operand;
    bits = hit.enters ? bits | bit : bits & ~bit;
    if (table[bits] != 0) return face;
  }
  return kNone;
}

Index EmbreeSolids::Impl::seen(int x, int y) {
  const Vec3 from = origin + across * (x + 0.5) + down * (y + 0.5);
  RTCRayHit ray{};
  ray.ray.org_x = static_cast<float>(from.x), ray.ray.dir_x = static_cast<float>(direction.x);
  ray.ray.org_y = static_cast<float>(from.y), ray.ray.dir_y = static_cast<float>(direction.y);
  ray.ray.org_z = static_cast<float>(from.z), ray.ray.dir_z = static_cast<float>(direction.z);
  ray.ray.tfar = INFINITY, ray.ray.mask = 0xFFFFFFFFu;
  ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  NotingContext noting{};
  rtcInitIntersectContext(&noting.context);
  noting.context.filter = note_and_refuse;
  noting.hits = &hits;
  hits.clear();
  rtcIntersect1(scene, &noting.context, &ray);
  return first_inside();
}

EmbreeSolids::EmbreeSolids(const Prepared& prepared) : impl_(std::make_unique<Impl>(prepared)) {}
EmbreeSolids::~EmbreeSolids() = default;

void EmbreeSolids::build() {
  Impl& impl = *impl_;
  if (impl.scene != nullptr) rtcReleaseScene(impl.scene);
  impl.scene = rtcNewScene(impl.device);
  rtcSetSceneFlags(impl.scene, static_cast<RTCSceneFlags>(RTC_SCENE_FLAG_ROBUST |
                                                          RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION));
  rtcSetSceneBuildQuality(impl.scene, RTC_BUILD_QUALITY_HIGH);
  RTCGeometry mesh = rtcNewGeometry(impl.device, RTC_GEOMETRY_TYPE_TRIANGLE);
  const Triangles& input = impl.triangles;
  float* vertices = static_cast<float*>(
      rtcSetNewGeometryBuffer(mesh, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float),
                              input.vertices.size()));
  for (const Vec3& p : input.vertices)
    for (int i = 0; i < 3; ++i) *vertices++ = static_cast<float>(p[i] + impl.shift[i]);
  Index* corners = static_cast<Index*>(rtcSetNewGeometryBuffer(
      mesh, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(Index), input.corners.size()));
  for (const auto& triangle : input.corners)
    corners = std::copy(triangle.begin(), triangle.end(), corners);
  rtcCommitGeometry(mesh);
  rtcAttachGeometry(impl.scene, mesh);
  rtcReleaseGeometry(mesh);
  rtcCommitScene(impl.scene);
}

void EmbreeSolids::trace() {
  impl_->picture.clear();
  for (int y = 0; y < impl_->rows; ++y)
    for (int x = 0; x < impl_->columns; ++x) impl_->picture.push_back(impl_->seen(x, y));
}

std::vector<Index> EmbreeSolids::row(int row) const {
  const auto first = impl_->picture.begin() + row * impl_->columns;
  return {first, first + impl_->columns};
}

}  // namespace overstrike::bench
