#include "viewer/picture/space/border_lines.h"

#include <algorithm>
#include <numbers>
#include <utility>

#include "kernel/plain_functions.h"

namespace hottel {
namespace {

Direction3 rounded(const Vector3& way) { return {to_double(way.x), to_double(way.y), to_double(way.z)}; }

Vector3 scaled(const Rational& factor, const Vector3& v) { return {factor * v.x, factor * v.y, factor * v.z}; }

// The first coordinate that is not 0.
Rational Vector3::*axis_of(const Vector3& v) { return v.x != 0 ? &Vector3::x : v.y != 0 ? &Vector3::y : &Vector3::z; }

// Takes a part away from others.
void take_away(const BorderPart3& gone, std::vector<BorderPart3>& parts) {
  std::vector<BorderPart3> rest;
  for (const BorderPart3& part : parts) {
    if (gone.to <= part.from || part.to <= gone.from) {
      rest.push_back(part);
      continue;
    }
    if (part.from < gone.from) rest.push_back({part.from, gone.from});
    if (gone.to < part.to) rest.push_back({gone.to, part.to});
  }
  parts = std::move(rest);
}

BorderPart3 part_of(const BorderLines3::Border& border) {
  return {std::min(border.at_begin, border.at_end), std::max(border.at_begin, border.at_end)};
}

}  // namespace

BorderLines3::BorderLines3(const PreparedScene3& prepared, const Point3& eye, std::span<const Face> seen,
                           double round_bend)
    : least_cosine_(same_bits::cos(round_bend * std::numbers::pi / 180) - 1e-9) {
  for (const Face& face : seen) add_side(prepared, eye, face);
  for (std::size_t k = 0; k < borders_.size(); ++k) borders_[k].drawn = drawn_of(k);
}

void BorderLines3::add_side(const PreparedScene3& prepared, const Point3& eye, const Face& face) {
  const Piece3& piece = prepared.arrangement().pieces()[face.surface];
  const Face& owner = piece.side(face.is_back).owner;
  const Surface& surface = prepared.scene.surfaces[owner.surface];
  const Direction3 normal = unit(rounded(doubled_area(piece.polygon)));
  sides_.push_back({surface.group, surface.material_of(owner.is_back), face.is_back ? -normal : normal});
  const std::vector<Point3>& points = piece.polygon.points;
  for (std::size_t k = 0; k < points.size(); ++k) {
    // As seen from the eye all outlines go around in one sense.
    const Point3 &a = points[k], &b = points[k + 1 == points.size() ? 0 : k + 1];
    side_of_.push_back(sides_.size() - 1);
    add_border((face.is_back ? b : a) - eye, (face.is_back ? a : b) - eye);
  }
  first_.push_back(borders_.size());
}

void BorderLines3::add_border(const Vector3& begin, const Vector3& end) {
  Vector3 way{end.x - begin.x, end.y - begin.y, end.z - begin.z};
  const auto axis = axis_of(way);
  way = scaled(1 / Rational(way.*axis), way);
  const Vector3 moment = cross(begin, way), along = scaled(begin.*axis, way);
  const Vector3 origin{begin.x - along.x, begin.y - along.y, begin.z - along.z};
  const auto [place, is_new] = known_.try_emplace(Key{way.x, way.y, way.z, moment.x, moment.y, moment.z},
                                                  static_cast<std::uint32_t>(lines_.size()));
  if (is_new) lines_.push_back({rounded(origin), rounded(way), {}});
  lines_[place->second].borders.push_back(borders_.size());
  borders_.push_back({place->second, rounded(begin), rounded(end), to_double(begin.*axis), to_double(end.*axis), {}});
}

// One ends where the other begins, seen from the same side.
bool BorderLines3::goes_on(std::size_t border, std::size_t other) const {
  const Border &a = borders_[border], &b = borders_[other];
  if ((a.at_begin < a.at_end) == (b.at_begin < b.at_end)) return false;
  const Side &one = sides_[side_of_[border]], &two = sides_[side_of_[other]];
  return one.group == two.group && one.material == two.material && dot(one.normal, two.normal) >= least_cosine_;
}

std::vector<BorderPart3> BorderLines3::drawn_of(std::size_t border) const {
  const BorderPart3 all = part_of(borders_[border]);
  std::vector<BorderPart3> drawn;
  if (all.from < all.to) drawn.push_back(all);
  for (const std::size_t other : lines_[borders_[border].line].borders)
    if (goes_on(border, other)) take_away(part_of(borders_[other]), drawn);
  return drawn;
}

}  // namespace hottel
