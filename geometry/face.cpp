#include "geometry/face.h"

namespace hottel {
namespace {

constexpr std::string_view kBack = ":back";

}  // namespace

SideName side_named(std::string_view text) {
  const bool is_back = text.ends_with(kBack);
  if (is_back) text.remove_suffix(kBack.size());
  return {std::string(text), is_back};
}

std::string side_text(const SideName& side) { return side.name + (side.is_back ? std::string(kBack) : ""); }

}  // namespace hottel
