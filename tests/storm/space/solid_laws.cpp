#include "tests/storm/space/solid_laws.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>

#include "geometry/space/arrangement/coplanar_clusters.h"
#include "geometry/space/exchange/exchange.h"
#include "kernel/support/failure.h"

namespace hottel::storm {

namespace {

using Kind = SolidBody3::Kind;
using Face3 = SolidBody3::Face;

constexpr double kAsked = 1e-12, kSame = 1e-10;
constexpr std::array<Rational Point3::*, 3> kAxes{&Point3::x, &Point3::y, &Point3::z};

ExchangeMatrix matrix_of(const PreparedScene3& prepared, Granularity granularity = Granularity::kFace) {
  return exact_exchange(prepared, {.granularity = granularity, .wants_measures = true, .tolerance = kAsked});
}

ExchangeMatrix matrix_of(const Scene3& scene) {
  validate(scene);
  return matrix_of(prepare(scene));
}

std::uint32_t face_number(const Element& element) { return Face{element.surface, element.is_back}.number(); }

// S by faces, each element counted for the face that `face_of` gives it.
FaceMeasures3 measures_of(const ExchangeMatrix& matrix, const std::function<std::uint32_t(const Element&)>& face_of) {
  FaceMeasures3 result;
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    const auto row = matrix.row(i);
    for (const FactorEntry& entry : row)
      result[{face_of(matrix.elements()[i]),
              entry.to == matrix.sky() ? kSkyFace : face_of(matrix.elements()[entry.to])}] +=
          entry.factor.value * matrix.elements()[i].area.value;
  }
  return result;
}

std::string name_of(std::uint32_t face) {
  return face == kSkyFace ? "sky" : fmt::format("{}{}", face / 2, face % 2 == 1 ? ":back" : "");
}

std::string difference(const FaceMeasures3& expected, const FaceMeasures3& found) {
  std::string wrong;
  const auto look = [&](const FaceMeasures3& a, const FaceMeasures3& b, bool all) {
    for (const auto& [pair, value] : a) {
      const auto other = b.find(pair);
      const double there = other == b.end() ? 0 : other->second;
      if ((all || other == b.end()) && std::abs(value - there) > kSame)
        wrong += fmt::format("S({}, {}) = {:.17g}, not {:.17g}\n", name_of(pair.first), name_of(pair.second),
                             all ? there : value, all ? value : there);
    }
  };
  look(expected, found, true);
  look(found, expected, false);
  return wrong;
}

std::string places_differ(const SolidSubject3& subject) {
  const oracle::Places places = to_places(subject.bodies());
  const Scene3 scene = to_scene_3(subject.bodies());
  const bool is_refused = !subject.refusal().empty();
  const int tries = is_refused ? 200 : 8;
  bool is_disputed = false;
  std::string wrong;
  for (std::size_t f = 0; f < scene.polygons.size(); ++f)
    for (const oracle::SpacePoint& at : places.points(f, subject.chance(), tries)) {
      const oracle::Places::Place place = places.place(f, at);
      const bool is_disputed_here = place.front.is_disputed || place.back.is_disputed;
      is_disputed = is_disputed || is_disputed_here;
      if (is_refused) continue;
      const auto told = [&] { return fmt::format("{} at ({}, {}, {})", f, at.x.get_d(), at.y.get_d(), at.z.get_d()); };
      if (is_disputed_here) wrong += told() + ": two materials claim a side\n";
      const Arrangement3& arrangement = subject.prepared().arrangement();
      const Vector3 normal = doubled_area(scene.polygons[f]);
      int found = 0;
      const Point3 point{at.x, at.y, at.z};
      for (const Piece3& piece : arrangement.pieces()) {
        const Vector3 other = doubled_area(piece.polygon);
        if (!cross(normal, other).is_zero() || !contains(piece.polygon, point)) continue;
        ++found;
        const bool is_turned = dot(other, normal) < 0;
        for (const bool is_back : {false, true}) {
          const oracle::Places::Side& expected = is_back ? place.back : place.front;
          const Piece3::Side& side = piece.side(is_back != is_turned);
          const bool is_covered =
              side.cover == Piece3::Cover::kCovered ||
              (side.cover == Piece3::Cover::kPartly &&
               std::none_of(side.free.begin(), side.free.end(), [&](const Polygon3& q) { return contains(q, point); }));
          if (is_covered != expected.is_covered)
            wrong += told() + fmt::format(": {} is {}covered\n", is_back ? "back" : "front", is_covered ? "" : "not ");
          else if (!is_covered && side.owner.number() != expected.owner)
            wrong +=
                told() + fmt::format(": {} is of {}, not of {}\n", is_back ? "back" : "front",
                                     name_of(side.owner.number()), name_of(static_cast<std::uint32_t>(expected.owner)));
        }
      }
      if (found != 1) wrong += told() + fmt::format(": in {} pieces\n", found);
      if (wrong.size() > 1000) return wrong;
    }
  if (is_refused && !is_disputed) wrong += "refused: " + subject.refusal() + "\n";
  return wrong;
}

std::string rows_are_wrong(const ExchangeMatrix& matrix) {
  std::string wrong;
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    const auto row = matrix.row(i);
    double sum = 0;
    for (std::size_t k = 0; k < row.size(); ++k) {
      const double factor = row[k].factor.value;
      sum += factor;
      const Enclosure bounds = matrix.bounds(i, k);
      const std::string told = fmt::format("F({}, {}) = {:.17g}", matrix.name(i), matrix.name(row[k].to), factor);
      if (!(factor > 0 && row[k].visibility > 0 && row[k].visibility <= 1))
        wrong += told + fmt::format(", Vis = {:.17g}\n", row[k].visibility);
      if (!(bounds.lower <= bounds.upper) ||
          (matrix.guarantee(i, k) != Guarantee::kEstimated && !(bounds.lower <= factor && factor <= bounds.upper)))
        wrong += told + fmt::format(", bounds {:.17g} to {:.17g}\n", bounds.lower, bounds.upper);
      const std::uint32_t j = row[k].to;
      if (j == matrix.sky() || !matrix.has_row(j)) continue;
      const double there = factor * matrix.elements()[i].area.value;
      const double back = matrix.factor(j, i).value * matrix.elements()[j].area.value;
      if (std::abs(there - back) > 1e-15 * (there + back)) wrong += told + ": not the same from both faces\n";
    }
    if (matrix.has_row(i) && std::abs(sum - 1) > kSame)
      wrong += fmt::format("row {} sums to {:.17g}\n", matrix.name(i), sum);
  }
  return wrong;
}

std::string rows_are_broken(const SolidSubject3& subject) { return rows_are_wrong(subject.matrix()); }

// Calls visit(u, v, square) for each unit square of a polygon parallel to two axes; u and v are those axes.
void for_each_square(const Polygon3& polygon,
                     const std::function<void(long, long, const std::vector<Point3>&)>& visit) {
  const Vector3 normal = doubled_area(polygon);
  const std::size_t axis = normal.x != 0 ? 0 : normal.y != 0 ? 1 : 2;
  const auto u = kAxes[(axis + 1) % 3], v = kAxes[(axis + 2) % 3];
  std::vector<oracle::SpacePolygon> loops;
  const auto add = [&loops](const std::vector<Point3>& points) {
    loops.emplace_back();
    for (const Point3& p : points) loops.back().push_back({p.x, p.y, p.z});
  };
  add(polygon.points);
  for (const auto& hole : polygon.holes) add(hole);
  std::array<long, 2> low{1L << 30, 1L << 30}, high{-(1L << 30), -(1L << 30)};
  for (const Point3& p : polygon.points) {
    low = {std::min(low[0], (p.*u).get_num().get_si()), std::min(low[1], (p.*v).get_num().get_si())};
    high = {std::max(high[0], (p.*u).get_num().get_si()), std::max(high[1], (p.*v).get_num().get_si())};
  }
  const auto at = [&](const Rational& x, const Rational& y) {
    Point3 p = polygon.points[0];
    p.*u = x;
    p.*v = y;
    return p;
  };
  const Rational half(1, 2);
  for (long y = low[1]; y < high[1]; ++y)
    for (long x = low[0]; x < high[0]; ++x) {
      const Point3 middle = at(x + half, y + half);
      if (oracle::is_inside_loops(loops, {middle.x, middle.y, middle.z}))
        visit(x, y, {at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)});
    }
}

std::string areas_differ(const SolidSubject3& subject) {
  if (!is_boxy_3(subject.bodies())) return "";
  const oracle::Places places = to_places(subject.bodies());
  const Scene3& scene = subject.prepared().scene;
  std::vector<double> areas(2 * scene.polygons.size());
  for (std::size_t f = 0; f < scene.polygons.size(); ++f)
    for_each_square(scene.polygons[f], [&](long, long, const std::vector<Point3>& square) {
      const Rational half(1, 2);
      const Point3 &a = square[0], &c = square[2];
      const auto place = places.place(f, {half * (a.x + c.x), half * (a.y + c.y), half * (a.z + c.z)});
      // A square that several have is counted for its owner where the owner is asked.
      if (!place.front.is_covered && place.front.owner == 2 * f) areas[2 * f] += 1;
      if (!place.back.is_covered && place.back.owner == 2 * f + 1) areas[2 * f + 1] += 1;
    });
  std::string wrong;
  for (const Element& element : subject.matrix().elements())
    if (element.area.value != areas[face_number(element)])
      wrong +=
          fmt::format("area of {} = {:.17g}, not {}\n", element.name, element.area.value, areas[face_number(element)]);
  return wrong;
}

std::string by_hand_differs(const SolidSubject3& subject) {
  constexpr std::uint32_t kBlack = 0xfffffffe;
  const Arrangement3& arrangement = subject.prepared().arrangement();
  const Scene3& scene = subject.prepared().scene;
  const auto is_material = [&](const Face& face) {
    return scene.surfaces[face.surface].material_of(face.is_back).has_value();
  };
  Scene3 parts = to_scene_3({});
  std::vector<std::uint32_t> face_of;
  for (const Piece3& piece : arrangement.pieces())
    for (const bool is_back : {false, true}) {
      const Piece3::Side &side = piece.side(is_back), &other = piece.side(!is_back);
      if (side.cover == Piece3::Cover::kCovered) continue;
      // The black back of what stands for the other side will do.
      if (!is_material(side.owner) && is_material(other.owner) && other.cover == Piece3::Cover::kFree &&
          side.cover == Piece3::Cover::kFree)
        continue;
      for (Polygon3 polygon : side.cover == Piece3::Cover::kFree ? std::vector<Polygon3>{piece.polygon} : side.free) {
        if (is_back) std::reverse(polygon.points.begin(), polygon.points.end());
        Surface surface;
        surface.name = fmt::format("part {}", face_of.size());
        surface.group = static_cast<std::uint32_t>(parts.groups.size());
        parts.groups.emplace_back(surface.name);
        parts.add(std::move(surface), std::move(polygon));
        face_of.push_back(is_material(side.owner) ? side.owner.number() : kBlack);
      }
    }
  FaceMeasures3 expected;
  for (const auto& [pair, value] : subject.measures()) {
    const bool is_black = pair.second != kSkyFace && !is_material(Face::of(pair.second));
    expected[{pair.first, is_black ? kBlack : pair.second}] += value;
  }
  FaceMeasures3 found = measures_of(
      matrix_of(parts), [&](const Element& element) { return element.is_back ? kBlack : face_of[element.surface]; });
  std::erase_if(found, [](const auto& entry) { return entry.first.first == kBlack; });
  return difference(expected, found);
}

SolidBodies3 moved(SolidBodies3 bodies, const std::function<Point3(const Point3&)>& move, bool is_reflected) {
  for (SolidBody3& body : bodies)
    for (Face3& face : body.faces) {
      for (Point3& p : face.polygon.points) p = move(p);
      for (auto& hole : face.polygon.holes)
        for (Point3& p : hole) p = move(p);
      if (is_reflected) std::reverse(face.polygon.points.begin(), face.polygon.points.end());
    }
  return bodies;
}

std::string moved_differs(const SolidSubject3& subject) {
  const Rational east = (Rational(1) << 53) + 1, north = 7 - (Rational(1) << 60);
  const Rational unit = subject.chance() % 2 == 0 ? Rational(1 << 20) : Rational(1, 1 << 20);
  std::string wrong;
  const std::vector<std::function<Point3(const Point3&)>> ways{[&](const Point3& p) {
                                                                 return Point3{p.x + east, p.y + north, p.z + 3};
                                                               },
                                                               [&](const Point3& p) {
                                                                 return Point3{p.x * unit, p.y * unit, p.z * unit};
                                                               }};
  for (const auto& way : ways) {
    const ExchangeMatrix &here = subject.matrix(), there = matrix_of(to_scene_3(moved(subject.bodies(), way, false)));
    if (here.entry_count() != there.entry_count()) return "moved: other entries\n";
    for (std::uint32_t i = 0; i < here.size(); ++i) {
      const auto a = here.row(i), b = there.row(i);
      for (std::size_t k = 0; k < a.size() && k < b.size(); ++k)
        if (a[k].to != b[k].to || a[k].factor.value != b[k].factor.value || a[k].visibility != b[k].visibility)
          wrong +=
              fmt::format("moved: F({}, {}) = {:.17g}, Vis {:.17g}; was {:.17g}, Vis {:.17g}\n", here.name(i),
                          here.name(a[k].to), b[k].factor.value, b[k].visibility, a[k].factor.value, a[k].visibility);
    }
  }
  return wrong;
}

std::string axes_differ(const SolidSubject3& subject) {
  const std::uint64_t chance = subject.chance();
  const bool is_reflected = chance % 2 == 1;
  const auto way = [&](const Point3& p) {
    const Point3 turned = chance % 3 == 0 ? p : chance % 3 == 1 ? Point3{p.y, p.z, p.x} : Point3{p.z, p.x, p.y};
    return is_reflected ? Point3{-turned.x, turned.y, turned.z} : Point3{-turned.x, -turned.y, turned.z};
  };
  const SolidBodies3 other = moved(subject.bodies(), way, is_reflected);
  return difference(subject.measures(), measures_of(matrix_of(to_scene_3(other)), face_number));
}

std::string order_differs(const SolidSubject3& subject) {
  const SolidBodies3& bodies = subject.bodies();
  const auto clusters = coplanar_clusters(to_scene_3(bodies).polygons);
  if (bodies.size() < 2 ||
      std::any_of(clusters.begin(), clusters.end(), [](const auto& cluster) { return cluster.members.size() > 1; }))
    return "";
  SolidBodies3 other = bodies;
  std::vector<std::uint32_t> place(to_scene_3(bodies).polygons.size());  // where a surface was
  std::iota(place.begin(), place.end(), 0U);
  const auto first = static_cast<std::ptrdiff_t>(1 + subject.chance() % (bodies.size() - 1));
  std::ptrdiff_t faces = 0;
  for (auto body = bodies.begin(); body != bodies.begin() + first; ++body)
    faces += static_cast<std::ptrdiff_t>(body->faces.size());
  std::rotate(other.begin(), other.begin() + first, other.end());
  std::rotate(place.begin(), place.begin() + faces, place.end());
  return difference(subject.measures(), measures_of(matrix_of(to_scene_3(other)), [&](const Element& element) {
                      return Face{place[element.surface], element.is_back}.number();
                    }));
}

// Parts of a polygon: two of a convex one; strips of one that is parallel to the axes; else itself.
std::vector<Polygon3> parts_of(const Polygon3& polygon, std::uint64_t chance) {
  const auto& p = polygon.points;
  const std::size_t n = p.size(), first = chance % n;
  if (is_convex(polygon)) {
    if (n == 3) {
      const Point3 &a = p[first], &b = p[(first + 1) % 3], &c = p[(first + 2) % 3];
      const Point3 m{(b.x + c.x) / 2, (b.y + c.y) / 2, (b.z + c.z) / 2};
      return {{{a, b, m}, {}}, {{a, m, c}, {}}};
    }
    std::vector<Point3> turned = p;
    std::rotate(turned.begin(), turned.begin() + static_cast<std::ptrdiff_t>(first), turned.end());
    return {{{turned.begin(), turned.begin() + 3}, {}},
            {[&] {
               std::vector<Point3> rest(turned.begin() + 2, turned.end());
               rest.push_back(turned[0]);
               return rest;
             }(),
             {}}};
  }
  if (!is_boxy_3({{Kind::kSheets, false, {{polygon, 0, {}}}}})) return {polygon};
  std::vector<Polygon3> strips;
  std::array<long, 2> last{1L << 30, 0};
  for_each_square(polygon, [&](long x, long y, const std::vector<Point3>& square) {
    if (!strips.empty() && last == std::array<long, 2>{x - 1, y}) {
      strips.back().points[1] = square[1];
      strips.back().points[2] = square[2];
    } else {
      strips.push_back({square, {}});
    }
    last = {x, y};
  });
  for (Polygon3& strip : strips)
    if (dot(doubled_area(strip), doubled_area(polygon)) < 0) std::reverse(strip.points.begin(), strip.points.end());
  return strips;
}

std::string split_differs(const SolidSubject3& subject) {
  SolidBodies3 other = subject.bodies();
  std::vector<std::uint32_t> whole;
  std::uint32_t surface = 0;
  for (SolidBody3& body : other) {
    std::vector<Face3> faces;
    for (const Face3& face : body.faces) {
      for (Polygon3& part : parts_of(face.polygon, subject.chance() / 7 + surface)) {
        faces.push_back({std::move(part), face.material, face.back});
        whole.push_back(surface);
      }
      ++surface;
    }
    body.faces = std::move(faces);
  }
  return difference(subject.measures(), measures_of(matrix_of(to_scene_3(other)), [&](const Element& element) {
                      return Face{whole[element.surface], element.is_back}.number();
                    }));
}

std::string two_sides_differ(const SolidSubject3& subject) {
  SolidBodies3 other;
  std::vector<std::uint32_t> faces;  // of surfaces
  std::uint32_t surface = 0;
  for (const SolidBody3& body : subject.bodies()) {
    if (body.kind != Kind::kSheets) {
      other.push_back(body);
      for (std::size_t f = 0; f < body.faces.size(); ++f) faces.push_back(2 * surface++);
      continue;
    }
    for (Face3 face : body.faces) {
      const std::optional<std::uint32_t> back = std::exchange(face.back, std::nullopt);
      other.push_back({Kind::kSheets, false, {face}});
      faces.push_back(2 * surface);
      if (back) {
        std::reverse(face.polygon.points.begin(), face.polygon.points.end());
        face.material = *back;
        other.push_back({Kind::kSheets, false, {face}});
        faces.push_back(2 * surface + 1);
      }
      ++surface;
    }
  }
  if (faces.size() == surface) return "";
  return difference(subject.measures(), measures_of(matrix_of(to_scene_3(other)), [&](const Element& element) {
                      return faces[element.surface] ^ (element.is_back ? 1U : 0U);
                    }));
}

std::string elements_differ(const SolidSubject3& subject) {
  Scene3 scene = to_scene_3(subject.bodies());
  for (std::size_t s = 0; s < scene.surfaces.size(); ++s)
    scene.surfaces[s].elements = (s + subject.chance()) % 3 == 0 ? 2 : 1;
  const ExchangeMatrix matrix = matrix_of(prepare(scene), Granularity::kElement);
  std::string wrong = difference(subject.measures(), measures_of(matrix, face_number));
  std::vector<double> areas(2 * scene.polygons.size());
  for (const Element& element : matrix.elements()) areas[face_number(element)] += element.area.value;
  for (const Element& element : subject.matrix().elements())
    if (std::abs(element.area.value - areas[face_number(element)]) > kSame)
      wrong += fmt::format("elements of {} have the area {:.17g}, not {:.17g}\n", element.name,
                           areas[face_number(element)], element.area.value);
  return wrong + rows_are_wrong(matrix);
}

std::string groups_differ(const SolidSubject3& subject) {
  const Scene3& scene = subject.prepared().scene;
  const auto group_of = [&](std::uint32_t face) {
    return face == kSkyFace ? face : 2 * scene.surfaces[face / 2].group + face % 2;
  };
  FaceMeasures3 expected;
  for (const auto& [pair, value] : subject.measures()) expected[{group_of(pair.first), group_of(pair.second)}] += value;
  const ExchangeMatrix matrix = matrix_of(subject.prepared(), Granularity::kGroup);
  return difference(expected, measures_of(matrix, [&](const Element& e) { return group_of(face_number(e)); })) +
         rows_are_wrong(matrix);
}

}  // namespace

SolidSubject3::SolidSubject3(SolidBodies3 bodies, std::uint64_t chance) : bodies_(std::move(bodies)), chance_(chance) {
  const Scene3 scene = to_scene_3(bodies_);
  validate(scene);
  try {
    prepared_ = prepare(scene);
  } catch (const InputError& error) {
    refusal_ = error.what();
    return;
  }
  matrix_ = matrix_of(*prepared_);
  measures_ = measures_of(matrix_, face_number);
}

const std::vector<SolidLaw3>& solid_laws_3() {
  static const std::vector<SolidLaw3> laws{
      {"places", places_differ, 1, true}, {"rows", rows_are_broken, 1}, {"areas", areas_differ, 1},
      {"by hand", by_hand_differs, 2},    {"moved", moved_differs, 4},  {"axes", axes_differ, 4},
      {"order", order_differs, 4},        {"split", split_differs, 4},  {"two sides", two_sides_differ, 2},
      {"elements", elements_differ, 8},   {"groups", groups_differ, 4}};
  return laws;
}

}  // namespace hottel::storm
