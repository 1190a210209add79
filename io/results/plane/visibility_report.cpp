#include "io/results/plane/visibility_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "geometry/name.h"
#include "geometry/scene_names.h"
#include "geometry/unit_of_length.h"
#include "geometry/visibility_quotient.h"
#include "kernel/decimal.h"
#include "kernel/exact_double.h"

namespace hottel {
namespace {

using Json = nlohmann::ordered_json;

// An answer while it is made.
struct Draft {
  Json json;
  std::string text;

  VisibilityAnswer done() const { return {json.dump(2) + "\n", text}; }
};

bool is_a_double(const Rational& value) {
  const double nearest = to_double(value);
  return std::isfinite(nearest) && exact_value(nearest) == value;
}

Json json_of(const Rational& value) { return {{"value", to_double(value)}, {"exact", to_string(value)}}; }

Json json_of(const Point2& p) {
  return {{"x", to_double(p.x)}, {"y", to_double(p.y)}, {"exact", {to_string(p.x), to_string(p.y)}}};
}

Json json_of(const Rounded& number) {
  const Enclosure bounds = number.enclosure();
  return {{"value", number.value}, {"lower", bounds.lower}, {"upper", bounds.upper}};
}

// People do not read longer fractions; the JSON has them.
constexpr std::size_t kLongestFraction = 40;

// "12", "0.3333333333333333 = 1/3" where a decimal would not say all, "≈ 0.3333333333333333" for a long fraction.
std::string text_of(const Rational& value) {
  if (is_a_double(value)) return decimal_text(value);
  const std::string exact = to_string(value);
  return exact.size() > kLongestFraction ? "≈ " + decimal_text(value) : decimal_text(value) + " = " + exact;
}

// "(1.5, 0.3333333333333333) = (3/2, 1/3)", the same way.
std::string text_of(const Point2& p) {
  const std::string text = fmt::format("({}, {})", decimal_text(p.x), decimal_text(p.y));
  if (is_a_double(p.x) && is_a_double(p.y)) return text;
  const std::string x = to_string(p.x), y = to_string(p.y);
  return std::max(x.size(), y.size()) > kLongestFraction ? "≈ " + text : fmt::format("{} = ({}, {})", text, x, y);
}

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
      return arrangement.triangulation().triangle_count() > 0 ? "outside the convex hull of the scene"
                                                              : "on or beside the line that holds the whole scene";
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

// From within a solid nothing is seen.
VisibilityAnswer from_solid(const PreparedScene2& prepared, const VisibilityPolygon2& polygon) {
  Draft answer;
  answer.json["at"] = json_of(polygon.eye);
  answer.json["location"] = where(prepared, polygon);
  answer.json["solid"] = prepared.scene.groups[polygon.solid].name;
  answer.json["area"] = nullptr;
  for (const char* list : {"polygon", "parts", "faces"}) answer.json[list] = Json::array();
  answer.json["mean_irradiance"] = nullptr;
  answer.text = fmt::format("from {}, {}: nothing is seen there\nno visibility polygon\nmean irradiance NaN\n",
                            text_of(polygon.eye), where(prepared, polygon));
  return answer.done();
}

void add_polygon(const PreparedScene2& prepared, const VisibilityPolygon2& polygon, Draft& answer) {
  answer.json["at"] = json_of(polygon.eye);
  answer.json["location"] = where(prepared, polygon);
  answer.json["area"] = polygon.area ? json_of(*polygon.area) : Json();
  answer.text = fmt::format("from {}, {}\n", text_of(polygon.eye), where(prepared, polygon));
  answer.text += polygon.area ? "area " + text_of(*polygon.area) + "\n" : "area unbounded: the sky is seen\n";
  answer.json["polygon"] = Json::array();
  answer.text += "\nvisibility polygon, counter-clockwise\n";
  for (const Point2& corner : polygon.corners()) {
    answer.json["polygon"].push_back(json_of(corner));
    answer.text += "  " + text_of(corner) + "\n";
  }
  answer.json["parts"] = Json::array();
  answer.text += "\nseen in turn\n";
  for (const auto& part : polygon.parts) {
    if (part.solid != Solids2::kNone) continue;
    const std::string name = face_name(prepared.scene, prepared.arrangement, part.side);
    answer.json["parts"].push_back({{"face", name}, {"from", json_of(part.from)}, {"to", json_of(part.to)}});
    answer.text += fmt::format("  {:<24} {} to {}\n", name, text_of(part.from), text_of(part.to));
  }
}

// The fractions of the full turn: of what is seen, and of directions that lead into solids, where the point is on the
// border of some.
void add_fractions(const PointView2& sight, Draft& answer) {
  const auto add = [&](const char* list, const char* key, const SeenFrom2& seen, const std::string& text) {
    Json entry{{key, seen.name}};
    entry["angle_fraction"] = json_of(seen.fraction);
    answer.json[list].push_back(entry);
    answer.text += fmt::format("  {:<24} {}\n", text, shortest(seen.fraction.value));
  };
  answer.json["faces"] = Json::array();
  answer.text += "\nfraction of the full turn\n";
  for (const SeenFrom2& face : sight.faces) add("faces", "face", face, face.name);
  for (const SeenFrom2& solid : sight.solids)
    add("solids", "solid", solid, "(in the solid " + quoted_name(solid.name) + ")");
}

void add_light(const PointLight2& light, Draft& answer) {
  if (!light.why_none.empty()) {  // no finite light: what is seen stands all the same
    answer.json["mean_irradiance"] = nullptr;
    answer.text += fmt::format("\nno mean irradiance: {}\n", light.why_none);
    return;
  }
  const bool is_nowhere = std::ranges::any_of(light.mean_irradiance, [](double value) { return std::isnan(value); });
  answer.text += is_nowhere
                     ? "\nno mean irradiance: the scene is promised to be closed, and no face with a material is seen\n"
                     : "\nmean irradiance\n";
  for (std::size_t c = 0; c < light.mean_irradiance.size(); ++c) {
    answer.json["mean_irradiance"][light.channel_names[c]] = light.mean_irradiance[c];
    if (!is_nowhere)
      answer.text += fmt::format("  {:<24} {}\n", light.channel_names[c], shortest(light.mean_irradiance[c]));
  }
}

}  // namespace

VisibilityAnswer point_answer(const PreparedScene2& prepared, const PointView2& sight,
                              const std::optional<PointLight2>& light) {
  if (sight.polygon.solid != Solids2::kNone) return from_solid(prepared, sight.polygon);
  Draft answer;
  add_polygon(prepared, sight.polygon, answer);
  add_fractions(sight, answer);
  if (light) add_light(*light, answer);
  return answer.done();
}

VisibilityAnswer face_point_answer(const PreparedScene2& prepared, const std::string& name, const Face& face,
                                   const Rational& t, const std::vector<FaceFactor2>& factors) {
  const Point2 x = point_at(prepared.scene.edges[face.surface], t);
  Draft answer;
  answer.json["on"] = name;
  answer.json["t"] = json_of(t);
  answer.json["at"] = json_of(x);
  answer.json["factors"] = Json::array();
  answer.text = fmt::format("view factors from the point t = {} of '{}', {}\n", to_string(t), name, text_of(x));
  for (const auto& [to, factor] : factors) {
    const Rounded value = round_quotient(factor, RootSum(Rational(1))).number;
    Json entry{{"to", to}};
    entry["factor"] = json_of(value);
    entry["exact"] = factor.to_string();
    answer.json["factors"].push_back(entry);
    answer.text += fmt::format("  {:<24} {:<22} = {}\n", to, shortest(value.value), factor.to_string());
  }
  return answer.done();
}

namespace {

// The closed form is in the unit, the decimal in metres where that is known.
void add_measure(const char* key, const std::string& label, const RootSum& measure, const std::string& unit,
                 Draft& answer) {
  const std::string form = measure.to_string();
  const Rational metres = metres_of(unit).value_or(1);
  const RootSum told = measure * metres;
  answer.json[key] = json_of(round_quotient(told, RootSum(Rational(1))).number);
  answer.json[key]["exact"] = form;
  answer.text += metres == 1
                     ? fmt::format("  {:<28} {:<22} = {}\n", label, decimal_text(told), form)
                     : fmt::format("  {:<28} {:<22} = {} in {}\n", label, decimal_text(told) + " m", form, unit);
}

// Of what has no area, as the sky, there is no quotient.
void add_quotient(const char* key, const std::string& label, const RootSum& numerator, const RootSum& denominator,
                  bool is_visibility, Draft& answer) {
  answer.json[key] = nullptr;
  if (denominator.is_zero()) return;
  const Rounded quotient = round_quotient(numerator, denominator).number;
  const double value = is_visibility ? visibility_of(quotient) : quotient.value;
  answer.json[key] = json_of(quotient);
  answer.json[key]["value"] = value;
  answer.text += fmt::format("  {:<28} {:<22}\n", label, shortest(value));
}

void add_critical_points(const PairSight2& sight, Draft& answer) {
  answer.json["critical_points"] = Json::array();
  answer.text += sight.face_from ? fmt::format("critical points on '{}': {}\n", sight.from, sight.critical.size())
                                 : "critical points are those of a face: the sky has none\n";
  for (const CriticalPoint2& c : sight.critical) {
    Json entry;
    entry["t"] = json_of(c.t);
    entry["at"] = json_of(c.point);
    entry["kind"] = c.is_jump ? "D0" : "D1";
    entry["past"] = {json_of(c.near), json_of(c.far)};
    answer.json["critical_points"].push_back(entry);
    answer.text += fmt::format("  {} t = {:<12} {} past {} and {}\n", c.is_jump ? "D0" : "D1", to_string(c.t),
                               text_of(c.point), text_of(c.near), text_of(c.far));
  }
}

}  // namespace

VisibilityAnswer pair_answer(const PairSight2& sight) {
  const ExactPair2& pair = sight.pair;
  Draft answer;
  answer.json["from"] = sight.from;
  answer.json["to"] = sight.to;
  answer.text = fmt::format("'{}' and '{}'\n", sight.from, sight.to);
  add_measure("exchange", "S, direct exchange area", pair.exchange, sight.unit, answer);
  add_measure("unobstructed", "S0, everything else removed", pair.unobstructed, sight.unit, answer);
  add_quotient("visibility", "Vis = S / S0", pair.exchange, pair.unobstructed, true, answer);
  const auto add_area = [&](const char* key, const std::string& name, const RootSum& area, bool is_face) {
    if (is_face)
      add_measure(key, "A of '" + name + "'", area, sight.unit, answer);
    else
      answer.json[key] = nullptr;
  };
  add_area("area_from", sight.from, pair.area_from, sight.face_from.has_value());
  add_area("area_to", sight.to, pair.area_to, sight.face_to.has_value());
  add_quotient("factor", "F from '" + sight.from + "'", pair.exchange, pair.area_from, false, answer);
  add_quotient("factor_back", "F from '" + sight.to + "'", pair.exchange, pair.area_to, false, answer);
  add_critical_points(sight, answer);
  return answer.done();
}

}  // namespace hottel
