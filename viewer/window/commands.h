// What one can tell a window to do: the names, the keys, and what help says of them.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "viewer/window/window.h"

namespace hottel {

// One thing to be told.
//
//   (1) keys are unique; a name stands once with a help, and once more for each other key that it has
struct Command {
  std::string_view topic;  // of the help
  std::string_view name;   // as scripts have it: "undo", "look light"
  std::string_view key;    // as key_text() gives it; "" where there is none
  std::string_view help;   // a few words; "" where the line above says it too
};

// All commands of a scene in the plane and their keys, in the order of the help.
std::span<const Command> commands();

// What the mouse does, for the help: the gesture and a few words.
struct Gesture {
  std::string_view gesture, help;
};
std::span<const Gesture> gestures();

// Returns how a key is written with what is held: "ctrl+shift+z". REQUIRES: a kKey event.
std::string key_text(const WindowEvent& event);

// Returns the name of the command of a key, or nothing (""); of those commands.
std::string_view command_of_key(std::string_view key, std::span<const Command> of = commands());

// Reads "ctrl+shift+z" into a kKey event.
WindowEvent key_event(std::string_view text);

}  // namespace hottel
