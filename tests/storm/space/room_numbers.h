// How the numbers of a furnished room are written.
#pragma once

#include <random>

#include "tests/storm/space/room_scene.h"

namespace hottel::storm {

// A turn by twice the angle of tangent t, about the vertical or another axis.
struct RoomTurn {
  Rational cosine = 1, sine = 0;

  RoomTurn() = default;
  explicit RoomTurn(const Rational& t) : cosine((1 - t * t) / (1 + t * t)), sine(2 * t / (1 + t * t)) {}
  void operator()(Rational& u, Rational& v) const {
    const Rational before = u;
    u = cosine * before - sine * v;
    v = sine * before + cosine * v;
  }
};

// Turns a room, rounds its numbers and cuts its polygons as RoomNumbers3 says. Bodies that would have no thickness any
// more, or hardly, and sheets without area are left out.
void write_numbers(FurnishedRoom3& room, std::mt19937_64& random);

}  // namespace hottel::storm
