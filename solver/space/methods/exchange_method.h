// Methods to compute view factors in space.
#pragma once

#include "solver/exchange_method.h"

namespace hottel {

struct PreparedScene3;

using ExchangeMethod3 = ExchangeMethod<PreparedScene3>;

// A method that knows elements only. Factors of faces and groups are put together from theirs (coarsened.h).
class ElementMethod3 : public ExchangeMethod3 {
 public:
  ExchangeMatrix compute(const PreparedScene3& prepared, const ExchangeRequest& request,
                         MethodReport& report) const final;
  bool works_by_elements() const override { return true; }
  // Nothing, unless a method knows better.
  std::optional<double> declared_error(const PreparedScene3&) const override { return std::nullopt; }

 protected:
  // The factors of the elements that the scene is divided into; fills what the report says of the method.
  virtual ExchangeMatrix compute_elements(const PreparedScene3& prepared, const std::function<void(double)>& progress,
                                          MethodReport& report) const = 0;
};

}  // namespace hottel
