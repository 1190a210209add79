// Surfaces divided into elements.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/element.h"
#include "geometry/plane/scene/scene.h"

namespace hottel {

// Divides every surface into n equal parts. Throws ContractViolation unless n > 0.
void divide_into(Scene2& scene, std::uint32_t n);

// Divides every surface into the least number of equal parts that are no longer than h. Exact: a surface of length 3 h
// has 3 parts. Returns nothing; or the first surface that asks for more than `most` parts: then it and those after it
// stay as they are.
// Throws ContractViolation unless h > 0.
std::optional<std::uint32_t> divide_by_length(Scene2& scene, const Rational& h, std::uint32_t most);

// The same of a valid scene, which stays valid. Throw ContractViolation also where n or `most` is above kMaxElements,
// or a surface has trees.
void divide_into(ValidScene2& scene, std::uint32_t n);
std::optional<std::uint32_t> divide_by_length(ValidScene2& scene, const Rational& h, std::uint32_t most);

// What lies between two parts of the way along an edge.
struct EdgeSpan2 {
  Rational from = 0, to = 1;

  // Where a node under one of so many equal parts lies, and an element: a face or a part of it. Exact.
  static EdgeSpan2 of(std::uint32_t parts, const TreeNode& node);
  static EdgeSpan2 of(const Element& element);

  friend bool operator==(const EdgeSpan2&, const EdgeSpan2&) = default;
};

// Where a surface is cut into the elements of both its faces: strictly between 0 and 1 of the way, ascending.
struct SurfaceCuts2 {
  std::vector<Rational> at{};

  SurfaceCuts2() = default;
  SurfaceCuts2(std::uint32_t equal_parts);  // throws ContractViolation for 0
  explicit SurfaceCuts2(const Surface& surface);

  bool is_cut() const { return !at.empty(); }
  std::size_t count() const { return at.size() + 1; }  // of what lies between
  friend bool operator==(const SurfaceCuts2&, const SurfaceCuts2&) = default;
};

// Where each surface is cut.
using Division2 = std::vector<SurfaceCuts2>;
Division2 division_of(const Scene2& scene);
bool is_cut(const Division2& division);

}  // namespace hottel
