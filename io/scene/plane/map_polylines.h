// Rings and lines of a map become polylines of a scene, whatever the format.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "geometry/plane/scene/scene_entries.h"
#include "io/scene/distinct_names.h"
#include "io/scene/passed_over.h"
#include "io/scene/plane/map_defaults.h"
#include "kernel/support/failure.h"

namespace hottel {

// What a feature says of its geometry.
struct MapFeature2 {
  std::string name;
  int name_line = 0;
  std::string material = kMapMaterial, back;
  std::uint32_t elements = 1;
  MapSide2 side = MapSide2::kInside;
};

// Collects polylines, as read_map_2 promises. Every function throws InputError.
class MapPolylines2 {
 public:
  using Points = std::vector<PolylinePoint2>;

  // REQUIRES that `passed_over` outlives this.
  MapPolylines2(const std::string& file, PassedOver& passed_over) : passed_over_(passed_over) { scene_.file = file; }

  PassedOver& passed_over() { return passed_over_; }
  // What is no line and no polygon.
  void pass_over(PassedKind kind, const FileLine& where, std::size_t count = 1) {
    passed_over_.add(kind, where, "", count);
  }
  // The same; where nothing else is in the map, that is told instead.
  void pass_over(PassedKind kind, InputError instead, std::size_t count = 1) {
    pass_over(kind, instead.where(), count);
    if (!instead_) instead_ = std::move(instead);
  }

  // A line, closed where it has four points or more and the last is the first; or one that has to close.
  void add_line(Points line, const MapFeature2& feature, const FileLine& where);
  void add_closed_line(Points line, const MapFeature2& feature, const FileLine& where);

  // A ring of a polygon, its last point the first: the outline or a hole.
  void add_ring(Points ring, bool is_hole, const MapFeature2& feature, const FileLine& where);

  // The scene of all that was added. To be called once. Throws InputError where that is nothing.
  ValidScene2 scene();

 private:
  void drop_repeated_points(Points& points, const FileLine& where);
  void refuse_crossing(const Points& ring, const MapFeature2& feature, const FileLine& where);
  void add(Points points, bool closed, const MapFeature2& feature);
  std::string free_name(const MapFeature2& feature);
  std::uint32_t material(const std::string& name);

  PassedOver& passed_over_;
  std::optional<InputError> instead_;
  Scene2 scene_;
  std::unordered_map<std::string, std::uint32_t> material_;
  DistinctNames names_;
};

}  // namespace hottel
