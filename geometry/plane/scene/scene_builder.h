// Scenes in the plane, made in code.
//
//   SceneBuilder2 scene;
//   scene.add_material("white", {.reflectivity = "0.7"}).add_material("glow", {.emission = 10});
//   scene.add_polyline("room", {{0, 0}, {0, 3}, {4, 3}, {4, 0}}, "white", {.closed = true});
//   scene.add_edge("lamp", {1, "2.9"}, {"4/3", "2.9"}, "glow", {.back = "white"});
//   std::printf("F = %.12g\n", view_factor(Simulation2(scene.build()), "lamp", "room[3]").value);
#pragma once

#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

#include "geometry/number.h"
#include "geometry/plane/scene/scene.h"

namespace hottel {

// A point as one writes it: {0, "1/3"}, {0.5, 2}, or a Point2.
struct TypedPoint2 {
  Number x, y;

  TypedPoint2(Number its_x, Number its_y) : x(std::move(its_x)), y(std::move(its_y)) {}
  TypedPoint2(const Point2& point) : x(point.x), y(point.y) {}
};

// A spectrum as one writes it: one number for all channels, or {r, g, b}. Without numbers it is 0.
struct TypedSpectrum {
  std::vector<Number> numbers;  // none, one or three

  TypedSpectrum() = default;
  template <class T>
  requires std::convertible_to<T, Number> TypedSpectrum(const T& number) : numbers{Number(number)} {}
  TypedSpectrum(const Number& r, const Number& g, const Number& b) : numbers{r, g, b} {}
};

// The properties of a material, as in a scene file: reflectivity and emission, or emissivity and temperature [K].
struct MaterialOptions {
  TypedSpectrum reflectivity = {}, emission = {};
  TypedSpectrum emissivity = {}, temperature = {};
  bool insulated = false;   // reflectivity 1 and emission 0; excludes all other spectra
  TypedSpectrum flux = {};  // the net flux [W/m²], one number of any sign, with one emissivity above 0
  bool two_sided = false;   // its edges have it on their backs too, unless they have one of their own or are patches
};

// Options of edges and polylines besides their points and their material, as in a scene file.
struct EdgeOptions2 {
  std::string back = {};  // the material of the back; empty: opaque and black
  std::uint32_t elements = 1;
  Behind behind = Behind::kByOutline;
  std::string on = {};  // what it is a patch on: the name of an edge or polyline, or NAME:back; empty: none
};
struct PolylineOptions2 {
  bool closed = false;
  std::string back = {};
  std::uint32_t elements = 1;  // of each piece
  Behind behind = Behind::kByOutline;
  std::string on = {};
};

// Makes a scene step by step. Each call refuses at once what contradicts an earlier call, or is not allowed.
//
//   (1) build() gives the scene that a file of the same entries gives, but all line numbers are 0: edges first, then
//       polylines, each in the order in which they were added; materials and groups in that order too
//   (2) names are as in a file: pieces of a polyline are NAME[k]; an empty name is "edge[k]" or "polyline[k]", k its
//       place among edges or polylines, from 0
//   (3) numbers are exact (Number); the front of an edge is right of from -> to, so that a room is listed clockwise
//   (4) after a throw the builder is as it was before the call
//   (5) build() puts patches onto their bases where they are off by rounding of doubles (seat_patches)
//
// Every function but the constructor throws InputError, naming the edge, polyline, piece or material, for what
// docs/scene_format.md does not allow; build() for names that are not unique.
class SceneBuilder2 {
 public:
  // title: what messages call the scene.
  explicit SceneBuilder2(std::string title = "scene made in code");

  // A material comes before the edges that have it.
  SceneBuilder2& add_material(const std::string& name, const MaterialOptions& options = {});
  SceneBuilder2& add_edge(const std::string& name, const TypedPoint2& from, const TypedPoint2& to,
                          const std::string& material, const EdgeOptions2& options = {});
  SceneBuilder2& add_polyline(const std::string& name, const std::vector<TypedPoint2>& points,
                              const std::string& material, const PolylineOptions2& options = {});
  // What the sky sends out; it is dark where nothing is said.
  SceneBuilder2& set_sky(const TypedSpectrum& emission);
  // The same by its temperature [K]: it sends out sigma T⁴.
  SceneBuilder2& set_sky_temperature(const TypedSpectrum& temperature);
  // The only grid on which light is computed. It replaces all grids that were set or added before.
  SceneBuilder2& set_grid(const TypedPoint2& min, const TypedPoint2& max, std::uint32_t nx, std::uint32_t ny);
  // One more grid, with a name that no other has.
  SceneBuilder2& add_grid(const std::string& name, const TypedPoint2& min, const TypedPoint2& max, std::uint32_t nx,
                          std::uint32_t ny);
  // Promises that no front with a material sees the sky, or takes the promise back.
  SceneBuilder2& set_closed(bool closed = true);
  SceneBuilder2& set_about(std::string about);
  // The unit of length, as "unit" of a scene file: "mm". Coordinates stay as typed; areas and powers of results are in
  // SI where hottel knows the unit (unit_of_length.h). Without it: m.
  SceneBuilder2& set_unit(std::string unit);

  // The scene. The builder keeps what it has: more may be added, and another scene made.
  ValidScene2 build() const;

 private:
  std::uint32_t material_of(const std::string& owner, const char* part, const std::string& name) const;
  Surface surface_of(const std::string& owner, const std::string& material, const std::string& back,
                     std::uint32_t elements) const;
  void put_on(Surface& surface, const std::string& owner, const std::string& base, Behind behind);

  Scene2 scene_;      // of the edges
  Scene2 polylines_;  // of these alone, with groups of their own
  std::unordered_map<std::string, std::uint32_t> material_index_;
};

}  // namespace hottel
