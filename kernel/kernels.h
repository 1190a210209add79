// The one place where CGAL kernels are chosen. Included by .cpp files only.
#pragma once

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include "kernel/rational.h"

namespace hottel {

using ExactKernel = CGAL::Exact_predicates_exact_constructions_kernel;

}  // namespace hottel
