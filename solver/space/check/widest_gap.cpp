#include "solver/space/check/widest_gap.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "geometry/name.h"
#include "geometry/space/check/wording.h"
#include "geometry/space/visibility/visibility_map.h"

namespace hottel {
namespace {

constexpr std::size_t kMostEdges = 64, kMostCorners = 64, kMostFaces = 16;
constexpr double kLeastPart = 0.25;  // of the sky that any of them sees
constexpr double kNoSky = 5e-15;     // what a map has of it where none is seen (VisibilityMap3 (4))

double length(const Vector3& v) { return std::sqrt(to_double(dot(v, v))); }

Point3 moved(const Point3& p, const Vector3& way, const Rational& t) {
  return {p.x + t * way.x, p.y + t * way.y, p.z + t * way.z};
}

// The point of a side that is nearest.
Point3 foot(const Point3& point, const Side3& side) {
  const Vector3 along = side.to - side.from;
  const Rational t = dot(point - side.from, along) / dot(along, along);
  return moved(side.from, along, t < 0 ? Rational(0) : t > 1 ? Rational(1) : t);
}

double distance(const Point3& point, const Polygon3& polygon) {
  const Vector3 normal = doubled_area(polygon);
  const Rational t = dot(point - polygon.points.front(), normal) / dot(normal, normal);
  if (!polygon.is_nearly_plane && contains_in_plane(polygon, normal, moved(point, normal, -t)))
    return std::abs(to_double(t)) * length(normal);
  double least = std::numeric_limits<double>::infinity();
  for (const Side3& side : sides_of(polygon)) least = std::min(least, length(point - foot(point, side)));
  return least;
}

// A gap, and how much of the sky is seen there.
struct Candidate {
  Meshes3::Gap gap;
  double sky = 0;
};

class GapFinder {
 public:
  GapFinder(const Meshes3& meshes, const PreparedScene3& prepared, const ExchangeMatrix& matrix)
      : meshes_(meshes), prepared_(prepared), scene_(prepared.scene), matrix_(matrix) {}

  std::optional<Meshes3::Gap> find() {
    const std::size_t step = std::max<std::size_t>(1, (meshes_.bare.size() + kMostEdges - 1) / kMostEdges);
    for (std::size_t k = 0; k < meshes_.bare.size(); k += step) look_at(meshes_.bare[k]);
    for (const std::uint32_t s : faces_that_see_sky()) look_on(s);
    double most = 0;
    for (const Candidate& candidate : found_) most = std::max(most, candidate.sky);
    std::optional<Meshes3::Gap> widest;
    for (const Candidate& candidate : found_)
      if (candidate.sky > kNoSky && candidate.sky >= kLeastPart * most &&
          (!widest || candidate.gap.width > widest->width))
        widest = candidate.gap;
    return widest;
  }

 private:
  std::string name(std::uint32_t s) const { return quoted_name(scene_.surfaces[s].name); }
  double sky_from(const Point3& eye, const std::optional<Point3>& normal) const {
    const VisibilityMap3 map = map_from(prepared_.occluders(), {eye, normal});
    return normal ? map.sky_factor : map.sky_fraction;
  }

  // What is nearest to the middle of an edge but the polygon that has it.
  void look_at(const EdgeStretch3& edge) {
    const std::uint32_t own = edge.uses.front().surface;
    const Point3 at = middle(edge.from, edge.to);
    std::uint32_t nearest = own;
    double width = std::numeric_limits<double>::infinity();
    for (std::uint32_t s = 0; s < scene_.surfaces.size(); ++s) {
      if (s == own) continue;
      if (const double d = distance(at, scene_.polygons[s]); d < width) {
        width = d;
        nearest = s;
      }
    }
    std::string text =
        fmt::format("{} of {} from {} to {} lies on nothing", meshes_.bare.size() == 1 ? "the edge" : "an edge",
                    name(own), place_text(edge.from), place_text(edge.to));
    if (nearest != own)
      text += fmt::format("; the nearest other surface, {}, is {:.3g} away from its middle", name(nearest), width);
    found_.push_back({{at, width, std::move(text)}, sky_from(at, std::nullopt)});
  }

  // The fronts that see most of it, by surface.
  std::vector<std::uint32_t> faces_that_see_sky() const {
    std::vector<std::uint32_t> faces;
    for (std::uint32_t face = 0; face < matrix_.size(); ++face)
      if (!matrix_.elements()[face].is_back && matrix_.has_row(face) && sky(face) > 0) faces.push_back(face);
    std::stable_sort(faces.begin(), faces.end(), [this](auto a, auto b) { return sky(a) > sky(b); });
    std::vector<std::uint32_t> surfaces;
    for (const std::uint32_t face : faces)
      if (surfaces.size() < kMostFaces) surfaces.push_back(matrix_.elements()[face].surface);
    return surfaces;
  }
  double sky(std::uint32_t face) const { return matrix_.factor(face, matrix_.sky()).value; }

  // Corners of others on a polygon, beside one of its sides.
  void look_on(std::uint32_t s) {
    const Polygon3& polygon = scene_.polygons[s];
    if (polygon.is_nearly_plane) return;
    const Vector3 normal = doubled_area(polygon);
    const std::vector<Side3> sides = sides_of(polygon);
    for (std::uint32_t t = 0; t < scene_.surfaces.size() && corners_ < kMostCorners; ++t) {
      if (t == s) continue;
      for (const Point3& corner : corners_of(scene_.polygons[t])) {
        if (dot(normal, corner - polygon.points[0]) != 0 || !contains_in_plane(polygon, normal, corner)) continue;
        const auto side = std::min_element(sides.begin(), sides.end(), [&](const Side3& a, const Side3& b) {
          return length(corner - foot(corner, a)) < length(corner - foot(corner, b));
        });
        const Point3 beside = foot(corner, *side);
        if (beside == corner || length(corner - beside) > length(side->to - side->from) / 64) continue;
        look_between(s, t, corner, beside, *side, normal);
      }
    }
  }

  void look_between(std::uint32_t s, std::uint32_t t, const Point3& corner, const Point3& beside, const Side3& side,
                    const Vector3& normal) {
    const Point3 at = middle(corner, beside);
    const double width = length(corner - beside);
    std::string text = fmt::format("the edge of {} from {} to {} lies {:.3g} beyond a corner of {}", name(s),
                                   place_text(side.from), place_text(side.to), width, name(t));
    found_.push_back({{at, width, std::move(text)}, sky_from(at, Point3{normal.x, normal.y, normal.z})});
    ++corners_;
  }

  const Meshes3& meshes_;
  const PreparedScene3& prepared_;
  const Scene3& scene_;
  const ExchangeMatrix& matrix_;
  std::vector<Candidate> found_;
  std::size_t corners_ = 0;
};

}  // namespace

std::optional<Meshes3::Gap> widest_gap(const Meshes3& meshes, const PreparedScene3& prepared,
                                       const ExchangeMatrix& matrix) {
  return GapFinder(meshes, prepared, matrix).find();
}

}  // namespace hottel
