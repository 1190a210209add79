#include "cli/deck_output.h"

#include "io/scene/space/vs3_reader.h"
#include "io/scene/space/vs3_writer.h"
#include "kernel/support/failure.h"
#include "kernel/support/with_file_context.h"

namespace hottel {

void write_deck(const std::string& in, const PolygonOptions& polygons, const std::string& out, const std::string& per,
                const Streams& streams) {
  const Scene scene = changeable(read_scene_noting(in, polygons, streams));
  const Scene3* const in_space = std::get_if<Scene3>(&scene);
  if (in_space == nullptr)
    throw InputError({in, 0}, "the scene is in the plane (dimension 2); a deck (.vs3) is in space");
  const bool combines_groups = per.empty() ? is_vs3(in) : per == "group";
  const WrittenVs3Deck3 deck = with_file_context(in, [&] { return write_vs3_3(*in_space, combines_groups); });
  streams.write(out, deck.text);
  for (const std::string& note : deck.notes) streams.note(one_line(note));
}

}  // namespace hottel
