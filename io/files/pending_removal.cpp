#include "io/files/pending_removal.h"

#include <dirent.h>
#include <fcntl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <climits>
#include <cstring>
#include <utility>

namespace hottel {
namespace {

constexpr int kDeepest = 8;  // folders in folders

// Paths where a signal handler can read them.
struct Slot {
  std::atomic<bool> is_used{false};   // taken by a PendingRemoval
  std::atomic<bool> is_ready{false};  // path and removal are complete
  Removal removal = Removal::kFile;
  std::array<char, PATH_MAX> path{};
};
std::array<Slot, 128> slots;

// Returns the slot, or -1 where there is none left.
int take_slot(const std::string& path, Removal removal) {
  if (path.size() >= PATH_MAX) return -1;
  for (std::size_t i = 0; i < slots.size(); ++i) {
    if (slots[i].is_used.exchange(true)) continue;
    std::copy_n(path.c_str(), path.size() + 1, slots[i].path.begin());
    slots[i].removal = removal;
    slots[i].is_ready = true;
    return static_cast<int>(i);
  }
  return -1;
}

void leave_slot(int slot) {
  if (slot < 0) return;
  slots[static_cast<std::size_t>(slot)].is_ready = false;
  slots[static_cast<std::size_t>(slot)].is_used = false;
}

// Removes what is in a folder by system calls alone: readdir() may allocate.
void empty_folder(int at, const char* path, int depth) noexcept {
  const int folder = ::openat(at, path, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
  if (folder < 0) return;
  struct Entry {  // linux_dirent64 of getdents64(2)
    ino64_t inode;
    off64_t offset;
    unsigned short length;
    unsigned char type;
    char name[1];
  };
  alignas(Entry) std::array<char, 4096> entries;
  for (long bytes = 0; (bytes = ::syscall(SYS_getdents64, folder, entries.data(), entries.size())) > 0;)
    for (long k = 0; k < bytes;) {
      const auto* entry = reinterpret_cast<const Entry*>(entries.data() + k);
      k += entry->length;
      const char* name = entry->name;
      if (std::strcmp(name, ".") == 0 || std::strcmp(name, "..") == 0) continue;
      if (::unlinkat(folder, name, 0) == 0 || depth == kDeepest) continue;
      empty_folder(folder, name, depth + 1);
      ::unlinkat(folder, name, AT_REMOVEDIR);
    }
  ::close(folder);
}

}  // namespace

PendingRemoval::PendingRemoval(const std::string& path, Removal removal) : slot_(take_slot(path, removal)) {}

PendingRemoval::PendingRemoval(PendingRemoval&& other) noexcept : slot_(std::exchange(other.slot_, -1)) {}

PendingRemoval& PendingRemoval::operator=(PendingRemoval&& other) noexcept {
  leave_slot(std::exchange(slot_, std::exchange(other.slot_, -1)));
  return *this;
}

PendingRemoval::~PendingRemoval() { leave_slot(slot_); }

void remove_pending() noexcept {
  for (const Slot& slot : slots) {
    if (!slot.is_ready || slot.removal == Removal::kEmptyFolder) continue;
    if (slot.removal == Removal::kFile) {
      ::unlink(slot.path.data());
    } else {
      empty_folder(AT_FDCWD, slot.path.data(), 0);
      ::rmdir(slot.path.data());
    }
  }
  // A folder is empty once those in it are gone.
  for (bool is_done = false; !is_done;) {
    is_done = true;
    for (const Slot& slot : slots)
      if (slot.is_ready && slot.removal == Removal::kEmptyFolder && ::rmdir(slot.path.data()) == 0) is_done = false;
  }
}

}  // namespace hottel
