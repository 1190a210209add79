// What a deck of View3D says, record by record.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/space/scene/polygon.h"

namespace hottel {

// What a record makes of its polygon, by its letter.
enum class Vs3Kind3 : char { kSurface = 'S', kMask = 'M', kNull = 'N', kObstruction = 'O' };

// One record S, M, N or O. Numbers of other records are as written; 0 is none.
struct Vs3Record3 {
  Vs3Kind3 kind = Vs3Kind3::kSurface;
  Polygon3 polygon;
  std::uint32_t base = 0, combined_with = 0;
  Rational emittance;
  std::string name;  // empty for obstructions
  int line = 0;
};

// Controls that say what View3D tells of its factors, 0 where a deck does not set them.
struct Vs3Output3 {
  std::uint32_t row = 0, column = 0;  // numbers of records; 0: all
  std::optional<std::uint32_t> out;   // 0 text, 1 binary, 2 a fork's sparse list
  std::uint32_t list = 0;
  bool wants_script_f = false;  // emit
  int line = 0;                 // where row or col is set
};

// The deck. Record k, from 0, has the number k + 1.
struct Vs3Deck3 {
  std::string file, title;
  std::vector<Vs3Record3> records;
  bool is_enclosure = false;            // encl
  Vs3Output3 output;                    // row, col, out, list, emit; no col without a row, and out at most 2
  std::vector<std::string> not_obeyed;  // other controls that it sets, as it spells them, each once
  bool has_inexact_angles = false;      // (3)
  Rational unit;                        // what the last digit of the vertices of F 3 stands for; 0: they have none
};

// Returns the records of a deck, of the form `F 3` or `F 3a`. docs/coming_from_view3d.md has all that is read.
//
//   (1) coordinates, lengths and emittances are exact
//   (2) records are numbered from 1 on without a gap, obstructions last; emittances are from 0 to 1; a name is one that
//       a surface may have (name_problem). A polygon has three or four points and may be none yet (polygon_problem);
//       what base and combined_with point to is not looked at
//   (3) azimuths and tilts that are multiples of 90 degrees are exact; others are turned into ones with rational sine
//       and cosine, less than 3e-16 radians away, so that quadrilaterals are exactly plane and rectangles exactly those
//
// Throws InputError with file and line for everything that it does not read, unknown letters and controls included.
// COST: linear.
Vs3Deck3 parse_vs3_deck_3(std::string_view text, const std::string& file);

}  // namespace hottel
