// Names that differ, whatever files call their things.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <unordered_map>
#include <unordered_set>

namespace hottel {

// Hands out names, each once: what is called as something before it is NAME~2, what follows NAME~3, and so on.
class DistinctNames {
 public:
  std::string take(const std::string& wanted) {
    std::string name = wanted;
    for (std::size_t& k = count_[wanted]; !names_.insert(name).second;)
      name = wanted + "~" + std::to_string(std::max<std::size_t>(++k, 2));
    return name;
  }

 private:
  std::unordered_map<std::string, std::size_t> count_;
  std::unordered_set<std::string> names_;
};

}  // namespace hottel
