// Scenes as decks for View3D.
#pragma once

#include <string>
#include <vector>

#include "geometry/space/scene/scene.h"

namespace hottel {

// A deck, and what it does not say, or not exactly: sentences without a full stop.
struct WrittenVs3Deck3 {
  std::string text;
  std::vector<std::string> notes;
};

// Returns a scene as a deck of the form `F 3`.
//
//   (1) records are in the order of the scene, a back with a material right after its front, as a surface NAME-back
//       that looks the other way; obstructions come last. So View3D's rows are those of `hottel factors`
//   (2) where later polygons fill all holes of one, facing its way, it is their base and has no holes; an obstruction
//       that fills one is an N record. Any other polygon of more than four corners, or with holes, is several records,
//       combined with the first
//   (3) combines_groups: those of a group are combined with its first one, which is called after it, and so are backs
//   (4) coordinates and emittances that are short decimals are exact, others are rounded to the nearest double.
//       Emittance is 1 - reflectivity, the mean of the channels where they differ
//   (5) what View3D would take for the end of a name is '_' in it
//   (6) a scene that is promised to be closed has encl=1
//   (7) polygons are as listed: overlaps are not settled, and solids cover nothing
//   (8) a mask is an M record
//   (9) a patch is a subsurface of what it lies on, where it and all that lies on each other there are one record each,
//       beside the others and after its base, and none lies on a back without a material; else each is cut into what
//       patches leave of it, as PatchedFaces3 has it where corners are rounded
//  (10) what is solid in the scene and not in the deck, as it is read again, is noted
//
// What is rounded, cut or left out is noted, and which surfaces have less than (7) says.
// REQUIRES: validate(scene) holds. Throws RequestError for a coordinate beyond the range of doubles, and for a mask
// whose base is no record before it; InputError as Arrangement3 does. COST: that of Arrangement3, and n for each hole.
WrittenVs3Deck3 write_vs3_3(const Scene3& scene, bool combines_groups);

}  // namespace hottel
