// The methods that are there in space, by name.
#pragma once

#include "solver/method_catalogue.h"
#include "solver/space/methods/exchange_method.h"

namespace hottel {

using MethodFamily3 = MethodFamily<PreparedScene3>;
using MethodCatalogue3 = MethodCatalogue<PreparedScene3>;

// The methods of this library, the exact one first. A new one is a file in solver/space/methods and a line in
// spatial_methods.cpp.
MethodCatalogue3 methods_3();

}  // namespace hottel
