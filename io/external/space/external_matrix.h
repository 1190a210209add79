// All ways to compute view factors in space, those of others too.
#pragma once

#include "solver/space/methods/method_catalogue.h"

namespace hottel {

// The methods of the library (methods_3), and what others computed (io/external/external_method.h).
MethodCatalogue3 all_methods_3();

}  // namespace hottel
