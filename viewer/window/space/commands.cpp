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
    {"file", "save", "ctrl+s", "save the scene"},
    {"file", "save as", "ctrl+shift+s", "under another name"},
    {"file", "picture", "ctrl+p", "save what is seen, png or svg"},
    {"file", "copy number", "ctrl+c", "copy the number shown"},
    {"file", "reload", "ctrl+o", "read the file again"},
    {"file", "quit", "ctrl+q", "quit"},
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
    {"change", "undo", "ctrl+z", "undo"},
    {"change", "redo", "ctrl+y", "do again"},
    {"change", "redo", "ctrl+shift+z", ""},
    {"change", "coordinates", "enter", "type where the light goes"},
    {"change", "turn", "r", "turn it by 15 degrees"},
    {"change", "turn back", "shift+r", "and back"},
    {"change", "turn square", "ctrl+r", "by 90, exactly"},
    {"change", "copy", "ctrl+d", "duplicate it"},
    {"change", "delete", "delete", "delete it"},
    {"change", "delete", "backspace", ""},
    {"change", "light", "b", "a point light at the mouse"},
    {"change", "play", "tab", "lights move, or stand again"},
    {"change", "escape", "escape", "drop it; pick nothing"},
    {"material or light under the mouse", "less reflectivity", "[", "less reflectivity; of a light: focus"},
    {"material or light under the mouse", "more reflectivity", "]", "more"},
    {"material or light under the mouse", "less emission", ";", "less emission; of a light: power"},
    {"material or light under the mouse", "more emission", "'", "more"},
    {"material or light under the mouse", "colour", "k", "next colour"},
    {"material or light under the mouse", "material", "i", "type its values"},
    {"material or light under the mouse", "spin", "y", "of a light: set it spinning, or stop it"},
};

constexpr Gesture kGestures[] = {
    {"drag", "go around what is seen"},
    {"ctrl + drag", "look around"},
    {"shift + drag, right drag", "move across what is seen"},
    {"wheel", "nearer, farther"},
    {"click", "pick a polygon, or a light"},
    {"drag a light", "or the axis, or a border of its beam"},
    {"shift + drag a light", "along x, y or z"},
    {"ctrl + drag an axis", "aim at what lies under the mouse"},
};

}  // namespace

std::span<const Command> commands_3() { return kCommands; }

std::span<const Gesture> gestures_3() { return kGestures; }

}  // namespace hottel
