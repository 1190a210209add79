// Sums of pairs in a folder of chunks, as large as the disk: of one run, or from a run that was ended to the next one.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "geometry/exchange_report.h"
#include "geometry/exchange_request.h"
#include "geometry/plane/exchange/sum_source.h"
#include "geometry/plane/prepared/prepared_scene.h"
#include "io/files/folder_hold.h"
#include "io/files/output_file.h"
#include "io/files/scratch_folder.h"
#include "io/sums/plane/sum_chunk.h"

namespace hottel {

// Whose sums they are: 64 hexadecimal digits of the scene, its elements and the rows that are asked for, and of the
// version of hottel. Equal iff a sweep finds the same sums in the same order.
std::string sums_key(const PreparedScene2& prepared, const ElementTable2& table, const ExchangeRequest& request);

// What is asked of a folder.
struct SumFolderRequest {
  std::filesystem::path folder;
  bool stays = false;                        // chunks of a run that does not come to its end stay: the next run goes on
  std::chrono::duration<double> between{2};  // what a sweep may take before it is written, where chunks stay
  std::uint64_t bytes_beside = 0;            // of each pair that the run will write to the same disk besides its sum
};

// The sums of a scene, swept into chunks.
//
//   (1) sums(k) is that of sums in memory, bit for bit: integers, whoever adds them and in whatever order
//   (2) chunks that are there and whole are not swept again, whoever wrote them
//   (3) nobody else's are taken, nor removed: InputError naming the file, the scene that it is of, and a remedy
//   (4) beside the prepared scene a sweep takes about half of the memory of the request, and a range as much
//   (5) without forget() they stay where that is asked for; else they are in a folder of their own in this one, which
//       the destructor removes, or the signal that ends the program, or the next such run in this folder
//       (ScratchFolder)
//   (6) sums that stay are those of one run at a time: InputError where another one has the folder
class SumFolder2 final : public SumSource2 {
 public:
  // Sweeps what is not there. Throws RequestError before the sweep where the disk has no room for the sums; OutputError
  // where they cannot be written; what progress throws.
  // REQUIRES that scene and table outlive this.
  SumFolder2(SumFolderRequest asked, const PreparedScene2& prepared, const ElementTable2& table,
             const ExchangeRequest& request, ExchangeReport& report);
  SumFolder2(const SumFolder2&) = delete;
  ~SumFolder2() override;

  const RowCuts& cuts() const override { return cuts_; }
  std::vector<PairSum2> sums(std::size_t k) const override;
  // The result is whole: the chunks are of no more use.
  void forget() { asked_.stays = false; }
  // Bytes on the disk.
  std::uint64_t bytes() const;
  // The files that the sums are in.
  std::vector<std::filesystem::path> files() const;

 private:
  struct Chunk {
    std::filesystem::path file;
    SumChunkHead2 head;
  };

  // Where the chunks are.
  const std::filesystem::path& place() const { return own_ ? own_->path() : asked_.folder; }
  void require_hold();
  void take_chunks();
  void take(const std::filesystem::path& file);
  void require_own(const std::filesystem::path& file, const SumChunkHead2& head) const;
  void require_room() const;
  void sweep(const ExchangeRequest& request);
  double sweep_chunk(std::span<const VertexId> order, std::size_t begin, std::size_t end,
                     const std::function<void(double)>& progress);

  SumFolderRequest asked_;
  const PreparedScene2& prepared_;
  const ElementTable2& table_;
  std::uint64_t memory_;
  std::string key_;
  std::uint64_t estimated_pairs_;
  RowCuts cuts_;
  OutputFolder folder_;
  std::optional<ScratchFolder> own_;  // unless chunks stay
  FolderHold hold_;                   // where they do
  std::vector<Chunk> chunks_;         // by place
};

// A sum on disk, at the most: in the rows of two ranges, and in a fifth more chunks than one. In bytes.
inline constexpr std::uint64_t kBytesOfSumOnDisk = 80;
// The disk that the sums of so many pairs take, in bytes, and the ranges of rows that they are kept by.
std::uint64_t disk_for_sums_2(std::uint64_t pairs);
std::size_t ranges_for_sums_2(std::uint64_t pairs, std::uint64_t memory);

}  // namespace hottel
