// The light of a solution in space: on a grid, and at one point.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/plane/exchange/element_table.h"
#include "geometry/plane/visibility/visibility_polygon.h"
#include "solver/plane/light/face_radiosity.h"
#include "solver/plane/light/illumination_grid.h"
#include "solver/radiosity/radiosity.h"

namespace hottel {

// Light on a grid, and the proven bound on its values where there is one: for "average" alone, of these radiosities.
struct SolvedLight2 {
  IlluminationGrid2 grid;
  std::optional<double> max_error{};
};

// Returns the light of a solution on a grid. way: "point" (illuminate_points), "average" (illuminate_averages, with its
// bound) or "inverse-square" (illuminate_inverse_square); these say what is thrown. Another word: ContractViolation.
// REQUIRES the solution of a matrix of the scene of that granularity.
SolvedLight2 illuminate(std::string_view way, const PreparedScene2& prepared, const Grid2& grid,
                        Granularity granularity, const RadiositySolution& solution,
                        const std::function<void(double)>& progress = {});

// The mean irradiance at a point once light has been reflected until it is absorbed.
struct PointLight2 {
  std::vector<std::string> channel_names;
  std::vector<double> mean_irradiance;  // by channel
  std::string why_none;                 // no solution, or none in doubles: the reason; else empty
};

// The mean irradiance at as many points as one likes, from one solution of the scene by faces (mean_irradiance.h).
//
//   (1) at() says for a point what light_at() says, bit for bit
//   (2) NaN in solids, in every channel
//
// REQUIRES that the prepared scene outlives it. Any number of threads may ask at once.
class PointLights2 {
 public:
  // Throws RequestError where there is no solution, or none that doubles can hold. COST: the exact factors of the scene
  // and one solution.
  explicit PointLights2(const PreparedScene2& prepared, const std::function<void(double)>& progress = {});

  const std::vector<std::string>& channel_names() const { return channel_names_; }
  // By channel. REQUIRES the location and the view of the eye. COST: one arc tangent for each change of radiosity.
  std::vector<double> at(const Eye2& eye, const Location2& location, const View2& view) const;
  // The same of a point in scene coordinates, which is looked around from.
  std::vector<double> at(const PointLocation2& location, const Point2& point) const;

 private:
  PointLights2(const PreparedScene2& prepared, const RadiositySolution& solution);

  const Vertices2& vertices_;
  std::vector<std::string> channel_names_;
  FaceRadiosity2 faces_;
};

// Solves the scene by faces and looks around from the eye (mean_irradiance.h). Does not throw RequestError: where there
// is no solution, or none that doubles can hold, why_none says why and the lists are empty.
// REQUIRES an eye that is in no solid. COST: the exact factors of the scene and one solution.
PointLight2 light_at(const PreparedScene2& prepared, const VisibilityPolygon2& seen);

}  // namespace hottel
