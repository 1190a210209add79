#include "io/external/plane/named_methods.h"

#include "io/external/plane/external_matrix.h"

namespace hottel {

std::unique_ptr<ExchangeMethod2> method_2(const std::string& name) { return all_methods_2().make(name); }

std::vector<std::string> method_patterns_2() {
  const MethodCatalogue2 methods = all_methods_2();
  std::vector<std::string> patterns;
  for (const MethodFamily2& family : methods.families()) patterns.push_back(family.pattern);
  return patterns;
}

}  // namespace hottel
