// SPDX-License-Identifier: GPL-3.0-or-later
#include "baselines/sampled.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <embree3/rtcore.h>
#include <numbers>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <xmmintrin.h>

namespace truelux {
namespace {

constexpr float kBegin = 1e-5F;    ///< of a ray's length
constexpr float kEnd = 1 - 1e-5F;  ///< of a ray's length

/// Rays that are handed over at once.
constexpr std::size_t kStream = 1024;

/// Embree's manual asks for denormals to be flushed to zero on every thread
/// that traces; the mode before is restored, since truelux must not run so.
class FlushToZero {
 public:
  FlushToZero() : before_(_mm_getcsr()) {
    constexpr unsigned kFlushResults = 0x8000;
    constexpr unsigned kDenormalsAreZero = 0x0040;
    _mm_setcsr(before_ | kFlushResults | kDenormalsAreZero);
  }

  ~FlushToZero() { _mm_setcsr(before_); }

  FlushToZero(const FlushToZero&) = delete;
  FlushToZero& operator=(const FlushToZero&) = delete;

 private:
  unsigned before_;
};

/// Makes rays from one receiver and weighs what they meet.
class Shooter {
 public:
  Shooter(const Receiver& receiver, const EmitterSamples& samples)
      : samples_(samples) {
    const Point3& p = receiver.position;
    const Vector3& n = receiver.normal;
    const double length = std::hypot(n.x, n.y, n.z);
    origin_ = {static_cast<float>(p.x), static_cast<float>(p.y),
               static_cast<float>(p.z)};
    normal_ = {static_cast<float>(n.x / length),
               static_cast<float>(n.y / length),
               static_cast<float>(n.z / length)};
  }

  /// cos cos' / d^2 if the point is visible; sets the ray if that is not 0.
  float Aim(const EmitterSamples::Point& point, RTCRay& ray) const {
    const auto& normal =
        samples_.pieces[static_cast<std::size_t>(point.piece)].normal;
    const float x = point.position[0] - origin_[0];
    const float y = point.position[1] - origin_[1];
    const float z = point.position[2] - origin_[2];
    const float here = normal_[0] * x + normal_[1] * y + normal_[2] * z;
    const float there = normal[0] * x + normal[1] * y + normal[2] * z;
    if (!(here > 0 && there < 0)) return 0;
    ray.org_x = origin_[0];
    ray.org_y = origin_[1];
    ray.org_z = origin_[2];
    ray.tnear = kBegin;
    ray.dir_x = x;
    ray.dir_y = y;
    ray.dir_z = z;
    ray.time = 0;
    ray.tfar = kEnd;
    ray.mask = ~0U;
    ray.id = 0;
    ray.flags = 0;
    const float square = x * x + y * y + z * z;
    return here * -there / (square * square);
  }

  void Add(const EmitterSamples::Point& point, float weight) {
    const Rgb& exitance =
        samples_.pieces[static_cast<std::size_t>(point.piece)].exitance;
    for (std::size_t c = 0; c < sum_.size(); ++c)
      sum_[c] += static_cast<double>(weight) * exitance[c];
  }

  [[nodiscard]] Rgb Mean() const {
    const double scale =
        samples_.area /
        (std::numbers::pi * static_cast<double>(samples_.points.size()));
    return {scale * sum_[0], scale * sum_[1], scale * sum_[2]};
  }

 private:
  const EmitterSamples& samples_;
  std::array<float, 3> origin_{};
  std::array<float, 3> normal_{};
  Rgb sum_{};
};

/// Embree marks a ray that is blocked.
bool IsBlocked(const RTCRay& ray) {
  return ray.tfar < 0;
}

void TraceOneByOne(RTCScene scene, const EmitterSamples& samples,
                   Shooter& shooter) {
  RTCIntersectContext context{};
  rtcInitIntersectContext(&context);
  RTCRay ray{};
  for (const EmitterSamples::Point& point : samples.points) {
    const float weight = shooter.Aim(point, ray);
    if (weight == 0) continue;
    rtcOccluded1(scene, &context, &ray);
    if (!IsBlocked(ray)) shooter.Add(point, weight);
  }
}

void TraceStream(RTCScene scene, std::span<const EmitterSamples::Point> points,
                 Shooter& shooter) {
  // Filled below as far as used; to clear them would take time from Embree.
  // NOLINTBEGIN(cppcoreguidelines-pro-type-member-init)
  std::array<RTCRay, kStream> rays;
  std::array<float, kStream> weights;
  std::array<std::size_t, kStream> indices;
  // NOLINTEND(cppcoreguidelines-pro-type-member-init)
  unsigned count = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    weights[count] = shooter.Aim(points[i], rays[count]);
    indices[count] = i;
    if (weights[count] != 0) ++count;
  }
  RTCIntersectContext context{};
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  rtcOccluded1M(scene, &context, rays.data(), count, sizeof(RTCRay));
  for (std::size_t k = 0; k < count; ++k) {
    if (!IsBlocked(rays[k])) shooter.Add(points[indices[k]], weights[k]);
  }
}

template <class Element>
std::span<Element> NewBuffer(RTCGeometry geometry, RTCBufferType type,
                             RTCFormat format, std::size_t count) {
  void* buffer = rtcSetNewGeometryBuffer(geometry, type, 0, format,
                                         sizeof(Element), count);
  if (buffer == nullptr) throw std::runtime_error("Embree is out of memory");
  return {static_cast<Element*>(buffer), count};
}

void FillGeometry(const Scene& scene, RTCGeometry geometry) {
  const auto vertices = NewBuffer<std::array<float, 3>>(
      geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3,
      scene.vertices().size());
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Point3& p = scene.vertices()[i];
    vertices[i] = {static_cast<float>(p.x), static_cast<float>(p.y),
                   static_cast<float>(p.z)};
  }
  const auto triangles = NewBuffer<std::array<unsigned, 3>>(
      geometry, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3,
      scene.triangles().size());
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      triangles[i][k] = static_cast<unsigned>(scene.triangles()[i].vertices[k]);
    }
  }
}

}  // namespace

struct ShadowRays::Impl {
  RTCDevice device = rtcNewDevice("threads=1");
  RTCScene scene = nullptr;

  Impl() = default;
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  ~Impl() {
    if (scene != nullptr) rtcReleaseScene(scene);
    if (device != nullptr) rtcReleaseDevice(device);
  }
};

bool ShadowRaysAvailable() {
  return true;
}

ShadowRays::ShadowRays(const Scene& scene) {
  auto impl = std::make_unique<Impl>();
  if (impl->device == nullptr) {
    throw std::runtime_error("Embree gives no device, error " +
                             std::to_string(rtcGetDeviceError(nullptr)));
  }
  impl->scene = rtcNewScene(impl->device);
  // The hierarchy that is slowest to build and fastest to trace.
  rtcSetSceneBuildQuality(impl->scene, RTC_BUILD_QUALITY_HIGH);
  if (!scene.triangles().empty()) {
    const RTCGeometry geometry =
        rtcNewGeometry(impl->device, RTC_GEOMETRY_TYPE_TRIANGLE);
    FillGeometry(scene, geometry);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(impl->scene, geometry);
    rtcReleaseGeometry(geometry);
  }
  rtcCommitScene(impl->scene);
  if (const RTCError error = rtcGetDeviceError(impl->device);
      error != RTC_ERROR_NONE)
    throw std::runtime_error("Embree reports error " + std::to_string(error));
  impl_ = std::move(impl);
}

ShadowRays::~ShadowRays() = default;
ShadowRays::ShadowRays(ShadowRays&&) noexcept = default;
ShadowRays& ShadowRays::operator=(ShadowRays&&) noexcept = default;

Rgb ShadowRays::Estimate(const Receiver& receiver,
                         const EmitterSamples& samples) const {
  if (samples.points.empty()) return {};
  const FlushToZero mode;
  Shooter shooter(receiver, samples);
  if (samples.pattern != SamplePattern::kRowOrdered) {
    TraceOneByOne(impl_->scene, samples, shooter);
    return shooter.Mean();
  }
  const std::span points(samples.points);
  for (std::size_t at = 0; at < points.size(); at += kStream) {
    TraceStream(impl_->scene,
                points.subspan(at, std::min(kStream, points.size() - at)),
                shooter);
  }
  return shooter.Mean();
}

}  // namespace truelux
