// Any bytes as a drawing: refused with InputError, or a valid scene.
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "io/scene/plane/svg_reader.h"
#include "kernel/support/failure.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const hottel::Scene2 scene =
        hottel::parse_svg_2(std::string_view(reinterpret_cast<const char*>(data), size), "fuzz.svg");
    hottel::validate(scene);
  } catch (const hottel::InputError& error) {
    if (!std::string_view(error.what()).starts_with("fuzz.svg")) std::abort();
  }
  return 0;
}
