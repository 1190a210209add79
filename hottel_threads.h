// Threads: on how many the library works, and values that threads of their own make.
#pragma once

#include "kernel/support/parallel.h"  // ThreadLimit
#include "kernel/support/stage.h"     // Stage
