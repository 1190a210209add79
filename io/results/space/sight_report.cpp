#include "io/results/space/sight_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "geometry/scene_names.h"
#include "geometry/space/scene/scene.h"
#include "io/results/csv_field.h"
#include "io/results/space/exact_point.h"
#include "kernel/support/counted.h"
#include "kernel/written_double.h"

namespace hottel {
namespace {

using Json = nlohmann::ordered_json;

double told_length(const GraphVertex3& a, const GraphVertex3& b) {
  const double length = length_between(a.point, b.point);
  require_double(written_double(Rounded{length, 1}), "a length in the visibility graph");
  return length;
}

std::string coordinates(const Point3& p, bool is_exact) {
  std::string text;
  for (const Rational* x : {&p.x, &p.y, &p.z}) {
    if (!is_exact) require_double(written_double(*x), "a coordinate of a vertex", "; --exact writes it");
    text += (text.empty() ? "" : ",") + (is_exact ? to_string(*x) : shortest(written_double(*x)));
  }
  return text;
}

std::string along(const Scene3& scene, const VisiblePair3& pair) {
  return pair.along ? scene.surfaces[*pair.along].name : "";
}

}  // namespace

VisibilityAnswer face_answer(const Scene3& scene, const std::string& name, std::span<const SeenFace3> seen) {
  Json json{{"face", name}, {"sees_sky", false}, {"faces", Json::array()}};
  std::string text = fmt::format("what some point of '{}' sees\n", name);
  for (const SeenFace3& each : seen) {
    const std::string what = each.face ? face_name(scene, *each.face) : "sky";
    text += fmt::format("  {:<24} {}\n", what, each.is_whole ? "nothing hides any of it" : "in part");
    if (!each.face)
      json["sees_sky"] = true;
    else
      json["faces"].push_back({{"face", what}, {"hidden_in_part", !each.is_whole}});
  }
  return {json.dump(2) + "\n", text};
}

void write_graph_csv_3(const Scene3& scene, const VisibilityGraph3& graph, bool is_exact,
                       const std::function<void(std::string_view)>& sink) {
  sink("vertex0,vertex1,x0,y0,z0,x1,y1,z1,length,along,surface0,surface1\n");
  std::vector<std::string> points, names;
  for (const GraphVertex3& vertex : graph.vertices) {
    points.push_back(coordinates(vertex.point, is_exact));
    names.push_back(csv_field(scene.surfaces[vertex.surface].name));
  }
  for (const VisiblePair3& pair : graph.pairs)
    sink(fmt::format("{},{},{},{},{},{},{},{}\n", pair.v, pair.w, points[pair.v], points[pair.w],
                     shortest(told_length(graph.vertices[pair.v], graph.vertices[pair.w])),
                     csv_field(along(scene, pair)), names[pair.v], names[pair.w]));
}

std::string graph_json_3(const Scene3& scene, const VisibilityGraph3& graph) {
  std::string text = "{\n  \"vertices\": [";
  const char* before = "\n    ";
  for (const GraphVertex3& vertex : graph.vertices) {
    Json entry = exact_point(vertex.point);
    entry["surface"] = scene.surfaces[vertex.surface].name;
    text += before + entry.dump();
    before = ",\n    ";
  }
  text += "\n  ],\n  \"pairs\": [";
  before = "\n    ";
  for (const VisiblePair3& pair : graph.pairs) {
    Json entry{{"vertices", {pair.v, pair.w}}};
    entry["length"] = told_length(graph.vertices[pair.v], graph.vertices[pair.w]);
    entry["along"] = pair.along ? Json(along(scene, pair)) : Json();
    text += before + entry.dump();
    before = ",\n    ";
  }
  return text + "\n  ]\n}\n";
}

std::string graph_summary_3(const VisibilityGraph3& graph) {
  const auto along =
      std::ranges::count_if(graph.pairs, [](const VisiblePair3& pair) { return pair.along.has_value(); });
  return fmt::format("{}; {} that see each other, {} of them along edges\n",
                     graph.vertices.size() == 1 ? "1 vertex" : fmt::format("{} vertices", graph.vertices.size()),
                     counted(graph.pairs.size(), "pair"), along);
}

}  // namespace hottel
