#include "io/results/npy.h"

#include <gtest/gtest.h>

#include <cstring>
#include <vector>

#include "kernel/support/failure.h"

namespace hottel::npy_test {
namespace {

TEST(Npy, HeadersAreWhatNumPyWrites) {
  const std::size_t shape[] = {2, 3, 1};
  const std::string header = npy_header(shape);
  ASSERT_EQ(header.size(), 128u);
  EXPECT_EQ(header.substr(0, 10), std::string("\x93NUMPY\x01\x00\x76\x00", 10));
  EXPECT_EQ(header.substr(10, 65), "{'descr': '<f8', 'fortran_order': False, 'shape': (2, 3, 1), }   ");
  EXPECT_EQ(header.back(), '\n');
}

TEST(Npy, HeadersFillWhole64Bytes) {
  for (std::size_t side = 1; side < 1'000'000'000'000; side *= 10)
    for (const std::vector<std::size_t>& shape : {std::vector{side}, {side, side}, {side, side, side}}) {
      const std::string header = npy_header(shape);
      EXPECT_EQ(header.size() % 64, 0u);
      EXPECT_EQ(static_cast<unsigned char>(header[8]) + 256u * static_cast<unsigned char>(header[9]) + 10,
                header.size());
    }
}

TEST(Npy, ShapesAreTuplesOfPython) {
  const std::size_t one[] = {7}, two[] = {7, 8};
  EXPECT_NE(npy_header(one).find("'shape': (7,), }"), std::string::npos);
  EXPECT_NE(npy_header(two).find("'shape': (7, 8), }"), std::string::npos);
  EXPECT_NE(npy_header({}).find("'shape': (), }"), std::string::npos);
}

TEST(Npy, NumbersFollowInCOrder) {
  const std::size_t shape[] = {2, 2};
  const std::vector<double> values{1, -2.5, 0.1, 4};
  std::string file;
  write_npy(shape, values, [&](std::string_view text) { file += text; });
  ASSERT_EQ(file.size(), 128 + 32u);
  std::vector<double> back(4);
  std::memcpy(back.data(), file.data() + 128, 32);
  EXPECT_EQ(back, values);
  EXPECT_THROW(write_npy(shape, std::vector<double>(3), [](std::string_view) {}), ContractViolation);
}

}  // namespace
}  // namespace hottel::npy_test
