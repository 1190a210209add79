// A simulation as Python holds it.
#pragma once

#include <pybind11/pybind11.h>

#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "io/results/radiosity_files.h"
#include "python/bindings/arrays.h"
#include "python/bindings/scene.h"
#include "python/bindings/simulation_options.h"
#include "python/bindings/visible.h"
#include "python/bindings/waiting.h"
#include "solver/plane/compare/method_comparison.h"
#include "solver/space/compare/method_comparison.h"

namespace hottel::python {

// The view factors of a simulation. Throws RequestError where the scene promises to be closed and is not.
std::shared_ptr<const ExchangeMatrix> matrix_of(const AnySimulation& simulation, const StageProgress& progress);

// A simulation, and what was made of it for Python. REQUIRES the lock of the interpreter for every function.
class PythonSimulation {
 public:
  PythonSimulation(PythonScene scene, SimulationOptions options, std::shared_ptr<const AnySimulation> simulation)
      : scene_(std::move(scene)), options_(std::move(options)), simulation_(std::move(simulation)) {}
  // Throws UsageError for options that make no sense.
  static PythonSimulation of(const PythonScene& scene, SimulationOptions options);
  PythonSimulation with_scene(const PythonScene& scene) const;

  const PythonScene& scene() const { return scene_; }
  const SimulationOptions& options() const { return options_; }
  bool is_plane() const { return scene_.is_plane(); }
  const AnySimulation& simulation() const { return *simulation_; }
  // REQUIRES that dimension.
  const Simulation2& in_the_plane() const { return std::get<Simulation2>(*simulation_); }
  const Simulation3& in_space() const { return std::get<Simulation3>(*simulation_); }

  // Returns work(simulation, progress), which runs without the lock of the interpreter.
  template <class Work>
  auto waited(const Work& work) const {
    return without_lock(options_.waiting, [&](const StageProgress& progress) { return work(*simulation_, progress); });
  }

  py::object factors();
  // channel: "r", "g" or "b", or empty.
  py::object script_f(const std::string& channel);
  // What the store was asked for, a dict; None where there is none.
  py::object store_use() const;
  py::object radiosity();
  py::object temperatures();
  py::object face_flux() { return flux(&NetFluxes::faces, faces_); }
  py::object group_flux() { return flux(&NetFluxes::groups, groups_); }
  py::object light_flux() { return flux(&NetFluxes::lights, lights_); }
  py::array light(const py::object& array, bool is_binary) const;
  py::object visible(const py::object& array, const py::object& range, bool is_binary) const;
  py::dict exact_form(const std::string& from, const std::string& to) const;
  std::string text() const;
  // The exact factors and radiosities of its elements, ready to judge methods: made once.
  std::shared_ptr<const std::variant<MethodComparison2, MethodComparison3>> comparison();

 private:
  std::string exchange_in_space(const std::string& from, const std::string& to) const;
  struct Solved {
    std::shared_ptr<const ExchangeMatrix> matrix;
    std::shared_ptr<const RadiositySolution> solution;
  };
  Solved solve() const;
  // Of faces, groups and lights.
  py::object flux(std::vector<NetFlux> NetFluxes::*which, py::object& place);
  template <class Values>
  py::array light_at(const Values& values_at) const;
  template <class Make>
  static py::object kept(py::object& place, const Make& make) {
    if (place.is_none()) place = make();
    return place;
  }

  PythonScene scene_;
  SimulationOptions options_;
  std::shared_ptr<const AnySimulation> simulation_;
  std::shared_ptr<const std::variant<MethodComparison2, MethodComparison3>> comparison_;
  py::dict script_f_;  // by channel
  py::object factors_{py::none()}, radiosity_{py::none()}, temperatures_{py::none()};
  py::object faces_{py::none()}, groups_{py::none()}, lights_{py::none()};
};

}  // namespace hottel::python
