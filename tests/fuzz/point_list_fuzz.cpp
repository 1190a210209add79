// Any bytes as a list of points: refused with InputError, or read; what is read is read again from what it is written
// as.
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include "io/external/plane/point_list.h"
#include "kernel/support/failure.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const std::vector<hottel::Point2> points =
        hottel::read_points_2({reinterpret_cast<const char*>(data), size}, "fuzz.points");
    if (points.empty()) std::abort();
    std::string written;
    for (const hottel::Point2& point : points)
      written += hottel::to_string(point.x) + "," + hottel::to_string(point.y) + "\n";
    // A number that is an exponent may be short, and too long where it is written out.
    if (written.size() < 4096 && !(hottel::read_points_2(written, "written.points") == points)) std::abort();
  } catch (const hottel::InputError& error) {
    if (!std::string_view(error.what()).starts_with("fuzz.points")) std::abort();
  }
  return 0;
}
