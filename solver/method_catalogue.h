// Methods to compute view factors, by name.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "solver/exchange_method.h"

namespace hottel {

// Methods that differ in a parameter or a variant.
template <class Prepared>
struct MethodFamily {
  std::string name;     // "gauss": what comes before the first colon
  std::string pattern;  // "gauss:n": what may be typed
  std::string what;     // one line for --help and tables
  std::string reference;
  Guarantee guarantee = Guarantee::kEstimated;
  std::vector<std::string> sweep;  // names in full, cheapest first: the points of one curve of accuracy against time

  // Makes the method from what follows the family's name ("" or ":4"). Throws UsageError when that makes no sense.
  std::function<std::unique_ptr<ExchangeMethod<Prepared>>(std::string_view variant)> make;
};

// The name of a method up to the first colon, or all of it: "gauss" of "gauss:4:normalised".
std::string family_of_method(const std::string& name);

// The name of a method without the ":normalised" at its end, and that, or nothing.
struct SplitMethodName {
  std::string raw, normalised;
};
SplitMethodName split_method_name(const std::string& name);

// Throws UnknownName for a method of none of these families; it lists their patterns, and where they are: "in space".
[[noreturn]] void refuse_method(const std::string& name, const std::string& where,
                                const std::vector<std::string>& families, const std::vector<std::string>& patterns);

// The same method with every row divided by its sum (normalised_method.h has the template: whoever defines a catalogue
// of a dimension instantiates it).
template <class Prepared>
std::unique_ptr<ExchangeMethod<Prepared>> normalised_method(std::unique_ptr<ExchangeMethod<Prepared>> raw);

// All methods by name. A name is a family, its variant, and at last perhaps ":normalised": the same method with every
// row divided by its sum, the sky included (normalised_method.h).
//
//   (1) the rows that are divided are those asked for, of elements, faces or groups; MethodReport::row_defect is that
//       of the elements before they were divided
//   (2) a normalised matrix is kEstimated, whatever the method says of its own
template <class Prepared>
class MethodCatalogue {
 public:
  // where: of which scenes, as messages say it ("in the plane").
  explicit MethodCatalogue(std::string where) : where_(std::move(where)) {}

  // Adds a family. REQUIRES a name that no family has yet: the first one of a name is found.
  void add(MethodFamily<Prepared> family) { families_.push_back(std::move(family)); }
  const std::vector<MethodFamily<Prepared>>& families() const { return families_; }

  // Makes the method of a name. Throws UnknownName that lists the patterns when there is no such family, UsageError
  // when its variant makes no sense.
  std::unique_ptr<ExchangeMethod<Prepared>> make(const std::string& name) const {
    if (const SplitMethodName split = split_method_name(name); !split.normalised.empty())
      return normalised_method(make(split.raw));
    const std::string family = family_of_method(name);
    std::vector<std::string> known, patterns;
    for (const MethodFamily<Prepared>& each : families_) {
      if (each.name == family) return each.make(std::string_view(name).substr(family.size()));
      known.push_back(each.name);
      patterns.push_back(each.pattern);
    }
    refuse_method(name, where_, known, patterns);
  }

 private:
  std::string where_;
  std::vector<MethodFamily<Prepared>> families_;
};

}  // namespace hottel
