#include "io/results/plane/graph_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

#include "io/results/csv_field.h"
#include "kernel/decimal.h"
#include "kernel/support/counted.h"
#include "kernel/support/failure.h"
#include "kernel/written_double.h"

namespace hottel {
namespace {

using Json = nlohmann::ordered_json;

double told_coordinate(const Rational& value) {
  const double written = written_double(value);
  require_double(written, "a coordinate of a vertex", "; --exact writes it");
  return written;
}

// A length, which is not 0.
double told_length(double value) {
  require_double(written_double(Rounded{value, 1}), "a length in the visibility graph");
  return value;
}

}  // namespace

// What is written again and again.
struct GraphWriter2::Labels {
  std::vector<GraphVertex2> vertices;  // by number
  std::vector<std::string> points;     // by number: their coordinates in csv
};

GraphWriter2::GraphWriter2(const PreparedScene2& prepared, GraphFormat2 format,
                           std::function<void(std::string_view)> sink)
    : prepared_(prepared), format_(format), sink_(std::move(sink)), labels_([&] {
        auto labels = std::make_unique<Labels>(Labels{graph_vertices(prepared), {}});
        if (format != GraphFormat2::kJson)
          for (const GraphVertex2& vertex : labels->vertices) labels->points.push_back(point(vertex));
        return labels;
      }()) {
  if (format_ == GraphFormat2::kJson)
    write_vertices();
  else
    sink_("vertex0,vertex1,x0,y0,x1,y1,length,along,surface0,surface1\n");
}

GraphWriter2::~GraphWriter2() = default;

std::string GraphWriter2::point(const GraphVertex2& vertex) const {
  const Vertices2& vertices = prepared_.arrangement.vertices();
  const Point2 p = vertices.to_scene(vertices.exact(vertex.id));
  if (format_ == GraphFormat2::kExactCsv) return to_string(p.x) + "," + to_string(p.y);
  return shortest(told_coordinate(p.x)) + "," + shortest(told_coordinate(p.y));
}

void GraphWriter2::write_vertices() {
  const Vertices2& vertices = prepared_.arrangement.vertices();
  std::string text = "{\n  \"vertices\": [";
  const char* before = "\n    ";
  for (const GraphVertex2& vertex : labels_->vertices) {
    const Point2 p = vertices.to_scene(vertices.exact(vertex.id));
    Json entry{{"x", told_coordinate(p.x)}, {"y", told_coordinate(p.y)}};
    entry["exact"] = {to_string(p.x), to_string(p.y)};
    entry["surface"] = prepared_.scene.surfaces[vertex.surface].name;
    entry["crossing"] = vertex.is_crossing;
    text += before + entry.dump();
    before = ",\n    ";
  }
  sink_(text + "\n  ],\n  \"pairs\": [");
}

std::string GraphWriter2::along(const VisiblePair2& pair) const {
  if (pair.along == kNoPiece) return "";
  return prepared_.scene.surfaces[prepared_.arrangement.sources(piece_of(pair.along)).front().surface].name;
}

std::string GraphWriter2::pair_as_csv(const VisiblePair2& pair) const {
  const auto name = [&](std::uint32_t vertex) {
    return csv_field(prepared_.scene.surfaces[labels_->vertices[vertex].surface].name);
  };
  return fmt::format("{},{},{},{},{},{},{},{}\n", pair.v, pair.w, labels_->points[pair.v], labels_->points[pair.w],
                     shortest(told_length(pair.length)), csv_field(along(pair)), name(pair.v), name(pair.w));
}

std::string GraphWriter2::pair_as_json(const VisiblePair2& pair) const {
  const std::string name = along(pair);
  Json entry;
  entry["vertices"] = {pair.v, pair.w};
  entry["length"] = told_length(pair.length);
  entry["along"] = name.empty() ? Json() : Json(name);
  return entry.dump();
}

void GraphWriter2::add(std::span<const VisiblePair2> pairs) {
  std::string text;
  for (const VisiblePair2& pair : pairs) {
    if (format_ == GraphFormat2::kJson)
      text += (pairs_ == 0 ? "\n    " : ",\n    ") + pair_as_json(pair);
    else
      text += pair_as_csv(pair);
    ++pairs_;
    if (pair.along != kNoPiece) ++along_;
  }
  sink_(text);
}

void GraphWriter2::finish() {
  if (format_ == GraphFormat2::kJson) sink_("\n  ]\n}\n");
}

std::string GraphWriter2::summary() const {
  const auto& vertices = labels_->vertices;
  const auto first = std::find_if(vertices.begin(), vertices.end(), [](const auto& v) { return v.is_crossing; });
  std::string result = vertices.size() == 1 ? "1 vertex" : fmt::format("{} vertices", vertices.size());
  if (first != vertices.end())
    result += fmt::format(" ({} from number {})", counted(static_cast<std::size_t>(vertices.end() - first), "crossing"),
                          first - vertices.begin());
  return fmt::format("{}; {} that see each other, {} of them along edges\n", result, counted(pairs_, "pair"), along_);
}

}  // namespace hottel
