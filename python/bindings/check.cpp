// What is worth telling about a scene, and its repair.

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "geometry/plane/check/wording.h"
#include "geometry/space/check/repair.h"
#include "io/results/finding_report.h"
#include "io/scene/scene_json.h"
#include "kernel/support/failure.h"
#include "python/bindings/arrays.h"
#include "python/bindings/bindings.h"
#include "python/bindings/errors.h"
#include "python/bindings/numbers.h"
#include "python/bindings/scene.h"
#include "python/bindings/waiting.h"
#include "python/bindings/words.h"
#include "solver/plane/check/scene_repair.h"
#include "solver/plane/simulation/simulation.h"
#include "solver/space/check/scene_repair.h"
#include "solver/space/simulation/queries.h"
#include "solver/space/simulation/simulation.h"

namespace hottel::python {
namespace {

// One finding as Python holds it.
struct PythonFinding {
  ReportedFinding told;
};

// A repaired scene, what was done, and what is found in it.
struct PythonRepair {
  PythonScene scene;
  std::vector<RepairStep> steps;
  std::vector<PythonFinding> findings;
  std::optional<std::vector<FactorChange>> changes;
};

template <class Scene, class Findings>
std::vector<PythonFinding> told(const Scene& scene, const Findings& findings) {
  const auto coordinates = [](const auto& point) {
    const auto numbers = to_doubles(point);
    return std::vector<double>(numbers.begin(), numbers.end());
  };
  std::vector<PythonFinding> result;
  for (ReportedFinding& finding : reported(scene, findings, coordinates)) result.push_back({std::move(finding)});
  return result;
}

std::shared_ptr<const SceneCheck2> look(const ValidScene2& scene, const StageProgress& progress) {
  return Simulation2(scene).check(progress);
}
std::shared_ptr<const SceneCheck3> look(const ValidScene3& scene, const StageProgress& progress) {
  return std::make_shared<const SceneCheck3>(scene_check(Simulation3(scene), progress));
}

template <class Item>
py::tuple tuple_of_all(const std::vector<Item>& items) {
  py::list list;
  for (const Item& item : items) list.append(item);
  return py::tuple(list);
}

py::tuple check(const PythonScene& scene) {
  return tuple_of_all(without_lock({}, [&](const StageProgress& progress) {
    return std::visit([&](const auto& each) { return told(*each, look(each, progress)->findings); }, scene.scene());
  }));
}

template <class Repair, class AnyValidScene, class Check>
PythonRepair repair_told(const Repair& repair, const AnyValidScene& repaired, const Check& before, const Check& after) {
  PythonRepair result{PythonScene(repaired), repair.steps, told(*repaired, after.findings), std::nullopt};
  if (before.factors && after.factors)
    result.changes = factor_changes(*before.factors, *after.factors,
                                    [&](const Element& element) { return former_name(repair, element); });
  return result;
}

PythonRepair repaired(const ValidScene2& scene, const Rational& distance, const StageProgress& progress) {
  const auto before = look(scene, progress);
  ValidScene2 written;
  std::shared_ptr<const SceneCheck2> after;
  const auto look_at_written = [&](const Scene2& some) {
    written = parse_scene_2(write_scene_2(some), std::string(kNoFile));
    return after = look(written, progress);
  };
  const Repair2 repair = repair_scene(*scene, distance, *before,
                                      {[&](const Scene2& some) { return look(some, progress); }, look_at_written});
  return repair_told(repair, written, *before, *after);
}

PythonRepair repaired(const ValidScene3& scene, const Rational& distance, const StageProgress& progress) {
  const auto before = look(scene, progress);
  ValidScene3 written;
  SceneCheck3 after;
  const Repair3 repair = repair_scene(*scene, distance, *before, [&](const Scene3& some) {
    written = parse_scene_3(write_scene_3(some), std::string(kNoFile));
    return after = *look(written, progress);
  });
  return repair_told(repair, written, *before, after);
}

PythonRepair fixed(const PythonScene& scene, const py::object& within, bool is_binary) {
  const Rational distance = rational_of(within, is_binary, "within");
  if (distance < 0) throw UsageError("within is a distance, 0 or more");
  return without_lock({}, [&](const StageProgress& progress) {
    return std::visit([&](const auto& each) { return repaired(each, distance, progress); }, scene.scene());
  });
}

py::object changes_of(const PythonRepair& repair) {
  if (!repair.changes) return py::none();
  py::list list;
  for (const FactorChange& change : *repair.changes)
    list.append(py::make_tuple(change.from, change.to, change.before, change.after));
  return py::tuple(list);
}

void add_finding(py::module_& module) {
  py::class_<PythonFinding>(module, "Finding", "One thing that is worth telling about a scene, as from Scene.check().")
      .def_property_readonly(
          "severity", [](const PythonFinding& finding) { return to_string(finding.told.severity); },
          "'error': light cannot be computed; 'warning': probably not meant; 'note': legal, and worth knowing.")
      .def_property_readonly(
          "kind", [](const PythonFinding& finding) { return finding.told.kind; },
          "A stable word for programs, a str: 'needle', 'crossing', ... docs/check.md has all of them.")
      .def_property_readonly(
          "surfaces", [](const PythonFinding& finding) { return tuple_of(finding.told.surfaces); },
          "The names of the surfaces that it is about, a tuple of str; empty where it is of the whole scene.")
      .def_property_readonly(
          "at",
          [](const PythonFinding& finding) -> py::object {
            if (finding.told.at.empty()) return py::none();
            return frozen(finding.told.at);
          },
          "Where it is, float64 of shape (2,), in space (3,), in units of the scene; None where it is nowhere.")
      .def_property_readonly(
          "line",
          [](const PythonFinding& finding) {
            return finding.told.where.line > 0 ? std::optional(finding.told.where.line) : std::nullopt;
          },
          "The line of the scene's file where the first surface stands, an int, or None.")
      .def_property_readonly(
          "message", [](const PythonFinding& finding) { return in_python(finding.told.message); },
          "What was found, a sentence for people, a str.")
      .def_property_readonly(
          "suggestion", [](const PythonFinding& finding) { return in_python(finding.told.suggestion); },
          "What to do about it, a str; empty where there is nothing to say.")
      .def("__repr__", [](const PythonFinding& finding) {
        return std::string("<hottel.Finding ") + to_string(finding.told.severity) + ": " + finding.told.kind + ": " +
               finding.told.message + ">";
      });
}

// Of the class Scene, which is there.
void add_check_questions(py::class_<PythonScene> type) {
  type.def("check", &check,
           "Returns what is wrong with the scene, probably not meant, or worth knowing: a tuple of Finding, errors "
           "first,\nas `hottel check` has them. InputError for a \"behind\" that cannot be obeyed.")
      .def("fixed", &fixed, py::arg("within") = 0, py::kw_only(), py::arg("binary") = false,
           "Returns the scene repaired without harm, Repair, as `hottel check --fix` does.\n\n"
           "within: how far a point may be moved, in units of the scene, a number. InputError for what is no number,\n"
           "UsageError where it is below 0.");
}

}  // namespace

void add_check(py::module_& module) {
  add_finding(module);
  py::class_<RepairStep>(module, "RepairStep", "One thing that a repair did, or left undone.")
      .def_readonly("kind", &RepairStep::kind, "A word, a str: 'merged', 'snapped', 'reversed', ..., 'not-repaired'.")
      .def_readonly("surface", &RepairStep::surface, "The name of the surface that it is about, a str.")
      .def_readonly("message", &RepairStep::message, "What was done, a sentence for people, a str.")
      .def("__repr__",
           [](const RepairStep& step) { return "<hottel.RepairStep " + step.kind + ": " + step.message + ">"; });
  py::class_<PythonRepair>(module, "Repair", "A repaired scene and what was done to it, as from Scene.fixed().")
      .def_readonly("scene", &PythonRepair::scene, "The repaired scene, Scene.")
      .def_property_readonly(
          "steps", [](const PythonRepair& repair) { return tuple_of_all(repair.steps); },
          "What was done, a tuple of RepairStep; empty where nothing was.")
      .def_property_readonly(
          "findings", [](const PythonRepair& repair) { return tuple_of_all(repair.findings); },
          "What is found in the repaired scene, a tuple of Finding.")
      .def_property_readonly("changes", &changes_of,
                             "Every view factor that is not what it was, a tuple of (from, to, before, after): names, "
                             "and\nfloats or None; None where factors could not be compared.")
      .def("__repr__", [](const PythonRepair& repair) {
        return "<hottel.Repair of " + std::to_string(repair.steps.size()) + " steps>";
      });
  add_check_questions(py::class_<PythonScene>(py::object(module.attr("Scene"))));
}

}  // namespace hottel::python
