// What must hold of a furnished room where everything is as warm as everything else.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "geometry/exchange_matrix.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "tests/storm/space/solid_scene.h"

namespace hottel::storm {

// What is asked for: S relative to the smaller area. The first is the default of the program.
inline constexpr double kRoomTolerances3[] = {1e-9, 1e-12};

// A room under test: its view factors within both tolerances, or why there are none.
class RoomSubject3 {
 public:
  // `chance` is what laws draw from.
  RoomSubject3(SolidBodies3 bodies, std::uint64_t chance);

  // Emission is 1 - reflectivity everywhere, and the sky emits 1.
  const Scene3& scene() const { return scene_; }
  const SolidBodies3& bodies() const { return bodies_; }
  std::uint64_t chance() const { return chance_; }
  // It claims one side for two materials: no law says anything of it.
  bool is_disputed() const { return is_disputed_; }
  // What could not be measured within a tolerance; empty where all was.
  const std::string& refusal(std::size_t t) const { return refusals_[t]; }
  bool is_measured() const { return matrices_[0] && matrices_[1]; }
  // REQUIRE that it is.
  const ExchangeMatrix& loose() const { return *matrices_[0]; }
  const ExchangeMatrix& tight() const { return *matrices_[1]; }
  // The scene prepared, and loose(), for who keeps them. The first REQUIRES that it is not disputed.
  const std::shared_ptr<const PreparedScene3>& prepared() const { return prepared_; }
  const std::shared_ptr<const ExchangeMatrix>& loose_shared() const { return matrices_[0]; }

 private:
  SolidBodies3 bodies_;
  std::uint64_t chance_;
  Scene3 scene_;
  bool is_disputed_ = false;
  std::string refusals_[2];
  std::shared_ptr<const PreparedScene3> prepared_;
  std::shared_ptr<const ExchangeMatrix> matrices_[2];
};

struct RoomLaw3 {
  const char* name;
  std::string (*broken)(const RoomSubject3& subject);  // what is wrong, or nothing
  unsigned every;                                      // tried in one of so many scenes
  bool takes_unmeasured = false;                       // of rooms of which some pair is not measured, too
};

// The laws, in order; the error of an entry is half the width of its bounds where it is enclosed, else the tolerance
// times the smaller area.
//
//   measured     every pair is measured within 1e-9 and within 1e-12
//   rows         within both tolerances each row sums to 1 within the sum of the errors of its entries, and its bounds
//                hold 1; within 1e-12 it sums to 1 within 1e-11
//   backs        no row has a black back
//   range        0 < F, 0 < Vis <= 1, bounds hold F, and those of an enclosed one are as narrow as was asked for
//   reciprocity  S and its bounds are the same from both faces, and Vis
//   verdicts     whether S = 0, and whether S = S0, is the same for both tolerances
//   values       F within 1e-9 and within 1e-12 differ by no more than their errors, and their bounds meet
//   radiosity    all radiosities are 1: within 1e-9, and between their bounds where these are of the true factors
//   patches      with some patches (with_patches) rows and radiosities are as they were, and S of a face with another
//                one, those of the patches on both added up, is what it was; so is whether S = 0
//   repair       gaps closed within some distance, the scene is measured as before, check finds no more in it than
//                before, and to close them once more changes nothing
const std::vector<RoomLaw3>& room_laws_3();

// What F of the k-th entry of a row may be off.
double error_of(const ExchangeMatrix& matrix, std::uint32_t i, std::size_t k, double tolerance);
// What is wrong with the sums of rows, or nothing.
std::string rows_are_wrong(const ExchangeMatrix& matrix, double tolerance);
// What is wrong with radiosities where emission is 1 less the reflectivity, or nothing.
std::string radiosities_are_wrong(const ExchangeMatrix& matrix, const Scene3& scene);

}  // namespace hottel::storm
