// The methods that are there, by name.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "solver/plane/methods/exchange_method.h"

namespace hottel {

// Methods that differ in a parameter or a variant.
struct MethodFamily2 {
  std::string name;     // "gauss": what comes before the first colon
  std::string pattern;  // "gauss:n": what may be typed
  std::string what;     // one line for --help and tables
  std::string reference;
  Guarantee guarantee = Guarantee::kEstimated;
  std::vector<std::string> sweep;  // names in full, cheapest first: the points of one curve of accuracy against time

  // Makes the method from what follows the family's name ("" or ":4"). Throws UsageError when that makes no sense.
  std::function<std::unique_ptr<ExchangeMethod2>(std::string_view variant)> make;
};

// The name of a method up to the first colon, or all of it: "gauss" of "gauss:4:normalised".
std::string family_of_2(const std::string& name);

// The name of a method without the ":normalised" at its end, and that, or nothing.
struct SplitMethodName2 {
  std::string raw, normalised;
};
SplitMethodName2 split_method_name_2(const std::string& name);

// All methods by name. A name is a family, its variant, and at last perhaps ":normalised": the same method with every
// row divided by its sum, the sky included.
//
//   (1) MethodReport::row_defect of a normalised method is that of the rows before they were divided
//   (2) what roundings leave is taken from the largest factor of a row: its doubles sum to 1 within an ulp of that
//       factor, and never to more
//   (3) rows that do not sum to more than 0 stay as they are
//   (4) a normalised matrix is kEstimated, whatever the method says of its own
class MethodCatalogue2 {
 public:
  // Adds a family. REQUIRES a name that no family has yet: the first one of a name is found.
  void add(MethodFamily2 family) { families_.push_back(std::move(family)); }
  const std::vector<MethodFamily2>& families() const { return families_; }

  // Makes the method of a name. Throws UnknownName that lists the patterns when there is no such family, UsageError
  // when its variant makes no sense.
  std::unique_ptr<ExchangeMethod2> make(const std::string& name) const;

 private:
  std::vector<MethodFamily2> families_;
};

// The methods of this library, the exact one first. A new one is a file in solver/plane/methods and a line in
// planar_methods.cpp.
MethodCatalogue2 methods_2();

}  // namespace hottel
