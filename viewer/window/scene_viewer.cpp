#include "viewer/window/scene_viewer.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "kernel/plain_functions.h"
#include "kernel/support/failure.h"
#include "viewer/edit/light_edits.h"
#include "viewer/picture/cairo_canvas.h"
#include "viewer/window/choices.h"
#include "viewer/window/file_questions.h"
#include "viewer/window/help.h"
#include "viewer/window/lights.h"
#include "viewer/window/panel.h"

namespace hottel {
namespace {

constexpr std::size_t kEventsPerFrame = 200;
constexpr double kSecondsBetweenUpdates = 1;
constexpr double kSecondsBetweenFrames = 0.02;  // while lights move
constexpr double kSecondsBetweenFileChecks = 1;
constexpr double kStill = 3;         // units that a click may wander
constexpr double kPerNotch = 1.2;    // of the wheel
constexpr Pixel kWarningAt{12, 52};  // units, where what is wrong is said

Rational thousandths(double seconds) {
  Rational result(std::lround(seconds * 1000), 1000);
  result.canonicalize();
  return result;
}

bool is_at_a_place(const WindowEvent& event) {
  using Kind = WindowEvent::Kind;
  return event.kind == Kind::kMove || event.kind == Kind::kPress || event.kind == Kind::kRelease ||
         event.kind == Kind::kWheel;
}

}  // namespace

SceneViewer::SceneViewer(Window& window, double unit, Tone usual, std::span<const Command> commands,
                         std::span<const Gesture> gestures)
    : window_(window),
      unit_(unit),
      size_(window.size()),
      tone_{.tone = usual},
      commands_(commands),
      gestures_(gestures) {}

bool SceneViewer::is_still() const {
  return std::hypot(mouse_.x - pressed_.x, mouse_.y - pressed_.y) <= kStill * unit_;
}

bool SceneViewer::is_on_bar() const { return std::abs(mouse_.x - split_ * size_.width) < kReach * unit_; }

// Events.

void SceneViewer::run() {
  Stopwatch watch;
  for (bool moves = false; !wants_quit_;) {
    handle_events(moves ? kSecondsBetweenFrames : kSecondsBetweenUpdates);
    const double gone = watch.lap();
    moves = pass_time(moves ? thousandths(gone) : Rational(0));
    update();
  }
}

// Waits so long for the first one. Of moves of the mouse one after the other the last one is handled.
void SceneViewer::handle_events(double seconds) {
  std::optional<WindowEvent> moved;
  for (std::size_t k = 0; k < kEventsPerFrame; ++k) {
    const std::optional<WindowEvent> event = window_.next(k == 0 ? seconds : 0);
    if (!event) break;
    if (event->kind == WindowEvent::Kind::kMove) {
      moved = event;
      continue;
    }
    if (moved) handle(*std::exchange(moved, std::nullopt));
    handle(*event);
  }
  if (moved) handle(*moved);
}

void SceneViewer::handle(const WindowEvent& event) {
  using Kind = WindowEvent::Kind;
  needs_frame_ = needs_frame_ || event.kind != Kind::kWake;
  const Pixel before = mouse_;
  if (is_at_a_place(event)) {
    mouse_ = {event.x, event.y};
    has_mouse_ = true;
  }
  switch (event.kind) {
    case Kind::kQuit:
      return quit();
    case Kind::kResize:
      return resize();
    case Kind::kMove:
      return move(before);
    case Kind::kLeave:
      has_mouse_ = false;
      return follow_mouse();
    case Kind::kPress:
      return press(event);
    case Kind::kRelease:
      return release(event);
    case Kind::kWheel:
      if (!scrolls_.wheel(mouse_, event.wheel) && !shows_help_) zoom(same_bits::pow(kPerNotch, event.wheel));
      return;
    case Kind::kKey:
      return handle_key(event);
    case Kind::kText:
      if (!std::exchange(drops_text_, false) && prompt_ && prompt_->keys.empty()) type_into(*prompt_, event.text);
      return;
    case Kind::kFocus:
      until_watch_ = 0;
      return;
    case Kind::kWake:
      return;
  }
}

void SceneViewer::resize() {
  needs_base_ = true;
  const FrameSize before = std::exchange(size_, window_.size());
  if (size_ != before) size_changed();
}

void SceneViewer::handle_key(const WindowEvent& event) {
  drops_text_ = false;
  if (prompt_) return answer_prompt(prompt_, event);
  if (takes_key(event)) return;
  if (event.held == HeldKeys() && scrolls_.key(event.key, mouse_, shows_help_ ? "help" : "")) return;
  if (const auto name = command_of_key(key_text(event), commands_); !name.empty()) command(name);
  drops_text_ = prompt_ && event.key.size() == 1 && !event.held.ctrl && !event.held.alt;
}

bool SceneViewer::frame_command(std::string_view name) {
  if (name == "tone") {
    tone_.tone = next_of(kTones, tone_.tone, 1);
    has_tone_ = true;
  } else if (name == "darker" || name == "brighter") {
    tone_.exposure *= name == "brighter" ? kExposureStep : 1 / kExposureStep;
    has_tone_ = true;
  } else if (name == "page up" || name == "page down") {
    if (!scrolls_.turn(name == "page up" ? -1 : 1, mouse_)) message_ = "no text has more to show";
  } else if (name == "fit") {
    fit();
  } else if (name == "help") {
    shows_help_ = !shows_help_;
  } else {
    return false;
  }
  return true;
}

// The file of the scene.

bool SceneViewer::file_command(std::string_view name) {
  if (name == "save") {
    save();
  } else if (name == "save as") {
    prompt_ = file_prompt("save as", name_to_save_as(), [this](const std::string& to) { save_as(to); });
  } else if (name == "picture") {
    prompt_ = file_prompt("picture", file().path().stem().string() + ".png", [this](const std::string& to) {
      save_picture(to);
      message_ = "saved " + to;
    });
  } else if (name == "copy number") {
    copy_number();
  } else if (name == "reload") {
    reload();
  } else if (name == "quit") {
    quit();
  } else {
    return false;
  }
  return true;
}

void SceneViewer::copy_number() {
  const std::string copied = number();
  message_ = copied.empty() ? "there is no number to copy" : "copied " + copied;
  if (copied.empty()) return;
  window_.set_clipboard(copied);
  if (is_number_behind()) message_ += ", before the last edit";
}

void SceneViewer::reload() {
  if (!is_changed()) return read_again();
  prompt_ = Prompt{.question = "unsaved changes:  r  read the file again and drop them   escape  keep them",
                   .keys = {{"r", [this] { read_again(); }}}};
}

// Tells what has become of the file.
void SceneViewer::watch_file() {
  until_watch_ -= since_watch_.lap();
  if (until_watch_ > 0 || prompt_) return;
  until_watch_ = kSecondsBetweenFileChecks;
  const FileNews news = file_news();
  if (news == FileNews::kNone) return;
  FileAnswer answer = answer_to(news, file(), is_changed() || is_dragging(), [this] { read_again(); });
  if (answer.is_to_be_read) read_again();
  if (message_.empty()) message_ = answer.message;
  prompt_ = std::move(answer.question);
  needs_frame_ = true;
}

// Returns what is wrong, or nothing.
std::string SceneViewer::save() {
  try {
    if (const std::string problem = why_not_saved(); !problem.empty()) throw UsageError(problem);
    save_as(file().path());
    return "";
  } catch (const std::runtime_error& error) {
    message_ = std::string("not saved: ") + error.what();
    return message_;
  }
}

void SceneViewer::save_as(const std::filesystem::path& file) {
  const std::filesystem::path to = file;  // it may be the path that is replaced
  write(to);
  message_ = "saved " + to.string();
  needs_frame_ = true;
}

void SceneViewer::quit() {
  const auto leave = [this] { wants_quit_ = true; };
  if (!quitting_loses(file(), is_changed())) return leave();
  prompt_ = quit_question(
      file(), [this] { return save(); }, leave);
}

// Lights.

bool SceneViewer::light_command(std::string_view name) {
  if (name == "play" || name == "light") {
    name == "play" ? play() : add_light();
    return true;
  }
  if (name != "material" && !is_light_edit(name)) return false;
  const std::optional<std::uint32_t> light = light_meant();
  if (!light && name == "spin") message_ = "no light lies under the mouse, and none is selected";
  if (!light) return name == "spin";
  name == "material" ? ask_for_light(*light) : change_light(*light, name);
  return true;
}

void SceneViewer::change_light(std::uint32_t light, std::string_view name) {
  Light values = table().lights[light];
  std::vector<Rational> rotation = rotation_of(light);
  edit_light(values, rotation, name);
  const bool turns = std::ranges::any_of(rotation, [](const Rational& rate) { return rate != 0; });
  const std::string changed = set_light(light, values, rotation);
  if (name == "spin" && !changed.empty() && !time_ && turns) time_ = 0;
  if (changed.empty())
    message_ = is_dragging() ? "not while something is dragged" : why_light_stays(name);
  else if (!hover_light_)  // what lies under the mouse is told already
    message_ = light_line(table().lights[light], rotation_of(light));
}

void SceneViewer::ask_for_light(std::uint32_t light) {
  prompt_ = light_prompt(table().lights[light], rotation_of(light),
                         [this, light](const Light& values, std::span<const Rational> rotation) {
                           set_light(light, values, rotation);
                           scene_changed();
                         });
}

// Lights begin to move, or stand again.
void SceneViewer::play() {
  if (time_)
    stop();
  else
    message_ = begin_to_move(time_, is_dragging(), can_lights_move());
}

void SceneViewer::stop() {
  time_.reset();
  show_lights_standing();
  needs_frame_ = true;
  message_ = "the lights stand";
}

bool SceneViewer::pass_time(const Rational& seconds) {
  if (!time_) return false;
  *time_ += seconds;
  if (seconds > 0 && is_light_at_rest()) move_lights();
  return true;
}

void SceneViewer::move_lights() {
  needs_frame_ = true;
  const std::string problem = can_lights_move() ? show_lights_after(*time_) : "no light moves";
  if (problem.empty()) return;
  const std::string why = why_lights_stand(*time_, problem);
  stop();
  message_ = why;
}

// Frames.

bool SceneViewer::update() {
  collect();
  watch_file();
  if (!needs_base_ && !needs_frame_) return false;
  draw();
  window_.show(frame_);
  return true;
}

void SceneViewer::draw() {
  if (needs_base_ || base_.width != size_.width || base_.height != size_.height) draw_base();
  frame_ = base_;
  CairoCanvas canvas(frame_);
  scrolls_.begin_frame();
  draw_marks_of_hand(canvas);
  if (shows_help_)
    draw_help(canvas, commands_, gestures_, scrolls_.of("help"), unit_);
  else
    draw_texts(canvas);
  if (prompt_) draw_prompt(canvas, *prompt_, scrolls_.of("prompt"), unit_);
  scrolls_.end_frame();
  canvas.finish();
  std::string title = file_title() + " - hottel";
  if (title != title_) window_.set_title(title);
  title_ = std::move(title);
  needs_frame_ = false;
}

TextRoom SceneViewer::draw_head(PictureCanvas& canvas) {
  std::string line = message_;
  if (const std::string now = status(); !now.empty()) line += (line.empty() ? "" : "   ") + now;
  return draw_head_and_line(canvas, head(), line, scrolls_, unit_);
}

void SceneViewer::draw_warning(PictureCanvas& canvas, std::vector<std::string> lines) {
  draw_panel(canvas, {.lines = std::move(lines), .is_warning = true},
             {.corner = {kWarningAt.x * unit_, kWarningAt.y * unit_},
              .width = side_width(canvas, 0.45, unit_),
              .height = 0.7 * size_.height,
              .scroll = &scrolls_.of("problem")},
             unit_);
}

std::string SceneViewer::file_title() const { return title_of(file(), is_changed()); }

}  // namespace hottel
