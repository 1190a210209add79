// NumPy's file format, version 1.0: arrays of float64 in C order, little-endian.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>

namespace hottel {

// Returns what stands before the numbers of an array of that shape: magic, version, a header padded to whole 64 bytes.
// The numbers follow as they lie in memory, the last index running fastest.
std::string npy_header(std::span<const std::size_t> shape);

// Writes a whole array through a sink; whatever the sink throws stops the writing.
// REQUIRES as many values as the shape has places.
void write_npy(std::span<const std::size_t> shape, std::span<const double> values,
               const std::function<void(std::string_view)>& sink);

}  // namespace hottel
