#include "io/results/space/map_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <numbers>
#include <optional>
#include <span>
#include <vector>

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

Json json_of(const VisibilityMap3& map, const VisibilityMap3::Fragment& fragment) {
  Json directions = Json::array(), points = Json::array();
  for (std::uint32_t c = fragment.begin; c < fragment.end; ++c) {
    const VisibilityMap3::Corner& corner = map.corners[c];
    directions.push_back({corner.direction.x, corner.direction.y, corner.direction.z});
    points.push_back({corner.x, corner.y, corner.z});
  }
  return {{"directions", directions}, {"points", points}};
}

// A number with what is proven of it, if that is told.
struct Told {
  double value;
  std::optional<Enclosure> bounds;
};

Told told(double value, const Enclosure* bounds) {
  if (bounds == nullptr) return {value, std::nullopt};
  return {bounds->contains(value) ? value : bounds->lower, *bounds};
}

// What is told of a face, or of the sky.
struct Line {
  std::string name;
  Told factor, fraction;
};

std::vector<Line> lines_of(const Scene3& scene, const VisibilityMap3& map, const PointBounds3* bounds) {
  std::vector<Line> lines;
  for (std::size_t k = 0; k < map.shares.size(); ++k) {
    const VisibilityMap3::Share& share = map.shares[k];
    const PointBounds3::Share* const proven = bounds == nullptr ? nullptr : &bounds->shares[k];
    lines.push_back({face_name(scene, share.face), told(share.factor, proven ? &proven->factor : nullptr),
                     told(share.fraction, proven ? &proven->fraction : nullptr)});
  }
  lines.push_back({"sky", told(not_negative(map.sky_factor), bounds ? &bounds->sky_factor : nullptr),
                   told(not_negative(map.sky_fraction), bounds ? &bounds->sky_fraction : nullptr)});
  return lines;
}

void add_numbers(const Line& line, bool has_factors, Json& json) {
  json["fraction"] = line.fraction.value;
  json["solid_angle"] = solid_angle(line.fraction.value);
  if (has_factors) json["factor"] = line.factor.value;
  if (!line.fraction.bounds) return;
  json["bounds"]["fraction"] = {line.fraction.bounds->lower, line.fraction.bounds->upper};
  if (has_factors) json["bounds"]["factor"] = {line.factor.bounds->lower, line.factor.bounds->upper};
}

// The shares, fragment by fragment of each: both lists are by face.
Json faces_of(const VisibilityMap3& map, std::span<const Line> lines, bool has_factors) {
  Json faces = Json::array();
  auto fragment = map.fragments.begin();
  for (std::size_t k = 0; k < map.shares.size(); ++k) {
    const Face& of = map.shares[k].face;
    Json face{{"name", lines[k].name}};
    add_numbers(lines[k], has_factors, face);
    Json pieces = Json::array();
    while (fragment != map.fragments.end() && fragment->face < of) ++fragment;
    for (; fragment != map.fragments.end() && fragment->face == of; ++fragment)
      pieces.push_back(json_of(map, *fragment));
    face["pieces"] = std::move(pieces);
    faces.push_back(std::move(face));
  }
  return faces;
}

std::string columns_of(const Told& number) {
  std::string text = fmt::format("{:<24} ", shortest(number.value));
  if (number.bounds)
    text += fmt::format("{:<24} {:<24} ", shortest(number.bounds->lower), shortest(number.bounds->upper));
  return text;
}

std::string titles_of(const char* title, bool has_bounds) {
  return has_bounds ? fmt::format("{:<24} {:<24} {:<24} ", title, "at least", "at most")
                    : fmt::format("{:<24} ", title);
}

// With bounds of the factors, or where there are none of the fractions.
std::string text_of(const Solids3& solids, const VisibilityMap3& map, std::span<const Line> lines,
                    const std::string& what, bool has_factors) {
  const bool has_bounds = lines.back().fraction.bounds.has_value();
  std::string text = "from " + what + "\n\n  ";
  if (has_factors) text += titles_of("view factor", has_bounds);
  text += titles_of("fraction of the sphere", has_bounds && !has_factors) + "solid angle [sr]\n";
  const auto add = [&](Line line) {
    if (has_factors) line.fraction.bounds.reset();
    text += "  " + (has_factors ? columns_of(line.factor) : "") + columns_of(line.fraction);
    text += fmt::format("{:<24} {}\n", shortest(solid_angle(line.fraction.value)), line.name);
  };
  for (const Line& line : lines) add(line);
  for (const VisibilityMap3::InSolid& solid : map.solids)
    add({"(in the solid " + quoted_name(solid_name(solids, solid.mesh)) + ")", {}, {solid.fraction, std::nullopt}});
  return text + "\n" + counted(map.fragments.size(), "piece") + " of " + counted(map.shares.size(), "face") + "\n";
}

}  // namespace

VisibilityAnswer map_answer(const Scene3& scene, const Solids3& solids, const Look3& look, const VisibilityMap3& map,
                            const std::string& what, const PointBounds3* bounds) {
  const bool has_factors = look.normal.has_value();
  const std::vector<Line> lines = lines_of(scene, map, bounds);
  Json json{{"at", exact_point(look.eye)}};
  if (has_factors) json["normal"] = exact_point(*look.normal);
  json["faces"] = faces_of(map, lines, has_factors);
  add_numbers(lines.back(), has_factors, json["sky"]);
  for (const VisibilityMap3::InSolid& solid : map.solids)
    json["solids"].push_back({{"solid", solid_name(solids, solid.mesh)},
                              {"fraction", solid.fraction},
                              {"solid_angle", solid_angle(solid.fraction)}});
  json["tiers"] = {
      {"filter", map.signs.by_tier[0]}, {"combinatorial", map.signs.by_tier[1]}, {"exact", map.signs.by_tier[2]}};
  return {json.dump(2) + "\n", text_of(solids, map, lines, what, has_factors)};
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
