#include "io/results/plane/edge_report.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "geometry/scene_names.h"
#include "io/results/csv_field.h"
#include "kernel/decimal.h"
#include "kernel/support/failure.h"
#include "kernel/written_double.h"

namespace hottel {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const Rational& value) { return {{"value", to_double(value)}, {"exact", to_string(value)}}; }

Json json_of(const Point2& p) {
  Json result{{"x", to_double(p.x)}, {"y", to_double(p.y)}};
  result["exact"] = {to_string(p.x), to_string(p.y)};
  return result;
}

Json json_of(const Edge2& edge, const Rational& t) {
  Json result{{"t", json_of(t)}};
  result["at"] = json_of(point_at(edge, t));
  return result;
}

std::string along_name(const PreparedScene2& prepared, const CriticalLine2& line) {
  if (line.along == kNoPiece) return "";
  return prepared.scene.surfaces[prepared.arrangement.sources(piece_of(line.along)).front().surface].name;
}

std::string coordinate_text(const Rational& value, bool is_exact) {
  if (is_exact) return to_string(value);
  const double written = written_double(value);
  require_double(written, "a coordinate of a critical line", "; --exact writes it");
  return shortest(written);
}

std::string point_text(const Point2& p, bool is_exact) {
  return coordinate_text(p.x, is_exact) + "," + coordinate_text(p.y, is_exact);
}

}  // namespace

std::string met_name(const PreparedScene2& prepared, PieceSideId side) {
  if (side != kSky && prepared.arrangement.is_covered(side)) return "#solid";
  return face_name(prepared.scene, prepared.arrangement, side);
}

VisibilityAnswer edge_answer(const PreparedScene2& prepared, const std::string& name, const WeakVisibility2& sight) {
  Json json;
  json["edge"] = name;
  json["sees_sky"] = sight.sees_sky;
  json["faces"] = Json::array();
  std::string text = fmt::format("what some point of '{}' sees\n", name);
  for (const SeenFace2& seen : sight.faces) {
    const Edge2& edge = prepared.scene.edges[seen.face.surface];
    const std::string face = face_name(prepared.scene, seen.face);
    Json entry{{"face", face}};
    entry["share"] = json_of(seen.share);
    entry["stretches"] = Json::array();
    text += fmt::format("  {:<24} {}\n", face, decimal_text(seen.share));
    for (const Stretch2& stretch : seen.stretches) {
      Json ends;
      ends["from"] = json_of(edge, stretch.begin);
      ends["to"] = json_of(edge, stretch.end);
      entry["stretches"].push_back(std::move(ends));
      text += fmt::format("    t = {} to {}\n", to_string(stretch.begin), to_string(stretch.end));
    }
    json["faces"].push_back(std::move(entry));
  }
  text += sight.sees_sky ? "  sky\n" : "";
  return {json.dump(2) + "\n", text};
}

void write_critical_lines_csv(const PreparedScene2& prepared, std::span<const CriticalLine2> lines, bool is_exact,
                              const std::function<void(std::string_view)>& sink) {
  sink(
      "x0,y0,x1,y1,along,behind_x,behind_y,behind_left,behind_right,ahead_x,ahead_y,ahead_left,ahead_right,"
      "from_behind_left,from_behind_right,from_ahead_left,from_ahead_right\n");
  for (const CriticalLine2& line : lines) {
    std::string text = point_text(line.from, is_exact) + "," + point_text(line.to, is_exact) + "," +
                       csv_field(along_name(prepared, line));
    for (const LineReach2* reach : {&line.behind, &line.ahead}) {
      text += "," + (reach->end ? point_text(*reach->end, is_exact) : ",");
      for (const PieceSideId side : {reach->left, reach->right}) text += "," + csv_field(met_name(prepared, side));
    }
    for (const LineReach2* reach : {&line.behind, &line.ahead})
      for (const PieceSideId side : {reach->seen_from_left, reach->seen_from_right})
        text += "," + (side == kNoPiece ? "" : csv_field(met_name(prepared, side)));
    sink(text + "\n");
  }
}

std::string critical_lines_json(const PreparedScene2& prepared, std::span<const CriticalLine2> lines) {
  Json json;
  json["lines"] = Json::array();
  for (const CriticalLine2& line : lines) {
    Json entry;
    entry["vertices"] = {json_of(line.from), json_of(line.to)};
    const std::string along = along_name(prepared, line);
    entry["along"] = along.empty() ? Json() : Json(along);
    const auto add = [&](const char* key, const LineReach2& reach) {
      entry[key]["end"] = reach.end ? json_of(*reach.end) : Json();
      entry[key]["left"] = met_name(prepared, reach.left);
      entry[key]["right"] = met_name(prepared, reach.right);
      const auto seen = [&](PieceSideId side) { return side == kNoPiece ? Json() : Json(met_name(prepared, side)); };
      entry[key]["seen_from_left"] = seen(reach.seen_from_left);
      entry[key]["seen_from_right"] = seen(reach.seen_from_right);
    };
    add("behind", line.behind);
    add("ahead", line.ahead);
    json["lines"].push_back(std::move(entry));
  }
  return json.dump(2) + "\n";
}

}  // namespace hottel
