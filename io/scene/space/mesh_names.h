// The names in a file of a mesh, each listed once.
#pragma once

#include <cstdint>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "io/scene/distinct_names.h"
#include "io/scene/space/mesh.h"

namespace hottel {

// Finds names in a list by what is typed in the file.
class MeshNames3 {
 public:
  // The index of what is typed. If it is new it is put at the end of the list: under its name, or NAME~2, NAME~3, ...
  // where something else that was typed has that.
  std::uint32_t index_of(const std::string& typed, const MeshName3& name, std::vector<MeshName3>& list) {
    const auto [entry, is_new] = index_.emplace(typed, static_cast<std::uint32_t>(list.size()));
    if (is_new) list.push_back({names_.take(name.name), name.line});
    return entry->second;
  }

 private:
  std::unordered_map<std::string, std::uint32_t> index_;
  DistinctNames names_;
};

}  // namespace hottel
