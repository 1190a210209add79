#include "benchmarks/reports/space/hard_scenes.h"

#include "geometry/space/point.h"

namespace hottel {
namespace {

using Points = std::vector<Point3>;

LongReal real(const Rational& value) {
  return LongReal(Integer(value.get_num()).get_str()) / LongReal(Integer(value.get_den()).get_str());
}
std::vector<LongPoint> real(const Points& points) {
  std::vector<LongPoint> result;
  for (const Point3& p : points) result.push_back({real(p.x), real(p.y), real(p.z)});
  return result;
}

std::string polygon(const std::string& name, const std::string& group, const Points& points) {
  std::string text = R"({"name": ")" + name + R"(", "group": ")" + group + R"(", "material": "m", "points": [)";
  for (std::size_t k = 0; k < points.size(); ++k) {
    const auto coordinate = [](const Rational& value) { return '"' + to_string(value) + '"'; };
    text += (k > 0 ? ", [" : "[") + coordinate(points[k].x) + ", " + coordinate(points[k].y) + ", " +
            coordinate(points[k].z) + "]";
  }
  return text + "]}";
}

Points reversed(const Points& points) { return {points.rbegin(), points.rend()}; }
Points up(const Rational& x0, const Rational& x1, const Rational& y0, const Rational& y1, const Rational& z) {
  return {{x0, y0, z}, {x1, y0, z}, {x1, y1, z}, {x0, y1, z}};
}

// The six sides of a box, fronts inward or outward.
struct BoxSides {
  std::string name[6] = {"bottom", "top", "south", "north", "west", "east"};
  Points points[6];
};
BoxSides box(const Point3& a, const Point3& b, bool is_room) {
  BoxSides box;
  const Points sides[6] = {up(a.x, b.x, a.y, b.y, a.z),
                           reversed(up(a.x, b.x, a.y, b.y, b.z)),
                           {{a.x, a.y, a.z}, {a.x, a.y, b.z}, {b.x, a.y, b.z}, {b.x, a.y, a.z}},
                           {{a.x, b.y, a.z}, {b.x, b.y, a.z}, {b.x, b.y, b.z}, {a.x, b.y, b.z}},
                           {{a.x, a.y, a.z}, {a.x, b.y, a.z}, {a.x, b.y, b.z}, {a.x, a.y, b.z}},
                           {{b.x, a.y, a.z}, {b.x, a.y, b.z}, {b.x, b.y, b.z}, {b.x, b.y, a.z}}};
  for (std::size_t k = 0; k < 6; ++k) box.points[k] = is_room ? sides[k] : reversed(sides[k]);
  return box;
}

// Two unit cubes beside each other without the wall between them, and that wall, less what `wall` leaves open.
std::string two_rooms(const Points& wall) {
  std::string text;
  for (const int x : {0, 1}) {
    const std::string group = x == 0 ? "left" : "right";
    const BoxSides room = box({x, 0, 0}, {x + 1, 1, 1}, true);
    for (std::size_t k = 0; k < 6; ++k)
      if (k != (x == 0 ? 5 : 4)) text += polygon(group + " " + room.name[k], group, room.points[k]) + ",\n";
  }
  return text + polygon("wall", "left", wall) + ",\n" + polygon("wall from behind", "right", reversed(wall));
}

Points upper_plate(const Rational& d) { return reversed(up(0, 1, 0, 1, d)); }
Points wedge_plate(const Rational& d) { return {{0, 0, 0}, {0, 1, 0}, {1, 1, d}, {1, 0, d}}; }
Points kinked_plate(const Rational& d) { return {{1, 0, 0}, {2, 0, d}, {2, 1, d}, {1, 1, 0}}; }
const Points& unit_plate() {
  static const Points plate = up(0, 1, 0, 1, 0);
  return plate;
}
LongReal from_unit_plate(const Points& other) { return contour_measure(real(unit_plate()), real(other)); }
std::string unit_plate_and(const Points& other) {
  return polygon("lower", "lower", unit_plate()) + ",\n" + polygon("upper", "upper", other);
}

// A box of side 1 above the middle of the floor of a room of side 3.
Points lifted_bottom(const Rational& d) { return reversed(up(1, 2, 1, 2, d)); }
std::string lifted_box(const Rational& d) {
  std::string text;
  const BoxSides room = box({0, 0, 0}, {3, 3, 3}, true), body = box({1, 1, d}, {2, 2, d + 1}, false);
  for (std::size_t k = 0; k < 6; ++k) text += polygon(room.name[k], k < 1 ? "floor" : "walls", room.points[k]) + ",\n";
  for (std::size_t k = 0; k < 6; ++k)
    text += polygon("box " + body.name[k], k < 1 ? "underside" : "box", body.points[k]) + (k < 5 ? ",\n" : "");
  return text;
}

std::string duct(const Rational& d) {
  std::string text;
  const BoxSides sides = box({0, 0, 0}, {1, 1, d}, true);
  for (std::size_t k = 0; k < 6; ++k)
    text += polygon(sides.name[k], sides.name[k], sides.points[k]) + (k < 5 ? ",\n" : "");
  return text;
}

}  // namespace

const std::vector<HardScene3>& hard_scenes_3() {
  static const std::vector<HardScene3> scenes = {
      {"door", "A gap of height d under a door",
       "Two rooms, cubes of side 1, with a door for a wall between them that ends d above the floor. Every line from "
       "one "
       "room to the other goes through the gap, whose other side is all of the other room: what they exchange is the "
       "area of the gap.",
       "F(left room, right room) = d / (6 - d)", Granularity::kGroup, "left", "right",
       [](const Rational& d) {
         return two_rooms({{1, 0, d}, {1, 0, 1}, {1, 1, 1}, {1, 1, d}});
       },
       [](const Rational& d) { return LongReal(real(d) / (6 - real(d))); }, -1, true},
      {"wall", "A wall that misses the ceiling by d",
       "The same rooms; the wall reaches the ceiling at one end and misses it by d at the other. What gets over it is "
       "the "
       "area of that triangle.",
       "F(left room, right room) = d / (12 - d)", Granularity::kGroup, "left", "right",
       [](const Rational& d) {
         return two_rooms({{1, 0, 0}, {1, 0, 1 - d}, {1, 1, 1}, {1, 1, 0}});
       },
       [](const Rational& d) { return LongReal(real(d) / (12 - real(d))); }, -1, true},
      {"underside", "What leaves the underside of a box that is lifted by d",
       "A box of side 1 hangs d above the middle of the floor of a room of side 3. What its underside sends to the "
       "walls "
       "is in proportion to d²: 10⁻⁶³ at the end of the sweep.",
       "F(underside, walls) = 1 - F(underside, floor), rectangles in parallel planes (Howell's C-13)",
       Granularity::kGroup, "underside", "walls", lifted_box,
       [](const Rational& d) { return LongReal(1 - contour_measure(real(lifted_bottom(d)), real(up(0, 3, 0, 3, 0)))); },
       -1, false},
      {"floor", "What the floor sees of a box that is lifted by d",
       "The same room: of the floor to the underside, a ninth in the limit; nothing is small but the gap.",
       "F(floor, underside) = F(underside, floor) / 9 (Howell's C-13)", Granularity::kGroup, "floor", "underside",
       lifted_box,
       [](const Rational& d) { return LongReal(contour_measure(real(lifted_bottom(d)), real(up(0, 3, 0, 3, 0))) / 9); },
       -1, false},
      {"wedge", "A dihedral angle that closes",
       "Two squares with a side in common, at an angle of about d. What escapes to the sky is in proportion to d.",
       "F(lower, sky) = 1 - F(lower, upper), by the contour integral", Granularity::kFace, "lower", "sky",
       [](const Rational& d) { return unit_plate_and(wedge_plate(d)); },
       [](const Rational& d) { return LongReal(1 - from_unit_plate(wedge_plate(d))); }, -1, false},
      {"kink", "A wall that is nearly flat",
       "Two squares that go on from each other but for a kink of an angle of about d. They see each other by a share "
       "in "
       "proportion to d². So is the kernel between two points, whatever they are: of factors below the tolerance pairs "
       "of "
       "points keep more digits.",
       "F(first, second) by the contour integral", Granularity::kFace, "lower", "upper",
       [](const Rational& d) { return unit_plate_and(kinked_plate(d)); },
       [](const Rational& d) { return from_unit_plate(kinked_plate(d)); }, -1, true},
      {"duct", "The ends of a duct of length d",
       "A closed duct, 1 by 1, up to 10³¹ times as long as it is wide: needles as walls, and ends that see each other "
       "by "
       "1 / (pi d²).",
       "F(bottom, top), aligned squares (Howell's C-11)", Granularity::kFace, "bottom", "top", duct,
       [](const Rational& d) { return from_unit_plate(upper_plate(d)); }, +1, false},
      {"far", "Plates that move apart",
       "Two unit squares face each other at distance d, alone under the sky, of which each sees all but 1 / (pi d²).",
       "F(lower, upper), aligned squares (Howell's C-11)", Granularity::kFace, "lower", "upper",
       [](const Rational& d) { return unit_plate_and(upper_plate(d)); },
       [](const Rational& d) { return from_unit_plate(upper_plate(d)); }, +1, false},
  };
  return scenes;
}

Rational hard_parameter(const HardScene3& scene, int k) {
  Rational ten_to_k = 1;
  for (int n = 0; n < k; ++n) ten_to_k *= 10;
  return scene.direction < 0 ? Rational(1 / ten_to_k) : ten_to_k;
}

std::string hard_scene_json(const HardScene3& scene, const Rational& d) {
  return R"({"hottel": 1, "dimension": 3, "materials": {"m": {}}, "polygons": [)" + scene.polygons(d) + "]}";
}

HardErrors hard_errors(double value, const LongReal& factor) {
  const LongReal error = abs(LongReal(LongReal(value) - factor));
  return {LongReal(error / factor).convert_to<double>(), error.convert_to<double>()};
}

}  // namespace hottel
