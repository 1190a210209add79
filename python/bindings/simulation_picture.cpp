#include "python/bindings/simulation_picture.h"

#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "geometry/space/prepared/prepared_scene.h"
#include "kernel/support/failure.h"
#include "python/bindings/light_request.h"
#include "python/bindings/picture.h"
#include "python/bindings/picture_names.h"
#include "solver/plane/light/oriented_lights.h"
#include "solver/space/light/oriented_lights.h"
#include "viewer/picture/plane/illumination_picture.h"
#include "viewer/picture/plane/shown_picture.h"
#include "viewer/picture/space/gathered_view.h"
#include "viewer/picture/space/grid_picture.h"
#include "viewer/picture/space/render_picture.h"

namespace hottel::python {
namespace {

// What is asked of a picture, by names of options of the program.
struct PictureKeywords {
  std::string show = "light", shading = "flat", of = "scene";
  std::optional<std::string> tone, channel, bar;
  double exposure = 1;
  std::int64_t size = 0;
  int contours = 0;
  bool has_axes = false;
  std::optional<bool> outlines;
  GridKeywords grid;
};

// The same, once it makes sense.
struct PictureRequest {
  Shown shown;
  Tone tone = Tone::kLog;
  Shading shading = Shading::kFlat;
  double exposure = 1;
  std::uint32_t width = 0;
  int contours = 0;
  bool has_axes = false;
  bool has_outlines = false;
  bool shows_cells = false;  // in the plane, beneath what is shown of faces
  bool is_of_grid = false;   // in space
};

void require_sense_in_plane(const PictureKeywords& asked, const PictureRequest& request) {
  if (asked.outlines) throw UsageError("outlines are for scenes in space: in the plane walls are lines");
  if (asked.of != "scene") throw UsageError("of is for scenes in space: in the plane light has a picture of its grid");
  if (request.shading == Shading::kGathered) throw UsageError("shading='gathered' is for scenes in space");
  if (request.shown.is_light() && request.shading != Shading::kFlat)
    throw UsageError("shading in the plane is for values of faces: light between the faces has no elements");
  if (!request.shown.is_light() && request.width > 0 && request.width < kMinPictureWidth)
    throw UsageError("size with show='" + asked.show + "' is " + std::to_string(kMinPictureWidth) + " at least");
}

void require_sense_in_space(const PictureKeywords& asked, const PictureRequest& request) {
  if (asked.of != "scene" && asked.of != "grid")
    throw UsageError("of is 'scene', what the camera sees, or 'grid', not '" + asked.of + "'");
  if (asked.contours > 0 && asked.of != "grid") throw UsageError("contours in space are for a picture with of='grid'");
  if (asked.of == "scene" && asked.grid.is_given())
    throw UsageError("cells and over go with of='grid': the camera sees faces");
  if (asked.of != "grid") return;
  if (asked.outlines) throw UsageError("outlines are for faces, not for a grid");
  if (!request.shown.is_light() && !is_of_points(request.shown))
    throw UsageError("a grid shows 'light', 'irradiance', 'temperature' or 'sky', not '" + asked.show + "'");
  if (request.shading != Shading::kFlat) throw UsageError("shading is for faces, not for a grid");
}

PictureRequest request_of(const PythonScene& scene, const PictureKeywords& asked) {
  PictureRequest request{.shown = shown_of(scene.table(), asked.show, asked.channel, asked.bar),
                         .tone = tone_named(asked.tone, scene.is_plane()),
                         .shading = shading_named(asked.shading),
                         .exposure = asked.exposure,
                         .width = width_of_picture(asked.size),
                         .contours = asked.contours,
                         .has_axes = asked.has_axes,
                         .has_outlines = asked.outlines.value_or(asked.show != "light"),
                         .is_of_grid = asked.of == "grid"};
  require_exposure(request.exposure);
  if (asked.contours < 0 || asked.contours > 100) throw UsageError("contours are a number from 0 to 100");
  const bool has_contours = asked.contours > 0 && asked.of != "grid";
  if (!request.shown.is_light() && (asked.tone || request.exposure != 1 || has_contours))
    throw UsageError("tone, exposure and contours are for show='light': '" + asked.show + "' has a scale");
  if (scene.is_plane())
    require_sense_in_plane(asked, request);
  else
    require_sense_in_space(asked, request);
  request.shows_cells = scene.is_plane() && is_of_points(request.shown) &&
                        asked.grid.illumination != "inverse-square" &&
                        (asked.grid.is_given() || !scene.in_plane().grids.empty());
  return request;
}

PythonPicture::Draw drawing(const Simulation2& simulation, const PictureRequest& request,
                            const StageProgress& progress) {
  const auto factors = simulation.factors(progress);
  const auto solution = simulation.radiosities(progress);
  const auto prepared = simulation.prepared(progress);
  if (request.shown.is_light()) {
    const IlluminationPicture2 picture{.tone = request.tone,
                                       .exposure = request.exposure,
                                       .wanted_width = request.width,
                                       .has_axes = request.has_axes,
                                       .contours = request.contours};
    return [prepared, light = simulation.light(progress), picture](PictureFormat format) {
      return illumination_picture_2(*prepared, light->grid, picture, format).bytes;
    };
  }
  ShownValues values = shown_values(request.shown, simulation.scene(), factors->matrix, *solution);
  std::optional<ShownCells2> cells;
  if (request.shows_cells) {
    const auto light = simulation.light(progress);
    const auto around = lights_around_cells(*prepared, light->grid, telling("light on the grid", progress));
    cells = ShownCells2{light->grid.grid, shown_at_points(request.shown, around, solution->channel_names)};
    share_scale(request.shown, values, cells->values);
  }
  const ShownPlan2 plan{.width = request.width, .has_axes = request.has_axes, .shading = request.shading};
  return [prepared, values = std::move(values), cells = std::move(cells), plan](PictureFormat format) {
    return shown_picture_2(*prepared, values, plan, format, cells ? &*cells : nullptr);
  };
}

PythonPicture::Draw drawing_of_grid(const Simulation3& simulation, const PictureRequest& request,
                                    const StageProgress& progress) {
  const auto only_pixels = [](PictureFormat format) {
    if (format != PictureFormat::kPng) throw UsageError("a picture of a grid has pixels: it is written as .png");
  };
  const GridPicture3 picture{.tone = request.tone,
                             .exposure = request.exposure,
                             .wanted_width = request.width,
                             .has_axes = request.has_axes,
                             .length_unit = length_unit(simulation.scene()),
                             .contours = request.contours};
  if (request.shown.is_light()) {
    return [light = simulation.light(progress), picture, only_pixels](PictureFormat format) {
      only_pixels(format);
      return grid_picture_3(*light, picture);
    };
  }
  const auto solution = simulation.radiosities(progress);
  const auto lights = oriented_lights_on_grid(*simulation.prepared(), simulation.request().factors.granularity,
                                              *solution, *simulation.grid(), telling("light on the grid", progress));
  ShownValues values = shown_at_points(request.shown, lights, solution->channel_names);
  return [grid = *simulation.grid(), values = std::move(values), picture, only_pixels](PictureFormat format) {
    only_pixels(format);
    return grid_picture_3(grid, values, picture);
  };
}

PythonPicture::Draw drawing(const Simulation3& simulation, const PictureRequest& request,
                            const StageProgress& progress) {
  const auto factors = simulation.factors(progress);
  const auto solution = simulation.radiosities(progress);
  if (request.is_of_grid) return drawing_of_grid(simulation, request, progress);
  if (request.shading == Shading::kGathered) require_gathered_3(request.shown);
  RenderOptions3 options{.tone = request.tone,
                         .exposure = request.exposure,
                         .wanted_width = request.width,
                         .shading = request.shading,
                         .has_outlines = request.has_outlines,
                         .has_axes = request.has_axes,
                         .asked = request.shown,
                         .light_shares = simulation.light_shares(progress),
                         .progress = telling("gathered light", progress)};
  if (!request.shown.is_light())
    options.shown = shown_values(request.shown, simulation.scene(), factors->matrix, *solution);
  const auto prepared = simulation.prepared(progress);
  const auto view = std::make_shared<const RenderedView3>(*prepared, simulation.request().factors.granularity,
                                                          *solution, std::move(options));
  return [prepared, view](PictureFormat format) { return view->file(format); };
}

PythonPicture picture(const PythonSimulation& simulation, const std::string& show,
                      const std::optional<std::string>& channel, const std::optional<std::string>& bar,
                      const std::optional<std::string>& tone, double exposure, std::int64_t size,
                      const std::string& shading, bool has_axes, std::optional<bool> outlines, int contours,
                      const py::object& cells, const py::object& over, const std::string& illumination,
                      const std::string& of) {
  const PictureKeywords asked{show,     shading, of,       tone,     channel,  bar,
                              exposure, size,    contours, has_axes, outlines, {cells, over, illumination}};
  const PictureRequest request = request_of(simulation.scene(), asked);
  const bool asks_for_grid = asked.grid.is_given() || illumination != "point";
  const bool has_grid = request.is_of_grid ||
                        (simulation.is_plane() && (request.shown.is_light() || request.shows_cells || asks_for_grid));
  if (has_grid) require_planar_grid(simulation, asked.grid.over, "a picture");
  const auto version = has_grid ? gridded(simulation, asked.grid) : nullptr;
  if (!has_grid && illumination != "point") throw UsageError("illumination is for light on a grid: of='grid'");
  auto draw = without_lock(simulation.options().waiting, [&](const StageProgress& progress) {
    return std::visit([&](const auto& each) { return drawing(each, request, progress); },
                      version ? *version : simulation.simulation());
  });
  return PythonPicture(std::move(draw), simulation.options().waiting);
}

}  // namespace

void add_picture_questions(py::class_<PythonSimulation>& type) {
  type.def(
      "picture", &picture, py::arg("show") = "light", py::kw_only(), py::arg("channel") = py::none(),
      py::arg("bar") = py::none(), py::arg("tone") = py::none(), py::arg("exposure") = 1.0, py::arg("size") = 0,
      py::arg("shading") = "flat", py::arg("axes") = false, py::arg("outlines") = py::none(), py::arg("contours") = 0,
      py::arg("cells") = py::none(), py::arg("over") = py::none(), py::arg("illumination") = "point",
      py::arg("of") = "scene",
      "Returns a picture of what was simulated, Picture: that of `solve`. In the plane the light between the faces, "
      "or\n"
      "a plan; in space what the scene's camera sees, or with of='grid' the scene's grid.\n\n"
      "show: 'light', or on the faces, in colours of a scale, 'radiosity', 'irradiance', 'net', 'temperature', 'sky'\n"
      "(view factor to it), 'factor:NAME'. channel: 'r', 'g', 'b', 'solar' or 'thermal'. bar: ends of the scale,\n"
      "'LOW:HIGH', 'LOW:HIGH:log'. tone: of light, 'linear', 'reinhard', 'log' or 'max' (None: 'log' in the plane,\n"
      "'reinhard' in space), and what it is multiplied by "
      "before,\n"
      "exposure. size: pixels across, 0 for the usual. shading: 'flat', 'smooth', 'parents' or, in space, 'gathered'. "
      "axes: coordinates and a "
      "scale\n"
      "bar. contours: in the plane, and of='grid'. outlines: in space, lines where surfaces end, bend or hide others; "
      "None: where a "
      "scale is shown. cells, "
      "over, illumination: as of grid(). Throws UsageError for what makes no sense, RequestError as of\n"
      "radiosity and for what cannot be drawn.");
}

}  // namespace hottel::python
