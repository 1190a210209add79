// hemicube:R, hemicube:R:uniform.
// GUARANTEE: estimated.
// REFERENCE: M. F. Cohen, D. P. Greenberg, The hemi-cube: a radiosity solution for complex environments, 1985.
#include "solver/plane/methods/hemicube.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "kernel/int128.h"
#include "kernel/support/failure.h"
#include "solver/methods/factor_rows.h"
#include "solver/plane/methods/method_catalogue.h"
#include "solver/plane/methods/place_tree.h"
#include "solver/radiosity/matrix_checks.h"

namespace hottel {
namespace {

constexpr std::uint32_t kMostPixels = 1u << 20;
constexpr double kApart = 0x1p-16;
constexpr const char* kHemicubeReference = "Cohen and Greenberg 1985";

// The scene as seen from the centre of a run: x along it, y over its front.
class CentreFrame {
 public:
  CentreFrame(const Vertices2& vertices, const ElementGeometry2& geometry, const ElementRun2& run)
      : vertices_(vertices), geometry_(geometry), run_(run), centre_(middle(run.from, run.to)) {}

  // y has the sign that it has exactly.
  LocalVector2 operator()(VertexId v) const {
    const LocalVector2 p = geometry_.place(v) - centre_;
    const int left_of_run = vertices_.orientation(run_.ends.a, run_.ends.b, v);
    const double y = left_of_run == 0 ? 0 : std::max(std::fabs(dot(p, run_.normal())), kLeast);
    return {dot(p, run_.direction), left_of_run < 0 ? y : -y};
  }

 private:
  static constexpr double kLeast = 0x1p-600;

  static LocalPoint2 middle(const LocalPoint2& p, const LocalPoint2& q) {
    LocalPoint2 result;
    two_sum(p.x / 2, q.x / 2, result.x, result.x_low);
    two_sum(p.y / 2, q.y / 2, result.y, result.y_low);
    result.x_low += (p.x_low + q.x_low) / 2;
    result.y_low += (p.y_low + q.y_low) / 2;
    return result;
  }

  const Vertices2& vertices_;
  const ElementGeometry2& geometry_;
  const ElementRun2& run_;
  const LocalPoint2 centre_;
};

// Every piece that is not wholly below the horizon, with the element on the side that is seen.
std::vector<BufferItem2> items_of(const Arrangement2& arrangement, const ElementTable2& table,
                                  const CentreFrame& frame) {
  std::vector<LocalVector2> seen;
  seen.reserve(arrangement.vertices().size());
  for (const VertexId v : arrangement.vertices().ids()) seen.push_back(frame(v));
  std::vector<BufferItem2> items;
  for (std::size_t k = 0; k < arrangement.pieces().size(); ++k) {
    const Segment2& piece = arrangement.pieces()[k];
    const LocalVector2 &a = seen[piece.a.index()], &b = seen[piece.b.index()];
    if (a.y <= 0 && b.y <= 0) continue;
    const double turn = a.x * b.y - a.y * b.x;
    // The frame mirrors the scene (y points to the right of x): a piece that runs counter-clockwise in it shows the
    // side that is its right one in the scene.
    if (turn == 0) continue;
    const std::uint32_t label = table.of(turn > 0 ? right_side(k) : left_side(k));
    if (label == table.covered()) continue;
    items.push_back(turn > 0 ? BufferItem2{a, b, label} : BufferItem2{b, a, label});
  }
  return items;
}

class Hemicube2 final : public ElementMethod2 {
 public:
  Hemicube2(const HemicubeOptions2& options, MakeItemBuffer2 make_buffer)
      : options_(options), make_buffer_(std::move(make_buffer)) {
    const char* uniform = options.is_uniform ? ":uniform" : "";
    info_.name = fmt::format("hemicube:{}{}", options.resolution, uniform);
    info_.family = fmt::format("hemicube{}", uniform);
    info_.parameter = options.resolution;
    info_.reference = kHemicubeReference;
  }
  const MethodInfo& info() const override { return info_; }
  std::optional<double> declared_error(const PreparedScene2& prepared) const override;
  ExchangeMatrix compute_elements(const PreparedScene2& prepared, const std::function<void(double)>& progress,
                                  MethodReport& report) const override;

 private:
  HemicubeOptions2 options_;
  MakeItemBuffer2 make_buffer_;
  MethodInfo info_;
};

ExchangeMatrix Hemicube2::compute_elements(const PreparedScene2& prepared, const std::function<void(double)>& progress,
                                           MethodReport& report) const {
  const ElementGeometry2 geometry(prepared);
  const HalfSquare2 square(options_.resolution);
  std::vector<double> weight(square.pixels(), 1 / static_cast<double>(square.pixels()));
  if (!options_.is_uniform)
    for (std::size_t k = 0; k < weight.size(); ++k) weight[k] = square.weight(k);
  const ElementTable2& table = geometry.table();
  ExchangeMatrix matrix = matrix_by_rows(geometry.table().elements(), has_runs(geometry), progress, [&]() -> FillRow {
    return [&, buffer = std::shared_ptr(make_buffer_(options_.resolution))](std::uint32_t from, RowSums& by) {
      for (const ElementRun2& run : geometry.runs(from)) {
        const CentreFrame frame(prepared.arrangement.vertices(), geometry, run);
        const auto image = buffer->draw(items_of(prepared.arrangement, table, frame), table.sky());
        for (std::size_t k = 0; k < image.size(); ++k) by.add(image[k], run.share * weight[k]);
      }
    };
  });
  report.row_defect = closure_defect(matrix);
  return matrix;
}

double distance_to_run(const LocalVector2& p, double run_length) {
  const double beyond = std::max(0.0, std::fabs(p.x) - run_length / 2);
  return std::hypot(beyond, p.y);
}

// Whether pieces that do not touch keep so far from each other, in parts of the scene's diagonal, that the buffer tells
// which one is nearer.
bool are_apart(const Arrangement2& arrangement, const ElementGeometry2& geometry, const PlaceTree2& tree) {
  const double least = kApart * geometry.diagonal();
  return std::all_of(arrangement.pieces().begin(), arrangement.pieces().end(), [&](const Segment2& piece) {
    const LocalPoint2& from = geometry.place(piece.a);
    const LocalVector2 along = geometry.place(piece.b) - from;
    const double squared = dot(along, along);
    return tree.visit_near(from, along, least, [&](VertexId v) {
      if (v == piece.a || v == piece.b) return true;
      const LocalVector2 way = geometry.place(v) - from;
      const double t = squared > 0 ? std::clamp(dot(way, along) / squared, 0.0, 1.0) : 0;
      return length({way.x - t * along.x, way.y - t * along.y}) > least;
    });
  });
}

// From the point x of a run, F_xj = 1/2 sum of sin phi_v over the vertices v between j and what is seen beside it, with
// signs. A vertex between j and its neighbour is off by half a pixel at the most, and a pixel weighs 1 / resolution or
// less. Along the run sin phi_v changes by y² / r³, and the mean distance from the centre is a quarter of the length.
// Where two pieces meet in a vertex the nearer one is not told within R 2^-50 / kApart of its length, if they leave it
// at an angle as small as kApart allows.
std::optional<double> Hemicube2::declared_error(const PreparedScene2& prepared) const {
  if (options_.is_uniform) return std::nullopt;
  constexpr double kRounding = 1e-9;
  const ElementGeometry2 geometry(prepared);
  const Vertices2& vertices = prepared.arrangement.vertices();
  const PlaceTree2 tree(geometry, vertices.size());
  const double of_vertex = 0.5 / options_.resolution + 2 * options_.resolution * 0x1p-50 / kApart;
  double largest = 0;
  for (std::uint32_t i = 0; i < geometry.count(); ++i) {
    if (!geometry.has_row(i)) continue;
    if (!geometry.is_whole(i)) return std::nullopt;
    double error = kRounding;
    for (const ElementRun2& run : geometry.runs(i)) {
      const CentreFrame frame(vertices, geometry, run);
      // An error of 1 claims nothing, so no more vertices are looked at than make it 1.
      const bool is_claimed = tree.visit_before(run, [&](VertexId v) {
        const LocalVector2 p = frame(v);
        if (p.y == 0 && vertices.is_between(run.ends.a, run.ends.b, v)) return false;
        if (p.y <= 0) return true;
        const double distance = distance_to_run(p, run.length);
        const double slope = p.y / distance * (p.y / distance) / distance;
        error += run.share * (of_vertex + run.length / 8 * slope);
        return error < 1;
      });
      if (!is_claimed) return std::nullopt;
    }
    largest = std::max(largest, error);
  }
  return are_apart(prepared.arrangement, geometry, tree) ? std::optional(largest) : std::nullopt;
}

std::unique_ptr<ExchangeMethod2> make_hemicube(std::string_view variant) {
  HemicubeOptions2 options;
  std::string_view text = variant;
  constexpr std::string_view kUniform = ":uniform";
  if (text.ends_with(kUniform)) {
    options.is_uniform = true;
    text.remove_suffix(kUniform.size());
  }
  const char* begin = text.data() + std::min<std::size_t>(1, text.size());
  const auto [end, error] = std::from_chars(begin, text.data() + text.size(), options.resolution);
  const bool is_number = !text.empty() && error == std::errc() && end == text.data() + text.size();
  if (!is_number || options.resolution < 2 || options.resolution > kMostPixels || options.resolution % 2 != 0)
    throw UsageError(fmt::format("hemicube{}: expected hemicube:R or hemicube:R:uniform with an even R from 2 to {}",
                                 variant, kMostPixels));
  return hemicube_method_2(options);
}

}  // namespace

std::unique_ptr<ExchangeMethod2> hemicube_method_2(const HemicubeOptions2& options, MakeItemBuffer2 make_buffer) {
  HOTTEL_REQUIRE(options.resolution >= 2 && options.resolution <= kMostPixels && options.resolution % 2 == 0);
  return std::make_unique<Hemicube2>(options, std::move(make_buffer));
}

MethodFamily2 hemicube_family_2() {
  std::vector<std::string> sweep;
  for (const char* uniform : {"", ":uniform"})
    for (const int resolution : {64, 128, 256, 512, 1024})
      sweep.push_back(fmt::format("hemicube:{}{}", resolution, uniform));
  return {.name = "hemicube",
          .pattern = "hemicube:R[:uniform]",
          .what = "an item buffer of 2 R pixels about each element's centre",
          .reference = kHemicubeReference,
          .guarantee = Guarantee::kEstimated,
          .sweep = std::move(sweep),
          .make = make_hemicube};
}

}  // namespace hottel
