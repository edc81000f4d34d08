#include "tests/bench/embree_peer.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <cmath>

namespace overstrike::bench {
namespace {

constexpr int kSide = 4;  ///< of a packet
constexpr int kRays = kSide * kSide;

}  // namespace

struct EmbreePeer::Impl {
  Impl(const Triangles& triangles, const View& in_view, std::vector<Vec3> all_shifts)
      : input(triangles),
        shifts(std::move(all_shifts)),
        columns(static_cast<int>(in_view.grid.columns)),
        rows(static_cast<int>(in_view.grid.rows)),
        device(rtcNewDevice("threads=1,set_affinity=0")),
        image(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows)) {
    // Columns of the inverse take (x, y, 1, depth) back to the world.
    const Mat4 back = glm::inverse(in_view.matrix);
    const double front = nearest_depth(in_view) + 1;
    across = Vec3(back[0]), down = Vec3(back[1]), origin = Vec3(back[2]) + Vec3(back[3]) * front;
    direction = -Vec3(back[3]) / std::sqrt(glm::dot(Vec3(back[3]), Vec3(back[3])));
  }
  ~Impl() {
    release();
    rtcReleaseDevice(device);
  }
  void release() {
    for (RTCScene* s : {&scene, &shape}) {
      if (*s != nullptr) rtcReleaseScene(*s);
      *s = nullptr;
    }
  }

  double nearest_depth(const View& view) const;
  RTCScene scene_of_triangles() const;
  RTCScene scene_of_instances() const;
  /// The number of the triangle that a ray of the packet hit, or kNothing.
  std::uint32_t number(const RTCHit16& hit, int lane) const {
    if (shifts.empty() || hit.geomID[lane] == RTC_INVALID_GEOMETRY_ID) return hit.primID[lane];
    return hit.instID[0][lane] * static_cast<std::uint32_t>(input.corners.size()) +
           hit.primID[lane];
  }

  /// The hits of the packet at column x, row y.
  void cast(int x, int y, RTCRayHit16& packet) const;
  void set_ray(RTCRay16& ray, int lane, double x, double y) const;

  const Triangles& input;
  std::vector<Vec3> shifts;
  int columns, rows;
  RTCDevice device;
  RTCScene scene = nullptr;
  RTCScene shape = nullptr;  ///< what instances are of
  std::vector<std::uint8_t> image;
  Vec3 origin, across, down, direction;
};

void EmbreePeer::Impl::set_ray(RTCRay16& ray, int lane, double x, double y) const {
  const Vec3 from = origin + across * x + down * y;
  ray.org_x[lane] = static_cast<float>(from.x), ray.dir_x[lane] = static_cast<float>(direction.x);
  ray.org_y[lane] = static_cast<float>(from.y), ray.dir_y[lane] = static_cast<float>(direction.y);
  ray.org_z[lane] = static_cast<float>(from.z), ray.dir_z[lane] = static_cast<float>(direction.z);
  ray.tnear[lane] = 0, ray.tfar[lane] = INFINITY;
  ray.mask[lane] = 0xFFFFFFFFu, ray.flags[lane] = 0, ray.time[lane] = 0;
}

void EmbreePeer::Impl::cast(int x, int y, RTCRayHit16& packet) const {
  alignas(64) int valid[kRays];
  for (int lane = 0; lane < kRays; ++lane) {
    const int px = x + lane % kSide, py = y + lane / kSide;
    valid[lane] = px < columns && py < rows ? -1 : 0;
    set_ray(packet.ray, lane, px + 0.5, py + 0.5);
    packet.hit.geomID[lane] = packet.hit.primID[lane] = packet.hit.instID[0][lane] =
        RTC_INVALID_GEOMETRY_ID;
  }
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  rtcIntersect16(valid, scene, &context, &packet);
}

double EmbreePeer::Impl::nearest_depth(const View& view) const {
  double nearest = -1e300;
  const auto reach = [&](const Vec3& shift) {
    for (const Vec3& p : input.vertices) nearest = std::max(nearest, view.project(p + shift).z);
  };
  if (shifts.empty()) reach(Vec3(0.0));
  for (const Vec3& shift : shifts) reach(shift);
  return nearest;
}

RTCScene EmbreePeer::Impl::scene_of_triangles() const {
  RTCGeometry mesh = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  float* vertices = static_cast<float*>(
      rtcSetNewGeometryBuffer(mesh, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float),
                              input.vertices.size()));
  for (const Vec3& p : input.vertices)
    for (int i = 0; i < 3; ++i) *vertices++ = static_cast<float>(p[i]);
  Index* corners = static_cast<Index*>(rtcSetNewGeometryBuffer(
      mesh, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(Index), input.corners.size()));
  for (const auto& triangle : input.corners)
    corners = std::copy(triangle.begin(), triangle.end(), corners);
  RTCScene made = rtcNewScene(device);
  rtcCommitGeometry(mesh);
  rtcAttachGeometry(made, mesh);
  rtcReleaseGeometry(mesh);
  rtcCommitScene(made);
  return made;
}

RTCScene EmbreePeer::Impl::scene_of_instances() const {
  RTCScene made = rtcNewScene(device);
  for (const Vec3& shift : shifts) {
    RTCGeometry instance = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_INSTANCE);
    rtcSetGeometryInstancedScene(instance, shape);
    const float columns_of[12] = {
        1, 0, 0, 0, 1, 0, 0, 0, 1, float(shift.x), float(shift.y), float(shift.z)};
    rtcSetGeometryTransform(instance, 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, columns_of);
    rtcCommitGeometry(instance);
    rtcAttachGeometry(made, instance);
    rtcReleaseGeometry(instance);
  }
  rtcCommitScene(made);
  return made;
}

EmbreePeer::EmbreePeer(const Triangles& triangles, const View& view, std::vector<Vec3> shifts)
    : impl_(std::make_unique<Impl>(triangles, view, std::move(shifts))) {}
EmbreePeer::~EmbreePeer() = default;

void EmbreePeer::build() {
  impl_->release();
  impl_->scene = impl_->scene_of_triangles();
  if (impl_->shifts.empty()) return;
  std::swap(impl_->shape, impl_->scene);
  impl_->scene = impl_->scene_of_instances();
}

void EmbreePeer::trace() {
  Impl& impl = *impl_;
  alignas(64) RTCRayHit16 packet;
  for (int y = 0; y < impl.rows; y += kSide)
    for (int x = 0; x < impl.columns; x += kSide) {
      impl.cast(x, y, packet);
      for (int lane = 0; lane < kRays; ++lane) {
        const int px = x + lane % kSide, py = y + lane / kSide;
        if (px >= impl.columns || py >= impl.rows) continue;
        const std::uint32_t hit = packet.hit.primID[lane];  // copies are shaded alike
        impl.image[static_cast<std::size_t>(py * impl.columns + px)] =
            static_cast<std::uint8_t>(hit == kNothing ? 0 : impl.input.shade[hit]);
      }
    }
}

std::vector<std::uint32_t> EmbreePeer::row(int row) const {
  std::vector<std::uint32_t> result;
  alignas(64) RTCRayHit16 packet;
  for (int x = 0; x < impl_->columns; x += kSide) {
    impl_->cast(x, row - row % kSide, packet);
    for (int lane = 0; lane < kSide && x + lane < impl_->columns; ++lane)
      result.push_back(impl_->number(packet.hit, row % kSide * kSide + lane));
  }
  return result;
}

}  // namespace overstrike::bench
