#include "io/results/space/map_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <numbers>

#include "geometry/name.h"
#include "geometry/scene_names.h"
#include "geometry/space/arrangement/solids.h"
#include "geometry/space/scene/scene.h"
#include "io/results/space/exact_point.h"
#include "kernel/support/counted.h"

namespace hottel {
namespace {

using Json = nlohmann::ordered_json;

std::string solid_name(const Solids3& solids, std::uint32_t mesh) { return solids.meshes()[mesh].name; }

// What is left of 1 may be less than nothing by rounding.
double not_negative(double rest) { return std::max(0.0, rest); }

double solid_angle(double fraction) { return 4 * std::numbers::pi * fraction; }

Json json_of(const PointMap3& map, const PointMap3::Fragment& fragment) {
  Json directions = Json::array(), points = Json::array();
  for (std::uint32_t c = fragment.begin; c < fragment.end; ++c) {
    const PointMap3::Corner& corner = map.corners[c];
    directions.push_back({corner.direction.x, corner.direction.y, corner.direction.z});
    points.push_back({corner.x, corner.y, corner.z});
  }
  return {{"directions", directions}, {"points", points}};
}

// The shares, fragment by fragment of each: both lists are by face.
Json faces_of(const Scene3& scene, const PointMap3& map, bool has_factors) {
  Json faces = Json::array();
  auto fragment = map.fragments.begin();
  for (const PointMap3::Share& share : map.shares) {
    Json face{{"name", face_name(scene, share.face)},
              {"fraction", share.fraction},
              {"solid_angle", solid_angle(share.fraction)}};
    if (has_factors) face["factor"] = share.factor;
    Json pieces = Json::array();
    while (fragment != map.fragments.end() && fragment->face < share.face) ++fragment;
    for (; fragment != map.fragments.end() && fragment->face == share.face; ++fragment)
      pieces.push_back(json_of(map, *fragment));
    face["pieces"] = std::move(pieces);
    faces.push_back(std::move(face));
  }
  return faces;
}

std::string text_of(const Scene3& scene, const Solids3& solids, const PointMap3& map, const std::string& what,
                    bool has_factors) {
  std::string text = "from " + what + "\n\n";
  text += has_factors ? "  view factor              fraction of the sphere   solid angle [sr]\n"
                      : "  fraction of the sphere   solid angle [sr]\n";
  const auto line = [&](double factor, double fraction, const std::string& name) {
    text += "  ";
    if (has_factors) text += fmt::format("{:<24} ", shortest(factor));
    text += fmt::format("{:<24} {:<24} {}\n", shortest(fraction), shortest(solid_angle(fraction)), name);
  };
  for (const PointMap3::Share& share : map.shares) line(share.factor, share.fraction, face_name(scene, share.face));
  line(not_negative(map.sky_factor), not_negative(map.sky_fraction), "sky");
  for (const PointMap3::InSolid& solid : map.solids)
    line(0, solid.fraction, "(in the solid " + quoted_name(solid_name(solids, solid.mesh)) + ")");
  return text + "\n" + counted(map.fragments.size(), "piece") + " of " + counted(map.shares.size(), "face") + "\n";
}

}  // namespace

VisibilityAnswer map_answer(const Scene3& scene, const Solids3& solids, const Look3& look, const PointMap3& map,
                            const std::string& what) {
  const bool has_factors = look.normal.has_value();
  Json json{{"at", exact_point(look.eye)}};
  if (has_factors) json["normal"] = exact_point(*look.normal);
  json["faces"] = faces_of(scene, map, has_factors);
  const double sky = not_negative(map.sky_fraction);
  json["sky"] = {{"fraction", sky}, {"solid_angle", solid_angle(sky)}};
  if (has_factors) json["sky"]["factor"] = not_negative(map.sky_factor);
  for (const PointMap3::InSolid& solid : map.solids)
    json["solids"].push_back({{"solid", solid_name(solids, solid.mesh)},
                              {"fraction", solid.fraction},
                              {"solid_angle", solid_angle(solid.fraction)}});
  json["tiers"] = {
      {"filter", map.signs.by_tier[0]}, {"combinatorial", map.signs.by_tier[1]}, {"exact", map.signs.by_tier[2]}};
  return {json.dump(2) + "\n", text_of(scene, solids, map, what, has_factors)};
}

VisibilityAnswer answer_in_solid_3(const Look3& look, const std::string& solid, const std::string& what) {
  const Json json{{"at", exact_point(look.eye)},
                  {"solid", solid},
                  {"faces", Json::array()},
                  {"sky", {{"fraction", 0}, {"solid_angle", 0}}},
                  {"irradiance", nullptr}};
  return {json.dump(2) + "\n", "from " + what + ": in the solid " + quoted_name(solid) + "; nothing is seen\n"};
}

}  // namespace hottel
