// The commands of a viewer.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "kernel/decimal.h"
#include "kernel/support/failure.h"
#include "solver/plane/methods/method_catalogue.h"
#include "viewer/edit/decimals.h"
#include "viewer/edit/material_edits.h"
#include "viewer/edit/plane/scene_edits.h"
#include "viewer/edit/plane/typed_point.h"
#include "viewer/picture/plane/drawable.h"
#include "viewer/window/choices.h"
#include "viewer/window/commands.h"
#include "viewer/window/plane/viewer.h"

namespace hottel {
namespace {

constexpr int kLampPixels = 8;  // units, half the side of a lamp

}  // namespace

void Viewer2::command(std::string_view name) {
  needs_frame_ = true;
  message_.clear();
  const std::uint64_t before = editor_.version();
  if (!view_command(name) && !edit_command(name) && !light_command(name) && !material_command(name) &&
      !file_command(name))
    throw UsageError("there is no command called '" + std::string(name) + "'");
  if (message_.empty() && !prompt_ && editor_.version() == before) message_ = why_nothing(name);
  scene_changed();
  follow_mouse();
}

// Why a command changed nothing; empty for those that do not change the scene.
std::string Viewer2::why_nothing(std::string_view name) const {
  const auto found = std::ranges::find(commands(), name, &Command::name);
  const bool is_edit = found != commands().end() && found->topic != "look" && found->topic != "file";
  if (!is_edit || name == "all" || name == "escape") return "";
  if (editor_.is_dragging()) return "not while something is dragged";
  if (name == "undo") return "there is nothing to undo";
  if (name == "redo") return "there is nothing to do again";
  if (found->topic != "edit") return "it goes no further";
  if (editor_.selected_vertex()) return "a vertex is selected: that is for edges";
  if (editor_.selected_light()) return "a light is selected: that is for edges";
  return editor_.selected().empty() ? "nothing is selected" : "";
}

bool Viewer2::view_command(std::string_view name) {
  if (name.starts_with("look ")) {
    const auto mode = view_mode_2(name.substr(5));
    if (!mode) return false;
    request_.mode = *mode;
    request_.other.reset();
    if (is_fitted_) fit();
    needs_base_ = true;
  } else if (name == "next" || name == "previous") {
    message_ = take_next(request_, methods_2(), name == "next" ? 1 : -1);
  } else if (name == "again") {
    views_.compute_again();
  } else if (name == "closed form") {
    request_.wants_closed_form = !request_.wants_closed_form;
  } else if (!frame_command(name)) {
    return false;
  }
  views_.set_tone(tone_, texture_pixels());
  needs_base_ = true;
  return true;
}

bool Viewer2::nudge(std::string_view name) {
  const bool is_far = name.starts_with("far ");
  if (is_far) name.remove_prefix(4);
  const int x = name == "right" ? 1 : name == "left" ? -1 : 0, y = name == "up" ? 1 : name == "down" ? -1 : 0;
  if (x == 0 && y == 0) return false;
  const Rational step = decimal_step(decimals_at(camera_.pixels_per_length()) - (is_far ? 1 : 0));
  message_ = editor_.move_by(x * step, y * step);
  return true;
}

bool Viewer2::edit_command(std::string_view name) {
  const int decimals = decimals_at(camera_.pixels_per_length());
  if (name == "undo") {
    if (editor_.is_dragging()) drag_ = Drag::kNone;
    message_ = editor_.undo();
  } else if (name == "redo") {
    message_ = editor_.redo();
  } else if (name == "coordinates") {
    if (tool_)
      end_tool(false);
    else
      ask_for_coordinates();
  } else if (name == "turn" || name == "turn back" || name == "turn square") {
    message_ = editor_.rotate(Rational(name == "turn" ? 15 : name == "turn back" ? -15 : 90), decimals + 2);
  } else if (name == "copy") {
    const Rational aside = rounded_decimal(24 * unit_ / camera_.pixels_per_length(), decimals);
    message_ = editor_.duplicate(aside, -aside);
  } else if (name == "delete") {
    message_ = editor_.erase();
  } else if (name == "reverse") {
    message_ = editor_.reverse();
  } else if (name == "edge" || name == "polyline") {
    begin_tool(name == "edge");
  } else if (name == "lamp") {
    const Rational half = rounded_decimal(kLampPixels * unit_ / camera_.pixels_per_length(), decimals + 1);
    message_ = editor_.add_lamp(editor_.snap(pointer()).at, half);
  } else if (name == "groups") {
    editor_.select_groups();
  } else if (name == "all") {
    editor_.select_all();
  } else if (name == "escape") {
    if (shows_help_)
      shows_help_ = false;
    else if (tool_)
      tool_.reset();
    else if (editor_.is_dragging())
      editor_.cancel();
    else
      editor_.select_none();
    drag_ = Drag::kNone;
  } else {
    return nudge(name);
  }
  return true;
}

// What is drawn has the material under the mouse, else the first one that does not shine.
void Viewer2::begin_tool(bool is_edge) {
  const std::vector<Material>& materials = editor_.scene()->materials;
  if (materials.empty()) {
    message_ = "there is no material to draw with: add a lamp first";
    return;
  }
  const auto touched = hover_.surface ? material_of(*editor_.scene(), asked_face(hover_)) : std::nullopt;
  const auto dark = std::ranges::find_if(materials, [](const Material& m) { return m.emission.is_zero(); });
  const auto first = dark == materials.end() ? 0 : static_cast<std::uint32_t>(dark - materials.begin());
  tool_ = Tool{{}, is_edge, touched.value_or(first)};
  message_ = fmt::format("click {} of '{}'", is_edge ? "two points" : "points", materials[tool_->material].name);
}

void Viewer2::add_tool_point() {
  const Point2 at = editor_.snap(pointer()).at;
  if (!tool_->points.empty() && tool_->points.back() == at) return;
  if (tool_->points.size() > 1 && tool_->points.front() == at) return end_tool(true);
  tool_->points.push_back(at);
  if (tool_->is_edge && tool_->points.size() == 2) end_tool(false);
}

void Viewer2::end_tool(bool closed) {
  message_ = editor_.add_line(tool_->points, closed && tool_->points.size() > 2, tool_->material);
  if (message_.empty()) message_ = "a line has two points at least";
  tool_.reset();
  scene_changed();
}

bool Viewer2::material_command(std::string_view name) {
  const bool copies_first = name.starts_with("own ");
  if (copies_first) name.remove_prefix(4);
  if (name != "material" && !is_material_edit(name)) return false;
  if (!hover_.surface)
    message_ = "no edge lies under the mouse";
  else if (name == "material")
    ask_for_material(copies_first);
  else
    change_material(name, copies_first);
  return true;
}

void Viewer2::change_material(std::string_view name, bool copies_first) {
  const Face face = asked_face(hover_);
  const std::string changed =
      editor_.change_material(face, copies_first, [name](Material& material) { edit_material(material, name); });
  if (changed.empty()) return;
  const Material& now = editor_.scene()->materials[*material_of(*editor_.scene(), face)];
  message_ = fmt::format("{}: reflectivity {}, emission {}", changed, spectrum_text(now.reflectivity),
                         spectrum_text(now.emission));
}

void Viewer2::ask_for_material(bool copies_first) {
  const Face face = asked_face(hover_);
  const Material& now = editor_.scene()->materials[*material_of(*editor_.scene(), face)];
  prompt_ = Prompt{.question = now.name + (copies_first ? ", for this group alone" : ""),
                   .text = material_text(now),
                   .answer = [this, face, copies_first](const std::string& text) {
                     Material values;
                     const std::string problem = read_material(text, values);
                     if (!problem.empty()) return problem;
                     editor_.change_material(face, copies_first, [&text](Material& m) { read_material(text, m); });
                     scene_changed();
                     return std::string();
                   }};
}

void Viewer2::ask_for_coordinates() {
  const std::optional<std::uint32_t> light = editor_.selected_light();
  if (!light && !editor_.selected_vertex() && editor_.selected().empty()) {
    message_ = "select what is to go there first";
    return;
  }
  const Point2 from = light                       ? editor_.scene()->light_places[*light].position
                      : editor_.selected_vertex() ? *editor_.selected_vertex()
                                                  : editor_.scene()->edges[editor_.selected().front()].from;
  const std::string shown = fmt::format("{}, {}", short_text(from.x), short_text(from.y));
  prompt_ = Prompt{.question = "goes to", .text = shown, .answer = [this, from, shown](const std::string& text) {
                     Typed<Point2> typed = typed_point_2(text);
                     if (!typed.value) return typed.problem;
                     // A coordinate as it was shown stays, with all the digits that it has.
                     const Point2 rounded = *typed_point_2(shown).value;
                     if (typed.value->x == rounded.x) typed.value->x = from.x;
                     if (typed.value->y == rounded.y) typed.value->y = from.y;
                     try {
                       require_drawable(*editor_.scene(), *typed.value, text);
                     } catch (const RequestError&) {
                       return std::string("this is too far away to be drawn");
                     }
                     message_ = editor_.move_to(*typed.value);
                     scene_changed();
                     return std::string();
                   }};
}

}  // namespace hottel
