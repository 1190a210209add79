// What is asked of a simulation in the plane, beside its scene.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "geometry/plane/scene/scene.h"
#include "geometry/row_choice.h"
#include "solver/plane/light/light_values.h"
#include "solver/plane/methods/exchange_method.h"
#include "solver/radiosity/light_test.h"
#include "solver/radiosity/radiosity_options.h"

namespace hottel {

class FactorStore;

// A picture of light as its painter made it: the bytes of an image file, or what else the painter returns.
struct LightPicture2 {
  std::string bytes;
  double scale = 1;    // factor that values were multiplied by before the tone curve
  double seconds = 0;  // the time it took, measured by the simulation
};

// Draws light. The solver knows nothing of pictures; a caller who wants one passes a painter.
class LightPainter2 {
 public:
  virtual ~LightPainter2() = default;
  // Draws the light of a scene. The same arguments give the same picture. Throws UsageError where it cannot be drawn.
  // Threads may share one.
  virtual LightPicture2 paint(const PreparedScene2& prepared, const IlluminationGrid2& light) const = 0;
};

// A request, with the defaults.
//
//   (1) two requests are equal if all their members are; methods and painters are equal if they are the same object
struct SimulationRequest2 {
  std::shared_ptr<const ExchangeMethod2> method = {};     // null: the exact one
  std::optional<Granularity> granularity = {};            // nothing: elements where a surface is divided, else faces
  bool wants_visibility = false, wants_measures = false;  // beside the factors
  RowChoice rows = {};                                    // as ExchangeRequest takes them
  bool everything = false;                                // every effect, though the scene calls for less of them
  Solver solver = Solver::kAuto;
  std::optional<int> iterations = {};  // of solvers that iterate, as in RadiosityOptions
  std::optional<double> until = {};
  std::optional<Grid2> grid = {};  // nothing: default_grid(scene); the plan then counts all grids of the scene
  bool wants_light = true;         // whether the plan counts it; light is made when it is asked for
  LightKind2 light = LightKind2::kPoint;
  LightTest lights = LightTest::kExact;  // how elements are lit by the scene's lights; light in the rooms stays exact
  bool keeps_rows = false;  // what the cells see is kept: light after an edit of materials needs no further look
  std::shared_ptr<const LightPainter2> painter = {};  // null: no picture can be asked for
  std::uint64_t memory = 0;                           // bytes, as memory_allowed() takes it
  // The store that kept factors are read from and computed ones are written to. Nothing that is computed depends on it.
  std::shared_ptr<FactorStore> store = {};

  friend bool operator==(const SimulationRequest2&, const SimulationRequest2&) = default;
};

}  // namespace hottel
