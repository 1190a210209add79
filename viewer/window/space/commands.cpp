#include "viewer/window/space/commands.h"

namespace hottel {
namespace {

constexpr Command kCommands[] = {
    {"look", "look light", "1", "light"},
    {"look", "look radiosity", "2", "radiosity, on a scale"},
    {"look", "look irradiance", "3", "irradiance, on a scale"},
    {"look", "look factors", "5", "view factors from a clicked polygon"},
    {"look", "look errors", "7", "a method against the exact one"},
    {"look", "look plan", "9", "what is simulated, and why"},
    {"look", "look sweeps", "0", "a solver, sweep by sweep"},
    {"look", "next", "m", "next method or solver"},
    {"look", "previous", "shift+m", "the one before"},
    {"look", "again", "space", "begin the sweeps again"},
    {"look", "shading", "o", "blend over flat surfaces, or not"},
    {"look", "tone", "t", "next tone curve"},
    {"look", "darker", "-", "less exposure"},
    {"look", "brighter", "=", "more exposure"},
    {"look", "brighter", "shift+=", ""},
    {"look", "brighter", "+", ""},
    {"look", "fit", "f", "back to the camera of the scene"},
    {"look", "help", "h", "this help"},
    {"walk", "forward", "w", "forward, on the ground"},
    {"walk", "back", "s", "back"},
    {"walk", "left", "a", "to the left"},
    {"walk", "right", "d", "to the right"},
    {"walk", "rise", "pageup", "up"},
    {"walk", "sink", "pagedown", "down"},
    {"walk", "look left", "left", "look around, as all arrows"},
    {"walk", "look right", "right", ""},
    {"walk", "look up", "up", ""},
    {"walk", "look down", "down", ""},
    {"walk", "orbit left", "shift+left", "shift: go around what is seen"},
    {"walk", "orbit right", "shift+right", ""},
    {"walk", "orbit up", "shift+up", ""},
    {"walk", "orbit down", "shift+down", ""},
    {"walk", "nearer", "e", "nearer to what is seen"},
    {"walk", "farther", "q", "farther"},
    {"material under the mouse", "less reflectivity", "[", "less reflectivity"},
    {"material under the mouse", "more reflectivity", "]", "more"},
    {"material under the mouse", "less emission", ";", "less emission"},
    {"material under the mouse", "more emission", "'", "more"},
    {"material under the mouse", "colour", "k", "next colour"},
    {"material under the mouse", "material", "i", "type its values"},
    {"material under the mouse", "undo", "ctrl+z", "undo"},
    {"material under the mouse", "redo", "ctrl+y", "do again"},
    {"material under the mouse", "redo", "ctrl+shift+z", ""},
    {"material under the mouse", "escape", "escape", "pick nothing"},
    {"file", "save", "ctrl+s", "save the scene"},
    {"file", "save as", "ctrl+shift+s", "under another name"},
    {"file", "picture", "ctrl+p", "save what is seen, png or svg"},
    {"file", "copy number", "ctrl+c", "copy the number shown"},
    {"file", "reload", "ctrl+o", "read the file again"},
    {"file", "quit", "ctrl+q", "quit"},
};

constexpr Gesture kGestures[] = {
    {"drag", "go around what is seen"},
    {"ctrl + drag", "look around"},
    {"shift + drag, right drag", "move across what is seen"},
    {"wheel", "nearer, farther"},
    {"click", "pick a polygon"},
};

}  // namespace

std::span<const Command> commands_3() { return kCommands; }

std::span<const Gesture> gestures_3() { return kGestures; }

}  // namespace hottel
