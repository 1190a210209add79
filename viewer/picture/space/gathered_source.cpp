#include "viewer/picture/space/gathered_source.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>

#include "geometry/space/prepared/face_patches.h"
#include "kernel/support/parallel.h"
#include "viewer/picture/space/direct_view.h"
#include "viewer/picture/space/smooth_mesh.h"
#include "viewer/picture/space/smooth_runs.h"

namespace hottel {
namespace {

constexpr int kPartInward =
    1024;  // the part of the way to the middle of an element by which points are off its corners

// The radiosities of elements and of the corners between them.
class CornerRadiosities {
 public:
  CornerRadiosities(const PreparedScene3& prepared, Granularity granularity, const RadiositySolution& solution,
                    std::span<const LightShares> shares)
      : prepared_(prepared),
        granularity_(granularity),
        solution_(solution),
        channels_(solution.channels.size()),
        table_(*prepared.elements(granularity)),
        mesh_(prepared, table_),
        direct_(mesh_.at_corners(direct_irradiances_3(prepared.scene, table_, channels_, shares), channels_)) {
    for (std::size_t i = 0; i < table_.count(); ++i)
      for (const ChannelSolution& channel : solution.channels) of_elements_.push_back(channel.elements[i].radiosity);
  }

  std::vector<PartRun3> runs() const {
    std::vector<double> at_corners = mesh_.at_corners(of_elements_, channels_);
    const std::vector<PartRun3> blended = runs(at_corners);
    const GatheredLight3 light(prepared_, granularity_, solution_, blended);
    const std::vector<std::optional<std::size_t>> part = parts_at_corners();
    parallel_for(
        part.size(),
        [&](std::size_t k) {
          if (part[k]) gather(light, k, *part[k], std::span(at_corners).subspan(k * channels_, channels_));
        },
        4);
    return runs(at_corners);
  }

 private:
  std::vector<PartRun3> runs(std::span<const double> at_corners) const {
    return smooth_runs_3(prepared_, table_, mesh_, at_corners, of_elements_, channels_);
  }

  // A part that has each corner.
  std::vector<std::optional<std::size_t>> parts_at_corners() const {
    std::vector<std::optional<std::size_t>> result(mesh_.corners().size());
    for (std::size_t k = 0; k < table_.parts().size(); ++k)
      for (const std::uint32_t corner : mesh_.ring(k))
        if (!result[corner]) result[corner] = k;
    return result;
  }

  void gather(const GatheredLight3& light, std::size_t corner, std::size_t part, std::span<double> result) const {
    const ElementTable3::Part& own = table_.parts()[part];
    light.irradiance(inner_point(mesh_.corners()[corner], own.patch), {own.patch.surface, own.is_back}, result);
    for (std::size_t c = 0; c < channels_; ++c) {
      const ElementRadiosity& element = solution_.channels[c].elements[own.label];
      result[c] = std::max(
          0.0, sent_by_itself_3(element) + element.reflectivity * (result[c] + direct_[corner * channels_ + c]));
    }
  }

  // Off a corner of a patch, a little to its middle.
  Point3 inner_point(const Point3& corner, const Patch3& patch) const {
    Vector3 way;
    const std::vector<Point3> corners = corners_of(prepared_.occluders().vertices(), patch);
    const Rational part = Rational(1) / Rational(kPartInward * static_cast<int>(corners.size()));
    for (const Point3& p : corners) {
      const Vector3 to = p - corner;
      way = {way.x + part * to.x, way.y + part * to.y, way.z + part * to.z};
    }
    return {corner.x + way.x, corner.y + way.y, corner.z + way.z};
  }

  const PreparedScene3& prepared_;
  Granularity granularity_;
  const RadiositySolution& solution_;
  std::size_t channels_;
  const ElementTable3& table_;
  SmoothMesh3 mesh_;
  std::vector<double> direct_;       // by corner and channel
  std::vector<double> of_elements_;  // by element and channel
};

}  // namespace

GatheredSource3::GatheredSource3(const PreparedScene3& prepared, Granularity granularity,
                                 const RadiositySolution& solution, Responses3 responses,
                                 std::span<const LightShares> shares)
    : prepared_(prepared),
      table_(prepared.elements(granularity)),
      responses_(std::move(responses)),
      runs_(CornerRadiosities(prepared, granularity, solution, shares).runs()),
      light_(prepared, granularity, solution, runs_) {}

}  // namespace hottel
