#include "tests/storm/space/room_scene.h"

#include <algorithm>
#include <array>
#include <random>
#include <utility>
#include <vector>

#include "tests/storm/space/room_numbers.h"

namespace hottel::storm {

namespace {

using Kind = SolidBody3::Kind;
using Spot = std::array<Rational, 2>;  // of the floor
using Plan = std::vector<Spot>;        // counter-clockwise

constexpr int kTries = 6;  // of furniture that fits
constexpr std::uint32_t kWalls = 0;

class Furnisher {
 public:
  explicit Furnisher(std::uint64_t number) : random_(number * 6151 + 11) {}

  FurnishedRoom3 draw() {
    room_.numbers = std::array{RoomNumbers3::kExact,  RoomNumbers3::kExact, RoomNumbers3::kTurned,
                               RoomNumbers3::kTyped,  RoomNumbers3::kTyped, RoomNumbers3::kTilted,
                               RoomNumbers3::kFloats, RoomNumbers3::kFloats}[static_cast<std::size_t>(below(8))];
    is_rounded_ = room_.numbers >= RoomNumbers3::kTyped;
    furniture_ = below(4) == 0 ? 1 : kWalls;
    const auto most = static_cast<std::size_t>(between(14, kMostRoomPolygons));
    add_room();
    for (int failed = 0; failed < kTries;) {
      const std::size_t before = room_.bodies.size();
      add_furniture();
      if (polygons() <= most) continue;
      room_.bodies.resize(before);
      ++failed;
    }
    write_numbers(room_, random_);
    return std::move(room_);
  }

 private:
  long below(long count) { return static_cast<long>(random_() % static_cast<std::uint64_t>(count)); }
  long between(long low, long high) { return low + below(high - low + 1); }
  static Rational fraction(long above, long below) {
    Rational result(above, below);
    result.canonicalize();
    return result;
  }
  Rational length(long low, long high) { return fraction(between(low, high), 20); }  // low to high times 5 cm

  // 2^-1 to 2^-50, or 1e-3 to 1e-15.
  Rational tiny() {
    Integer power;
    if (below(2) == 0)
      mpz_ui_pow_ui(power.get_mpz_t(), 2, static_cast<unsigned long>(between(1, 50)));
    else
      mpz_ui_pow_ui(power.get_mpz_t(), 10, static_cast<unsigned long>(between(3, 15)));
    return Rational(1) / power;
  }
  // Between two that stand side by side; below 0: they overlap.
  Rational slit(bool may_overlap = true) {
    switch (below(8)) {
      case 0:
      case 1:
        return 0;
      case 2:
        return may_overlap ? -tiny() : tiny();
      case 3:
        return length(1, 8);
      default:
        return tiny();
    }
  }
  // To a wall, the floor or the ceiling.
  Rational gap() { return below(2) == 0 ? Rational(0) : slit(has_outside_); }
  // The height of the bottom of what stands.
  Rational foot() { return below(3) == 0 ? gap() : Rational(0); }
  // How far two that should be flush are not.
  Rational step() { return below(3) == 0 ? Rational(0) : below(2) == 0 ? tiny() : -tiny(); }
  // All but a length, and above 0.
  Rational nearly(const Rational& length) {
    const Rational other = length + step();
    return other > 0 ? other : length;
  }

  std::size_t polygons() const {
    std::size_t count = 0;
    for (const SolidBody3& body : room_.bodies)
      for (const SolidBody3::Face& face : body.faces)
        count += room_.numbers == RoomNumbers3::kFloats ? face.polygon.points.size() - 2 : 1;
    return count;
  }

  static Point3 at(const Spot& spot, const Rational& height) { return {spot[0], spot[1], height}; }
  static Plan rectangle(const Rational& x0, const Rational& y0, const Rational& x1, const Rational& y1) {
    return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
  }

  void add_face(SolidBody3& body, std::vector<Point3> points, std::uint32_t material, bool has_back) {
    std::rotate(points.begin(), points.begin() + below(static_cast<long>(points.size())), points.end());
    SolidBody3::Face face{Polygon3{std::move(points), {}}, material, {}};
    if (has_back) face.back = material;
    body.faces.push_back(std::move(face));
  }

  // The prism over a plan; its fronts are inside where it is a room.
  SolidBody3 prism(const Plan& plan, const Rational& low, const Rational& high, bool is_room) {
    SolidBody3 body{is_room ? Kind::kRoom : Kind::kSolid, false, {}};
    const auto add = [&](std::vector<Point3> points) {
      if (is_room) std::reverse(points.begin(), points.end());
      add_face(body, std::move(points), is_room ? kWalls : furniture_, false);
    };
    std::vector<Point3> top, bottom;
    for (const Spot& spot : plan) {
      top.push_back(at(spot, high));
      bottom.insert(bottom.begin(), at(spot, low));
    }
    add(std::move(top));
    add(std::move(bottom));
    for (std::size_t k = 0; k < plan.size(); ++k) {
      const Spot &p = plan[k], &q = plan[(k + 1) % plan.size()];
      add({at(p, low), at(q, low), at(q, high), at(p, high)});
    }
    return body;
  }
  // Whether something may stand there: within the room, where this has no outside.
  bool may_stand(const std::vector<Point3>& points) const {
    return has_outside_ || std::ranges::all_of(points, [this](const Point3& p) {
             return 0 <= p.x && p.x <= size_[0] && 0 <= p.y && p.y <= size_[1] && 0 <= p.z && p.z <= height_;
           });
  }
  void add_prism(const Plan& plan, const Rational& low, const Rational& high) {
    std::vector<Point3> corners;
    for (const Spot& spot : plan) corners.insert(corners.end(), {at(spot, low), at(spot, high)});
    if (high > low && may_stand(corners)) room_.bodies.push_back(prism(plan, low, high, false));
  }
  void add_sheet(std::vector<Point3> points) {
    if (!may_stand(points)) return;
    SolidBody3 body{Kind::kSheets, false, {}};
    if (below(2) == 0) std::reverse(points.begin(), points.end());
    add_face(body, std::move(points), kWalls, true);
    room_.bodies.push_back(std::move(body));
  }

  void add_room() {
    size_ = {length(50, 120), length(50, 120)};
    height_ = length(48, 64);
    const long shape = below(8);
    has_outside_ = is_rounded_ || shape < 3 || below(2) == 0;
    SolidBody3 room;
    if (shape == 0) {  // an L
      const Rational x = size_[0] - length(15, 30), y = size_[1] - length(15, 30);
      room = prism({{0, 0}, {size_[0], 0}, {size_[0], y}, {x, y}, {x, size_[1]}, {0, size_[1]}}, 0, height_, true);
    } else if (shape == 1) {  // a roof slopes over it
      room = prism(rectangle(0, 0, size_[0], size_[1]), 0, height_, true);
      const Rational low = length(20, 44);
      for (SolidBody3::Face& face : room.faces)
        for (Point3& p : face.polygon.points)
          if (p.x == 0 && p.z > 0) p.z = low;
    } else {
      room = prism(rectangle(0, 0, size_[0], size_[1]), 0, height_, true);
    }
    if (has_outside_) {  // no room then, in the sense of solids, but sheets around one
      room.kind = Kind::kSheets;
      for (SolidBody3::Face& face : room.faces) face.back = face.material;
    }
    room_.bodies.push_back(std::move(room));
  }

  void add_furniture() {
    switch (below(12)) {
      case 0:
      case 1:
      case 2:
      case 3:
        return add_run();
      case 4:
      case 5:
        return add_corner();
      case 6:
        return add_turned();
      case 7:
        return add_column();
      case 8:
        return add_table();
      case 9:
      case 10:
        return add_shelves();
      default:
        return add_picture();
    }
  }

  // A place by its distance from the beginning of a wall, going around counter-clockwise, and from the wall.
  Spot along(long wall, const Rational& s, const Rational& d) const {
    switch (wall % 4) {
      case 0:
        return {s, d};
      case 1:
        return {size_[0] - d, s};
      case 2:
        return {size_[0] - s, size_[1] - d};
      default:
        return {d, size_[1] - s};
    }
  }
  const Rational& length_of(long wall) const { return size_[static_cast<std::size_t>(wall % 2)]; }
  Plan at_wall(long wall, const Rational& s, const Rational& width, const Rational& d, const Rational& depth) const {
    return {along(wall, s, d), along(wall, s + width, d), along(wall, s + width, d + depth), along(wall, s, d + depth)};
  }

  // Cupboards side by side, and at times one on another.
  void add_run() {
    const long wall = below(4), count = between(1, 4);
    const Rational depth = length(6, 14), high = length(14, 44), off = gap();
    Rational s = below(2) == 0 ? gap() : length(4, 20);
    for (long k = 0; k < count; ++k) {
      const Rational width = length(8, 24), d = below(2) == 0 ? off : gap();
      if (s + width > length_of(wall)) break;
      const Rational deep = below(2) == 0 ? nearly(depth) : length(6, 14);
      const Rational low = foot();
      const Rational top = below(2) == 0 ? nearly(high) : length(14, 44);
      add_prism(at_wall(wall, s, width, d, deep), low, top);
      if (below(4) == 0) add_on_top(wall, s, width, d, deep, top);
      s += width + slit();
    }
  }

  void add_on_top(long wall, const Rational& s, const Rational& width, const Rational& d, const Rational& deep,
                  const Rational& top) {
    const Rational from = top + slit();
    const Rational to = below(2) == 0 ? Rational(height_ - gap()) : Rational(from + length(4, 12));
    const Rational aside = step(), wider = step(), off = d > 0 ? Rational(0) : gap(), deeper = step();
    add_prism(at_wall(wall, s + aside, width + wider, d + off, deep + deeper), from, to);
  }

  // Two cupboards at two walls, all but touching in the corner.
  void add_corner() {
    const long wall = below(4);
    const Rational depth = length(6, 14), high = length(14, 44), width = length(8, 20), off = gap(), end = gap();
    const Rational low = foot();
    add_prism(at_wall(wall, length_of(wall) - width - end, width, off, depth), low, high);
    const Rational from = below(3) == 0 ? gap() : Rational(off + depth + slit());
    const Rational wide = length(8, 20), other = gap(), deep = nearly(depth), bottom = foot();
    add_prism(at_wall(wall + 1, from, wide, other, deep), bottom, below(2) == 0 ? nearly(high) : length(14, 44));
  }

  // Twice the angle of this tangent is an ordinary angle, or all but none.
  Rational tangent() {
    if (below(3) == 0) return step() / 4;
    const long above = between(-9, 9);
    return fraction(above, between(10, 20));
  }

  // Moves a plan so that it is within the room, and this far from a wall.
  void put_at_wall(Plan& plan, long wall, const Rational& off) {
    std::array<Rational, 2> low = plan[0], high = plan[0];
    for (const Spot& spot : plan)
      for (std::size_t a = 0; a < 2; ++a) {
        low[a] = std::min(low[a], spot[a]);
        high[a] = std::max(high[a], spot[a]);
      }
    for (std::size_t a = 0; a < 2; ++a) {
      const bool is_across = static_cast<std::size_t>(wall % 2) != a;
      const Rational room = size_[a] - (high[a] - low[a]);
      const Rational to = !is_across               ? Rational(room * fraction(between(1, 9), 10))
                          : wall == 0 || wall == 3 ? off
                                                   : Rational(room - off);
      for (Spot& spot : plan) spot[a] += to - low[a];
    }
  }

  void add_turned() {
    const Rational width = length(8, 20), depth = length(6, 14);
    Plan plan = rectangle(0, 0, width, depth);
    const RoomTurn turn(tangent());
    for (Spot& spot : plan) turn(spot[0], spot[1]);
    const long wall = below(4);
    put_at_wall(plan, wall, below(2) == 0 ? gap() : length(4, 20));
    const Rational low = foot();
    add_prism(plan, low, length(8, 44));
  }

  void add_column() {
    static const std::array<Plan, 3> kPlans{Plan{{0, 0}, {8, 1}, {3, 7}}, Plan{{3, 0}, {7, 2}, {6, 7}, {2, 7}, {0, 3}},
                                            Plan{{2, 0}, {6, 0}, {8, 3}, {6, 6}, {2, 6}, {0, 3}}};
    Plan plan = kPlans[static_cast<std::size_t>(below(3))];
    for (Spot& spot : plan)
      for (Rational& x : spot) x /= 20;
    const long wall = below(4);
    put_at_wall(plan, wall, below(2) == 0 ? gap() : length(4, 20));
    const Rational low = foot();
    add_prism(plan, low, below(2) == 0 ? Rational(height_ - gap()) : length(8, 44));
  }

  void add_table() {
    const Rational width = length(16, 36), depth = length(12, 20), x = length(6, 14), y = length(6, 14);
    const Rational high = length(13, 16), inset = below(2) == 0 ? Rational(abs(step())) : Rational(1, 20);
    const Rational foot = gap(), head = below(2) == 0 ? Rational(0) : slit();
    add_prism(rectangle(x, y, x + width, y + depth), high, high + Rational(below(3) == 0 ? tiny() : Rational(1, 40)));
    const Rational thick = below(4) == 0 ? Rational(tiny() / 8) : Rational(1, 20);
    const long legs = between(1, 4), shape = below(3);
    for (long k = 0; k < legs; ++k) {
      const bool is_right = k % 2 == 1, is_rear = k / 2 == 1;
      const Rational x0 = is_right ? Rational(x + width - inset - thick) : Rational(x + inset);
      const Rational y0 = is_rear ? Rational(y + depth - inset - thick) : Rational(y + inset);
      const Rational x1 = x0 + thick, y1 = y0 + thick;
      if (shape == 0)
        add_prism(rectangle(x0, y0, x1, y1), foot, high - head);
      else if (shape == 1)
        add_prism({{x0, y0}, {x1, y0}, {x0, y1}}, foot, high - head);
      else
        add_sheet({at({x0, y0}, foot), at({x1, y1}, foot), at({x1, y1}, high - head), at({x0, y0}, high - head)});
    }
  }

  // Shelves at a wall one above the other: sheets, boxes, or boxes as thin as can be.
  void add_shelves() {
    const long wall = below(4), count = between(1, 4), shape = below(3);
    const Rational s = below(2) == 0 ? gap() : length(4, 20), width = length(8, 24), depth = length(4, 10);
    const Rational thick = shape == 1 ? Rational(1, 50) : tiny() / 16;
    Rational high = length(10, 24);
    for (long k = 0; k < count && high < height_ - 1; ++k) {
      const Rational aside = below(3) == 0 ? Rational(abs(step())) : Rational(0), off = gap();
      const Plan plan = at_wall(wall, s + aside, width, off, below(2) == 0 ? depth : nearly(depth));
      if (shape == 0)
        add_sheet({at(plan[0], high), at(plan[1], high), at(plan[2], high), at(plan[3], high)});
      else
        add_prism(plan, high, high + thick);
      high += thick + (below(3) == 0 ? Rational(tiny() / 16) : length(4, 8));
    }
  }

  // A sheet before a wall, or standing off it; a triangle, at times as thin as a needle.
  void add_picture() {
    const long wall = below(4);
    const Rational s = length(4, 20), width = length(4, 16), low = length(10, 24);
    const Rational off = below(4) == 0 ? Rational(0) : tiny() / 2;
    const Rational high = below(3) == 0 ? Rational(low + tiny()) : Rational(low + length(4, 12));
    switch (below(3)) {
      case 0: {
        const Spot from = along(wall, s, off),
                   to = along(wall, s + width, below(2) == 0 ? off : Rational(off + tiny()));
        return add_sheet({at(from, low), at(to, low), at(to, high), at(from, high)});
      }
      case 1: {
        const Spot from = along(wall, s, off), to = along(wall, s, off + width);
        return add_sheet({at(from, low), at(to, low), at(to, high), at(from, high)});
      }
      default: {
        const Spot from = along(wall, s, off), to = along(wall, s + width, off + length(0, 8));
        return add_sheet({at(from, low), at(to, low), at(from, high)});
      }
    }
  }

  std::mt19937_64 random_;
  FurnishedRoom3 room_;
  bool is_rounded_ = false, has_outside_ = false;
  std::uint32_t furniture_ = kWalls;
  Spot size_;
  Rational height_;
};

}  // namespace

FurnishedRoom3 furnished_room_3(std::uint64_t number) {
  FurnishedRoom3 room = Furnisher(number).draw();
  // Thin bodies that rounding turns inside out.
  std::erase_if(room.bodies, [](const SolidBody3& body) { return !is_valid_3(SolidBodies3{body}); });
  return room;
}

}  // namespace hottel::storm
