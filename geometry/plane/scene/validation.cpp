#include "geometry/grid_names.h"
#include "geometry/light_motion.h"
#include "geometry/name.h"
#include "geometry/number.h"
#include "geometry/plane/scene/patch_seats.h"
#include "geometry/plane/scene/scene.h"
#include "kernel/decimal.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

bool has_lowest_terms(const Point2& point) { return is_in_lowest_terms(point.x) && is_in_lowest_terms(point.y); }

bool is_on(const Point2& point, const Edge2& edge) {
  const auto is_between = [](const Rational& a, const Rational& x, const Rational& b) {
    return (a <= x && x <= b) || (b <= x && x <= a);
  };
  if (!is_between(edge.from.x, point.x, edge.to.x) || !is_between(edge.from.y, point.y, edge.to.y)) return false;
  return (edge.to.x - edge.from.x) * (point.y - edge.from.y) == (edge.to.y - edge.from.y) * (point.x - edge.from.x);
}

// What is wrong with where a light is, as the end of a sentence; empty when nothing is.
std::string place_problem(const Scene2& scene, const Light& light, const LightPlace2& place) {
  if (!has_lowest_terms(place.position) || !has_lowest_terms(place.direction))
    return "has a coordinate that is not in lowest terms (mpq_class::canonicalize)";
  if (light.type != LightType::kPoint && place.direction == Point2{0, 0})
    return "shines nowhere: its direction is zero";
  if (light.is_sun()) return place.path ? "is a sun: it has no path" : "";
  for (std::size_t s = 0; s < scene.edges.size(); ++s)
    if (is_on(place.position, scene.edges[s]))
      return "lies on the surface " + quoted_name(scene.surfaces[s].name) + "; a light has to be beside it";
  const auto text_of = [](const Point2& p) { return "(" + short_text(p.x) + ", " + short_text(p.y) + ")"; };
  return place.path ? path_problem(*place.path, place.position, text_of) : "";
}

}  // namespace

std::string grid_problem(const Grid2& grid) {
  if (!has_lowest_terms(grid.min) || !has_lowest_terms(grid.max)) return "a coordinate is not in lowest terms";
  if (grid.max.x <= grid.min.x || grid.max.y <= grid.min.y) return "max must be greater than min in both coordinates";
  const auto is_count = [](std::uint32_t cells) { return cells >= 1 && cells <= kMaxGridCells; };
  if (!is_count(grid.nx) || !is_count(grid.ny))
    return "cells must be integers from 1 to " + std::to_string(kMaxGridCells);
  return "";
}

void validate(const Scene2& scene) {
  HOTTEL_REQUIRE(scene.edges.size() == scene.surfaces.size());
  validate_table(scene);
  for (std::size_t s = 0; s < scene.edges.size(); ++s) {
    const Edge2& edge = scene.edges[s];
    const auto refuse = [&](const std::string& problem) {
      throw InputError({scene.file, scene.surfaces[s].line},
                       "surface " + quoted_name(scene.surfaces[s].name) + " " + problem);
    };
    if (!has_lowest_terms(edge.from) || !has_lowest_terms(edge.to))
      refuse("has a coordinate that is not in lowest terms (mpq_class::canonicalize)");
    if (edge.from == edge.to) refuse("has length zero");
    for (const bool is_back : {false, true})
      if (const auto& leaves = scene.surfaces[s].trees.of(is_back); !leaves.empty())
        HOTTEL_REQUIRE(are_whole(leaves, scene.surfaces[s].elements, 2));
  }
  validate_patches(scene);
  HOTTEL_REQUIRE(scene.light_places.size() == scene.lights.size());
  for (std::size_t k = 0; k < scene.lights.size(); ++k)
    if (const auto problem = place_problem(scene, scene.lights[k], scene.light_places[k]); !problem.empty())
      throw InputError({scene.file, scene.lights[k].line},
                       "light " + quoted_name(scene.lights[k].name) + " " + problem);
  validate_grids(scene.grids, scene.file);
}

void ValidScene2::set_grids(std::vector<Grid2> grids) {
  validate_grids(grids, scene_.file);
  scene_.grids = std::move(grids);
}

}  // namespace hottel
