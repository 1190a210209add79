// Sums of pairs in space in files, as many as the disk holds, while a run lasts.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include "geometry/exchange_request.h"
#include "geometry/space/exchange/pair_source.h"
#include "geometry/space/prepared/element_table.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "io/files/output_file.h"
#include "io/files/scratch_folder.h"

namespace hottel {

// Pairs by the ranges of rows that they belong to, a file for each, to which they are appended as they come.
//
//   (1) pairs(k) are those of pairs in memory, bit for bit
//   (2) they are in a folder of their own in this one, which the destructor removes, or the signal that ends the
//       program, or the next such run in this folder (ScratchFolder)
//   (3) nothing in memory grows with their number but what is handed over at a time, and one range: there are 256, or
//       one for each row
// A pair takes 56 bytes, twice where its rows are in two ranges. COST: that of writing each pair once or twice, and of
// reading and sorting a range.
class PairFolder3 final : public PairKeeper3 {
 public:
  // Throws RequestError where the disk has no room for about as many pairs as there will be; OutputError where no
  // folder can be made.
  PairFolder3(const std::filesystem::path& folder, const PreparedScene3& prepared, const ElementTable3& table,
              const ExchangeRequest& request);

  const RowCuts& cuts() override { return cuts_; }
  // Throws InputError, naming the file, where it does not hold what was written.
  std::vector<PairSum3> pairs(std::size_t k) override;
  // Throws OutputError where they cannot be written.
  void keep(std::span<const PairSum3> pairs) override;
  std::uint64_t bytes_per_pair() const override { return 0; }

  // Bytes on the disk.
  std::uint64_t bytes() const;

 private:
  // What was written of a range.
  struct Segment {
    std::uint64_t count = 0;
    std::uint32_t sum = 0;  // CRC-32 of the bytes
  };

  std::filesystem::path file(std::size_t k) const;

  std::uint32_t rows_;
  RowCuts cuts_;
  OutputFolder folder_;
  ScratchFolder own_;
  std::vector<Segment> segments_;  // by range
};

// The disk that so many pairs take at the most, in bytes.
std::uint64_t disk_for_pairs_3(std::uint64_t pairs);

}  // namespace hottel
