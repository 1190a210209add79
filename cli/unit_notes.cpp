#include "cli/unit_notes.h"

#include <utility>
#include <variant>

#include "geometry/unit_of_length.h"
#include "kernel/support/with_file_context.h"

namespace hottel {
namespace {

std::vector<std::string> joined(std::optional<std::string> first, std::vector<std::string> notes) {
  if (first) notes.insert(notes.begin(), *std::move(first));
  return notes;
}

}  // namespace

void note_unknown_unit(const Scene& scene, const Streams& streams) {
  const auto* const plane = std::get_if<Scene2>(&scene);
  const auto note = plane != nullptr ? unknown_unit_note_2(*plane) : unknown_unit_note_3(std::get<Scene3>(scene));
  if (note) streams.note("note: " + *note);
}

std::vector<std::string> with_unit_note(const Scene2& scene, std::vector<std::string> notes) {
  return joined(unknown_unit_note_2(scene), std::move(notes));
}

std::vector<std::string> with_unit_note(const Scene3& scene, std::vector<std::string> notes) {
  return joined(unknown_unit_note_3(scene), std::move(notes));
}

void require_light_in_watts(const Scene& scene) {
  std::visit([](const SceneTable& table) { with_file_context(table.file, [&] { require_told_lamps(table); }); }, scene);
}

}  // namespace hottel
