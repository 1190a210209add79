// The one place where CGAL kernels are chosen. Included by .cpp files only.
#pragma once

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include "kernel/rational.h"

namespace hottel {

// Exact, and fast where the products of coordinates are doubles: filtered by intervals.
using ExactKernel = CGAL::Exact_predicates_exact_constructions_kernel;

// Exact for numbers of any size: rational arithmetic throughout.
using RationalKernel = ExactKernel::Exact_kernel;

}  // namespace hottel
