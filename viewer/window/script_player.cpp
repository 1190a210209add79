#include "viewer/window/script_player.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>
#include <thread>

#include "io/files/output_file.h"
#include "kernel/support/failure.h"
#include "viewer/picture/picture_options.h"
#include "viewer/picture/png_file.h"
#include "viewer/window/commands.h"

namespace hottel {
namespace {

constexpr double kPatience = 600;  // seconds that a step may take
constexpr int kStepsOfADrag = 12;

// Plays one script.
class Player {
 public:
  Player(const std::string& name, Viewer& viewer, RecordingWindow& window, const ScriptOutputs& outputs)
      : name_(name), viewer_(viewer), window_(window), outputs_(outputs) {}

  void play(const ScriptStep& step) {
    step_ = &step;
    try {
      do_step();
    } catch (const UsageError& error) {
      refuse(error.what());
    }
    record();
  }

 private:
  [[noreturn]] void refuse(const std::string& text) const { throw InputError({name_, step_->line}, text); }

  void do_step() {
    const std::string& word = step_->word;
    if (word == "move" || word == "press" || word == "release" || word == "click" || word == "drag" || word == "wheel")
      mouse();
    else if (word == "key")
      type_key(step_->arguments[0]);
    else if (word == "type")
      send({.kind = WindowEvent::Kind::kText, .text = step_->rest});
    else if (word == "do")
      viewer_.command(fmt::format("{}", fmt::join(step_->arguments, " ")));
    else if (word == "leave" || word == "close")
      send({.kind = word == "leave" ? WindowEvent::Kind::kLeave : WindowEvent::Kind::kQuit});
    else if (word == "size")
      resize();
    else if (word == "pause")
      pause();
    else if (!viewer_.do_own_step(*step_))
      write();
  }

  void record() {
    viewer_.settle(kPatience);
    if (outputs_.frame) outputs_.frame(window_.frame());
  }

  void send(const WindowEvent& event) { viewer_.handle(event); }

  // "3.5,2" or "3.5,2,1" in the scene, or "@640,400" in pixels.
  Pixel pixel(std::string_view text) const {
    const bool is_pixel = text.starts_with('@');
    if (is_pixel) text.remove_prefix(1);
    std::vector<double> place;
    for (std::string_view rest = text;; rest.remove_prefix(1)) {
      const std::size_t comma = std::min(rest.find(','), rest.size());
      if (!read_script_number(rest.substr(0, comma), place.emplace_back())) place.clear();
      rest.remove_prefix(comma);
      if (rest.empty() || place.empty()) break;
    }
    if (place.size() < 2 || (is_pixel && place.size() != 2))
      refuse("a place is X,Y in the scene or @X,Y in pixels, not '" + std::string(is_pixel ? "@" : "") +
             std::string(text) + "'");
    return is_pixel ? Pixel{place[0], place[1]} : viewer_.pixel_of_place(place);
  }

  // The button and what is held, from the arguments behind the places.
  WindowEvent held_event(std::size_t first) const {
    WindowEvent event{.button = MouseButton::kLeft};
    for (std::size_t k = first; k < step_->arguments.size(); ++k) {
      std::string_view text = step_->arguments[k];
      if (text == "left" || text == "middle" || text == "right") {
        event.button = text == "left"    ? MouseButton::kLeft
                       : text == "right" ? MouseButton::kRight
                                         : MouseButton::kMiddle;
        continue;
      }
      while (!text.empty()) {
        const auto plus = std::min(text.find('+'), text.size());
        const std::string_view key = text.substr(0, plus);
        text.remove_prefix(std::min(plus + 1, text.size()));
        if (key == "shift")
          event.held.shift = true;
        else if (key == "ctrl")
          event.held.ctrl = true;
        else if (key == "alt")
          event.held.alt = true;
        else
          refuse("a button is left, middle or right, and held are shift, ctrl and alt, not '" + std::string(key) + "'");
      }
    }
    return event;
  }

  void send_mouse(WindowEvent event, WindowEvent::Kind kind, const Pixel& at) {
    event.kind = kind;
    event.x = at.x;
    event.y = at.y;
    send(event);
  }

  void mouse() {
    using Kind = WindowEvent::Kind;
    const std::string& word = step_->word;
    const Pixel first = pixel(step_->arguments[0]);
    if (word == "drag") return drag(first);
    if (word == "wheel") {
      WindowEvent event;
      if (!read_script_number(step_->arguments[1], event.wheel)) refuse("how many notches the wheel turns is a number");
      return send_mouse(event, Kind::kWheel, first);
    }
    const WindowEvent event = held_event(1);
    send_mouse(event, Kind::kMove, first);
    if (word == "press" || word == "click") send_mouse(event, Kind::kPress, first);
    if (word == "release" || word == "click") send_mouse(event, Kind::kRelease, first);
  }

  void drag(const Pixel& first) {
    using Kind = WindowEvent::Kind;
    std::vector<Pixel> places{first};
    std::size_t next = 1;
    for (; next < step_->arguments.size() && step_->arguments[next].find(',') != std::string::npos; ++next)
      places.push_back(pixel(step_->arguments[next]));
    const WindowEvent event = held_event(next);
    send_mouse(event, Kind::kMove, first);
    send_mouse(event, Kind::kPress, first);
    for (std::size_t k = 1; k < places.size(); ++k)
      for (int s = 1; s <= kStepsOfADrag; ++s) {
        const double t = static_cast<double>(s) / kStepsOfADrag;
        send_mouse(event, Kind::kMove,
                   {std::lerp(places[k - 1].x, places[k].x, t), std::lerp(places[k - 1].y, places[k].y, t)});
        if (outputs_.frame) record();
      }
    send_mouse(event, Kind::kRelease, places.back());
  }

  void type_key(const std::string& text) {
    const WindowEvent event = key_event(text);
    send(event);
    if (event.key.size() == 1 && !event.held.ctrl && !event.held.alt)
      send({.kind = WindowEvent::Kind::kText, .text = event.key});
  }

  void resize() {
    const std::string& text = step_->arguments[0];
    const auto x = text.find('x');
    double width = 0, height = 0;
    if (x == std::string::npos || !read_script_number(text.substr(0, x), width) ||
        !read_script_number(text.substr(x + 1), height) || width < 1 || height < 1 || width > kMaxPictureSide ||
        height > kMaxPictureSide || width != std::floor(width) || height != std::floor(height))
      refuse("a size is WIDTHxHEIGHT in pixels, not '" + text + "'");
    window_.resize({static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height)});
    while (const auto event = window_.next(0)) send(*event);
  }

  void pause() {
    double seconds = 0;
    if (!read_script_number(step_->arguments[0], seconds) || seconds < 0) refuse("seconds are a number not below 0");
    for (int k = 0; k < seconds * kFramesPerSecond; ++k) {
      if (viewer_.pass_time(Rational(1, kFramesPerSecond))) {
        viewer_.settle(kPatience);
      } else {
        std::this_thread::sleep_for(std::chrono::milliseconds(1000 / kFramesPerSecond));
        viewer_.update();
      }
      if (outputs_.frame) outputs_.frame(window_.frame());
    }
  }

  void write() {
    const std::string& word = step_->word;
    if (word != "wait" && word != "save" && word != "screenshot" && word != "picture" && word != "hash")
      refuse("'" + word + "' is a step for scenes in space");
    viewer_.settle(kPatience);
    if (word == "save") viewer_.save_as(step_->arguments[0]);
    if (word == "screenshot") save_screenshot(window_.frame(), step_->arguments[0]);
    if (word == "picture") viewer_.save_picture(step_->arguments[0]);
    if (word == "hash") outputs_.print(viewer_.hashes());
  }

  const std::string& name_;
  Viewer& viewer_;
  RecordingWindow& window_;
  const ScriptOutputs& outputs_;
  const ScriptStep* step_ = nullptr;
};

}  // namespace

bool read_script_number(std::string_view text, double& value) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size() && std::abs(value) < 1e300;
}

void save_screenshot(const Raster& frame, const std::filesystem::path& file) {
  if (picture_format(file.string()) != PictureFormat::kPng)
    throw UsageError("a screenshot ends in .png, not '" + file.string() + "'");
  write_output_file(file, png_file(frame));
}

void play_script(const std::vector<ScriptStep>& steps, const std::string& name, Viewer& viewer, RecordingWindow& window,
                 const ScriptOutputs& outputs) {
  Player player(name, viewer, window, outputs);
  viewer.settle(kPatience);
  for (const ScriptStep& step : steps) {
    if (viewer.wants_quit()) return;
    player.play(step);
  }
}

}  // namespace hottel
