#include "io/results/plane/polygon_files.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "geometry/plane/visibility/polygon_extent.h"
#include "io/results/csv_field.h"
#include "io/results/plane/drawn_polygon.h"
#include "io/results/plane/polygon_names.h"
#include "io/results/plane/polygon_npz.h"

namespace hottel {
namespace {

using Json = nlohmann::ordered_json;

std::string irradiance_name(const std::string& channel) {
  return channel == "all" ? "irradiance" : "irradiance_" + channel;
}

std::string number_text(double value) { return std::isnan(value) ? "NaN" : shortest(value); }

// What the writers of text share: they number the points and write through the sink at the end of each batch.
class TextWriter : public PolygonWriter2 {
 public:
  TextWriter(const PreparedScene2& prepared, PolygonFileOptions2 options, std::function<void(std::string_view)> sink)
      : prepared_(prepared), options_(std::move(options)), sink_(std::move(sink)) {}

  void add(const PolygonBatch2& batch) override {
    std::string text;
    for (std::size_t k = 0; k < batch.polygons.size(); ++k, ++point_) {
      const std::vector<double> none;
      append(batch.eyes[k], batch.polygons[k], batch.irradiance.empty() ? none : batch.irradiance[k], text);
    }
    sink_(text);
  }
  void finish() override {}

 protected:
  virtual void append(const Point2& eye, const RoundedPolygon2& polygon, const std::vector<double>& irradiance,
                      std::string& text) = 0;

  const PreparedScene2& prepared_;
  const PolygonFileOptions2 options_;
  const std::function<void(std::string_view)> sink_;
  std::size_t point_ = 0;
};

class CsvWriter final : public TextWriter {
 public:
  CsvWriter(const PreparedScene2& prepared, PolygonFileOptions2 options, std::function<void(std::string_view)> sink)
      : TextWriter(prepared, std::move(options), std::move(sink)) {
    std::string head = "point,corner,x,y,face";
    for (const std::string& channel : options_.channel_names) head += "," + irradiance_name(channel);
    sink_(head + ",area,perimeter\n");
  }

 private:
  // Both empty where the region is unbounded, or there is none.
  std::string extent_text(const Point2& eye, const RoundedPolygon2& polygon) const {
    const auto extent = extent_of(eye, polygon, options_.range);
    if (!extent) return ",,";
    return "," + (options_.is_exact ? to_string(*exact_area_of(polygon)) : shortest(extent->area)) + "," +
           shortest(extent->perimeter);
  }

  void append(const Point2& eye, const RoundedPolygon2& polygon, const std::vector<double>& irradiance,
              std::string& text) override {
    std::string light;
    for (const double value : irradiance) light += "," + number_text(value);
    light += extent_text(eye, polygon);
    if (polygon.corners.empty())
      text += fmt::format("{},,,,{}{}\n", point_, csv_field(no_polygon_name(prepared_, polygon)), light);
    for (std::size_t k = 0; k < polygon.corners.size(); ++k) {
      const auto& corner = polygon.corners[k];
      if (!options_.is_exact) require_finite(corner, point_);
      const std::string x = options_.is_exact ? to_string(polygon.exact[k].x) : shortest(corner.x);
      const std::string y = options_.is_exact ? to_string(polygon.exact[k].y) : shortest(corner.y);
      text += fmt::format("{},{},{},{},{}{}\n", point_, k, x, y, csv_field(polygon_side_name(prepared_, corner.after)),
                          light);
    }
  }
};

class GeoJsonWriter final : public TextWriter {
 public:
  GeoJsonWriter(const PreparedScene2& prepared, PolygonFileOptions2 options, std::function<void(std::string_view)> sink)
      : TextWriter(prepared, std::move(options), std::move(sink)) {
    sink_("{\"type\": \"FeatureCollection\", \"features\": [\n");
  }
  void finish() override { sink_("\n]}\n"); }

 private:
  static Json position(const RoundedPolygon2::Corner& corner) { return {corner.x, corner.y}; }

  Json geometry(const DrawnPolygon2& drawn, const RoundedPolygon2& polygon) const {
    if (polygon.solid != Solids2::kNone) return nullptr;
    Json lines = Json::array();
    for (const auto& line : drawn.lines) {
      Json positions = Json::array();
      for (const auto& vertex : line) {
        require_finite(vertex.corner, point_);
        positions.push_back(position(vertex.corner));
      }
      if (drawn.is_bounded) positions.push_back(positions.front());
      lines.push_back(std::move(positions));
    }
    return {{"type", drawn.is_bounded ? "Polygon" : "MultiLineString"}, {"coordinates", std::move(lines)}};
  }

  Json properties(const Point2& eye, const DrawnPolygon2& drawn, const RoundedPolygon2& polygon,
                  const std::vector<double>& irradiance) const {
    const auto number = [](double value) { return std::isfinite(value) ? Json(value) : Json(); };
    Json result{{"index", point_}, {"point", {number(to_double(eye.x)), number(to_double(eye.y))}}};
    if (polygon.solid != Solids2::kNone) result["solid"] = prepared_.scene.groups[polygon.solid].name;
    result["bounded"] = drawn.is_bounded;
    Json faces = Json::array(), sky = Json::array(), exact = Json::array();
    for (const auto& line : drawn.lines)
      for (const auto& vertex : line) {
        if (vertex.corner.after == kSky) sky.push_back(faces.size());
        faces.push_back(polygon_side_name(prepared_, vertex.corner.after));
        if (!options_.is_exact) continue;
        const Point2& p = polygon.exact[vertex.of];
        exact.push_back({to_string(p.x), to_string(p.y)});
      }
    result["faces"] = std::move(faces);
    result["sky"] = std::move(sky);
    if (options_.is_exact) result["exact"] = std::move(exact);
    if (options_.range) result["range"] = number(to_double(*options_.range));
    for (std::size_t c = 0; c < irradiance.size(); ++c)
      result[irradiance_name(options_.channel_names[c])] = number(irradiance[c]);
    const auto extent = extent_of(eye, polygon, options_.range);
    result["area"] = extent ? number(extent->area) : Json();
    result["perimeter"] = extent ? number(extent->perimeter) : Json();
    return result;
  }

  void append(const Point2& eye, const RoundedPolygon2& polygon, const std::vector<double>& irradiance,
              std::string& text) override {
    const DrawnPolygon2 drawn = drawn_polygon_2(eye, polygon, options_.range);
    Json feature{{"type", "Feature"}};
    feature["geometry"] = geometry(drawn, polygon);
    feature["properties"] = properties(eye, drawn, polygon, irradiance);
    text += (point_ == 0 ? "" : ",\n") + feature.dump();
  }
};

class WktWriter final : public TextWriter {
 public:
  using TextWriter::TextWriter;

 private:
  void append(const Point2& eye, const RoundedPolygon2& polygon, const std::vector<double>&,
              std::string& text) override {
    const DrawnPolygon2 drawn = drawn_polygon_2(eye, polygon, options_.range);
    text += drawn.is_bounded ? "POLYGON " : "MULTILINESTRING ";
    if (drawn.lines.empty()) text += "EMPTY";
    for (std::size_t i = 0; i < drawn.lines.size(); ++i) {
      text += i == 0 ? "((" : ", (";
      for (const auto& vertex : drawn.lines[i]) append_position(vertex.corner, text);
      if (drawn.is_bounded) append_position(drawn.lines[i].front().corner, text);
      text.resize(text.size() - 2);
      text += ")";
    }
    text += drawn.lines.empty() ? "\n" : ")\n";
  }

  void append_position(const RoundedPolygon2::Corner& corner, std::string& text) const {
    require_finite(corner, point_);
    text += shortest(corner.x) + " " + shortest(corner.y) + ", ";
  }
};

}  // namespace

std::optional<PolygonFormat2> polygon_format_2(const std::filesystem::path& file) {
  const std::string ending = file.extension().string();
  if (ending == ".csv") return PolygonFormat2::kCsv;
  if (ending == ".geojson" || ending == ".json") return PolygonFormat2::kGeoJson;
  if (ending == ".wkt") return PolygonFormat2::kWkt;
  if (ending == ".npz") return PolygonFormat2::kNpz;
  return std::nullopt;
}

std::unique_ptr<PolygonWriter2> polygon_writer_2(PolygonFormat2 format, const PreparedScene2& prepared,
                                                 PolygonFileOptions2 options,
                                                 std::function<void(std::string_view)> sink) {
  switch (format) {
    case PolygonFormat2::kCsv:
      return std::make_unique<CsvWriter>(prepared, std::move(options), std::move(sink));
    case PolygonFormat2::kGeoJson:
      return std::make_unique<GeoJsonWriter>(prepared, std::move(options), std::move(sink));
    case PolygonFormat2::kWkt:
      return std::make_unique<WktWriter>(prepared, std::move(options), std::move(sink));
    case PolygonFormat2::kNpz:
      break;
  }
  return polygon_npz_writer(prepared, options.channel_names.size(), options.range, std::move(sink));
}

}  // namespace hottel
