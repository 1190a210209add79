// On how many threads the library works; and Stage, a value that is computed by a thread of its own when it is asked
// for.
#pragma once

#include "kernel/support/parallel.h"  // ThreadLimit
#include "kernel/support/stage.h"     // Stage
