// The methods that are there in the plane, by name.
#pragma once

#include "solver/method_catalogue.h"
#include "solver/plane/methods/exchange_method.h"

namespace hottel {

using MethodFamily2 = MethodFamily<PreparedScene2>;
using MethodCatalogue2 = MethodCatalogue<PreparedScene2>;

// The methods of this library, the exact one first. A new one is a file in solver/plane/methods and a line in
// planar_methods.cpp.
MethodCatalogue2 methods_2();

}  // namespace hottel
