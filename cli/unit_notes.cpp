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

std::optional<std::string> unknown_unit_note(const Scene2& scene) { return unknown_unit_note_2(scene); }
std::optional<std::string> unknown_unit_note(const Scene3& scene) { return unknown_unit_note_3(scene); }

void note(const std::optional<std::string>& text, const Streams& streams) {
  if (text) streams.note("note: " + *text);
}

void require_light_in_watts(const SceneTable& table) {
  with_file_context(table.file, [&] { require_told_lamps(table); });
}

}  // namespace

void note_unknown_unit(const ValidScene& scene, const Streams& streams) {
  note(std::visit([](const auto& each) { return unknown_unit_note(*each); }, scene), streams);
}

std::vector<std::string> with_unit_note(const Scene2& scene, std::vector<std::string> notes) {
  return joined(unknown_unit_note_2(scene), std::move(notes));
}

std::vector<std::string> with_unit_note(const Scene3& scene, std::vector<std::string> notes) {
  return joined(unknown_unit_note_3(scene), std::move(notes));
}

void require_light_in_watts(const ValidScene& scene) {
  std::visit([](const auto& each) { require_light_in_watts(static_cast<const SceneTable&>(*each)); }, scene);
}

}  // namespace hottel
