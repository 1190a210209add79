#include "geometry/element.h"

namespace hottel {

std::string element_name(const std::string& face, std::uint32_t parts, const TreeNode& node) {
  if (parts == 1 && node.path.depth() == 0) return face;
  return face + "#" + node.text();
}

}  // namespace hottel
