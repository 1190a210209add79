#include "python/bindings/frames.h"

#include <cmath>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <variant>

#include "geometry/plane/scene/moving_lights.h"
#include "geometry/space/scene/moving_lights.h"
#include "kernel/support/failure.h"
#include "kernel/support/memory.h"
#include "python/bindings/bindings.h"
#include "python/bindings/light_request.h"
#include "python/bindings/numbers.h"
#include "python/bindings/picture.h"
#include "python/bindings/picture_names.h"
#include "solver/animation.h"
#include "solver/memory_store.h"
#include "solver/plane/light/refinement.h"
#include "solver/space/light/refinement.h"
#include "viewer/picture/plane/film_frame.h"
#include "viewer/picture/space/film_frame.h"

namespace hottel::python {
namespace {

constexpr std::uint64_t kMostFrames = 100'000;

// Frames by one painter, whose curve is that of the first one.
template <class Simulation, class Painter>
struct Film {
  using Frames = Animation<Simulation, typename Painter::Kept>;
  Frames frames;
  Painter painter;

  std::pair<Simulation, std::string> at(const Rational& time, const StageProgress& progress) {
    if (!painter.is_fitted()) painter.fit_to(frames.at(Rational(0), progress).simulation, progress);
    const typename Frames::Frame frame = frames.at(time, progress);
    return {frame.simulation, painter.file(frame.simulation, *frame.kept, progress)};
  }
};
using Film2 = Film<Simulation2, FilmPainter2>;
using Film3 = Film<Simulation3, FilmPainter3>;

struct PythonFrame {
  std::uint32_t index = 0;
  double seconds = 0;
  py::object simulation;
  PythonPicture picture;
};

// An iterator. REQUIRES the lock of the interpreter for every function.
class PythonFrames {
 public:
  PythonFrames(const PythonSimulation& simulation, std::unique_ptr<std::variant<Film2, Film3>> film,
               std::uint32_t count, Rational per_second)
      : options_(simulation.options()), film_(std::move(film)), count_(count), per_second_(std::move(per_second)) {}

  std::uint32_t count() const { return count_; }

  PythonFrame next() {
    if (next_ == count_) throw py::stop_iteration();
    const std::uint32_t k = next_++;
    const Rational time = Rational(k) / per_second_;
    try {
      return frame(k, time);
    } catch (...) {
      next_ = k;  // it can be asked for again
      throw;
    }
  }

 private:
  PythonFrame frame(std::uint32_t k, const Rational& time) {
    auto [simulation, png] = without_lock(options_.waiting, [&](const StageProgress& progress) {
      const std::lock_guard<std::mutex> one_at_a_time(mutex_);
      return std::visit(
          [&](auto& film) {
            auto made = film.at(time, progress);
            return std::pair(std::make_shared<const AnySimulation>(std::move(made.first)), std::move(made.second));
          },
          *film_);
    });
    const auto drawn = [bytes = std::move(png)](PictureFormat format) {
      if (format != PictureFormat::kPng) throw UsageError("a frame has pixels: it is written as .png");
      return bytes;
    };
    PythonScene scene(std::visit([](const auto& each) { return ValidScene(each.scene()); }, *simulation));
    return {k, to_double(time), py::cast(PythonSimulation(std::move(scene), options_, simulation)),
            PythonPicture(drawn, {})};
  }

  SimulationOptions options_;
  std::mutex mutex_;
  std::unique_ptr<std::variant<Film2, Film3>> film_;
  std::uint32_t count_, next_ = 0;
  Rational per_second_;
};

// How frames are drawn.
struct FrameLook {
  Tone tone = Tone::kLog;
  Shading shading = Shading::kFlat;
  double exposure = 1;
  std::uint32_t width = 0;
};

std::unique_ptr<std::variant<Film2, Film3>> film_of(const PythonSimulation& asked, const GridKeywords& grid,
                                                    const FrameLook& look) {
  SimulationOptions options = asked.options();
  const std::uint64_t kept = memory_allowed(static_cast<std::uint64_t>(options.memory.value_or(0))) / 4;
  const RefinementLevels levels = options.levels;
  const std::shared_ptr<FactorStore> given = store_of(options);
  AnySimulation still = simulation_of(divided(asked.scene().scene(), options), options, given);
  if (const auto* const plane = std::get_if<Simulation2>(&still)) {
    SimulationRequest2 request = plane->request();
    request.grid = std::get<Simulation2>(*gridded(asked, grid)).request().grid;
    request.keeps_rows = !levels.is_any();
    return std::make_unique<std::variant<Film2, Film3>>(
        std::in_place_type<Film2>,
        Film2{Film2::Frames(plane->with_request(std::move(request)), levels, kept, given),
              FilmPainter2({.tone = look.tone, .exposure = look.exposure, .wanted_width = look.width})});
  }
  const auto& space = std::get<Simulation3>(still);
  SimulationRequest3 request = space.request();
  request.factors.granularity = Granularity::kElement;
  request.factors.store = given ? given : make_memory_store(kept);
  request.system.serves_many = true;
  const std::shared_ptr<FactorStore> store = request.factors.store;
  return std::make_unique<std::variant<Film2, Film3>>(
      std::in_place_type<Film3>,
      Film3{Film3::Frames(space.with_request(request), levels, kept, store),
            FilmPainter3(
                {.tone = look.tone, .exposure = look.exposure, .wanted_width = look.width, .shading = look.shading})});
}

std::shared_ptr<PythonFrames> frames(const PythonSimulation& simulation, std::int64_t count, const py::object& fps,
                                     const std::optional<std::string>& tone, double exposure, std::int64_t size,
                                     const std::string& shading, const py::object& cells) {
  if (count < 1 || static_cast<std::uint64_t>(count) > kMostFrames)
    throw UsageError("frames are a number from 1 to " + std::to_string(kMostFrames));
  const Rational per_second = rational_of(fps, false, "fps");
  if (per_second <= 0) throw UsageError("fps is a number above 0");
  const FrameLook look{tone_named(tone, simulation.is_plane()), shading_named(shading), exposure,
                       width_of_picture(size)};
  require_exposure(exposure);
  if (simulation.is_plane() && look.shading != Shading::kFlat) throw UsageError("shading is for scenes in space");
  if (!simulation.is_plane() && !cells.is_none())
    throw UsageError("cells are for scenes in the plane: in space frames show what a camera sees");
  const auto number = static_cast<std::uint32_t>(count);
  without_lock({}, [&](const StageProgress&) {
    std::visit([&](const auto& scene) { require_lights_beside_surfaces(*scene, number, per_second); },
               simulation.scene().scene());
  });
  return std::make_shared<PythonFrames>(simulation, film_of(simulation, {cells, py::none(), "point"}, look), number,
                                        per_second);
}

}  // namespace

void add_frames(py::module_& module) {
  py::class_<PythonFrame>(module, "Frame", "A scene some seconds on, its lights moved: one of Simulation.frames().")
      .def_readonly("index", &PythonFrame::index, "Its number, an int from 0.")
      .def_readonly("seconds", &PythonFrame::seconds, "How far on, a float [s].")
      .def_readonly("simulation", &PythonFrame::simulation,
                    "The simulation of the scene at that time, Simulation: its radiosities are there.")
      .def_readonly("picture", &PythonFrame::picture, "The picture of its light, Picture, toned as the first frame is.")
      .def("__repr__", [](const PythonFrame& frame) {
        return "<hottel.Frame " + std::to_string(frame.index) + ", at " + shortest(frame.seconds) + " s>";
      });
  py::class_<PythonFrames, std::shared_ptr<PythonFrames>>(
      module, "Frames", "Frames one after the other, an iterator: each is made when it is asked for.")
      .def("__iter__", [](const std::shared_ptr<PythonFrames>& frames) { return frames; })
      .def("__next__", &PythonFrames::next)
      .def("__len__", &PythonFrames::count);
}

void add_frames_questions(py::class_<PythonSimulation>& type) {
  type.def("frames", &frames, py::arg("count"), py::arg("fps") = 24, py::kw_only(), py::arg("tone") = py::none(),
           py::arg("exposure") = 1.0, py::arg("size") = 0, py::arg("shading") = "flat", py::arg("cells") = py::none(),
           "Returns an iterator over frames in which lights turn and follow their paths, Frames: frame k is the light\n"
           "k / fps seconds on, the frame of `hottel animate`. What frames share is computed once.\n\n"
           "fps: a number. The others: as of picture(). UsageError for what makes no sense, RequestError where a light "
           "comes\nto lie on a surface, and as of radiosity.");
}

}  // namespace hottel::python
