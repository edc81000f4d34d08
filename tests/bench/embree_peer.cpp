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
  Impl(const Triangles& triangles, const View& in_view)
      : input(triangles),
        columns(static_cast<int>(in_view.grid.columns)),
        rows(static_cast<int>(in_view.grid.rows)),
        device(rtcNewDevice("threads=1,set_affinity=0")),
        image(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows)) {
    // Columns of the inverse take (x, y, 1, depth) back to the world.
    const Mat4 back = glm::inverse(in_view.matrix);
    double nearest = -1e300;
    for (const Vec3& p : input.vertices) nearest = std::max(nearest, in_view.project(p).z);
    const double front = nearest + 1 + std::fabs(nearest) / 8;
    across = Vec3(back[0]), down = Vec3(back[1]), origin = Vec3(back[2]) + Vec3(back[3]) * front;
    direction = -Vec3(back[3]) / std::sqrt(glm::dot(Vec3(back[3]), Vec3(back[3])));
  }
  ~Impl() {
    if (scene != nullptr) rtcReleaseScene(scene);
    rtcReleaseDevice(device);
  }

  /// The hits of the packet at column x, row y.
  void cast(int x, int y, RTCRayHit16& packet) const;
  void set_ray(RTCRay16& ray, int lane, double x, double y) const;

  const Triangles& input;
  int columns, rows;
  RTCDevice device;
  RTCScene scene = nullptr;
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
    packet.hit.geomID[lane] = packet.hit.primID[lane] = RTC_INVALID_GEOMETRY_ID;
  }
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  rtcIntersect16(valid, scene, &context, &packet);
}

EmbreePeer::EmbreePeer(const Triangles& triangles, const View& view)
    : impl_(std::make_unique<Impl>(triangles, view)) {}
EmbreePeer::~EmbreePeer() = default;

void EmbreePeer::build() {
  Impl& impl = *impl_;
  if (impl.scene != nullptr) rtcReleaseScene(impl.scene);
  impl.scene = rtcNewScene(impl.device);
  RTCGeometry mesh = rtcNewGeometry(impl.device, RTC_GEOMETRY_TYPE_TRIANGLE);
  float* vertices = static_cast<float*>(
      rtcSetNewGeometryBuffer(mesh, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float),
                              impl.input.vertices.size()));
  for (const Vec3& p : impl.input.vertices)
    for (int i = 0; i < 3; ++i) *vertices++ = static_cast<float>(p[i]);
  Index* corners =
      static_cast<Index*>(rtcSetNewGeometryBuffer(mesh, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                                  3 * sizeof(Index), impl.input.corners.size()));
  for (const auto& triangle : impl.input.corners)
    corners = std::copy(triangle.begin(), triangle.end(), corners);
  rtcCommitGeometry(mesh);
  rtcAttachGeometry(impl.scene, mesh);
  rtcReleaseGeometry(mesh);
  rtcCommitScene(impl.scene);
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
        const std::uint32_t hit = packet.hit.primID[lane];
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
      result.push_back(packet.hit.primID[row % kSide * kSide + lane]);
  }
  return result;
}

}  // namespace overstrike::bench
