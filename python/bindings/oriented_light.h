// The light on small areas as Python holds it.
#pragma once

#include <string>
#include <vector>

#include "python/bindings/simulation.h"

namespace hottel::python {

// The columns of `hottel visibility --points` of points with normals.
struct PythonOrientedLight {
  py::array irradiance, mean_irradiance, sky_view_factor, mean_radiant_temperature;
  std::vector<std::string> channels;
};

void add_oriented_light_questions(py::class_<PythonSimulation>& type);

}  // namespace hottel::python
