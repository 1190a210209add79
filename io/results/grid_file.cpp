#include "io/results/grid_file.h"

#include <algorithm>
#include <filesystem>

namespace hottel {

std::string grid_file(const std::string& file, const std::string& grid) {
  if (grid.empty()) return file;
  const std::size_t begin = file.size() - std::filesystem::path(file).filename().string().size();
  const std::size_t ending = std::min(file.find('.', begin), file.size());
  return file.substr(0, ending) + "-" + grid + file.substr(ending);
}

}  // namespace hottel
