// Sums of pairs in files: each has what the sweeps about some vertices added up to, by the rows that they belong to.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "geometry/plane/exchange/sum_source.h"
#include "geometry/plane/exchange/term_sums.h"
#include "geometry/plane/prepared/element_table.h"

namespace hottel {

// What a chunk says of itself.
struct SumChunkHead2 {
  // Of the sums of one range of rows, in the file one after the other.
  struct Segment {
    std::uint64_t count = 0;
    std::uint32_t sum = 0;  // CRC-32 of their bytes
  };

  std::string key;                   // of the scene and what is asked of it: 64 hexadecimal digits
  std::string about;                 // the same for people
  std::uint64_t begin = 0, end = 0;  // the places of the vertices in the order of the sweep
  SumCounts2 counts = {};
  std::vector<Segment> segments = {};
};

// Writes a chunk: the sums of each range of rows that the pairs have, a pair whose rows are in two ranges in both. The
// file is there whole or not at all. head: without segments. Returns it with these.
//
// Layout 1, little-endian: the 16 bytes "hottel sums 1\n\0\0"; the size of the head in 4 bytes, the head, its CRC-32;
// the segments. The head: key, about (the size in 8 bytes, the text), begin, end, gaps, terms, the number of segments,
// of each count and CRC-32, 8 bytes a number. A sum: the key of the pair (the smaller label in the upper half), how
// many lengths were rounded, times 2, plus 1 where it is obstructed; 2 S in 16 bytes. Throws OutputError.
SumChunkHead2 write_sum_chunk(const std::filesystem::path& file, SumChunkHead2 head, const PairSums2& sums,
                              const ElementTable2& table, const RowCuts& cuts);

// Returns the head of a chunk. Throws InputError for what is none of this layout, or breaks off.
SumChunkHead2 read_sum_chunk_head_2(const std::filesystem::path& file);

// Returns the sums of segment k, ascending by key. Throws InputError where they are not those that were written.
std::vector<PairSum2> read_sum_segment(const std::filesystem::path& file, const SumChunkHead2& head, std::size_t k);

}  // namespace hottel
