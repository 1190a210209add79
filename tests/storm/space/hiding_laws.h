// What must hold of what convex bodies hide from a polygon, and of what is left out of sight of it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tests/comparison/space/pair_scene.h"
#include "tests/storm/space/hiding_scene.h"
#include "tests/storm/space/matrix_law.h"

namespace hottel::storm {

// A scene under test: what both sides of polygon 0 exchange with all sides of all others and with the sky.
class HidingSubject3 {
 public:
  // `chance` is what laws draw from.
  HidingSubject3(Polygons3 polygons, std::uint64_t chance);

  // Of a polygon, or of a side of the sky, which have numbers after them.
  struct Target {
    std::size_t polygon;
    bool is_back;
    Patch3 patch;
    PairResult3 measure;
  };
  struct Row {
    bool is_back;
    Patch3 patch;
    std::vector<Target> targets;
  };

  const Polygons3& polygons() const { return polygons_; }
  // These, and the sides of the sky, seen from inside.
  const Polygons3& with_sky() const { return with_sky_; }
  std::uint64_t chance() const { return chance_; }
  const oracle::PairScene3& scene() const { return scene_; }
  const std::vector<Row>& rows() const { return rows_; }
  // Of the whole scene; made when it is first asked for, by one thread.
  const MatrixAnswer3& matrix() const;
  // What is asked of a pair: 1e-12 of the smaller area, or as far as doubles go.
  PairRequest3 request(const Patch3& i, const Patch3& j) const;
  double slack(const Patch3& i, const Patch3& j) const;  // in scene units

 private:
  Polygons3 polygons_, with_sky_;
  std::uint64_t chance_;
  oracle::PairScene3 scene_;
  double square_;  // of the largest distance in the scene
  double sky_square_;
  std::vector<Row> rows_;
  mutable std::optional<MatrixAnswer3> matrix_;
};

struct HidingLaw3 {
  const char* name;
  std::string (*broken)(const HidingSubject3& subject);  // what is wrong, or nothing
  unsigned every;                                        // tried in one of so many scenes
  bool needs_matrix = false;                             // of scenes of which all pairs are measured
};

// The laws, in order.
//
//   bodies          each body lies on one side of its planes and of its lid, and lines from within it leave it through
//                   one surface of it, or through the lid alone: exact
//   rays            where a ray from a point of polygon 0 arrives first, S is not 0: exact
//   never first     no ray arrives first at what is never first, from all of polygon 0 and from its quarters: exact
//   walked          S, S = 0, S = S0 and what could not be told are the same where everything is walked; of
//                   towns some pairs
//   closure         S of a side with all others sum to its area
//   reversed        S is the same from the other patch
//   alone           S has the same bits for a pair by itself, with details and without
//   parts           S of quarters of a side sum to that of the side; S = 0 where all of them are
//   sky             S of a side with all of the sky is the sum of those with six sides of it, and of quarters of the
//                   side, and the same where everything is walked; so is whether S = 0
//   matrix          rows of the whole scene, both sides of each polygon and the sky, sum to 1 within the errors that
//                   their entries state; by closure the sky is the same within these (matrix_law.h);
//                   of scenes of which all pairs can be measured
const std::vector<HidingLaw3>& hiding_laws_3();

}  // namespace hottel::storm
