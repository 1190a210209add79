#include "geometry/name.h"
#include "io/files/text_file.h"
#include "io/scene/exact_json.h"
#include "io/scene/json_fields.h"
#include "io/scene/plane/scene_reader.h"
#include "io/scene/scene_json.h"

namespace hottel {
namespace {

// Returns the dimension. Refuses other versions and dimensions.
void require_versions(const JsonValue& root) {
  const auto require = [&](std::string_view key, std::initializer_list<const char*> allowed) {
    for (const auto [k, value] : root.members()) {
      if (k.text() != key) continue;
      require_kind(value, JsonKind::kNumber, {key});
      const Rational number = read_number(value, {key});
      for (const char* a : allowed)
        if (number == Rational(a)) return number;
      refuse(value, std::string(key) + " is " + quoted_name(value.text()) + "; this version reads " + *allowed.begin());
    }
    refuse(root, "the scene has no \"" + std::string(key) + "\"",
           {"a scene begins { \"hottel\": 1, \"dimension\": 2,"});
  };
  require("hottel", {"1"});
  if (require("dimension", {"2", "3"}) == 3)
    for (const auto [key, value] : root.members())
      if (key.text() == "dimension") refuse(value, "dimension 3 is not supported by this version");
}

}  // namespace

Scene parse_scene(std::string_view text, const std::string& name_for_messages) {
  const JsonDocument document(text, name_for_messages);
  require_kind(document.root(), JsonKind::kObject, {"the scene"});
  require_versions(document.root());
  return read_document_2(document.root(), name_for_messages);
}

Scene read_scene(const std::filesystem::path& file) { return parse_scene(read_text_file(file), file.string()); }

Scene2 read_scene_2(const std::filesystem::path& file) { return std::get<Scene2>(read_scene(file)); }

Scene2 parse_scene_2(std::string_view text, const std::string& name_for_messages) {
  return std::get<Scene2>(parse_scene(text, name_for_messages));
}

}  // namespace hottel
