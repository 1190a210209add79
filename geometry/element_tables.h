// The elements of a prepared scene, for those who ask: made once.
#pragma once

#include <array>
#include <memory>
#include <mutex>

#include "geometry/element.h"

namespace hottel {

// The tables of elements of one scene, one for each granularity, each made when it is first asked for.
//
//   (1) a table is made once, whoever asks, and lives as long as this or one who was given it
//   (2) any number of threads may ask at once. Those who come while it is made wait
//   (3) where `make` throws, nothing is kept, and who asks next makes it
template <class Table>
class ElementTables {
 public:
  template <class Make>
  std::shared_ptr<const Table> of(Granularity granularity, const Make& make) {
    Slot& slot = slots_[static_cast<std::size_t>(granularity)];
    const std::lock_guard lock(slot.being_made);
    if (slot.table == nullptr) slot.table = std::make_shared<const Table>(make());
    return slot.table;
  }

 private:
  struct Slot {
    std::mutex being_made;
    std::shared_ptr<const Table> table;
  };
  std::array<Slot, kGranularities> slots_;
};

}  // namespace hottel
