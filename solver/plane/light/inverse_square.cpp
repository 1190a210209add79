#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <vector>

#include "geometry/plane/visibility/solid_around.h"
#include "kernel/support/failure.h"
#include "solver/plane/light/cell_views.h"
#include "solver/plane/light/illumination_grid.h"

namespace hottel {
namespace {

struct Spot {
  double x, y;
};

Spot rounded(const Point2& p) { return {to_double(p.x), to_double(p.y)}; }

// Lengths of pieces and elements, in the unit of approximate vertices.
class Lengths {
 public:
  Lengths(const Arrangement2& arrangement, const ElementTable2& table) : arrangement_(arrangement) {
    of_label_.assign(table.covered() + std::size_t{1}, 0.0);
    for (const PieceSideId side : arrangement.sides()) of_label_[table.of(side)] += piece(piece_of(side));
  }

  // The part of its element's length that is seen of one side of a piece between two vertices.
  double seen_fraction(const Eye2& eye, const View2::Seen& right, VertexId left, std::uint32_t label) const {
    const std::size_t index = piece_of(right.behind);
    return std::fabs(place(eye, left, index) - place(eye, right.vertex, index)) * piece(index) / of_label_[label];
  }

 private:
  double piece(std::size_t index) const {
    const auto &a = arrangement_.vertices().approximate(arrangement_.pieces()[index].a),
               &b = arrangement_.vertices().approximate(arrangement_.pieces()[index].b);
    return std::hypot(b.x - a.x, b.y - a.y);
  }
  // Where the ray through a vertex meets a piece, from 0 at its first to 1 at its second end.
  double place(const Eye2& eye, VertexId through, std::size_t index) const {
    const Segment2& piece = arrangement_.pieces()[index];
    if (through == piece.a) return 0;
    if (through == piece.b) return 1;
    const Vertices2& vertices = arrangement_.vertices();
    const auto &p = vertices.approximate(through), &a = vertices.approximate(piece.a),
               &b = vertices.approximate(piece.b);
    const double dx = p.x - eye.x(), dy = p.y - eye.y(), ux = b.x - a.x, uy = b.y - a.y;
    const double t = (dy * (a.x - eye.x()) - dx * (a.y - eye.y())) / (dx * uy - dy * ux);
    return std::clamp(t, 0.0, 1.0);
  }

  const Arrangement2& arrangement_;
  std::vector<double> of_label_;
};

std::vector<Spot> middles(const Scene2& scene, const ElementTable2& table) {
  std::vector<Spot> result;
  for (const Element& element : table.elements()) {
    const EdgeSpan2 span = EdgeSpan2::of(element);
    result.push_back(rounded(point_at(scene.edges[element.surface], (span.from + span.to) / 2)));
  }
  return result;
}

}  // namespace

IlluminationGrid2 illuminate_inverse_square(const PreparedScene2& prepared, const Grid2& grid,
                                            const ElementTable2& table, std::span<const double> by_element,
                                            std::uint32_t channels, const std::function<void(double)>& progress) {
  HOTTEL_REQUIRE(channels > 0 && by_element.size() == std::size_t{table.count()} * channels);
  IlluminationGrid2 result{grid, channels, {}};
  result.values.assign(std::size_t{grid.nx} * grid.ny * channels, 0.0);
  const Lengths lengths(prepared.arrangement, table);
  const std::vector<Spot> middle = middles(prepared.scene, table);
  std::vector<double> x, y;
  for (std::uint32_t ix = 0; ix < grid.nx; ++ix) x.push_back(to_double(cell_centre(grid, ix, 0).x));
  for (std::uint32_t iy = 0; iy < grid.ny; ++iy) y.push_back(to_double(cell_centre(grid, 0, iy).y));
  const double nearest = to_double(std::min<Rational>((grid.max.x - grid.min.x) / Rational(Integer(2ul * grid.nx)),
                                                      (grid.max.y - grid.min.y) / Rational(Integer(2ul * grid.ny))));

  std::atomic<bool> is_beyond = false;
  const auto visit = [&](std::size_t cell, const Eye2& eye, const Location2&, const View2& view) {
    double* sum = result.values.data() + cell * channels;
    if (solid_around(prepared.arrangement, view) != Solids2::kNone) {
      std::fill_n(sum, channels, std::numeric_limits<double>::quiet_NaN());
      return;
    }
    const double cx = x[cell % grid.nx], cy = y[cell / grid.nx];
    const std::size_t m = view.seen.size();
    bool is_outside = prepared.scene.closed;  // and no face with a material is seen
    for (std::size_t k = 0; k < m; ++k) {
      if (view.seen[k].behind == kSky) continue;
      const std::uint32_t label = table.of(view.seen[k].behind);
      if (label == table.covered() || !table.elements()[label].material) continue;
      is_outside = false;
      const double r = std::max(std::hypot(middle[label].x - cx, middle[label].y - cy), nearest);
      const double weight =
          lengths.seen_fraction(eye, view.seen[k], view.seen[k + 1 == m ? 0 : k + 1].vertex, label) / (r * r);
      for (std::uint32_t c = 0; c < channels; ++c) sum[c] += weight * by_element[std::size_t{label} * channels + c];
    }
    if (std::any_of(sum, sum + channels, [](double value) { return !std::isfinite(value); })) is_beyond = true;
    if (is_outside) std::fill_n(sum, channels, std::numeric_limits<double>::quiet_NaN());
  };
  for_each_cell_view(prepared, grid, progress, visit);
  if (is_beyond) throw RequestError("the inverse square of lengths in this scene is beyond the range of doubles");
  return result;
}

}  // namespace hottel
