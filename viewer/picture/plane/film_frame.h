// Frames of an animation in the plane as pictures.
#pragma once

#include <cstdint>
#include <string>

#include "kernel/support/stage.h"
#include "solver/plane/simulation/simulation.h"
#include "viewer/picture/plane/illumination_picture.h"

namespace hottel {

// The light of simulations of one scene at several times, all by one tone curve.
//
//   (1) the curve is fitted to the light that it is told first, so that light that moves does not change what stays
//   (2) file() is a function of that light and of the simulation: what is kept changes nothing
class FilmPainter2 {
 public:
  struct Kept {  // beside a list of active elements: nothing
    static std::uint64_t bytes() { return 0; }
  };

  explicit FilmPainter2(const IlluminationPicture2& picture) : picture_(picture) {}

  bool is_fitted() const { return picture_.curve != nullptr; }
  void fit_to(const Simulation2& simulation, const StageProgress& progress);
  // The bytes of a PNG file. REQUIRES is_fitted().
  std::string file(const Simulation2& simulation, Kept& kept, const StageProgress& progress) const;

 private:
  IlluminationPicture2 picture_;
};

}  // namespace hottel
