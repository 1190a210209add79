#include "python/bindings/oriented_light.h"

#include <utility>

#include "kernel/support/failure.h"
#include "python/bindings/bindings.h"
#include "python/bindings/errors.h"
#include "python/bindings/point_light.h"

namespace hottel::python {
namespace {

void require_directions(const PythonPoints& points, const PythonPoints& normals) {
  if (points.size() != normals.size())
    throw UsageError("there are " + std::to_string(points.size()) + " points and " + std::to_string(normals.size()) +
                     " normals: there is to be one for each, or one for all");
  for (std::size_t k = 0; k < normals.size(); ++k)
    if (normals.is_origin(k)) throw InputError({std::string(kNoFile), 0}, "normal " + std::to_string(k) + " is zero");
}

// One normal for all points is repeated.
py::object for_each_point(const py::object& normals, std::size_t points) {
  const py::module_ numpy = py::module_::import("numpy");
  py::object array;
  try {
    array = numpy.attr("asarray")(normals);
  } catch (const py::error_already_set& error) {
    if (!error.matches(PyExc_ValueError)) throw;
    return normals;  // refused with its rows
  }
  if (array.attr("ndim").cast<int>() != 1 || array.attr("size").cast<std::size_t>() == 0) return array;
  return numpy.attr("tile")(array, py::make_tuple(points, 1));
}

PythonOrientedLight light_on(const PythonSimulation& simulation, const py::object& array,
                             const py::object& normal_array, bool is_binary) {
  const std::size_t dimension = simulation.is_plane() ? 2 : 3;
  const PythonPoints points(array, dimension, is_binary);
  const PythonPoints normals(for_each_point(normal_array, points.size()), dimension, is_binary);
  require_directions(points, normals);
  AreaLightValues found = simulation.waited([&](const AnySimulation& any, const StageProgress& progress) {
    return light_on_areas(any, points, normals, progress);
  });
  const auto n = static_cast<py::ssize_t>(points.size()), channels = static_cast<py::ssize_t>(found.channels.size());
  return {frozen(std::move(found.irradiance), {n, channels}), frozen(std::move(found.mean_irradiance), {n, channels}),
          frozen(std::move(found.sky_view_factor)), frozen(std::move(found.mean_radiant_temperature)),
          std::move(found.channels)};
}

}  // namespace

void add_oriented_light(py::module_& module) {
  py::class_<PythonOrientedLight>(
      module, "OrientedLight",
      "The light on small areas at n points, as from Simulation.light_on. NaN in solids, and outside closed scenes.")
      .def_readonly("irradiance", &PythonOrientedLight::irradiance,
                    "What arrives on the front of each area, float64 of shape (n, c) by channel, [W/m2].\n"
                    "Read only.")
      .def_readonly("mean_irradiance", &PythonOrientedLight::mean_irradiance,
                    "The mean over all directions, shape (n, c), [W/m2]: that of Simulation.light. Read only.")
      .def_readonly("sky_view_factor", &PythonOrientedLight::sky_view_factor,
                    "View factors from the areas to the sky, float64 of shape (n,). Read only.")
      .def_readonly("mean_radiant_temperature", &PythonOrientedLight::mean_radiant_temperature,
                    "Mean radiant temperatures of the points, float64 of shape (n,), [K]. Read only.")
      .def_property_readonly(
          "channels", [](const PythonOrientedLight& light) { return tuple_of(light.channels); },
          "What irradiances have a column each for, a tuple of c str.")
      .def("__len__", [](const PythonOrientedLight& light) { return light.sky_view_factor.size(); })
      .def("__repr__", [](const PythonOrientedLight& light) {
        return "<hottel.OrientedLight at " + std::to_string(light.sky_view_factor.size()) + " points>";
      });
}

void add_oriented_light_questions(py::class_<PythonSimulation>& type) {
  type.def(
      "light_on", &light_on, py::arg("points"), py::arg("normals"), py::kw_only(), py::arg("binary") = false,
      "Returns the light on small areas at n points, OrientedLight: irradiance, sky view factor, mean radiant\n"
      "temperature.\n\n"
      "points and binary: as of light(). normals: which way the front of each looks, of the same shape, or one "
      "for\n"
      "all; of any length, not zero. Throws TypeError, InputError for points or normals that are none, UsageError\n"
      "where there are not as many of both, RequestError as of radiosity.");
}

}  // namespace hottel::python
