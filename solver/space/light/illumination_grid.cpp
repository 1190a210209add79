#include "solver/space/light/illumination_grid.h"

#include <algorithm>
#include <limits>
#include <span>
#include <utility>

#include "geometry/space/exchange/element_table.h"
#include "geometry/space/exchange/prepared_scene.h"
#include "geometry/space/visibility/convex_cut.h"
#include "geometry/space/visibility/direction.h"
#include "geometry/space/visibility/point_map.h"
#include "kernel/support/parallel.h"
#include "kernel/support/progress_count.h"
#include "kernel/support/stopwatch.h"
#include "solver/space/light/scene_lights.h"

namespace hottel {
namespace {

using Cone = std::vector<Direction3>;

// What the sides of pieces send out, element by element.
class SentOut {
 public:
  SentOut(const PreparedScene3& prepared, Granularity granularity, const RadiositySolution& solution)
      : prepared_(prepared),
        table_(prepared.scene, prepared.arrangement(), prepared.blockers(), granularity),
        solution_(solution),
        parts_(2 * prepared.blockers().size()) {
    for (const ElementTable3::Part& part : table_.parts()) {
      if (part.patch.is_sky() || !table_.has_row(part.label)) continue;
      Side& side = parts_[Face{part.patch.surface, part.is_back}.number()];
      side.is_divided = side.is_divided || (!side.parts.empty() && side.parts[0].label != part.label);
      side.parts.push_back({part.label, {}});
      for (const Point3& corner : corners_of(prepared.blockers().vertices(), part.patch))
        side.parts.back().corners.push_back({to_double(corner.x), to_double(corner.y), to_double(corner.z)});
    }
    for (const Rational& emission : prepared.scene.sky_emission.value) sky_.push_back(to_double(emission));
  }

  // Writes the mean over all directions; nothing outside a closed scene, where no face with a material is seen.
  void mean(const Point3& eye, std::span<double> result) const {
    const PointMap3 map = map_from(prepared_.blockers(), {.eye = eye, .normal = {}});
    const auto is_black = [this](const PointMap3::Fragment& fragment) {
      return parts_[fragment.face.number()].parts.empty();
    };
    if (prepared_.scene.closed && std::ranges::all_of(map.fragments, is_black)) return;
    std::fill(result.begin(), result.end(), 0.0);
    for (const PointMap3::Fragment& fragment : map.fragments) {
      const Side& side = parts_[fragment.face.number()];
      if (side.parts.empty()) continue;
      if (!side.is_divided)
        add(side.parts[0].label, fragment.fraction, result);
      else
        add_divided(map, fragment, side, eye, result);
    }
    for (std::size_t c = 0; c < result.size(); ++c) result[c] += map.sky_fraction * sky_[c];
  }

 private:
  struct Part {
    std::uint32_t label;
    std::vector<Direction3> corners;  // in scene coordinates
  };
  struct Side {
    bool is_divided = false;  // its parts are of several elements
    std::vector<Part> parts;
  };

  void add(std::uint32_t label, double fraction, std::span<double> result) const {
    for (std::size_t c = 0; c < result.size(); ++c)
      result[c] += fraction * solution_.channels[c].elements[label].radiosity;
  }

  // The fragment by its elements, in the proportion of their solid angles.
  void add_divided(const PointMap3& map, const PointMap3::Fragment& fragment, const Side& side, const Point3& eye,
                   std::span<double> result) const {
    Cone whole;
    for (std::uint32_t c = fragment.begin; c < fragment.end; ++c) whole.push_back(map.corners[c].direction);
    std::vector<double> fractions;
    double sum = 0;
    const Direction3 from{to_double(eye.x), to_double(eye.y), to_double(eye.z)};
    for (const Part& part : side.parts) {
      fractions.push_back(fraction_of(whole, part, from));
      sum += fractions.back();
    }
    if (!(sum > 0)) return add(side.parts[0].label, fragment.fraction, result);
    for (std::size_t k = 0; k < side.parts.size(); ++k)
      add(side.parts[k].label, fragment.fraction * (fractions[k] / sum), result);
  }

  static double fraction_of(Cone cone, const Part& part, const Direction3& eye) {
    Cone ways;
    for (const Direction3& corner : part.corners) ways.push_back(unit(corner - eye));
    cone = common_cone_3(std::move(cone), ways);
    return cone.size() > 2 ? std::max(0.0, solid_angle_fraction_3(cone)) : 0;
  }

  const PreparedScene3& prepared_;
  ElementTable3 table_;
  const RadiositySolution& solution_;
  std::vector<Side> parts_;  // by side of a piece
  std::vector<double> sky_;
};

}  // namespace

IlluminationGrid3 illuminate_points(const PreparedScene3& prepared, Granularity granularity,
                                    const RadiositySolution& solution, const Grid3& grid,
                                    const std::function<void(double)>& progress) {
  Stopwatch watch;
  const SentOut sent_out(prepared, granularity, solution);
  const SceneLights3 lights(prepared);
  IlluminationGrid3 result{grid, static_cast<std::uint32_t>(solution.channels.size()), {}};
  const std::size_t cells = std::size_t{grid.nu} * grid.nv;
  result.values.assign(cells * result.channels, std::numeric_limits<double>::quiet_NaN());
  ProgressCount count(progress, cells);
  parallel_for(
      cells,
      [&](std::size_t cell) {
        const Rational s = Rational(2 * (cell % grid.nu) + 1) / Rational(2 * std::size_t{grid.nu});
        const Rational t = Rational(2 * (cell / grid.nu) + 1) / Rational(2 * std::size_t{grid.nv});
        const Point3 centre{grid.origin.x + s * grid.u.x + t * grid.v.x, grid.origin.y + s * grid.u.y + t * grid.v.y,
                            grid.origin.z + s * grid.u.z + t * grid.v.z};
        if (!prepared.arrangement().solids().around(centre)) {
          const std::span<double> here(result.values.data() + cell * result.channels, result.channels);
          sent_out.mean(centre, here);
          lights.add(centre, here);
        }
        count.add(1);
      },
      4);
  result.seconds = watch.lap();
  return result;
}

}  // namespace hottel
