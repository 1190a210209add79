#include "solver/space/methods/embree_scene.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include "kernel/support/failure.h"

namespace hottel {
namespace {

// What a filter is told: triangles of the piece that a ray starts from are passed over.
struct Context {
  RTCIntersectContext base;
  const std::uint32_t* piece_of;  // of a triangle
  std::uint32_t own_piece;
};

void pass_over_own_piece(const RTCFilterFunctionNArguments* arguments) {
  const auto* const context = reinterpret_cast<const Context*>(arguments->context);
  const unsigned triangle = RTCHitN_primID(arguments->hit, arguments->N, 0);
  if (context->piece_of[triangle] == context->own_piece) arguments->valid[0] = 0;
}

}  // namespace

struct EmbreeScene3::Held {
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;
  std::vector<std::uint32_t> piece_of;
  double scale = 1;  // Embree's coordinates over those of Vertices3

  Held() = default;
  Held(const Held&) = delete;
  Held& operator=(const Held&) = delete;
  ~Held() {
    if (scene != nullptr) rtcReleaseScene(scene);
    if (device != nullptr) rtcReleaseDevice(device);
  }
  void require(bool is_good) const {
    if (!is_good || rtcGetDeviceError(device) != RTC_ERROR_NONE)
      throw RequestError("Embree cannot hold the scene: out of memory, or not for this processor");
  }
};

EmbreeScene3::EmbreeScene3(const Occluders3& occluders) : held_(std::make_unique<Held>()) {
  const Vertices3& vertices = occluders.vertices();
  double largest = 0;
  for (const VertexId3 v : IdRange<VertexId3>(vertices.size()))
    largest = std::max(largest, vertices.approximate(v).size);
  if (largest > 0) held_->scale = 1 / largest;

  held_->device = rtcNewDevice("threads=1");
  held_->require(held_->device != nullptr);
  held_->scene = rtcNewScene(held_->device);
  held_->require(held_->scene != nullptr);
  rtcSetSceneFlags(held_->scene, RTC_SCENE_FLAG_ROBUST);
  const RTCGeometry geometry = rtcNewGeometry(held_->device, RTC_GEOMETRY_TYPE_TRIANGLE);
  held_->require(geometry != nullptr);

  std::vector<std::array<unsigned, 3>> triangles;
  for (std::uint32_t piece = 0; piece < occluders.size(); ++piece) {
    const auto outline = occluders.outline(piece);
    for (std::size_t k = 1; k + 1 < outline.size(); ++k) {
      triangles.push_back({static_cast<unsigned>(outline[0].index()), static_cast<unsigned>(outline[k].index()),
                           static_cast<unsigned>(outline[k + 1].index())});
      held_->piece_of.push_back(piece);
    }
  }
  auto* const places = static_cast<float*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), vertices.size()));
  auto* const corners = static_cast<unsigned*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(unsigned), triangles.size()));
  held_->require(places != nullptr && corners != nullptr);
  for (const VertexId3 v : IdRange<VertexId3>(vertices.size())) {
    const BoundedVector& place = vertices.approximate(v);
    float* const here = places + 3 * v.index();
    here[0] = static_cast<float>(place.x * held_->scale);
    here[1] = static_cast<float>(place.y * held_->scale);
    here[2] = static_cast<float>(place.z * held_->scale);
  }
  for (std::size_t k = 0; k < triangles.size(); ++k)
    std::copy(triangles[k].begin(), triangles[k].end(), corners + 3 * k);
  rtcSetGeometryIntersectFilterFunction(geometry, pass_over_own_piece);
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(held_->scene, geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(held_->scene);
  held_->require(true);
}

EmbreeScene3::~EmbreeScene3() = default;

std::optional<RayHit3> EmbreeScene3::first_hit(const Vector3d& from, const Vector3d& way,
                                               std::uint32_t own_piece) const {
  Context context{};
  rtcInitIntersectContext(&context.base);
  context.piece_of = held_->piece_of.data();
  context.own_piece = own_piece;
  RTCRayHit ray{};
  ray.ray.org_x = static_cast<float>(from.x * held_->scale);
  ray.ray.org_y = static_cast<float>(from.y * held_->scale);
  ray.ray.org_z = static_cast<float>(from.z * held_->scale);
  ray.ray.dir_x = static_cast<float>(way.x);
  ray.ray.dir_y = static_cast<float>(way.y);
  ray.ray.dir_z = static_cast<float>(way.z);
  ray.ray.tnear = 0;
  ray.ray.tfar = std::numeric_limits<float>::infinity();
  ray.ray.mask = ~0u;
  ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  ray.hit.primID = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(held_->scene, &context.base, &ray);
  if (ray.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
  return RayHit3{held_->piece_of[ray.hit.primID], ray.ray.tfar / held_->scale};
}

}  // namespace hottel
