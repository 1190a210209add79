// All ways to compute view factors in the plane, those of others too.
#pragma once

#include "solver/plane/methods/method_catalogue.h"

namespace hottel {

// The methods of the library (methods_2), and what others computed (io/external/external_method.h).
MethodCatalogue2 all_methods_2();

}  // namespace hottel
