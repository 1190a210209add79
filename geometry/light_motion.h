// How lights move: how far along a path, and how far turned.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "kernel/rational.h"

namespace hottel {

// Digits that motions are computed with, before they are rounded to doubles. The same on every machine.
inline constexpr long kMotionPrecision = 320;

// Returns what is wrong with the path of a light that stands at a position, in either dimension, as the end of a
// sentence about the light; empty when nothing is. text_of: what a point is called.
template <class Path, class Point, class Text>
std::string path_problem(const Path& path, const Point& position, const Text& text_of) {
  if (path.seconds <= 0) return "has a path of no time: seconds must be greater than 0";
  if (std::ranges::adjacent_find(path.points, std::ranges::not_equal_to()) == path.points.end())
    return "has a path that leads nowhere: it needs two points that differ";
  if (position != path.points.front())
    return "has its position at " + text_of(position) + " but its path starts at " + text_of(path.points.front()) +
           ": leave the position out, or say where the path starts";
  return "";
}

// A place on a line of segments.
struct PathPlace {
  std::size_t segment = 0;
  std::vector<double> point;  // its coordinates
};

// Returns where one is after a part of the way along points, each given by its coordinates; of a closed way the last
// segment leads back to the first point. part: 0 at the first point, 1 at the end.
//
//   (1) coordinates are rounded to doubles: those of the real place, or their neighbours
//   (2) the first point is where part is 0, and of a way that is not closed the last one where it is 1, each rounded
// Throws RequestError where a coordinate is beyond the range of doubles.
// REQUIRES two points that differ, of as many coordinates each, and 0 <= part <= 1.
PathPlace place_on_path(const std::vector<std::vector<Rational>>& points, bool is_closed, const Rational& part);

// Returns the part of a way that is done after some seconds, of one that takes `seconds`: 1 where it has ended; a
// closed one is walked over and over.
Rational part_of_way(const Rational& time, const Rational& seconds, bool is_closed);

// The number of degrees from 0 on, below 360, that is the same angle.
Rational within_a_turn(const Rational& degrees);

// The doubles nearest to a vector turned about the axes x, y and z, in this order, each by so many degrees. Of a vector
// scaled so that its largest component is 1.
//
//   (1) quarters of a turn are exact
// REQUIRES a vector of three components that is not zero.
std::vector<double> turned(const std::vector<Rational>& vector, const std::vector<Rational>& degrees);

}  // namespace hottel
