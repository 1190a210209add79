// What tells kept factors of one scene and method from those of all others.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/scene_table.h"
#include "kernel/rational.h"

namespace hottel {

// A key (StoreTable::key), put together of texts and numbers.
//
//   (1) two keys are equal iff they were put together of the same, in the same order: texts come with their lengths
//   (2) each version of this program has its own keys: its numbers need not be those of another one
class StoreKey {
 public:
  // kind: what numbers are kept, and how: "plane exact 1".
  explicit StoreKey(std::string_view kind);

  void add(std::string_view text);
  void add_count(std::uint64_t number) { add(std::to_string(number)); }
  void add_number(const Rational& number) { add(to_string(number)); }
  void add_bits(double number);
  // The elements of rows and columns, for methods that look at all of them.
  void add_elements(const std::vector<std::string>& ids);
  // What of a table decides whose a place is, and what areas are in: the unit where it is not the metre, names, groups
  // and what is behind them, what patches lie on, and which faces have a material; not which. Which surfaces are
  // divided is none of it: ids of elements say so.
  void add_table(const SceneTable& scene);
  // How many parts each surface is divided into.
  void add_division(const SceneTable& scene);

  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

}  // namespace hottel
