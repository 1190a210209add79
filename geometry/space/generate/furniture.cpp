#include "geometry/space/generate/furniture.h"

#include <array>

namespace hottel {
namespace {

// Where a piece of furniture stands, and how it is turned: its x goes along (c, s) and its y along (-s, c), two numbers
// whose root of the sum of squares is a whole one.
struct Stand3 {
  Dot3 origin;
  std::int64_t c = 1, s = 0, unit = 1;  // unit^2 = c^2 + s^2

  // The way to (x, y), in millimetres along the turned axes, rounded towards 0 to whole units of each.
  Dot3 along(std::int64_t x, std::int64_t y) const {
    const std::int64_t p = x / unit, q = y / unit;
    return {p * c - q * s, p * s + q * c, 0};
  }
  // A box from low to high, rounded in the same way.
  Block3 block(const Dot3& low, const Dot3& high) const {
    const Dot3 corner = along(low.x, low.y);
    return {origin + corner + Dot3{0, 0, low.z},
            along(high.x, low.y) - corner,
            along(low.x, high.y) - corner,
            {0, 0, high.z - low.z}};
  }
};

// Turned a little to the left or right, and half around where it is asked for.
Stand3 turned_stand(const Dot3& origin, bool half_around, Chance& chance) {
  constexpr std::array<std::array<std::int64_t, 3>, 3> kTriples = {{{4, 3, 5}, {12, 5, 13}, {15, 8, 17}}};
  const auto [c, s, unit] = kTriples[chance.below(3)];
  const std::int64_t turn = half_around ? -1 : 1, side = chance.below(2) == 0 ? -1 : 1;
  return {origin, turn * c, turn * side * s, unit};
}

// Legs end within the top, boards within the sides of a shelf: no two faces of a piece lie in one plane and meet.
void add_table(GeneratorCanvas3& canvas, const std::string& name, const Stand3& stand, Paint paint) {
  canvas.add_block(name + ".top", stand.block({-800, -450, 710}, {800, 450, 750}), paint);
  for (int leg = 0; leg < 4; ++leg) {
    const std::int64_t x = leg % 2 == 0 ? -740 : 680, y = leg / 2 == 0 ? -390 : 330;
    canvas.add_standing(numbered((name + ".leg").c_str(), leg), stand.block({x, y, 0}, {x + 60, y + 60, 730}), paint);
  }
}

// The back is at the far end of y.
void add_chair(GeneratorCanvas3& canvas, const std::string& name, const Stand3& stand, Paint paint) {
  canvas.add_block(name + ".seat", stand.block({-220, -220, 430}, {220, 220, 460}), paint);
  for (int leg = 0; leg < 4; ++leg) {
    const std::int64_t x = leg % 2 == 0 ? -200 : 160, y = leg / 2 == 0 ? -200 : 160;
    canvas.add_standing(numbered((name + ".leg").c_str(), leg), stand.block({x, y, 0}, {x + 40, y + 40, 440}), kWood);
  }
  canvas.add_block(name + ".back", stand.block({-190, 160, 450}, {190, 200, 900}), paint);
}

void add_shelf(GeneratorCanvas3& canvas, const std::string& name, const Dot3& origin, Paint paint) {
  const Stand3 stand{origin};
  canvas.add_standing(name + ".side0", stand.block({0, 0, 0}, {30, 300, 1800}), kWood);
  canvas.add_standing(name + ".side1", stand.block({870, 0, 0}, {900, 300, 1800}), kWood);
  for (int board = 0; board < 4; ++board) {
    const std::int64_t z = 100 + 500 * board;
    canvas.add_block(numbered((name + ".board").c_str(), board), stand.block({20, 10, z}, {880, 290, z + 30}), kWood);
  }
  canvas.add_block(name + ".back", stand.block({15, 270, 50}, {885, 285, 1750}), paint);
}

void add_lamps(GeneratorCanvas3& canvas, const std::string& number, const Dot3& foot, const Dot3& table) {
  const Stand3 stand{foot};
  canvas.add_standing("lamp" + number + ".foot", stand.block({-150, -150, 0}, {150, 150, 30}), kGrey);
  canvas.add_block("lamp" + number + ".pole", stand.block({-15, -15, 15}, {15, 15, 1500}), kGrey);
  canvas.add_block("lamp" + number + ".shade", stand.block({-175, -175, 1450}, {175, 175, 1750}), kLamp);
  canvas.add_block("pendant" + number, Stand3{table}.block({-200, -200, 1900}, {200, 200, 2000}), kLamp);
}

}  // namespace

void furnish(GeneratorCanvas3& canvas, const std::string& number, const Dot3& corner, Chance& chance) {
  const auto paint = [&chance] {
    constexpr std::array<Paint, 4> kPaints = {kWhite, kRed, kBlue, kWood};
    return kPaints[chance.below(4)];
  };
  const auto somewhat = [&chance] { return chance.between(-150, 150); };
  // No call has two drawn arguments: their order is up to the compiler.
  const Dot3 middle = corner + Dot3{2500 + somewhat(), 1700 + somewhat(), 0};
  const Stand3 table = turned_stand(middle, false, chance);
  add_table(canvas, "table" + number, table, paint());
  for (int chair = 0; chair < 2; ++chair) {
    const Dot3 seat = table.along(chance.between(-250, 250), chair == 0 ? 680 : -680);
    const Stand3 stand = turned_stand(middle + seat, chair == 1, chance);
    add_chair(canvas, numbered(("table" + number + ".chair").c_str(), chair), stand, paint());
  }
  const Dot3 shelf = corner + Dot3{600 + chance.between(0, 1500), 3680, 0};
  add_shelf(canvas, "shelf" + number, shelf, paint());
  const Dot3 foot = corner + Dot3{4400 + somewhat(), 3400 + somewhat(), 0};
  add_lamps(canvas, number, foot, middle);
}

}  // namespace hottel
