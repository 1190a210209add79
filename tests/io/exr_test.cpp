// Pictures of linear light as OpenEXR files, read back by OpenEXR.
#include "io/results/exr.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "kernel/support/failure.h"

#ifdef HOTTEL_EXR
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputFile.h>
#include <ImfStringAttribute.h>

#include <cstring>
#endif

namespace hottel::exr_test {
namespace {

TEST(Exr, IsToldByTheEnding) {
  EXPECT_TRUE(is_exr("a.b/light.exr"));
  EXPECT_FALSE(is_exr("light.exr.png") || is_exr("exr") || is_exr("") || is_exr("light.EXRS"));
}

#ifdef HOTTEL_EXR

class ReadBytes : public OPENEXR_IMF_NAMESPACE::IStream {
 public:
  explicit ReadBytes(const std::string& text) : IStream("bytes"), text_(text) {}
  bool read(char to[], int count) override {
    if (place_ + static_cast<std::size_t>(count) > text_.size()) throw std::runtime_error("the file ends too early");
    std::memcpy(to, text_.data() + place_, static_cast<std::size_t>(count));
    place_ += static_cast<std::size_t>(count);
    return place_ < text_.size();
  }
  std::uint64_t tellg() override { return place_; }
  void seekg(std::uint64_t place) override { place_ = place; }

 private:
  const std::string& text_;
  std::size_t place_ = 0;
};

// A channel, the topmost row first.
std::vector<float> channel_of(OPENEXR_IMF_NAMESPACE::InputFile& file, const std::string& name, int width, int height) {
  std::vector<float> result(static_cast<std::size_t>(width * height), -1);
  OPENEXR_IMF_NAMESPACE::FrameBuffer frame;
  frame.insert(name, OPENEXR_IMF_NAMESPACE::Slice(OPENEXR_IMF_NAMESPACE::FLOAT, reinterpret_cast<char*>(result.data()),
                                                  sizeof(float), sizeof(float) * static_cast<std::size_t>(width)));
  file.setFrameBuffer(frame);
  file.readPixels(0, height - 1);
  return result;
}

TEST(Exr, OpenExrReadsTheFloatsAndTheTexts) {
  const std::vector<double> values{1, 2, 3, 0.1, 1e-20, 7, 4, 5, 6, 1e30, 0, 1e-60};  // two rows of two pixels
  const std::string bytes = exr_file({.width = 2,
                                      .height = 2,
                                      .channels = {"r", "g", "b"},
                                      .values = values,
                                      .begins_below = true,
                                      .attributes = {{"unit", "W/m²"}, {"hottel", "{}"}}});
  ReadBytes stream(bytes);
  OPENEXR_IMF_NAMESPACE::InputFile file(stream);
  EXPECT_EQ(channel_of(file, "R", 2, 2), (std::vector<float>{4, 1e30f, 1, 0.1f}));
  EXPECT_EQ(channel_of(file, "G", 2, 2), (std::vector<float>{5, 0, 2, 1e-20f}));
  EXPECT_EQ(channel_of(file, "B", 2, 2), (std::vector<float>{6, 0, 3, 7}));
  EXPECT_EQ(file.header().typedAttribute<OPENEXR_IMF_NAMESPACE::StringAttribute>("unit").value(), "W/m²");
  EXPECT_EQ(file.header().channels()["R"].type, OPENEXR_IMF_NAMESPACE::FLOAT);
}

TEST(Exr, OneChannelIsYAndOthersKeepTheirNames) {
  const std::vector<double> values{1, std::numeric_limits<double>::quiet_NaN()};
  const std::string grey = exr_file({.width = 2, .height = 1, .channels = {"all"}, .values = values});
  ReadBytes stream(grey);
  OPENEXR_IMF_NAMESPACE::InputFile file(stream);
  const std::vector<float> read = channel_of(file, "Y", 2, 1);
  EXPECT_EQ(read[0], 1);
  EXPECT_TRUE(std::isnan(read[1])) << "a cell in a solid";
  const std::string bands = exr_file({.width = 1, .height = 1, .channels = {"solar", "thermal"}, .values = values});
  ReadBytes of_bands(bands);
  OPENEXR_IMF_NAMESPACE::InputFile two(of_bands);
  EXPECT_EQ(channel_of(two, "solar", 1, 1), std::vector<float>{1});
}

TEST(Exr, TheSamePictureHasTheSameBytes) {
  std::vector<double> values(300 * 200);
  for (std::size_t k = 0; k < values.size(); ++k) values[k] = std::sin(static_cast<double>(k));
  const ExrPicture picture{.width = 300, .height = 200, .channels = {"all"}, .values = values};
  EXPECT_EQ(exr_file(picture), exr_file(picture));
}

TEST(Exr, NumbersBeyondFloatsAreRefused) {
  const std::vector<double> values{1e39};
  EXPECT_THROW(exr_file({.width = 1, .height = 1, .channels = {"all"}, .values = values}), RequestError);
}

#else

TEST(Exr, WithoutOpenExrIsRefused) { EXPECT_THROW(require_exr("--exr"), UsageError); }

#endif

}  // namespace
}  // namespace hottel::exr_test
