// Methods for view factors by name, and how they compare with the exact one.
#pragma once

#include "io/external/plane/named_methods.h"         // method_2
#include "solver/plane/compare/method_comparison.h"  // MethodComparison2, add_verdict
#include "solver/plane/methods/exchange_method.h"    // ExchangeMethod2
#include "solver/space/methods/exchange_method.h"    // ExchangeMethod3
