// Decks of View3D as scenes.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/space/scene/triangulator.h"

namespace hottel {

// True iff a file is a deck by its ending: .vs3, in letters of either case.
bool is_vs3(const std::filesystem::path& file);

// What a deck asks of the output, for those who obey it.
struct DeckOutput3 {
  std::optional<std::uint32_t> row, column;  // surfaces of the scene; nothing: all
  std::optional<std::uint32_t> out;          // 0 text, 1 binary, 2 a fork's sparse list
  std::uint32_t list = 0;                    // how much is told of the rows: 0 to 3
  bool wants_script_f = false;               // emit: gray-body exchange factors
};

// A deck as a scene, and what is read otherwise than View3D does: sentences without a full stop.
struct Vs3Scene3 {
  ValidScene3 scene;
  std::vector<std::string> notes;
  DeckOutput3 output;
};

// Returns the scene that a deck is by itself.
//
//   (1) S: a surface of that name, or NAME~NUMBER where several have it, in the order of the deck. Its front reflects
//       1 - emit, exactly, and emits nothing; its back is black and has no row
//   (2) a surface lies where its polygon does, less the polygons of the S and N records whose base it is, which are
//       holes in it; one of which nothing is left is no surface of the scene
//   (3) O and N: an obstruction, opaque and without rows, called O~NUMBER or as (1) says
//   (4) M: a surface as S, and a mask of its base (Mask3)
//   (5) surfaces that are combined are a group, called after the one with which they are; others are groups of their
//       own. Groups whose surfaces lie on each other are of one body (Group::body), where three records of one of them
//       are combined
//   (6) what has a base is put onto it exactly, as patches are (seat_patches)
//   (7) encl=1 is the promise that the scene is closed
//
// Throws InputError with file and line as parse_vs3_deck_3 and validate do; for a surface that is no polygon, lies not
// in the plane of its base or within it, or faces the wrong way; for a base or a partner that cannot be one; for a mask
// that shares an area with another surface of its base; for controls that ask for a surface that is not there.
// COST: that of validate.
// A triangulator cuts surfaces that are not plane, unless they are bases.
Vs3Scene3 read_vs3_3(const std::filesystem::path& file, Triangulator3* triangulator = nullptr);
Vs3Scene3 parse_vs3_3(std::string_view text, const std::string& file, Triangulator3* triangulator = nullptr);

}  // namespace hottel
