#include "solver/space/dividing/estimate.h"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "geometry/space/prepared/element_table.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "geometry/space/scene/division.h"
#include "kernel/support/failure.h"
#include "kernel/support/parallel.h"
#include "kernel/support/progress_count.h"
#include "solver/dividing/cut_elements.h"
#include "solver/dividing/direct_parts.h"
#include "solver/dividing/merged_elements.h"
#include "solver/dividing/sampled_elements.h"
#include "solver/refinement.h"
#include "solver/space/light/sent_out.h"
#include "solver/space/light/tested_shares.h"

namespace hottel {
namespace {

// A whole polygon is divided as by 2, where that is not more than it takes.
std::vector<TreeNode> parts_of(const Scene3& scene, const Element& element) {
  if (element.is_part()) {
    std::vector<TreeNode> parts;
    for (int digit = 0; digit < 4; ++digit) parts.push_back({element.part, element.path.child(digit)});
    return parts;
  }
  const std::uint32_t roots = root_count(scene.polygons[element.surface], 1);
  return uniform_leaves(roots, 4, roots < 4 ? 1 : 0);
}

// Twice the vector area of a convex polygon.
Vector3 doubled_area(const std::vector<Point3>& corners) {
  Vector3 sum;
  for (std::size_t k = 1; k + 1 < corners.size(); ++k) {
    const Vector3 turn = cross(corners[k] - corners[0], corners[k + 1] - corners[0]);
    sum = {sum.x + turn.x, sum.y + turn.y, sum.z + turn.z};
  }
  return sum;
}

// A point inside the largest patch of a part, and the way that its front looks.
struct PlaceOnPart {
  Point3 eye;
  Vector3 normal;
};

PlaceOnPart place_on(const ElementTable3& table, std::uint32_t label, const Vertices3& vertices) {
  PlaceOnPart place;
  Rational largest = -1;
  for (const ElementTable3::Part& part : table.free_parts(label)) {
    const std::vector<Point3> corners = corners_of(vertices, part.patch);
    const Vector3 area = doubled_area(corners);
    if (dot(area, area) <= largest) continue;
    largest = dot(area, area);
    Point3 sum;
    for (const Point3& corner : corners) sum = {sum.x + corner.x, sum.y + corner.y, sum.z + corner.z};
    const Rational count(static_cast<unsigned long>(corners.size()));
    place = {{sum.x / count, sum.y / count, sum.z / count}, area};
  }
  return place;
}

// The parts of elements that are looked at, and what they gather.
class Parts {
 public:
  Parts(const DividingRequest3& request, std::span<const SampledElement> samples)
      : request_(request),
        samples_(samples),
        cut_(request.prepared.under(divided())),
        table_(*cut_.elements(Granularity::kElement)),
        around_(elements_around(table_.elements(), request.solved.matrix.elements())),
        direct_(cut_.scene, table_.elements(),
                cut_.scene.lights.empty() ? std::vector<LightShares>()
                                          : light_shares(cut_, Granularity::kElement, request.lights)) {}

  std::vector<std::vector<PartSight>> sights() const {
    const std::size_t channels = request_.solved.solution.channels.size();
    std::vector<std::uint32_t> sample_of(request_.solved.matrix.size(), kNone);
    for (std::uint32_t k = 0; k < samples_.size(); ++k) sample_of[samples_[k].element] = k;
    std::vector<std::uint32_t> labels;
    for (std::uint32_t label = 0; label < table_.count(); ++label)
      if (sample_of[around_[label]] != kNone && table_.has_row(label)) labels.push_back(label);
    const SentOut3 sent_out(request_.prepared, request_.granularity, request_.solved.solution);
    std::vector<PartSight> parts(labels.size());
    ProgressCount count(request_.progress, labels.size());
    parallel_for(
        labels.size(),
        [&](std::size_t k) {
          parts[k].irradiance.assign(channels, 0.0);
          parts[k].share = table_.extent(labels[k]).value;
          if (!table_.free_parts(labels[k]).empty()) {
            const PlaceOnPart place = place_on(table_, labels[k], request_.prepared.occluders().vertices());
            sent_out.irradiance(place.eye, place.normal, parts[k].irradiance);
          }
          count.add(1);
        },
        4);
    std::vector<std::vector<PartSight>> sights(samples_.size());
    std::vector<std::uint32_t> place_of(table_.count(), kNone);
    for (std::uint32_t k = 0; k < labels.size(); ++k) place_of[labels[k]] = k;
    for (const ElementTable3::Contact& contact : table_.contacts()) {
      add_contact(contact.mask, contact.base, contact.extent.value, place_of, parts, sights, sample_of);
      add_contact(contact.base, contact.mask, contact.extent.value, place_of, parts, sights, sample_of);
    }
    for (std::size_t k = 0; k < labels.size(); ++k) {
      for (std::size_t c = 0; c < channels; ++c) parts[k].irradiance[c] += direct_.of(labels[k], c);
      if (parts[k].share > 0) sights[sample_of[around_[labels[k]]]].push_back(std::move(parts[k]));
    }
    return sights;
  }

 private:
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

  Scene3 divided() const {
    const auto& [scene, matrix, solution, lights] = request_.solved;
    return with_trees(request_.prepared.scene,
                      trees_with_parts(scene, matrix.elements(), samples_, [this](const Element& element) {
                        return parts_of(request_.prepared.scene, element);
                      }));
  }

  // What a part gathers where another element lies on it: all that this one sends out.
  void add_contact(std::uint32_t of, std::uint32_t other, double extent, const std::vector<std::uint32_t>& place_of,
                   std::vector<PartSight>& parts, std::vector<std::vector<PartSight>>& sights,
                   const std::vector<std::uint32_t>& sample_of) const {
    if (place_of[of] == kNone) return;
    PartSight sight{.share = extent, .irradiance = {}};
    for (const ChannelSolution& channel : request_.solved.solution.channels)
      sight.irradiance.push_back(channel.elements[around_[other]].radiosity);
    parts[place_of[of]].share = std::max(0.0, parts[place_of[of]].share - extent);
    sights[sample_of[around_[of]]].push_back(std::move(sight));
  }

  const DividingRequest3& request_;
  std::span<const SampledElement> samples_;
  PreparedScene3 cut_;
  const ElementTable3& table_;
  std::vector<std::uint32_t> around_;  // of each part the element that it lies in
  DirectParts direct_;
};

// Where the k-th of n^2 triangles lies among (n / 2)^2, both as PolygonDivision3 numbers them.
std::uint32_t coarse_triangle(std::uint32_t k, std::uint32_t n) {
  std::uint32_t row = 0;
  for (; k >= 2 * (n - row) - 1; ++row) k -= 2 * (n - row) - 1;
  // Three times the middle, in sides of the triangles; those that point down have theirs further from both.
  const std::uint32_t down = k % 2, x = 3 * (k / 2) + 1 + down, y = 3 * row + 1 + down;
  const std::uint32_t column = x / 6, coarse_row = y / 6;
  const std::uint32_t is_down = x % 6 + y % 6 > 6 ? 1 : 0;
  return coarse_row * (n - coarse_row) + 2 * column + is_down;
}

}  // namespace

ElementMerging merging_in_fours(const Scene3& scene, std::span<const Element> elements) {
  return merged_elements(scene, elements, [&scene](const Element& element) {
    const Polygon3& polygon = scene.polygons[element.surface];
    const std::uint32_t n = scene.surfaces[element.surface].elements, half = n / 2;
    const std::uint32_t shapes = element.parts / (n * n);
    const bool is_quad = shapes == 1 && polygon.points.size() == 4;
    const std::uint32_t shape = element.part / (n * n), k = element.part % (n * n);
    const std::uint32_t coarse = is_quad ? k / n / 2 * half + k % n / 2 : coarse_triangle(k, n);
    return CoarsePart{shape * half * half + coarse, shapes * half * half};
  });
}

DividingEstimate estimate_dividing(const DividingRequest3& request) {
  SightsOfParts sights;
  if (request.has_exact_factors)
    sights = [&request](std::span<const SampledElement> samples) { return Parts(request, samples).sights(); };
  return estimate_dividing(request.solved, request.most, sights, [&request] {
    return merging_in_fours(request.prepared.scene, request.solved.matrix.elements());
  });
}

}  // namespace hottel
