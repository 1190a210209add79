// Arrays that are larger than memory: they stand in files of a folder, and the system keeps in memory what is used.
//
//   const auto memory = std::make_shared<FolderMemory>("/scratch");
//   PlacedArray<double> numbers{PlacedArray<double>::allocator_type(memory)};  // a std::vector in a file
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

namespace hottel {

// Pieces of memory, each in a file that has no name.
//
//   (1) the disk has room for what was taken: take() is refused where it has not, and writing never fails later
//   (2) nothing is left in the folder when the process ends, however it ends
// Threads may share one.
class FolderMemory {
 public:
  // Throws RequestError where the folder takes no files.
  explicit FolderMemory(std::filesystem::path folder);

  // Returns memory whose bytes are 0. Throws RequestError where the disk has no room for it. REQUIRES: bytes > 0.
  void* take(std::size_t bytes) const;
  // REQUIRES: what take() returned for so many bytes.
  static void give_back(void* begin, std::size_t bytes) noexcept;

 private:
  std::filesystem::path folder_;
};

// Takes memory from a folder, or from the heap where there is none.
template <class T>
class PlacingAllocator {
 public:
  using value_type = T;
  using propagate_on_container_copy_assignment = std::true_type;
  using propagate_on_container_move_assignment = std::true_type;
  using propagate_on_container_swap = std::true_type;

  PlacingAllocator() = default;
  explicit PlacingAllocator(std::shared_ptr<const FolderMemory> memory) : memory_(std::move(memory)) {}
  template <class Other>
  PlacingAllocator(const PlacingAllocator<Other>& other) : memory_(other.memory()) {}

  T* allocate(std::size_t count) {
    if (count > static_cast<std::size_t>(-1) / sizeof(T)) throw std::bad_array_new_length();
    return static_cast<T*>(memory_ ? memory_->take(count * sizeof(T)) : ::operator new(count * sizeof(T)));
  }
  void deallocate(T* begin, std::size_t count) noexcept {
    if (memory_)
      FolderMemory::give_back(begin, count * sizeof(T));
    else
      ::operator delete(begin);
  }
  // Null where it is the heap.
  const std::shared_ptr<const FolderMemory>& memory() const { return memory_; }

  friend bool operator==(const PlacingAllocator& a, const PlacingAllocator& b) { return a.memory_ == b.memory_; }

 private:
  std::shared_ptr<const FolderMemory> memory_;
};

// An array that may be larger than memory.
template <class T>
using PlacedArray = std::vector<T, PlacingAllocator<T>>;

}  // namespace hottel
