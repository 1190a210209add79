// hottel visibility: what a point sees, what a point of a face receives, what two faces see of each other.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "cli/command.h"
#include "cli/scene_input.h"
#include "geometry/exchange/pair_rounding_2.h"
#include "geometry/visibility/critical_points_2.h"
#include "geometry/visibility/visibility_polygon_2.h"
#include "io/scene_json.h"
#include "kernel/decimal.h"
#include "kernel/failure.h"
#include "solver/illumination/mean_irradiance_2.h"
#include "solver/system/matrix_checks.h"
#include "solver/system/radiosity.h"
#include "viewer/picture/visibility_picture_2.h"

namespace hottel {
namespace {

using Json = nlohmann::ordered_json;

struct VisibilityOptions {
  std::string scene, at, on, from, to, out;
  bool json = false;
};

// One answer in three forms.
struct Answer {
  Json json;
  std::string text;
  std::function<std::string(PictureFormat)> draw;
};

std::array<double, 2> rounded(const ExactPoint2& p) { return {to_double(p.x), to_double(p.y)}; }

Json json_of(const Rational& value) { return {{"value", to_double(value)}, {"exact", to_string(value)}}; }

Json json_of(const ExactPoint2& p) {
  return {{"x", to_double(p.x)}, {"y", to_double(p.y)}, {"exact", {to_string(p.x), to_string(p.y)}}};
}

Json json_of(const Rounded& number) {
  const Enclosure bounds = number.enclosure();
  return {{"value", number.value}, {"lower", bounds.lower}, {"upper", bounds.upper}};
}

bool is_a_double(const Rational& value) {
  const double nearest = to_double(value);
  return std::isfinite(nearest) && Rational(nearest) == value;
}

// "(1.5, 0.3333333333333333)", with "= (3/2, 1/3)" where a decimal would not say all.
std::string text_of(const ExactPoint2& p) {
  std::string text = fmt::format("({}, {})", decimal_text(p.x), decimal_text(p.y));
  if (!is_a_double(p.x) || !is_a_double(p.y)) text += fmt::format(" = ({}, {})", to_string(p.x), to_string(p.y));
  return text;
}

std::string name_of(const Scene2& scene, const Arrangement2& arrangement, PieceSideId side) {
  if (side == kSky) return "sky";
  if (arrangement.is_covered(side)) return "";
  const FacePart& owner = arrangement.owner(side);
  return scene.surfaces[owner.surface].name + (owner.is_back ? ":back" : "");
}

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

std::string where(const PreparedScene2& prepared, const VisibilityPolygon2& polygon) {
  const Arrangement2& arrangement = prepared.arrangement;
  switch (polygon.location.kind) {
    case Location2::Kind::kInTriangle:
      return "in the open";
    case Location2::Kind::kOutside:
      return "outside the hull of the scene, or on its only line";
    case Location2::Kind::kOnVertex:
      return "at a vertex; every direction is seen";
    case Location2::Kind::kOnEdge: {
      const HalfEdgeId h = polygon.location.half_edge;
      if (arrangement.triangulation().twin(h) >= 0 || arrangement.triangulation().side(h) == kSky) return "in the open";
      const auto piece = static_cast<std::size_t>(arrangement.triangulation().side(h) / 2);
      return "on '" + prepared.scene.surfaces[arrangement.sources(piece).front().surface].name +
             "'; both sides are seen";
    }
  }
  return "";
}

// The mean irradiance at a point once the light has been reflected until it is absorbed, per channel.
void add_mean_irradiance(const PreparedScene2& prepared, const VisibilityPolygon2& seen, Answer& answer) {
  const Vertices2& vertices = prepared.arrangement.vertices();
  const ExchangeMatrix matrix = exact_exchange(prepared, {.per = Per::kFace, .wants_visibility = false});
  const RadiositySolution solution = solve_radiosity(matrix, prepared.scene.materials, prepared.scene.sky_emission, {});
  require_doubles(matrix, prepared.scene.sky_emission, solution);
  const Labels2 labels(prepared.scene, prepared.arrangement, prepared.division, Per::kFace);
  const std::vector<double> sky = sky_by_channel(prepared.scene.sky_emission, solution.channels.size());
  const FaceRadiosity2 faces(prepared.arrangement, labels, radiosity_by_element(solution), sky);
  const Eye2 look(vertices, vertices.from_scene(seen.eye));
  std::vector<double> mean(solution.channels.size());
  mean_irradiance(vertices, faces, look, seen.location, seen.view, mean);
  answer.text += "\nmean irradiance\n";
  for (std::size_t c = 0; c < mean.size(); ++c) {
    answer.json["mean_irradiance"][solution.channel_names[c]] = mean[c];
    answer.text += fmt::format("  {:<24} {}\n", solution.channel_names[c], shortest(mean[c]));
  }
}

Answer from_point(const PreparedScene2& prepared, const ExactPoint2& eye, bool wants_light) {
  const Arrangement2& arrangement = prepared.arrangement;
  const PointLocation2 location(arrangement.vertices(), arrangement.triangulation());
  const VisibilityPolygon2 polygon = visibility_polygon(arrangement, location, eye);
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

Answer from_face(const PreparedScene2& prepared, const std::string& name, const Rational& t) {
  if (t < 0 || t > 1) throw UsageError("--at is a position on the edge, between 0 and 1, not " + to_string(t));
  if (name == "sky") throw UsageError("--on is a face, which the sky is not");
  const Arrangement2& arrangement = prepared.arrangement;
  const FaceName face = face_of(prepared.scene, name);
  const Surface2& surface = prepared.scene.surfaces[face.surface];
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

// A face of --from or --to by name; nothing for the sky.
std::optional<FaceName> face_or_sky(const Scene2& scene, const std::string& name) {
  if (name == "sky") return std::nullopt;
  return face_of(scene, name);
}

// The pair in closed form; one of the two may be the sky, whose area is left 0 and which takes all there is: S0 = A.
ExactPair2 exact_pair_of(const PreparedScene2& prepared, const std::optional<FaceName>& a,
                         const std::optional<FaceName>& b) {
  const Labels2 labels(prepared.scene, prepared.arrangement, prepared.division, Per::kFace);
  const auto label_of = [&](const std::optional<FaceName>& face) {
    if (!face) return labels.sky();
    const auto& elements = labels.elements();
    return static_cast<std::uint32_t>(
        std::find_if(elements.begin(), elements.end(),
                     [&](const Element& e) { return e.surface == face->surface && e.is_back == face->is_back; }) -
        elements.begin());
  };
  if (a) return exact_pair(prepared, labels, Per::kFace, label_of(a), label_of(b));
  ExactPair2 pair = exact_pair(prepared, labels, Per::kFace, label_of(b), label_of(a));
  std::swap(pair.area_from, pair.area_to);
  return pair;
}

Answer between_faces(const PreparedScene2& prepared, const std::string& from, const std::string& to) {
  const std::optional<FaceName> a = face_or_sky(prepared.scene, from), b = face_or_sky(prepared.scene, to);
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
  drawing.a = (a ? a : b)->surface;
  drawing.b = (b ? b : a)->surface;
  drawing.a_is_back = (a ? a : b)->is_back;
  drawing.b_is_back = (b ? b : a)->is_back;
  drawing.a_label = a ? from : to;
  drawing.b_label = a && b ? to : "";
  answer.json["critical_points"] = Json::array();
  if (!a) answer.text += "critical points are those of a face: the sky has none\n";
  std::vector<CriticalPoint2> critical;
  if (a) {
    const FaceSide2 toward = b ? FaceSide2{b->surface, b->is_back} : FaceSide2{.is_sky = true};
    critical = critical_points(prepared.arrangement, prepared.scene, {a->surface, a->is_back}, toward);
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
                    "hottel visibility scenes/showcase/apartment.json --at 6,3 -o /tmp/seen.png"},
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
