// How findings speak of numbers, places and surfaces.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "geometry/plane/predicates/vertices.h"
#include "geometry/plane/scene/scene.h"
#include "kernel/root_sum.h"

namespace hottel {

// Returns the number as shortly as it can be said: the decimal when that is exact, p/q when that is short, otherwise
// a decimal (kernel/decimal.h).
std::string short_text(const Rational& value);

// "(2, 3/7)"
std::string place_text(const Point2& point);

// Returns sqrt(squared), correctly rounded, as its shortest decimal.
std::string length_text(const Rational& squared);

// "'a'", "'a' and 'b'", "'a', 'b', 'c' and 4 more"
std::string names_text(const Scene2& scene, const std::vector<std::uint32_t>& surfaces);

// "the solid 'box'"
std::string solid_text(const Scene2& scene, std::uint32_t group);

inline Point2 to_point(const ExactPoint2& p) { return {p.x, p.y}; }
inline ExactPoint2 to_exact(const Point2& p) { return {p.x, p.y}; }
inline Point2 middle(const Point2& a, const Point2& b) { return {(a.x + b.x) / 2, (a.y + b.y) / 2}; }
inline Point2 middle(const Edge2& edge) { return middle(edge.from, edge.to); }

}  // namespace hottel
