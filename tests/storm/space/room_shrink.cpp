#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include "geometry/space/scene/near_plane.h"
#include "tests/storm/space/room_scene.h"

namespace hottel::storm {

namespace {

using Kind = SolidBody3::Kind;

constexpr int kMostTries = 150;
constexpr std::array<Rational Point3::*, 3> kRoomAxes{&Point3::x, &Point3::y, &Point3::z};
const Rational kTypedUnit(1, 1'000'000);

template <class List>
List without(List list, std::size_t k) {
  list.erase(list.begin() + static_cast<std::ptrdiff_t>(k));
  return list;
}

class Shrinker {
 public:
  Shrinker(SolidBodies3 bodies, const std::function<bool(const SolidBodies3&)>& fails)
      : bodies_(std::move(bodies)), fails_(fails) {}

  SolidBodies3 shrink() {
    while (leave_out_bodies() || open_bodies() || leave_out_faces() || shorten_numbers()) {
    }
    return std::move(bodies_);
  }

 private:
  // Takes what is given where it is valid and still fails.
  bool take(SolidBodies3 some) {
    if (tries_ >= kMostTries || !is_valid_3(some)) return false;
    ++tries_;
    if (!fails_(some)) return false;
    bodies_ = std::move(some);
    return true;
  }

  bool leave_out_bodies() {
    bool is_less = false;
    for (std::size_t b = bodies_.size(); b-- > 0;) is_less |= bodies_.size() > 1 && take(without(bodies_, b));
    return is_less;
  }

  bool open_bodies() {
    bool is_less = false;
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
      if (bodies_[b].kind == Kind::kSheets) continue;
      SolidBodies3 some = bodies_;
      some[b].kind = Kind::kSheets;
      for (SolidBody3::Face& face : some[b].faces) face.back = face.material;
      is_less |= take(std::move(some));
    }
    return is_less;
  }

  bool leave_out_faces() {
    bool is_less = false;
    for (std::size_t b = 0; b < bodies_.size(); ++b)
      for (std::size_t f = bodies_[b].faces.size(); f-- > 0;) {
        if (bodies_[b].kind != Kind::kSheets || bodies_[b].faces.size() == 1) continue;
        SolidBodies3 some = bodies_;
        some[b].faces = without(some[b].faces, f);
        is_less |= take(std::move(some));
      }
    return is_less;
  }

  // All coordinates along an axis that have one value get one of fewer digits.
  bool shorten_numbers() {
    bool is_less = false;
    for (const auto axis : kRoomAxes) {
      std::set<Rational> values;
      for (const SolidBody3& body : bodies_)
        for (const SolidBody3::Face& face : body.faces)
          for (const Point3& p : face.polygon.points) values.insert(p.*axis);
      for (const Rational& value : values)
        for (const long unit : {1L, 2L, 10L, 100L, 10'000L}) {
          const Rational to(static_cast<long>(value.get_d() * static_cast<double>(unit)), unit);
          Rational shorter = to;
          shorter.canonicalize();
          if (shorter == value) break;
          if (take(with_value(axis, value, shorter))) {
            is_less = true;
            break;
          }
        }
    }
    return is_less;
  }

  SolidBodies3 with_value(Rational Point3::*axis, const Rational& from, const Rational& to) const {
    SolidBodies3 some = bodies_;
    for (SolidBody3& body : some)
      for (SolidBody3::Face& face : body.faces) {
        bool is_changed = false;
        for (Point3& p : face.polygon.points)
          if (p.*axis == from) {
            p.*axis = to;
            is_changed = true;
          }
        if (is_changed && face.polygon.is_nearly_plane) accept_nearly_plane(face.polygon, kTypedUnit);
      }
    return some;
  }

  SolidBodies3 bodies_;
  const std::function<bool(const SolidBodies3&)>& fails_;
  int tries_ = 0;
};

}  // namespace

SolidBodies3 shrunk_room_3(SolidBodies3 bodies, const std::function<bool(const SolidBodies3&)>& fails) {
  return Shrinker(std::move(bodies), fails).shrink();
}

}  // namespace hottel::storm
