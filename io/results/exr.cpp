#include "io/results/exr.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfOutputFile.h>
#include <ImfStringAttribute.h>

#include <cmath>
#include <cstdint>
#include <limits>

#include "io/results/short_digits.h"
#include "kernel/rational.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

// A file in memory.
class ExrBytes : public OPENEXR_IMF_NAMESPACE::OStream {
 public:
  ExrBytes() : OStream("") {}
  void write(const char bytes[], int count) override {
    const auto size = static_cast<std::size_t>(count);
    if (text.size() < place_ + size) text.resize(place_ + size);
    text.replace(place_, size, bytes, size);
    place_ += size;
  }
  std::uint64_t tellp() override { return place_; }
  void seekp(std::uint64_t place) override { place_ = place; }

  std::string text;

 private:
  std::size_t place_ = 0;
};

std::string exr_name(const ExrPicture& picture, std::size_t channel) {
  if (picture.channels.size() == 1) return "Y";
  const std::string& name = picture.channels[channel];
  return name == "r" ? "R" : name == "g" ? "G" : name == "b" ? "B" : name;
}

float as_float(double value) {
  if (std::isfinite(value) && std::abs(value) > std::numeric_limits<float>::max())
    throw RequestError("an .exr file has 32-bit floats, and " + shortest(value) + " is beyond their range");
  return static_cast<float>(value);
}

// The numbers of one channel, the topmost row first.
std::vector<float> plane_of(const ExrPicture& picture, std::size_t channel) {
  std::vector<float> result;
  result.reserve(picture.width * picture.height);
  for (std::size_t y = 0; y < picture.height; ++y) {
    const std::size_t row = picture.begins_below ? picture.height - 1 - y : y;
    for (std::size_t x = 0; x < picture.width; ++x)
      result.push_back(as_float(picture.values[(row * picture.width + x) * picture.channels.size() + channel]));
  }
  return result;
}

OPENEXR_IMF_NAMESPACE::Header exr_header(const ExrPicture& picture) {
  OPENEXR_IMF_NAMESPACE::Header header(static_cast<int>(picture.width), static_cast<int>(picture.height));
  for (const auto& [name, text] : picture.attributes) header.insert(name, OPENEXR_IMF_NAMESPACE::StringAttribute(text));
  for (std::size_t channel = 0; channel < picture.channels.size(); ++channel)
    header.channels().insert(exr_name(picture, channel), OPENEXR_IMF_NAMESPACE::Channel(OPENEXR_IMF_NAMESPACE::FLOAT));
  return header;
}

}  // namespace

void require_exr(std::string_view) {}

std::string exr_file(const ExrPicture& picture) {
  HOTTEL_REQUIRE(picture.width > 0 && picture.height > 0 && !picture.channels.empty());
  HOTTEL_REQUIRE(picture.values.size() == picture.width * picture.height * picture.channels.size());
  std::vector<std::vector<float>> planes;
  OPENEXR_IMF_NAMESPACE::FrameBuffer frame;
  for (std::size_t channel = 0; channel < picture.channels.size(); ++channel) {
    planes.push_back(plane_of(picture, channel));
    frame.insert(
        exr_name(picture, channel),
        OPENEXR_IMF_NAMESPACE::Slice(OPENEXR_IMF_NAMESPACE::FLOAT, reinterpret_cast<char*>(planes.back().data()),
                                     sizeof(float), sizeof(float) * picture.width));
  }
  ExrBytes bytes;
  {
    OPENEXR_IMF_NAMESPACE::OutputFile file(bytes, exr_header(picture), 0);  // whose end writes where lines begin
    file.setFrameBuffer(frame);
    file.writePixels(static_cast<int>(picture.height));
  }
  return std::move(bytes.text);
}

}  // namespace hottel
