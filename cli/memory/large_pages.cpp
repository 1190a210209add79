// How the programs take memory: in pages of two megabytes, by jemalloc. Matrices and hash tables are large and are read
// all over; with small pages exact factors take a tenth to a half longer, much of it for clearing them one by one.
// The library leaves this to the programs that it is linked into.
//
//   thp:always             large pages wherever the system has them
//   oversize_threshold:0   large blocks are kept as others are, not given back at once
//   dirty_decay_ms:60000   what is free is given back within a minute, so that one stage finds what the one before left
// SEE: jemalloc(3).
extern "C" {
extern const char* malloc_conf;
const char* malloc_conf = "thp:always,oversize_threshold:0,dirty_decay_ms:60000,muzzy_decay_ms:0";
}
