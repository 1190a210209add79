// Arrays in files of a folder.
#include "kernel/support/folder_memory.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <numeric>

#include "kernel/support/failure.h"
#include "tests/temporary_folder.h"

namespace hottel::folder_memory_test {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

bool is_empty(const TemporaryFolder& folder) { return std::filesystem::is_empty(folder.path()); }

// Property (2).
TEST(FolderMemory, HasZerosInFilesThatNobodySees) {
  const TemporaryFolder folder;
  const FolderMemory memory(folder.path());
  constexpr std::size_t kBytes = 100'000;
  auto* bytes = static_cast<char*>(memory.take(kBytes));
  EXPECT_TRUE(std::all_of(bytes, bytes + kBytes, [](char byte) { return byte == 0; }));
  std::fill(bytes, bytes + kBytes, 'x');
  EXPECT_TRUE(is_empty(folder));
  FolderMemory::give_back(bytes, kBytes);
  EXPECT_TRUE(is_empty(folder));
}

// Property (1).
TEST(FolderMemory, IsRefusedWhereThereIsNoRoom) {
  const TemporaryFolder folder;
  const FolderMemory memory(folder.path());
  const auto takes_too_much = [&] { memory.take(std::size_t{1} << 60); };
  EXPECT_THAT(takes_too_much, ThrowsMessage<RequestError>(HasSubstr("no room for 1152921504606846976 bytes")));
  const auto is_nowhere = [&] { const FolderMemory nowhere(folder / "not there"); };
  EXPECT_THAT(is_nowhere, ThrowsMessage<RequestError>(HasSubstr("no file can be made there")));
}

TEST(PlacedArray, GrowsMovesAndIsCopiedWhereItStands) {
  const TemporaryFolder folder;
  const auto memory = std::make_shared<const FolderMemory>(folder.path());
  PlacedArray<int> numbers{PlacingAllocator<int>(memory)};
  for (int k = 0; k < 10'000; ++k) numbers.push_back(k);
  const int* where = numbers.data();
  PlacedArray<int> moved;
  moved = std::move(numbers);
  EXPECT_EQ(moved.data(), where) << "not copied";
  EXPECT_EQ(moved.get_allocator().memory(), memory);
  const PlacedArray<int> copy = moved;
  EXPECT_EQ(copy.get_allocator().memory(), memory);
  EXPECT_EQ(std::accumulate(copy.begin(), copy.end(), 0), 10'000 * 9'999 / 2);
  moved = PlacedArray<int>();
  EXPECT_EQ(moved.get_allocator().memory(), nullptr);
}

TEST(PlacedArray, IsOnTheHeapWhereNothingIsSaid) {
  PlacedArray<double> numbers(5);
  EXPECT_EQ(numbers.get_allocator().memory(), nullptr);
  EXPECT_EQ(std::accumulate(numbers.begin(), numbers.end(), 0.0), 0);
}

}  // namespace
}  // namespace hottel::folder_memory_test
