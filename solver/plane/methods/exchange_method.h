// Methods to compute view factors in the plane.
#pragma once

#include "solver/exchange_method.h"

namespace hottel {

struct PreparedScene2;

using ExchangeMethod2 = ExchangeMethod<PreparedScene2>;

// A method that knows elements only. Factors of faces and groups are put together from theirs (coarsened.h).
class ElementMethod2 : public ExchangeMethod2 {
 public:
  ExchangeMatrix compute(const PreparedScene2& prepared, const ExchangeRequest& request,
                         MethodReport& report) const final;
  bool works_by_elements() const override { return true; }

 protected:
  // The factors of the elements that `prepared` is divided into; fills what the report says of the method.
  virtual ExchangeMatrix compute_elements(const PreparedScene2& prepared, const std::function<void(double)>& progress,
                                          MethodReport& report) const = 0;
};

}  // namespace hottel
