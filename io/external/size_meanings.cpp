#include "io/external/size_meanings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

namespace hottel {
namespace {

// What a row may be of.
struct Side {
  std::uint32_t place = 0;
  double area = 0;
  bool has_material = false;
};

// The faces of elements that follow each other.
std::vector<Side> whole_faces(const std::vector<Element>& elements) {
  std::vector<Side> faces;
  const Element* before = nullptr;
  for (const Element& element : elements) {
    if (!before || before->surface != element.surface || before->is_back != element.is_back) faces.emplace_back();
    faces.back().area += element.area.value;
    faces.back().has_material = element.material.has_value();
    before = &element;
  }
  return faces;
}

// How far A_i F_ij is from the same both ways, of all that is exchanged between rows; the sky and black backs aside.
double asymmetry(const ExternalMatrix& external, const std::vector<Side>& sides) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, double> differences;
  double sum = 0;
  for (const ExternalEntry& entry : external.entries) {
    if (entry.row >= sides.size() || entry.column >= sides.size() || entry.row == entry.column) continue;
    if (!sides[entry.row].has_material || !sides[entry.column].has_material) continue;
    const double exchange = sides[entry.row].area * entry.value;
    sum += std::abs(exchange);
    differences[std::minmax(entry.row, entry.column)] += entry.row < entry.column ? exchange : -exchange;
  }
  double difference = 0;
  for (const auto& each : differences) difference += std::abs(each.second);
  return sum > 0 ? difference / sum : 0;
}

}  // namespace

std::vector<SizeMeaning> size_meanings(const ExternalMatrix& external, const std::vector<Element>& elements) {
  std::vector<Side> parts;
  for (const Element& element : elements)
    parts.push_back({static_cast<std::uint32_t>(parts.size()), element.area.value, element.material.has_value()});
  const std::vector<Side> wholes = whole_faces(elements);
  const bool is_divided = wholes.size() < parts.size();
  const char* const noun = is_divided ? "elements" : "faces";
  std::vector<SizeMeaning> meanings;
  const auto add = [&](std::vector<Side> sides, bool is_whole, bool has_all, bool has_sky) {
    if (!has_all) std::erase_if(sides, [](const Side& side) { return !side.has_material; });
    if (sides.size() + (has_sky ? 1 : 0) != external.rows) return;
    SizeMeaning meaning;
    meaning.words = std::string(has_all ? "all " : "the ") + (is_whole ? "undivided faces" : noun) +
                    (has_all ? "" : " with a material") + (has_sky ? " and the sky" : "");
    meaning.asymmetry = asymmetry(external, sides);
    if (!is_whole)
      for (const Side& side : sides) meaning.places.push_back(side.place);
    if (!is_whole && has_sky) meaning.places.push_back(static_cast<std::uint32_t>(elements.size()));
    for (const SizeMeaning& other : meanings)
      if (!is_whole && other.places == meaning.places) return;
    meanings.push_back(std::move(meaning));
  };
  for (const bool is_whole : {false, true})
    for (const bool has_all : {true, false})
      for (const bool has_sky : {false, true})
        if (!is_whole || is_divided) add(is_whole ? wholes : parts, is_whole, has_all, has_sky);
  return meanings;
}

}  // namespace hottel
