// Faces: sides of surfaces.
#pragma once

#include <compare>
#include <cstdint>
#include <string>
#include <string_view>

namespace hottel {

// A face is one side of a surface: its front or its back. The sky is no face; where either may stand, a
// std::optional<Face> without a value is the sky.
//
//   (1) ordered as elements are: by surface, the front before the back
//   (2) the faces of n surfaces have the numbers 0 .. 2 n - 1 in that order; Face::of(f.number()) == f
struct Face {
  std::uint32_t surface = 0;
  bool is_back = false;

  // A place in a table of all faces.
  constexpr std::uint32_t number() const { return 2 * surface + (is_back ? 1 : 0); }
  static constexpr Face of(std::uint32_t number) { return {number / 2, number % 2 == 1}; }

  friend constexpr bool operator==(const Face&, const Face&) = default;
  friend constexpr auto operator<=>(const Face&, const Face&) = default;
};

// The name of one side of a surface or group: "wall" is its front, "wall:back" its back.
struct SideName {
  std::string name;
  bool is_back = false;
  friend bool operator==(const SideName&, const SideName&) = default;
};
SideName side_named(std::string_view text);
// Returns that text: side_named(side_text(side)) == side, where the name is one (name_problem).
std::string side_text(const SideName& side);

}  // namespace hottel
