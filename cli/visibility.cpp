// hottel visibility: what a point sees, what a point of a face receives, what two faces see of each other.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cli/command.h"
#include "cli/scene_input.h"
#include "cli/visibility_answer.h"
#include "geometry/name.h"
#include "geometry/plane/check/face_cover.h"
#include "geometry/plane/exchange/closed_forms.h"
#include "geometry/plane/exchange/pair_rounding.h"
#include "geometry/plane/visibility/critical_points.h"
#include "geometry/plane/visibility/visibility_polygon.h"
#include "io/scene/scene_json.h"
#include "kernel/decimal.h"
#include "kernel/support/failure.h"
#include "viewer/picture/plane/visibility_picture.h"

namespace hottel {
namespace {

using Json = nlohmann::ordered_json;

struct VisibilityOptions {
  std::string scene, at, on, from, to, out;
  bool json = false;
};

Rational number(const std::string& text, const std::string& option) {
  const auto value = parse_rational(text);
  if (!value) throw UsageError(option + " takes numbers such as 0.25 or 1/3, not '" + text + "'");
  return *value;
}

ExactPoint2 point(const std::string& text) {
  const auto comma = text.find(',');
  if (comma == std::string::npos || text.find(',', comma + 1) != std::string::npos)
    throw UsageError("--at takes X,Y in a plane scene (and a number t in [0,1] with --on), not '" + text + "'");
  return {number(text.substr(0, comma), "--at"), number(text.substr(comma + 1), "--at")};
}

// The solid that a face looks into at a place (just after it, at its end just before it); Solids2::kNone where it is
// free.
std::uint32_t solid_at(const PreparedScene2& prepared, const Face& face, const Rational& t) {
  const Arrangement2& arrangement = prepared.arrangement;
  const Surface2& surface = prepared.scene.surfaces[face.surface];
  const Rational dx = surface.to.x - surface.from.x, dy = surface.to.y - surface.from.y;
  const auto place = [&](VertexId v) -> Rational {
    const ExactPoint2 p = arrangement.vertices().to_scene(arrangement.vertices().exact(v));
    return ((p.x - surface.from.x) * dx + (p.y - surface.from.y) * dy) / (dx * dx + dy * dy);
  };
  for (std::size_t piece = 0; piece < arrangement.pieces().size(); ++piece)
    for (const PieceSource2& source : arrangement.sources(piece)) {
      if (source.surface != face.surface) continue;
      const Rational a = place(arrangement.pieces()[piece].a), b = place(arrangement.pieces()[piece].b);
      const Rational &low = std::min(a, b), &high = std::max(a, b);
      if (t < low || t > high || (t == high && t < 1)) continue;
      const bool right = source.is_reversed == face.is_back;
      return arrangement.solids().maker(right ? right_side(piece) : left_side(piece));
    }
  return Solids2::kNone;
}

// "scene.json:4: the front of 'floor'"
std::string face_text(const Scene2& scene, const Face& face) {
  const Surface2& surface = scene.surfaces[face.surface];
  return fmt::format("{}:{}: the {} of {}", scene.file, surface.line, face.is_back ? "back" : "front",
                     quoted_name(surface.name));
}

Answer from_face(const PreparedScene2& prepared, const std::string& name, const Rational& t) {
  if (t < 0 || t > 1) throw UsageError("--at is a position on the edge, between 0 and 1, not " + to_string(t));
  if (name == "sky") throw UsageError("--on is a face, which the sky is not");
  const Arrangement2& arrangement = prepared.arrangement;
  const Face face = face_of(prepared.scene, name);
  const Surface2& surface = prepared.scene.surfaces[face.surface];
  if (const std::uint32_t solid = solid_at(prepared, face, t); solid != Solids2::kNone)
    throw RequestError(fmt::format("{} looks into {} at t = {}: nothing is seen there", face_text(prepared.scene, face),
                                   solid_text(prepared.scene, solid), to_string(t)));
  const PointLocation2 location(arrangement.vertices(), arrangement.triangulation());
  const ExactPoint2 x{surface.from.x + t * (surface.to.x - surface.from.x),
                      surface.from.y + t * (surface.to.y - surface.from.y)};
  Answer answer;
  answer.json["on"] = name;
  answer.json["t"] = json_of(t);
  answer.json["at"] = json_of(x);
  answer.json["factors"] = Json::array();
  answer.text = fmt::format("view factors from the point t = {} of '{}', {}\n", to_string(t), name, text_of(x));
  // Pieces of one face are added up.
  std::vector<std::pair<std::string, RootSum>> factors;
  for (const PointFactor2& factor : point_factors(arrangement, location, surface.from, surface.to, face.is_back, t)) {
    const std::string to = name_of(prepared.scene, arrangement, factor.side);
    const auto same =
        std::find_if(factors.begin(), factors.end(), [&](const auto& entry) { return entry.first == to; });
    if (same == factors.end())
      factors.emplace_back(to, factor.factor);
    else
      same->second += factor.factor;
  }
  for (const auto& [to, factor] : factors) {
    const Rounded value = round_quotient(factor, RootSum(Rational(1))).number;
    Json entry{{"to", to}};
    entry["factor"] = json_of(value);
    entry["exact"] = factor.to_string();
    answer.json["factors"].push_back(entry);
    answer.text += fmt::format("  {:<24} {:<22} = {}\n", to, shortest(value.value), factor.to_string());
  }
  answer.draw = from_point(prepared, x, false).draw;
  return answer;
}

// Throws RequestError where a face looks into solids all along.
void require_free(const PreparedScene2& prepared, const Face& face) {
  if (prepared.arrangement.solids().is_empty()) return;
  const FaceCover2 cover(prepared.scene, prepared.arrangement);
  if (cover.has_area[face.number()] == 0 && cover.covered_by[face.number()] != Solids2::kNone)
    throw RequestError(fmt::format("{} looks into {} all along: it has no area and exchanges nothing",
                                   face_text(prepared.scene, face),
                                   solid_text(prepared.scene, cover.covered_by[face.number()])));
}

// A face of --from or --to by name; nothing for the sky.
std::optional<Face> face_or_sky(const Scene2& scene, const std::string& name) {
  if (name == "sky") return std::nullopt;
  return face_of(scene, name);
}

// The pair in closed form; one of the two may be the sky, whose area is left 0 and which takes all there is: S0 = A.
ExactPair2 exact_pair_of(const PreparedScene2& prepared, const std::optional<Face>& a, const std::optional<Face>& b) {
  const ElementTable2 table(prepared.scene, prepared.arrangement, prepared.division, Granularity::kFace);
  const auto label_of = [&](const std::optional<Face>& face) {
    if (!face) return table.sky();
    const auto& elements = table.elements();
    return static_cast<std::uint32_t>(
        std::find_if(elements.begin(), elements.end(),
                     [&](const Element& e) { return e.surface == face->surface && e.is_back == face->is_back; }) -
        elements.begin());
  };
  if (a) return exact_pair(prepared, table, Granularity::kFace, label_of(a), label_of(b));
  ExactPair2 pair = exact_pair(prepared, table, Granularity::kFace, label_of(b), label_of(a));
  std::swap(pair.area_from, pair.area_to);
  return pair;
}

Answer between_faces(const PreparedScene2& prepared, const std::string& from, const std::string& to) {
  const std::optional<Face> a = face_or_sky(prepared.scene, from), b = face_or_sky(prepared.scene, to);
  for (const auto& face : {a, b})
    if (face) require_free(prepared, *face);
  const ExactPair2 pair = exact_pair_of(prepared, a, b);
  const RootSum one{Rational(1)};
  Answer answer;
  answer.json["from"] = from;
  answer.json["to"] = to;
  answer.text = fmt::format("'{}' and '{}'\n", from, to);
  const auto add = [&](const char* key, const std::string& label, const RootSum& numerator, const RootSum& denominator,
                       bool is_visibility) {
    answer.json[key] = nullptr;
    if (denominator.is_zero()) return;
    const Rounded quotient = round_quotient(numerator, denominator).number;
    const double value = is_visibility ? visibility_of(quotient) : quotient.value;
    answer.json[key] = json_of(quotient);
    answer.json[key]["value"] = value;
    answer.text += fmt::format("  {:<28} {:<22}\n", label, shortest(value));
  };
  const auto add_exact = [&](const char* key, const std::string& label, const RootSum& measure) {
    const std::string form = measure.to_string();
    answer.json[key] = json_of(round_quotient(measure, one).number);
    answer.json[key]["exact"] = form;
    answer.text += fmt::format("  {:<28} {:<22} = {}\n", label, decimal_text(measure), form);
  };
  add_exact("exchange", "S, exchange measure", pair.exchange);
  add_exact("unobstructed", "S0, everything else removed", pair.unobstructed);
  add("visibility", "Vis = S / S0", pair.exchange, pair.unobstructed, true);
  const auto add_area = [&](const char* key, const std::string& name, const RootSum& area, bool is_sky) {
    if (is_sky)
      answer.json[key] = nullptr;
    else
      add_exact(key, "A of '" + name + "'", area);
  };
  add_area("area_from", from, pair.area_from, !a);
  add_area("area_to", to, pair.area_to, !b);
  add("factor", "F from '" + from + "'", pair.exchange, pair.area_from, false);
  add("factor_back", "F from '" + to + "'", pair.exchange, pair.area_to, false);

  PairDrawing drawing;  // the sky is not drawn: its place is taken by the face, under it
  drawing.a = a ? *a : *b;
  drawing.b = b ? *b : *a;
  drawing.a_label = a ? from : to;
  drawing.b_label = a && b ? to : "";
  answer.json["critical_points"] = Json::array();
  if (!a) answer.text += "critical points are those of a face: the sky has none\n";
  std::vector<CriticalPoint2> critical;
  if (a) {
    critical = critical_points(prepared.arrangement, prepared.scene, *a, b);
    answer.text += fmt::format("critical points on '{}': {}\n", from, critical.size());
  }
  for (const CriticalPoint2& c : critical) {
    Json entry;
    entry["t"] = json_of(c.t);
    entry["at"] = json_of(c.point);
    entry["kind"] = c.is_jump ? "D0" : "D1";
    entry["past"] = {json_of(c.near), json_of(c.far)};
    answer.json["critical_points"].push_back(entry);
    answer.text += fmt::format("  {} t = {:<12} {} past {} and {}\n", c.is_jump ? "D0" : "D1", to_string(c.t),
                               text_of(c.point), text_of(c.near), text_of(c.far));
    drawing.critical_on_a.push_back(rounded(c.point));
    drawing.lines.emplace_back(rounded(c.point), rounded(c.far));
  }
  answer.draw = [&prepared, drawing](PictureFormat format) { return pair_picture_2(prepared, drawing, format); };
  return answer;
}

ExitCode visibility(const VisibilityOptions& options, Streams& streams) {
  const bool is_pair = !options.from.empty() || !options.to.empty();
  if (is_pair && (options.from.empty() || options.to.empty() || !options.at.empty() || !options.on.empty()))
    throw UsageError("--from A and --to B go together, without --at and --on");
  if (!is_pair && options.at.empty())
    throw UsageError("visibility needs --at X,Y or --on NAME --at T or --from A --to B");
  if (options.from == "sky" && options.to == "sky")
    throw UsageError("--from or --to is a face: the sky exchanges nothing with itself");
  const bool is_drawn = !options.out.empty() && options.out != "-";
  const auto format = is_drawn ? picture_format(options.out) : std::nullopt;
  if (is_drawn && !format) throw UsageError("a drawing is written as .svg or .png, not '" + options.out + "'");
  const std::optional<ExactPoint2> eye =
      is_pair || !options.on.empty() ? std::nullopt : std::optional(point(options.at));
  const Rational t = options.on.empty() ? Rational(0) : number(options.at, "--at with --on");

  const PreparedScene2 prepared = prepare(read_scene_2(options.scene));
  if (format) require_drawable(prepared.scene);
  if (format && eye && std::max(std::abs(rounded(*eye)[0]), std::abs(rounded(*eye)[1])) > kLargestDrawn)
    throw RequestError(options.scene + ": the point " + options.at + " is too far away to be drawn");
  const Answer answer = is_pair               ? between_faces(prepared, options.from, options.to)
                        : !options.on.empty() ? from_face(prepared, options.on, t)
                                              : from_point(prepared, *eye, true);
  std::optional<OutputFile> drawing;
  if (format) {
    drawing.emplace(options.out);
    drawing->write(answer.draw(*format));
    drawing->finish();
  }
  if (options.json)
    streams.write("", answer.json.dump(2) + "\n");
  else if (format)
    streams.note(answer.text);
  else
    streams.write("", answer.text);
  if (drawing) drawing->commit();
  return ExitCode::kDone;
}

}  // namespace

void add_visibility(Commands& commands) {
  const auto options = std::make_shared<VisibilityOptions>();
  CLI::App& command =
      commands.add("visibility", "What a point sees, what a point of a face sees, what two faces see of each other",
                   {"hottel visibility scenes/analytic/triangle_345.json --at 1,1",
                    "hottel visibility scenes/analytic/triangle_345.json --on three --at 1/2",
                    "hottel visibility scenes/analytic/strip_obstructed.json --from bottom --to top --json",
                    "hottel visibility scenes/showcase/apartment.json --at 4,3 -o /tmp/seen.png"},
                   [options](Streams& streams) { return visibility(*options, streams); });
  command.add_option("SCENE", options->scene, "the scene file")->required();
  command.add_option("--at", options->at, "a point X,Y, or with --on a position T from 0 to 1 (numbers may be p/q)");
  command.add_option("--on", options->on, "a face: view factors from its point --at T")->type_name("NAME");
  command
      .add_option("--from", options->from, "a face, or sky; with --to: their exchange and the critical points on it")
      ->type_name("A");
  command.add_option("--to", options->to, "the other face, or sky")->type_name("B");
  command.add_flag("--json", options->json, "the answer as one JSON object");
  command
      .add_option("-o", options->out,
                  "draw it: .svg or .png; the answer in words is a remark then, on stderr. Without it, or with -, the "
                  "answer is on standard output")
      ->type_name("FILE");
}

}  // namespace hottel
