#include "geometry/space/exchange/event_surfaces.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "geometry/name.h"
#include "geometry/scene_names.h"
#include "geometry/space/exchange/face_sight.h"
#include "geometry/space/pairs/pair_details.h"
#include "geometry/space/pairs/pair_integrator.h"
#include "geometry/space/prepared/element_table.h"
#include "geometry/space/prepared/face_patches.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "kernel/support/failure.h"
#include "kernel/support/parallel.h"

namespace hottel {
namespace {

// A line of space by its direction and moment, of all multiples one.
using LineKey = std::array<Rational, 6>;

LineKey line_through(const Point3& a, const Point3& b) {
  const Vector3 way = b - a, moment = cross(a - Point3{}, way);
  LineKey key{way.x, way.y, way.z, moment.x, moment.y, moment.z};
  const Rational first = *std::ranges::find_if(key, [](const Rational& x) { return x != 0; });
  for (Rational& x : key) x /= first;
  return key;
}

// The plane of a face, in doubles.
struct FlatPlane {
  std::array<double, 3> at, normal;

  std::optional<std::array<double, 3>> met_by(const std::array<double, 3>& eye, const Direction3& way) const {
    const double speed = normal[0] * way.x + normal[1] * way.y + normal[2] * way.z;
    if (speed == 0) return std::nullopt;
    double height = 0;
    for (std::size_t c = 0; c < 3; ++c) height += normal[c] * (at[c] - eye[c]);
    const double s = height / speed;
    return std::array{eye[0] + s * way.x, eye[1] + s * way.y, eye[2] + s * way.z};
  }
};

FlatPlane plane_of(const Vertices3& vertices, const Patch3& patch) {
  const std::vector<Point3> corners = corners_of(vertices, patch);
  Vector3 normal;
  for (std::size_t k = 1; k + 1 < corners.size() && normal.is_zero(); ++k)
    normal = cross(corners[k] - corners[0], corners[k + 1] - corners[0]);
  return {to_doubles(corners[0]), to_doubles(normal)};
}

// The events of two patches.
class PatchEvents {
 public:
  PatchEvents(const PreparedScene3& prepared, const ElementTable3::Part& from, const ElementTable3::Part& to)
      : prepared_(prepared), vertices_(prepared.occluders().vertices()) {
    planes_ = {plane_of(vertices_, from.patch), plane_of(vertices_, to.patch)};
    details_.wants_corners = true;
    const bool is_turned = to.label < from.label;  // a pair is looked at from the face that comes first
    const PairResult3 found =
        prepared.measurer().measure((is_turned ? to : from).patch, (is_turned ? from : to).patch,
                                    {.tolerance = kCoarseTolerance, .always_along_edges = true}, &details_);
    if (found.is_undecided) problem_ = found.problem;
  }

  const std::string& problem() const { return problem_; }

  void append(std::vector<EventSurface3>& events) const {
    for (const PairDetails3::Stretch& stretch : details_.stretches) add_stretch(stretch, events);
  }

 private:
  using Corner = PairDetails3::Corner;

  // Parts of a stretch that follow each other have one event as long as its corner stays.
  void add_stretch(const PairDetails3::Stretch& stretch, std::vector<EventSurface3>& events) const {
    std::map<std::uint64_t, std::size_t> open;  // events by label
    double end = -1;
    for (const PairDetails3::Piece& piece : stretch.pieces) {
      if (piece.low - end > kGap) open.clear();
      std::map<std::uint64_t, std::size_t> now;
      for (const Corner& corner : piece.corners) {
        if (!is_event(stretch, corner)) continue;
        const auto before = open.find(corner.label);
        const std::size_t number = before != open.end() ? before->second : events.size();
        if (before == open.end()) events.push_back(begun(stretch, corner, piece.low));
        extend(corner, piece, events[number]);
        now[corner.label] = number;
      }
      open = std::move(now);
      end = piece.high;
    }
  }

  // Something of it is not of the two patches alone.
  static bool is_event(const PairDetails3::Stretch& stretch, const Corner& corner) {
    return stretch.role != StretchRole3::kSource || corner.is_of_others;
  }

  EventSurface3 begun(const PairDetails3::Stretch& stretch, const Corner& corner, double low) const {
    EventSurface3 event;
    event.kind = corner.vertex ? EventSurface3::Kind::kEV : EventSurface3::Kind::kEEE;
    event.edge = {place(stretch.from), place(stretch.to)};
    for (const std::uint32_t piece : stretch.surfaces) event.surfaces.push_back(surface_of(piece));
    sort_out(event.surfaces);
    event.begin = low;
    if (corner.vertex) event.vertex = place(*corner.vertex);
    for (const auto& [a, b] : corner.edges) event.others.push_back({place(a), place(b)});
    for (const std::uint32_t piece : corner.surfaces) event.crossing.push_back(surface_of(piece));
    sort_out(event.crossing);
    return event;
  }

  void extend(const Corner& corner, const PairDetails3::Piece& piece, EventSurface3& event) const {
    event.end = piece.high;
    const std::array<double, 3> from = to_doubles(event.edge[0]), to = to_doubles(event.edge[1]);
    const auto count = static_cast<double>(corner.ways.size() - 1);
    for (std::size_t k = 0; k < corner.ways.size(); ++k) {
      const double t = std::lerp(piece.low, piece.high, static_cast<double>(k) / count);
      if (!event.rulings.empty() && t <= event.rulings.back().t) continue;
      std::array<double, 3> eye{};
      for (std::size_t c = 0; c < 3; ++c) eye[c] = std::lerp(from[c], to[c], t);
      const auto a = planes_[0].met_by(eye, corner.ways[k]), b = planes_[1].met_by(eye, corner.ways[k]);
      if (a && b) event.rulings.push_back({t, *a, *b});
    }
  }

  std::uint32_t surface_of(std::uint32_t piece) const { return prepared_.arrangement().pieces()[piece].surface; }
  static void sort_out(std::vector<std::uint32_t>& surfaces) {
    std::ranges::sort(surfaces);
    surfaces.erase(std::unique(surfaces.begin(), surfaces.end()), surfaces.end());
  }
  Point3 place(const WeightedPoint3& p) const {
    const Rational unit = vertices_.scale() / p.weight;
    const Point3& origin = vertices_.origin();
    return {origin.x + unit * p.numerator.x, origin.y + unit * p.numerator.y, origin.z + unit * p.numerator.z};
  }

  static constexpr double kGap = 0x1p-40;

  const PreparedScene3& prepared_;
  const Vertices3& vertices_;
  std::array<FlatPlane, 2> planes_;
  PairDetails3 details_;
  std::string problem_;
};

// The three edges of an EEE, in an order of their own: equal for what is told by another of them.
using EdgeKeys = std::array<LineKey, 3>;

std::optional<EdgeKeys> keys_of(const EventSurface3& event) {
  if (event.kind != EventSurface3::Kind::kEEE || event.others.size() != 2) return std::nullopt;
  EdgeKeys keys{line_through(event.edge[0], event.edge[1]), line_through(event.others[0][0], event.others[0][1]),
                line_through(event.others[1][0], event.others[1][1])};
  std::ranges::sort(keys);
  return keys;
}

// Leaves what is told by the least of the edges by which it is told.
void leave_once(std::vector<EventSurface3>& events) {
  std::map<EdgeKeys, LineKey> teller;
  for (const EventSurface3& event : events)
    if (const auto keys = keys_of(event)) {
      const LineKey own = line_through(event.edge[0], event.edge[1]);
      const auto [place, is_new] = teller.try_emplace(*keys, own);
      if (!is_new) place->second = std::min(place->second, own);
    }
  std::erase_if(events, [&](const EventSurface3& event) {
    const auto keys = keys_of(event);
    return keys && teller.at(*keys) != line_through(event.edge[0], event.edge[1]);
  });
}

}  // namespace

std::vector<EventSurface3> event_surfaces(const PreparedScene3& prepared, const Face& from, const Face& to) {
  const DefaultFloatingPoint arithmetic;
  const ElementTable3& table = *prepared.elements(Granularity::kFace);
  const bool are_free = table.is_partly_covered(from.number()) && table.is_partly_covered(to.number());
  const auto parts = [&](const Face& face) {
    return are_free ? table.free_parts(face.number()) : table.parts(face.number());
  };
  std::vector<EventSurface3> events;
  for (const ElementTable3::Part& i : parts(from))
    for (const ElementTable3::Part& j : parts(to)) {
      if (i.patch.surface == j.patch.surface) continue;
      const PatchEvents of_patches(prepared, i, j);
      if (!of_patches.problem().empty())
        throw RequestError(quoted_name(face_name(prepared.scene, from)) + " and " +
                           quoted_name(face_name(prepared.scene, to)) + ": " + of_patches.problem());
      of_patches.append(events);
    }
  leave_once(events);
  return events;
}

}  // namespace hottel
