// OpenEXR: pictures of linear light, as 32-bit floats.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace hottel {

// Numbers by pixel, and what is said of them.
struct ExrPicture {
  std::size_t width = 0, height = 0;
  std::vector<std::string> channels;  // as solutions name them
  std::span<const double> values;     // row by row, the channels of a pixel beside each other
  bool begins_below = false;          // the first row is the lowest
  std::vector<std::pair<std::string, std::string>> attributes{};  // texts of the header, by name
};

// Whether a file name ends in .exr.
inline bool is_exr(std::string_view file_name) { return file_name.size() > 4 && file_name.ends_with(".exr"); }

// Throws UsageError where the program was built without OpenEXR; what: the option that asks for it.
void require_exr(std::string_view what);

// Returns the bytes of a file: scanlines from the top to the bottom, each channel a 32-bit float, losslessly compressed
// (ZIP).
//
//   (1) one channel is called Y; r, g and b are R, G and B; others have their own names
//   (2) a number is the nearest float, below 2^-150 it is 0; NaN stays NaN
//   (3) the same picture has the same bytes, whatever the number of threads
// Throws RequestError for a number beyond the range of floats. REQUIRES as many values as pixels have channels, a
// picture of some pixels, names of attributes that no standard one has.
std::string exr_file(const ExrPicture& picture);

}  // namespace hottel
