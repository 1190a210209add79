#include "tests/storm/space/room_patches.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <random>
#include <utility>

#include "geometry/face.h"
#include "geometry/space/exchange/exchange.h"
#include "geometry/space/scene/near_plane.h"
#include "geometry/space/scene/patch_seats.h"
#include "kernel/support/failure.h"
#include "tests/storm/space/room_laws.h"

namespace hottel::storm {

namespace {

constexpr double kRounding = 1e-14;  // of areas and of sums
const Rational kTypedUnit(1, 1'000'000);

Point3 between(const Point3& a, const Point3& b, const Rational& t) {
  const Vector3 way = b - a;
  return {a.x + t * way.x, a.y + t * way.y, a.z + t * way.z};
}

class Patcher {
 public:
  Patcher(Scene3 scene, std::uint64_t chance) : random_(chance), room_{std::move(scene), {}} {
    for (std::uint32_t s = 0; s < room_.scene.surfaces.size(); ++s) room_.root.push_back(s);
  }

  PatchedRoom3 patched() {
    for (long left = 1 + below(5); left > 0; --left) add();
    seat_patches(room_.scene, kTypedUnit);
    return std::move(room_);
  }

 private:
  long below(long count) { return static_cast<long>(random_() % static_cast<std::uint64_t>(count)); }

  // From 0 to 1, the ends among them, and what is all but an end.
  Rational share() {
    if (below(6) == 0) return scaled_by_power_of_two(1, -static_cast<int>(3 + below(20)));
    Rational result(below(9), 8);
    result.canonicalize();
    return result;
  }
  std::pair<Rational, Rational> range() {
    Rational a = share(), b = share();
    if (a > b) std::swap(a, b);
    return a < b ? std::pair(a, b) : std::pair(Rational(0), Rational(1));
  }

  void add() {
    Scene3& scene = room_.scene;
    const auto base = static_cast<std::uint32_t>(below(static_cast<long>(scene.surfaces.size())));
    const std::vector<Polygon3> facets = facets_of(scene.polygons[base]);
    const Polygon3& facet = facets[static_cast<std::size_t>(below(static_cast<long>(facets.size())))];
    std::optional<Polygon3> part =
        facets.size() > 1 && below(2) == 0 ? part_across_bends(scene.polygons[base]) : part_of(facet);
    if (!part) return;
    const bool is_on_back = scene.surfaces[base].back && below(2) == 0;
    if (is_on_back) std::reverse(part->points.begin(), part->points.end());
    Surface surface;
    surface.name = fmt::format("patch {}", scene.surfaces.size());
    surface.material = static_cast<std::uint32_t>(below(static_cast<long>(scene.materials.size())));
    const bool other_side_has_rows = scene.surfaces[base].material_of(!is_on_back).has_value();
    if (other_side_has_rows && below(3) == 0) surface.back = surface.material;
    surface.group = static_cast<std::uint32_t>(scene.groups.size());
    scene.groups.emplace_back(surface.name);
    surface.on = static_cast<std::uint32_t>(scene.bases.size());
    scene.bases.push_back({scene.surfaces[base].name, is_on_back});
    // The side of the root that its front is on.
    room_.root.push_back(room_.root[base]);
    scene.add(std::move(surface), *std::move(part));
  }

  // Of a rectangle that rounding has bent; its corners lie beside it by as little.
  std::optional<Polygon3> part_across_bends(const Polygon3& bent) {
    const auto& p = bent.points;
    if (p.size() != 4 || !bent.facets.empty()) return std::nullopt;
    const auto [u0, u1] = range();
    const auto [v0, v1] = range();
    const auto at = [&](const Rational& u, const Rational& v) {
      return between(between(p[0], p[1], u), between(p[3], p[2], u), v);
    };
    Polygon3 part{{at(u0, v0), at(u1, v0), at(u1, v1), at(u0, v1)}, {}};
    accept_nearly_plane(part, kTypedUnit);
    return part;
  }

  std::optional<Polygon3> part_of(const Polygon3& facet) {
    const auto& p = facet.points;
    if (!is_convex(facet)) return std::nullopt;
    if (below(8) == 0) return facet;
    const bool is_parallelogram = p.size() == 4 && p[1] - p[0] == p[2] - p[3];
    if (is_parallelogram && below(4) != 0) {
      const auto [u0, u1] = range();
      const auto [v0, v1] = range();
      const auto at = [&](const Rational& u, const Rational& v) {
        return between(between(p[0], p[1], u), between(p[3], p[2], u), v);
      };
      return Polygon3{{at(u0, v0), at(u1, v0), at(u1, v1), at(u0, v1)}, {}};
    }
    const auto k = static_cast<std::size_t>(below(static_cast<long>(p.size())));
    const Point3 &a = p[k], &b = p[(k + 1) % p.size()], &c = p[(k + p.size() - 1) % p.size()];
    const auto [low, high] = range();
    Polygon3 part{{between(a, b, high), between(a, c, high)}, {}};
    if (low > 0)
      part.points.insert(part.points.end(), {between(a, c, low), between(a, b, low)});
    else
      part.points.push_back(a);
    return part;
  }

  std::mt19937_64 random_;
  PatchedRoom3 room_;
};

// S and areas of faces of a room, those of patches added to those of what they lie on.
struct Sums {
  std::map<Face, double> areas;
  std::map<std::pair<Face, std::optional<Face>>, std::pair<double, double>> exchange;  // S, and what it may be off
};

// The side of the root that a face is on.
Face side_of_root(const PatchedRoom3& room, const Element& element) {
  bool is_back = element.is_back;
  for (std::uint32_t s = element.surface; room.scene.surfaces[s].on;) {
    const PatchBase& base = room.scene.bases[*room.scene.surfaces[s].on];
    is_back = is_back != base.is_back;
    s = *room.scene.find(base.name);
  }
  return {room.root[element.surface], is_back};
}

Sums sums_of(const PatchedRoom3& room, const ExchangeMatrix& matrix, double tolerance) {
  Sums sums;
  const auto& elements = matrix.elements();
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    const Face from = side_of_root(room, elements[i]);
    const double area = elements[i].area.value;
    if (elements[i].material) sums.areas[from] += area;
    if (!matrix.has_row(i)) continue;
    for (std::size_t k = 0; k < matrix.row(i).size(); ++k) {
      const FactorEntry& entry = matrix.row(i)[k];
      std::optional<Face> to;
      if (entry.to != matrix.sky()) to = side_of_root(room, elements[entry.to]);
      auto& [sum, error] = sums.exchange[{from, to}];
      sum += area * entry.factor.value;
      error += area * (error_of(matrix, i, k, tolerance) + kRounding * entry.factor.value);
    }
  }
  return sums;
}

std::string face_text(const Scene3& scene, const std::optional<Face>& face) {
  if (!face) return "sky";
  return side_text({scene.surfaces[face->surface].name, face->is_back});
}

std::string sums_differ(const Scene3& scene, const Sums& before, const Sums& after) {
  // A face that another one in its plane shares may have lost to patches what was not its own.
  const auto is_kept = [&](const std::optional<Face>& face) {
    if (!face) return true;
    const auto a = before.areas.find(*face), b = after.areas.find(*face);
    const double was = a == before.areas.end() ? 0 : a->second, is = b == after.areas.end() ? 0 : b->second;
    return std::abs(is - was) <= kRounding * was;
  };
  std::string wrong;
  const auto hold = [&](const auto& some, const auto& others, bool is_after) {
    for (const auto& [pair, sum] : some) {
      if (!is_kept(pair.first) || !is_kept(pair.second)) continue;
      const auto other = others.find(pair);
      if (is_after && other != others.end()) continue;
      const auto [value, error] = other == others.end() ? std::pair(0., 0.) : other->second;
      // S = 0 is exact: a pair that one of the two matrices alone lists is wrong, however small it is.
      if (other == others.end() || !(std::abs(value - sum.first) <= error + sum.second))
        wrong += fmt::format("S({}, {}) = {:.17g} {} patches, {:.17g} {} them: off by {:.3g}, errors {:.3g}\n",
                             face_text(scene, pair.first), face_text(scene, pair.second), sum.first,
                             is_after ? "with" : "without", value, is_after ? "without" : "with",
                             std::abs(value - sum.first), error + sum.second);
    }
  };
  hold(before.exchange, after.exchange, false);
  hold(after.exchange, before.exchange, true);
  return wrong;
}

}  // namespace

PatchedRoom3 with_patches(Scene3 scene, std::uint64_t chance) { return Patcher(std::move(scene), chance).patched(); }

std::string room_patches_are_broken(const RoomSubject3& subject) {
  const double tolerance = kRoomTolerances3[0];
  const auto are_wrong = [&](const ExchangeMatrix& some, const Scene3& scene) {
    return rows_are_wrong(some, tolerance) + radiosities_are_wrong(some, scene);
  };
  if (!are_wrong(subject.loose(), subject.scene()).empty()) return "";  // which other laws tell
  const PatchedRoom3 room = with_patches(subject.scene(), subject.chance());
  std::optional<ExchangeMatrix> matrix;
  try {
    validate(room.scene);
    matrix = exact_exchange(prepare(room.scene), {.wants_measures = true, .tolerance = tolerance});
  } catch (const InputError& error) {
    // Two on one side, of two materials.
    if (std::string(error.what()).find("claim the same side") != std::string::npos) return "";
    return std::string(error.what()) + "\n";
  } catch (const RequestError& error) {
    return std::string(error.what()) + "\n";
  }
  PatchedRoom3 bare{subject.scene(), {}};
  for (std::uint32_t s = 0; s < bare.scene.surfaces.size(); ++s) bare.root.push_back(s);
  return are_wrong(*matrix, room.scene) +
         sums_differ(bare.scene, sums_of(bare, subject.loose(), tolerance), sums_of(room, *matrix, tolerance));
}

}  // namespace hottel::storm
