// The commands of a viewer in space.
#include <fmt/format.h>

#include <algorithm>

#include "kernel/support/failure.h"
#include "solver/space/methods/method_catalogue.h"
#include "viewer/edit/material_edits.h"
#include "viewer/window/choices.h"
#include "viewer/window/space/viewer.h"

namespace hottel {
namespace {

constexpr double kStepsAcross = 40;  // of a walk through the scene
constexpr double kLookStep = 3, kOrbitStep = 5, kZoomStep = 1.1;

}  // namespace

void Viewer3::command(std::string_view name) {
  needs_frame_ = true;
  message_.clear();
  if (!walk_command(name) && !view_command(name) && !edit_command(name) && !selection_command(name) &&
      !add_command(name) && !light_command(name) && !material_command(name) && !file_command(name))
    throw UsageError("there is no command called '" + std::string(name) + "'");
  scene_changed();
  touch();
}

bool Viewer3::view_command(std::string_view name) {
  ViewRequest3 request = request_;
  if (name.starts_with("look ")) {
    const auto mode = view_mode_3(name.substr(5));
    if (!mode) return false;
    request.mode = *mode;
  } else if (name == "next" || name == "previous") {
    message_ = take_next(request, methods_3(), name == "next" ? 1 : -1);
  } else if (name == "again") {
    ask(true);
  } else if (name == "shading") {
    is_smooth_ = !is_smooth_;
    message_ = is_smooth_ ? "blended over flat surfaces" : "one value an element";
  } else if (name == "gather") {
    gathers_ = !gathers_;
    message_ = gathers_ ? "at rest light is gathered point by point" : "the light of elements";
  } else if (name == "outlines") {
    has_outlines_ = !has_outlines_;
    has_tone_ = true;
    message_ = has_outlines_ ? "outlines of faces" : "no outlines";
  } else if (!frame_command(name)) {
    return false;
  }
  set_request(std::move(request));
  needs_base_ = true;
  return true;
}

bool Viewer3::walk_command(std::string_view name) {
  EyeCamera3 camera = camera_;
  const double step = camera_.size() / kStepsAcross;
  if (name == "forward" || name == "back") {
    camera.walk(name == "forward" ? step : -step, 0, 0);
  } else if (name == "left" || name == "right") {
    camera.walk(0, name == "right" ? step : -step, 0);
  } else if (name == "rise" || name == "sink") {
    camera.walk(0, 0, name == "rise" ? step : -step);
  } else if (name == "look left" || name == "look right") {
    camera.turn(name == "look right" ? kLookStep : -kLookStep, 0);
  } else if (name == "look up" || name == "look down") {
    camera.turn(0, name == "look up" ? kLookStep : -kLookStep);
  } else if (name == "orbit left" || name == "orbit right") {
    camera.orbit(name == "orbit right" ? kOrbitStep : -kOrbitStep, 0);
  } else if (name == "orbit up" || name == "orbit down") {
    camera.orbit(0, name == "orbit up" ? kOrbitStep : -kOrbitStep);
  } else if (name == "nearer" || name == "farther") {
    camera.zoom(name == "nearer" ? kZoomStep : 1 / kZoomStep);
  } else {
    return false;
  }
  if (camera == camera_)
    message_ = "it goes no further";
  else
    see(camera);
  return true;
}

// The material that lies under the mouse, else that of the picked polygon.
std::optional<std::uint32_t> Viewer3::material_meant() {
  touch();
  const std::optional<LiveElement3>& element = hover_ ? hover_ : picked_;
  if (element) return element->element().material;
  message_ = "no polygon with a material lies under the mouse, and none is picked";
  return std::nullopt;
}

bool Viewer3::edit_command(std::string_view name) {
  if (name == "undo" || name == "redo") {
    if (editor_.is_dragging()) drag_ = Drag::kNone;
    message_ = name == "undo" ? editor_.undo() : editor_.redo();
    if (message_.empty()) message_ = name == "undo" ? "there is nothing to undo" : "there is nothing to do again";
  } else if (name == "escape") {
    drop();
  } else {
    return false;
  }
  return true;
}

// Drops what is there to be dropped first: the help, a drag, or all that is picked.
void Viewer3::drop() {
  if (shows_help_) {
    shows_help_ = false;
    return;
  }
  if (editor_.is_dragging()) {
    editor_.cancel();
    drag_ = Drag::kNone;
    return;
  }
  editor_.select_none();
  unpick();
}

bool Viewer3::material_command(std::string_view name) {
  if (name != "material" && !is_material_edit(name)) return false;
  const std::optional<std::uint32_t> material = material_meant();
  if (!material) return true;
  if (name == "material") {
    ask_for_material(*material);
    return true;
  }
  Material changed = scene()->materials[*material];
  edit_material(changed, name);
  message_ = fmt::format("{}: reflectivity {}, emission {}", changed.name, spectrum_text(changed.reflectivity),
                         spectrum_text(changed.emission));
  if (changed == scene()->materials[*material])
    message_ = "it goes no further";
  else
    change_material(*material, changed);
  return true;
}

void Viewer3::ask_for_material(std::uint32_t material) {
  const Material& now = scene()->materials[material];
  prompt_ =
      Prompt{.question = now.name, .text = material_text(now), .answer = [this, material](const std::string& text) {
               Material values = scene()->materials[material];
               const std::string problem = read_material(text, values);
               if (problem.empty()) change_material(material, values);
               return problem;
             }};
}

void Viewer3::change_material(std::uint32_t material, const Material& values) {
  std::vector<Material> materials = scene()->materials;
  materials[material] = values;
  editor_.change_materials(std::move(materials), "change " + values.name);
  scene_changed();
}

}  // namespace hottel
