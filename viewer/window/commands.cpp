#include "viewer/window/commands.h"

#include <algorithm>
#include <array>

namespace hottel {
namespace {

constexpr Command kCommands[] = {
    {"look", "look light", "1", "light"},
    {"look", "look floor", "2", "floor colour times light"},
    {"look", "look bands", "3", "radiosity along edges"},
    {"look", "look visibility", "4", "what the mouse sees"},
    {"look", "look factors", "5", "view factors from a clicked face"},
    {"look", "look pair", "6", "critical lines of two clicked faces"},
    {"look", "look errors", "7", "a method against the exact one"},
    {"look", "look check", "8", "what check finds"},
    {"look", "look plan", "9", "what is simulated, and why"},
    {"look", "look sweeps", "0", "a solver, sweep by sweep"},
    {"look", "next", "m", "next method or solver"},
    {"look", "previous", "shift+m", "the one before"},
    {"look", "again", "space", "begin the sweeps again"},
    {"look", "closed form", "c", "closed forms, or none"},
    {"look", "tone", "t", "next tone curve"},
    {"look", "darker", "-", "less exposure"},
    {"look", "darker", "f3", ""},
    {"look", "brighter", "=", "more exposure"},
    {"look", "brighter", "f4", ""},
    {"look", "brighter", "shift+=", ""},
    {"look", "brighter", "+", ""},
    {"look", "fit", "f", "show everything"},
    {"look", "help", "h", "this help"},
    {"look", "help", "f1", ""},
    {"look", "page up", "pageup", "scroll a long text"},
    {"look", "page down", "pagedown", "and on"},
    {"edit", "undo", "ctrl+z", "undo"},
    {"edit", "redo", "ctrl+y", "do again"},
    {"edit", "redo", "ctrl+shift+z", ""},
    {"edit", "left", "left", "nudge, as all arrows; shift: ten"},
    {"edit", "right", "right", ""},
    {"edit", "up", "up", ""},
    {"edit", "down", "down", ""},
    {"edit", "far left", "shift+left", ""},
    {"edit", "far right", "shift+right", ""},
    {"edit", "far up", "shift+up", ""},
    {"edit", "far down", "shift+down", ""},
    {"edit", "coordinates", "enter", "type where the selection goes"},
    {"edit", "turn", "r", "turn by 15 degrees"},
    {"edit", "turn back", "shift+r", "and back"},
    {"edit", "turn square", "ctrl+r", "by 90, exactly"},
    {"edit", "copy", "d", "duplicate"},
    {"edit", "delete", "delete", "delete"},
    {"edit", "delete", "backspace", ""},
    {"edit", "reverse", "v", "exchange front and back"},
    {"edit", "edge", "e", "draw an edge: click two points"},
    {"edit", "polyline", "p", "draw a polyline: enter ends it"},
    {"edit", "lamp", "l", "a lamp at the mouse"},
    {"edit", "light", "b", "a point light at the mouse"},
    {"edit", "play", "tab", "lights move, or stand again"},
    {"edit", "groups", "g", "select the whole group"},
    {"edit", "all", "ctrl+a", "select everything"},
    {"edit", "escape", "escape", "drop it; select nothing"},
    {"material under the mouse", "less reflectivity", "[", "less reflectivity"},
    {"material under the mouse", "less reflectivity", "f5", ""},
    {"material under the mouse", "more reflectivity", "]", "more"},
    {"material under the mouse", "more reflectivity", "f6", ""},
    {"material under the mouse", "less emission", ";", "less emission"},
    {"material under the mouse", "less emission", "f7", ""},
    {"material under the mouse", "more emission", "'", "more"},
    {"material under the mouse", "more emission", "f8", ""},
    {"material under the mouse", "colour", "k", "next colour"},
    {"material under the mouse", "material", "i", "type its values"},
    {"material under the mouse", "spin", "y", "of a light: set it spinning, or stop it"},
    {"material under the mouse", "own less reflectivity", "shift+[", "for this group alone"},
    {"material under the mouse", "own less reflectivity", "shift+f5", ""},
    {"material under the mouse", "own more reflectivity", "shift+]", ""},
    {"material under the mouse", "own more reflectivity", "shift+f6", ""},
    {"material under the mouse", "own less emission", "shift+;", ""},
    {"material under the mouse", "own less emission", "shift+f7", ""},
    {"material under the mouse", "own more emission", "shift+'", ""},
    {"material under the mouse", "own more emission", "shift+f8", ""},
    {"material under the mouse", "own colour", "shift+k", ""},
    {"material under the mouse", "own material", "shift+i", ""},
    {"file", "save", "ctrl+s", "save the scene"},
    {"file", "save as", "ctrl+shift+s", "under another name"},
    {"file", "picture", "ctrl+p", "save what is seen, png or svg"},
    {"file", "copy number", "ctrl+c", "copy the number shown"},
    {"file", "reload", "ctrl+o", "read the file again"},
    {"file", "quit", "ctrl+q", "quit"},
};

constexpr Gesture kGestures[] = {
    {"drag a vertex", "all that meets there moves"},
    {"drag an edge", "its neighbours stretch"},
    {"drag a light", "or the axis, or a border of its beam"},
    {"drag the selection", "whole groups move by themselves"},
    {"alt + drag", "one end, or one edge, alone"},
    {"click", "select; shift adds, ctrl takes the group"},
    {"shift + drag beside", "select in a rectangle"},
    {"drag beside, right drag", "move the view; the wheel zooms"},
};

}  // namespace

std::span<const Command> commands() { return kCommands; }

std::span<const Gesture> gestures() { return kGestures; }

std::string key_text(const WindowEvent& event) {
  return std::string(event.held.ctrl ? "ctrl+" : "") + (event.held.alt ? "alt+" : "") +
         (event.held.shift ? "shift+" : "") + event.key;
}

std::string_view command_of_key(std::string_view key, std::span<const Command> of) {
  const auto found = std::ranges::find(of, key, &Command::key);
  return found == of.end() || key.empty() ? std::string_view() : found->name;
}

WindowEvent key_event(std::string_view text) {
  WindowEvent event{.kind = WindowEvent::Kind::kKey};
  const std::array<std::pair<std::string_view, bool*>, 3> held{
      {{"ctrl+", &event.held.ctrl}, {"alt+", &event.held.alt}, {"shift+", &event.held.shift}}};
  for (bool found = true; found;) {
    found = false;
    for (const auto& [prefix, flag] : held)
      if (text.size() > prefix.size() && text.starts_with(prefix)) {
        *flag = found = true;
        text.remove_prefix(prefix.size());
      }
  }
  event.key = std::string(text);
  return event;
}

}  // namespace hottel
