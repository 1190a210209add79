// Any bytes as a deck of View3D: refused with InputError, or a valid scene that is written as a deck and read again.
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "io/scene/space/vs3_reader.h"
#include "io/scene/space/vs3_writer.h"
#include "kernel/support/failure.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  hottel::Vs3Scene3 deck;
  try {
    deck = hottel::parse_vs3_3({reinterpret_cast<const char*>(data), size}, "fuzz.vs3");
  } catch (const hottel::InputError&) {
    return 0;
  }
  hottel::WrittenVs3Deck3 written;
  try {
    written = hottel::write_vs3_3(deck.scene, true);
  } catch (const hottel::RequestError&) {
    return 0;  // a coordinate beyond the range of doubles
  } catch (const hottel::InputError&) {
    return 0;  // claims for different materials
  }
  // Where nothing is rounded or cut, the polygons are those that were read.
  try {
    const hottel::Vs3Scene3 again = hottel::parse_vs3_3(written.text, "written.vs3");
    if (again.scene->surfaces.size() < deck.scene->surfaces.size()) std::abort();
  } catch (const hottel::InputError&) {
    bool is_rounded = false;
    for (const std::string& note : written.notes) is_rounded |= note.find("rounded") != std::string::npos;
    if (!is_rounded) std::abort();
  }
  return 0;
}
