// The surfaces of lines along which what two faces see of each other changes: EV and EEE.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "geometry/face.h"
#include "geometry/space/point.h"

namespace hottel {

struct PreparedScene3;

// A part of a surface of lines that touch three edges, or an edge and a vertex, and are free between both faces.
//
//   (1) kEV: the lines through a stretch of an edge and a vertex: a plane. kEEE: those through a stretch of an edge
//       that meet two other edges: a quadric. At least one of these is of something between the faces, or stands on
//       them
//   (2) `edge` is the stretch, t from 0 to 1 along it; the lines are those with t from begin to end
//   (3) `others` of an EEE: two edges, exactly; where surfaces pierce each other, or stand on one, what they share has
//       no ends here and they are named in `crossing`, ascending
//   (4) rulings: some of the lines, evenly in t: where each meets the planes of both faces, in doubles
struct EventSurface3 {
  enum class Kind : unsigned char { kEV, kEEE };
  struct Ruling {
    double t;
    std::array<double, 3> on_from, on_to;
  };

  Kind kind = Kind::kEV;
  std::array<Point3, 2> edge;
  std::vector<std::uint32_t> surfaces;  // with that edge, ascending
  double begin = 0, end = 1;
  std::optional<Point3> vertex;
  std::vector<std::array<Point3, 2>> others;
  std::vector<std::uint32_t> crossing;
  std::vector<Ruling> rulings;
};

// Returns the event surfaces between two faces.
//
//   (1) exact: which there are, and where they begin and end up to 2^-46 of a stretch (StretchMapper3)
//   (2) a surface that is told by several of its edges is there once, by the one that comes first: as a whole where it
//       has three edges; an edge that others cut, or along which what else is seen changes, may make several parts
//   (3) lines that touch the edges and vertices of the two faces alone are no events between them
//   (4) the same for any number of threads; empty where nothing is seen, or nothing stands between
//
// Throws RequestError, naming both, where the pair cannot be looked at. COST: that of measuring the pair coarsely.
std::vector<EventSurface3> event_surfaces(const PreparedScene3& prepared, const Face& from, const Face& to);

}  // namespace hottel
