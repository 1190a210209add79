// What radiosities with their view factors on disk will take, told before anything is computed.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

namespace hottel {

// `hottel solve OPTION FOLDER`.
struct PlannedOnDisk {
  std::string option;  // --out-of-core, --checkpoint
  std::string folder;
  double pairs = 0;                   // that see each other, about
  double memory_bytes = 0;            // at the most, the program and the scene included
  double disk_bytes = 0;              // at the most; a run refuses to begin where so many are not free
  std::optional<std::uint64_t> free;  // bytes of the disk; nothing where that is not told
  double seconds = 0;                 // of all that is asked for

  bool fits() const { return !free || disk_bytes <= static_cast<double>(*free); }
};

// A line each, under a heading.
std::string on_disk_text(const PlannedOnDisk& planned);
nlohmann::ordered_json on_disk_object(const PlannedOnDisk& planned);
// What that is called in a report: out_of_core, checkpoint.
const char* on_disk_key(const PlannedOnDisk& planned);

}  // namespace hottel
