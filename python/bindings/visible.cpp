#include "python/bindings/visible.h"

#include <algorithm>
#include <map>
#include <span>
#include <utility>

#include "geometry/plane/visibility/visibility_polygons.h"
#include "kernel/support/interrupt.h"
#include "kernel/support/parallel.h"
#include "python/bindings/bindings.h"
#include "python/bindings/parts.h"

namespace hottel::python {

namespace {

// All that can be seen: what is no side, an arc, the sky, and the sides of pieces.
std::vector<PieceSideId> side_table(std::size_t pieces) {
  std::vector<PieceSideId> sides{kNoPiece, kRange, kSky};
  for (std::size_t piece = 0; piece < pieces; ++piece)
    for (const PieceSideId side : sides_of(piece)) sides.push_back(side);
  return sides;
}

// The place in that table.
std::size_t table_place(PieceSideId side) {
  if (side == kNoPiece) return 0;
  if (side == kRange) return 1;
  return 2 + place_after_sky(side);
}

// What some points see that follow each other.
struct SeenCorners {
  std::vector<double> xy;
  std::vector<std::int32_t> sides;   // after each corner, as a place in the table
  std::vector<std::int32_t> counts;  // corners of each point
};

// Points looked from one after the other, in memory that is used again.
class Looker {
 public:
  Looker(const VisibilityPolygons2& polygons, const PythonPoints& points, const PolygonsOptions2& wanted)
      : polygons_(polygons), points_(points), wanted_(wanted) {}

  void look(std::size_t first, std::size_t end, SeenCorners& seen) const {
    seen.xy.clear();
    seen.sides.clear();
    seen.counts.clear();
    Point2 eye;
    RoundedPolygon2 polygon;
    RoundingCounts2 counts;
    for (std::size_t k = first; k < end; ++k) {
      throw_if_interrupted();
      points_.read(k, eye);
      if (wanted_.range)
        polygon = polygons_.of(eye, wanted_);
      else
        polygons_.look(eye, false, polygon, counts);
      add(polygon, seen);
    }
  }

 private:
  static void add(const RoundedPolygon2& polygon, SeenCorners& seen) {
    seen.counts.push_back(static_cast<std::int32_t>(polygon.corners.size()));
    for (const RoundedPolygon2::Corner& corner : polygon.corners) {
      seen.xy.push_back(corner.x);
      seen.xy.push_back(corner.y);
      seen.sides.push_back(static_cast<std::int32_t>(table_place(corner.after)));
    }
  }

  const VisibilityPolygons2& polygons_;
  const PythonPoints& points_;
  const PolygonsOptions2& wanted_;
};

// Adds what was seen from some points, `done` of all of them with these.
void append(std::span<const SeenCorners> seen, std::size_t done, std::size_t all, VisibleLists& lists) {
  std::vector<std::size_t> begins;
  for (const SeenCorners& some : seen) {
    begins.push_back(static_cast<std::size_t>(lists.begin.back()));
    for (const std::int32_t count : some.counts) lists.begin.push_back(lists.begin.back() + count);
  }
  const auto corners = static_cast<std::size_t>(lists.begin.back());
  if (corners > lists.face.capacity()) {  // as many as there will be by these; what is not used costs nothing
    const std::size_t expected = corners + corners / done * (all - done) / 4 * 5;
    lists.face.reserve(expected);
    lists.xy.reserve(2 * expected);
  }
  lists.face.resize(corners);
  lists.xy.resize(2 * corners);
  parallel_for(seen.size(), [&](std::size_t k) {
    const auto begin = static_cast<std::ptrdiff_t>(begins[k]);
    std::ranges::copy(seen[k].xy, lists.xy.begin() + 2 * begin);
    std::ranges::copy(seen[k].sides, lists.face.begin() + begin);
  });
}

// The numbers in a list, each once, in the order in which they are first met. REQUIRES that they are below a bound.
std::vector<std::int32_t> each_once(std::span<const std::int32_t> list, std::size_t bound) {
  std::vector<char> is_met(bound, 0);
  std::vector<std::int32_t> result;
  for (const std::int32_t number : list) {
    if (is_met[static_cast<std::size_t>(number)] != 0) continue;
    is_met[static_cast<std::size_t>(number)] = 1;
    result.push_back(number);
  }
  return result;
}

// Makes places in the table of sides those in the list of names.
void name_sides(const PreparedScene2& prepared, VisibleLists& lists) {
  const std::vector<PieceSideId> sides = side_table(prepared.arrangement.pieces().size());
  constexpr std::size_t kTogether = 1 << 18;
  const std::span<std::int32_t> face(lists.face);
  std::vector<std::vector<std::int32_t>> met((face.size() + kTogether - 1) / kTogether);
  parallel_for(met.size(), [&](std::size_t k) {
    const std::size_t begin = k * kTogether;
    met[k] = each_once(face.subspan(begin, std::min(kTogether, face.size() - begin)), sides.size());
  });
  std::vector<std::int32_t> in_order;
  for (const std::vector<std::int32_t>& some : met) in_order.insert(in_order.end(), some.begin(), some.end());

  std::vector<std::int32_t> place_of_side(sides.size(), 0);
  std::map<std::string, std::int32_t> place_of_name;
  for (const std::int32_t side : each_once(in_order, sides.size())) {
    const std::string name = polygon_side_name(prepared, sides[static_cast<std::size_t>(side)]);
    const auto [place, is_new] = place_of_name.emplace(name, static_cast<std::int32_t>(lists.names.size()));
    if (is_new) lists.names.push_back(name);
    place_of_side[static_cast<std::size_t>(side)] = place->second;
  }
  parallel_ranges(face.size(), kTogether, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) face[k] = place_of_side[static_cast<std::size_t>(face[k])];
  });
}

}  // namespace

VisibleLists visible_lists(const PreparedScene2& prepared, const PythonPoints& points, const PolygonsOptions2& wanted,
                           const StageProgress& progress) {
  constexpr std::size_t kTogether = 64;  // points
  const VisibilityPolygons2 polygons(prepared.arrangement);
  const Looker looker(polygons, points, wanted);
  VisibleLists lists;
  lists.begin.reserve(points.size() + 1);
  std::vector<SeenCorners> seen;
  const std::size_t groups = (points.size() + kTogether - 1) / kTogether;
  in_parts(groups, "visibility polygons", progress, [&](std::size_t first, std::size_t end) {
    seen.resize(std::max(seen.size(), end - first));
    const auto end_of = [&](std::size_t group) { return std::min((group + 1) * kTogether, points.size()); };
    parallel_for(end - first, [&](std::size_t k) { looker.look((first + k) * kTogether, end_of(first + k), seen[k]); });
    append(std::span(seen).first(end - first), end_of(end - 1), points.size(), lists);
  });
  name_sides(prepared, lists);
  return lists;
}

PythonVisible::PythonVisible(VisibleLists lists) : names(std::move(lists.names)) {
  const auto corners = static_cast<py::ssize_t>(lists.face.size());
  xy = frozen(std::move(lists.xy), {corners, 2});
  begin = frozen(std::move(lists.begin));
  face = frozen(std::move(lists.face));
}

namespace {

std::size_t count(const PythonVisible& visible) { return static_cast<std::size_t>(visible.begin.size()) - 1; }

// The corners of one point, as a slice of an array by corner.
py::slice corners_of(const PythonVisible& visible, py::ssize_t point) {
  const auto points = static_cast<py::ssize_t>(count(visible));
  if (point < -points || point >= points)
    throw py::index_error("there are " + std::to_string(points) + " points, and none is number " +
                          std::to_string(point));
  const auto* const begin = static_cast<const std::int64_t*>(visible.begin.data());
  const py::ssize_t k = point < 0 ? point + points : point;
  return {static_cast<py::ssize_t>(begin[k]), static_cast<py::ssize_t>(begin[k + 1]), 1};
}

py::array polygon(const PythonVisible& visible, py::ssize_t point) { return visible.xy[corners_of(visible, point)]; }

py::tuple sides(const PythonVisible& visible, py::ssize_t point) {
  std::vector<std::string> names;
  for (const py::handle place : py::object(visible.face[corners_of(visible, point)]))
    names.push_back(visible.names[place.cast<std::size_t>()]);
  return tuple_of(names);
}

}  // namespace

void add_visible(py::module_& module) {
  py::class_<PythonVisible> type(
      module, "Visible",
      "What n points of the plane see: visible[k] is the visibility polygon of point k, float64 of shape (corners, "
      "2),\n"
      "counter-clockwise, each coordinate the nearest double. IndexError for a point that there is not.");
  type.def_readonly("xy", &PythonVisible::xy,
                    "Corners of all points, float64 of shape (corners, 2), in units of the scene. Read only.")
      .def_readonly("begin", &PythonVisible::begin,
                    "int64 of shape (n + 1,): the corners of point k are begin[k] up to begin[k + 1]. Read only.")
      .def_readonly("face", &PythonVisible::face,
                    "int32 of shape (corners,): what is seen from each corner to the next, as a place in names.\n"
                    "Read only.")
      .def_property_readonly(
          "names", [](const PythonVisible& visible) { return tuple_of(visible.names); },
          "What is seen, a tuple of str: names of faces, 'sky', '#range' along arcs, '' along a ray.")
      .def("sides", &sides, py::arg("point"),
           "Returns the names of what is seen after each corner of one point, a tuple of str. IndexError for a point\n"
           "that there is not.")
      .def("__getitem__", &polygon, py::arg("point"))
      .def("__len__", &count)
      .def("__repr__", [](const PythonVisible& visible) {
        return "<hottel.Visible from " + std::to_string(count(visible)) + " points>";
      });
}

}  // namespace hottel::python
