// A preprocessed scene of the plane: edges cut at each other, each side with its owner, and a triangulation.
#pragma once

#include <memory>
#include <utility>

#include "geometry/element_tables.h"
#include "geometry/plane/arrangement/arrangement.h"
#include "geometry/plane/scene/scene.h"

namespace hottel {

class ElementTable2;

// A scene overlaid and triangulated: what every method receives, and what visibility is asked of.
//
//   (1) division says where the arrangement cuts each surface: nowhere where it is not divided
//   (2) while nobody changes it, any number of threads may use it at once
//   (3) copies share the arrangement and the tables of elements, which live as long as one of them
//   (4) a table of elements is made when it is first asked for, once
//
// COST: O((n + k) log n) for n edges with k contacts.
struct PreparedScene2 {
  Scene2 scene;
  Division2 division;
  std::shared_ptr<const Arrangement2> shared;
  const Arrangement2& arrangement;  // *shared
  double seconds;                   // what the preparation took

  // REQUIRES: the arrangement, by this division, of this scene or of one that differs from it only in values of
  // materials and sky, in lights and grid, and in which the same materials act alike.
  PreparedScene2(Scene2 s, Division2 d, std::shared_ptr<const Arrangement2> a, double took);

  // Which element each side belongs to. COST: that of the table, for the first who asks.
  std::shared_ptr<const ElementTable2> elements(Granularity granularity) const;

 private:
  std::shared_ptr<ElementTables<ElementTable2>> tables_;
};

// Whether the parts of surfaces are told apart. kYes is needed for Granularity::kElement only: whole
// surfaces are cheaper.
enum class Divided2 : bool { kNo, kYes };
// Prepares a scene, with as many parts of each surface as it asks for (Surface::elements), or with one. It rounds to
// nearest, whatever the caller has set.
// Throws InputError when claims on an overlap conflict, or for a "behind" that cannot be obeyed.
// REQUIRES: a valid scene (validate).
PreparedScene2 prepare(Scene2 scene, Divided2 divided = Divided2::kNo);

// Prepares a scene, with as many parts of each surface as it asks for, from `undivided`: a scene prepared undivided
// that differs from it only in these numbers of parts, in values of materials and sky, in lights and grid. COST: a
// triangulation.
PreparedScene2 prepare_divided(const PreparedScene2& undivided, Scene2 scene);

}  // namespace hottel
