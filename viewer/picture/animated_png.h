// Pictures one after the other as one file.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

namespace hottel {

// An animated PNG, put together from the files of its frames. Programs that know PNG only show the first one.
//
//   (1) pixels and colours are those of the frames, which are taken over as they are packed
//   (2) it is played over and over
// SEE: PNG specification, third edition, 2025: acTL, fcTL, fdAT.
class AnimatedPng {
 public:
  // What is put together is given to `sink` as it comes. seconds for each frame: numerator / denominator.
  // REQUIRES frames > 0, and a quotient above 0.
  AnimatedPng(std::uint32_t frames, std::uint16_t numerator, std::uint16_t denominator,
              std::function<void(std::string_view)> sink);

  // Adds the next frame: the bytes of a PNG file. Returns what is wrong with it, as the end of a sentence; empty when
  // nothing is: it is whole, and in size and kind of pixels like the first one.
  std::string add(std::string_view png);
  // Throws ContractViolation unless all frames were added.
  void finish();

 private:
  void chunk(std::string_view type, std::string_view bytes);

  std::uint32_t frames_, added_ = 0, sequence_ = 0;
  std::uint16_t numerator_, denominator_;
  std::function<void(std::string_view)> sink_;
  std::string header_;  // IHDR of the first frame
};

}  // namespace hottel
