// How messages tell of memory.
#include "geometry/memory_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "kernel/support/failure.h"

namespace hottel::memory_text_test {
namespace {

using testing::EndsWith;

TEST(ShortBytes, HaveTwoDigits) {
  EXPECT_EQ(short_bytes(0), "0 bytes");
  EXPECT_EQ(short_bytes(1), "1 byte");
  EXPECT_EQ(short_bytes(999), "999 bytes");
  EXPECT_EQ(short_bytes(1234), "1.2 kB");
  EXPECT_EQ(short_bytes(99.6e6), "100 MB");
  EXPECT_EQ(short_bytes(4.5e9), "4.5 GB");
  EXPECT_EQ(short_bytes(2e30), "2.0e+12 EB");
}

TEST(MemoryRefusal, AdvisesWhatHelps) {
  const auto refusal = [](const SceneTable& scene, std::uint64_t limit = 10) -> std::string {
    try {
      refuse_memory(scene, 14, "visible pairs", 200, limit);
    } catch (const RequestError& error) {
      return error.what();
    }
  };
  const std::string told = "about 14 visible pairs need about 2.8 kB of memory; the limit is 10 bytes. ";
  SceneTable scene;
  scene.surfaces.resize(2);
  EXPECT_EQ(refusal(scene), told + "Allow more (--memory)");
  scene.surfaces[1].elements = 2;
  EXPECT_THAT(refusal(scene, std::uint64_t{1} << 60), EndsWith("Allow more memory, or take fewer elements"));
  EXPECT_EQ(refusal(scene), told + "Allow more (--memory), or take fewer elements");
}

}  // namespace
}  // namespace hottel::memory_text_test
