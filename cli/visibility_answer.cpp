#include "cli/visibility_answer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "geometry/name.h"
#include "geometry/plane/exchange/exchange.h"
#include "kernel/decimal.h"
#include "kernel/support/failure.h"
#include "solver/plane/light/mean_irradiance.h"
#include "solver/radiosity/matrix_checks.h"
#include "solver/radiosity/radiosity.h"
#include "viewer/picture/plane/visibility_picture.h"

namespace hottel {

using Json = nlohmann::ordered_json;

namespace {

bool is_a_double(const Rational& value) {
  const double nearest = to_double(value);
  return std::isfinite(nearest) && Rational(nearest) == value;
}

}  // namespace

std::array<double, 2> rounded(const ExactPoint2& p) { return {to_double(p.x), to_double(p.y)}; }

Json json_of(const Rational& value) { return {{"value", to_double(value)}, {"exact", to_string(value)}}; }

Json json_of(const ExactPoint2& p) {
  return {{"x", to_double(p.x)}, {"y", to_double(p.y)}, {"exact", {to_string(p.x), to_string(p.y)}}};
}

Json json_of(const Rounded& number) {
  const Enclosure bounds = number.enclosure();
  return {{"value", number.value}, {"lower", bounds.lower}, {"upper", bounds.upper}};
}

std::string text_of(const ExactPoint2& p) {
  std::string text = fmt::format("({}, {})", decimal_text(p.x), decimal_text(p.y));
  if (!is_a_double(p.x) || !is_a_double(p.y)) text += fmt::format(" = ({}, {})", to_string(p.x), to_string(p.y));
  return text;
}

std::string name_of(const Scene2& scene, const Arrangement2& arrangement, PieceSideId side) {
  if (side == kSky) return "sky";
  const FacePart& owner = arrangement.owner(side);
  return scene.surfaces[owner.surface].name + (owner.is_back ? ":back" : "");
}

std::string solid_text(const Scene2& scene, std::uint32_t group) {
  return "the solid " + quoted_name(scene.groups[group].name);
}

namespace {

std::string where(const PreparedScene2& prepared, const VisibilityPolygon2& polygon) {
  const Arrangement2& arrangement = prepared.arrangement;
  if (polygon.solid != Solids2::kNone) return "in " + solid_text(prepared.scene, polygon.solid);
  const auto covered = std::find_if(polygon.parts.begin(), polygon.parts.end(),
                                    [](const auto& part) { return part.solid != Solids2::kNone; });
  const bool is_on_solid = covered != polygon.parts.end();
  switch (polygon.location.kind) {
    case Location2::Kind::kInTriangle:
      return "in the open";
    case Location2::Kind::kOutside:
      return "outside the hull of the scene, or on its only line";
    case Location2::Kind::kOnVertex:
      return is_on_solid ? "at a vertex of " + solid_text(prepared.scene, covered->solid) +
                               "; every direction that does not lead into a solid is seen"
                         : "at a vertex; every direction is seen";
    case Location2::Kind::kOnEdge: {
      const HalfEdgeId h = polygon.location.half_edge;
      if (!arrangement.triangulation().is_piece(h)) return "in the open";
      const std::size_t piece = piece_of(arrangement.triangulation().side(h));
      return "on '" + prepared.scene.surfaces[arrangement.sources(piece).front().surface].name +
             (is_on_solid ? "'; one side is seen, the other is in " + solid_text(prepared.scene, covered->solid)
                          : "'; both sides are seen");
    }
  }
  return "";
}

// The mean irradiance at a point once the light has been reflected until it is absorbed, per channel.
void add_mean_irradiance(const PreparedScene2& prepared, const VisibilityPolygon2& seen, Answer& answer) {
  const Vertices2& vertices = prepared.arrangement.vertices();
  const ExchangeMatrix matrix =
      exact_exchange(prepared, {.granularity = Granularity::kFace, .wants_visibility = false});
  const RadiositySolution solution = solve_radiosity(matrix, prepared.scene.materials, prepared.scene.sky_emission, {});
  require_doubles(matrix, prepared.scene.sky_emission, solution);
  const ElementTable2 table(prepared.scene, prepared.arrangement, prepared.division, Granularity::kFace);
  const std::vector<double> sky = sky_by_channel(prepared.scene.sky_emission, solution.channels.size());
  const FaceRadiosity2 faces(prepared.arrangement, table, radiosity_by_element(solution), sky);
  const Eye2 look(vertices, vertices.from_scene(seen.eye));
  std::vector<double> mean(solution.channels.size());
  mean_irradiance(vertices, faces, look, seen.location, seen.view, mean);
  answer.text += "\nmean irradiance\n";
  for (std::size_t c = 0; c < mean.size(); ++c) {
    answer.json["mean_irradiance"][solution.channel_names[c]] = mean[c];
    answer.text += fmt::format("  {:<24} {}\n", solution.channel_names[c], shortest(mean[c]));
  }
}

// From within a solid nothing is seen.
Answer from_solid(const PreparedScene2& prepared, const VisibilityPolygon2& polygon) {
  Answer answer;
  answer.json["at"] = json_of(polygon.eye);
  answer.json["location"] = where(prepared, polygon);
  answer.json["solid"] = prepared.scene.groups[polygon.solid].name;
  answer.json["area"] = nullptr;
  for (const char* list : {"polygon", "parts", "faces"}) answer.json[list] = Json::array();
  answer.json["mean_irradiance"] = nullptr;
  answer.text = fmt::format("from {}, {}: nothing is seen there\nno visibility polygon\nmean irradiance NaN\n",
                            text_of(polygon.eye), where(prepared, polygon));
  answer.draw = [&prepared, polygon](PictureFormat format) {
    VisibilityDrawing drawing;
    drawing.eye = rounded(polygon.eye);
    return visibility_picture_2(prepared, drawing, format);
  };
  return answer;
}

// The fraction of the full turn that leads into solids, where the point is on the border of some.
void add_solids(const PreparedScene2& prepared, const VisibilityPolygon2& polygon, Answer& answer) {
  std::map<std::uint32_t, std::vector<std::size_t>> parts_of;
  for (std::size_t k = 0; k < polygon.parts.size(); ++k)
    if (polygon.parts[k].solid != Solids2::kNone) parts_of[polygon.parts[k].solid].push_back(k);
  if (parts_of.empty()) return;
  answer.json["solids"] = Json::array();
  for (const auto& [solid, parts] : parts_of) {
    const Rounded fraction = rounded_angle_fraction(polygon, parts);
    Json entry{{"solid", prepared.scene.groups[solid].name}};
    entry["angle_fraction"] = json_of(fraction);
    answer.json["solids"].push_back(entry);
    answer.text +=
        fmt::format("  {:<24} {}\n", "(in " + solid_text(prepared.scene, solid) + ")", shortest(fraction.value));
  }
}

}  // namespace

Answer from_point(const PreparedScene2& prepared, const ExactPoint2& eye, bool wants_light) {
  const Arrangement2& arrangement = prepared.arrangement;
  const PointLocation2 location(arrangement.vertices(), arrangement.triangulation());
  const VisibilityPolygon2 polygon = visibility_polygon(arrangement, location, eye);
  if (polygon.solid != Solids2::kNone) return from_solid(prepared, polygon);
  Answer answer;
  answer.json["at"] = json_of(eye);
  answer.json["location"] = where(prepared, polygon);
  answer.json["area"] = polygon.area ? json_of(*polygon.area) : Json();
  answer.text = fmt::format("from {}, {}\n", text_of(eye), where(prepared, polygon));
  answer.text += polygon.area ? fmt::format("area {}{}\n", decimal_text(*polygon.area),
                                            is_a_double(*polygon.area) ? "" : " = " + to_string(*polygon.area))
                              : "area unbounded: the sky is seen\n";
  const std::vector<ExactPoint2> corners = polygon.corners();
  answer.json["polygon"] = Json::array();
  answer.text += "\nvisibility polygon, counter-clockwise\n";
  for (const ExactPoint2& corner : corners) {
    answer.json["polygon"].push_back(json_of(corner));
    answer.text += "  " + text_of(corner) + "\n";
  }

  answer.json["parts"] = Json::array();
  answer.text += "\nseen in turn\n";
  std::vector<std::string> faces;  // in the order of first sight
  std::vector<std::vector<std::size_t>> parts_of;
  for (std::size_t k = 0; k < polygon.parts.size(); ++k) {
    const auto& part = polygon.parts[k];
    if (part.solid != Solids2::kNone) continue;
    const std::string name = name_of(prepared.scene, arrangement, part.side);
    const auto place = std::find(faces.begin(), faces.end(), name) - faces.begin();
    if (place == static_cast<std::ptrdiff_t>(faces.size())) {
      faces.push_back(name);
      parts_of.emplace_back();
    }
    parts_of[static_cast<std::size_t>(place)].push_back(k);
    answer.json["parts"].push_back({{"face", name}, {"from", json_of(part.from)}, {"to", json_of(part.to)}});
    answer.text += fmt::format("  {:<24} {} to {}\n", name, text_of(part.from), text_of(part.to));
  }
  answer.json["faces"] = Json::array();
  answer.text += "\nfraction of the full turn\n";
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const Rounded fraction = rounded_angle_fraction(polygon, parts_of[f]);
    Json entry{{"face", faces[f]}};
    entry["angle_fraction"] = json_of(fraction);
    answer.json["faces"].push_back(entry);
    answer.text += fmt::format("  {:<24} {}\n", faces[f], shortest(fraction.value));
  }
  add_solids(prepared, polygon, answer);

  if (wants_light) {
    try {
      add_mean_irradiance(prepared, polygon, answer);
    } catch (const RequestError& error) {  // no finite light: what is seen stands all the same
      answer.json["mean_irradiance"] = nullptr;
      answer.text += fmt::format("\nno mean irradiance: {}\n", error.what());
    }
  }

  answer.draw = [&prepared, polygon, corners](PictureFormat format) {
    VisibilityDrawing drawing;
    drawing.eye = rounded(polygon.eye);
    for (const auto& part : polygon.parts) {
      if (part.solid != Solids2::kNone) {
        drawing.polygon.push_back(drawing.eye);
        continue;
      }
      // Towards the sky the region is drawn far beyond the picture.
      const auto far = [&](const ExactPoint2& p) {
        const auto [x, y] = rounded(p);
        return std::array<double, 2>{drawing.eye[0] + 1e4 * (x - drawing.eye[0]),
                                     drawing.eye[1] + 1e4 * (y - drawing.eye[1])};
      };
      drawing.polygon.push_back(rounded(part.from));
      if (part.side == kSky) {
        drawing.polygon.push_back(far(part.from));
        drawing.polygon.push_back(far(part.to));
      }
      drawing.polygon.push_back(rounded(part.to));
    }
    return visibility_picture_2(prepared, drawing, format);
  };
  return answer;
}

}  // namespace hottel
