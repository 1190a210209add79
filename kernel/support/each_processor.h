// Functions that are compiled once for each kind of processor.
#pragma once

// Before a function: it is compiled for vectors of several lengths, and the one for the processor is called. Only for
// plain loops, of which no result depends on that.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(__SANITIZE_THREAD__)
#define HOTTEL_FOR_EACH_PROCESSOR __attribute__((target_clones("default", "avx2", "avx512f")))
#else
#define HOTTEL_FOR_EACH_PROCESSOR
#endif
