#include "io/sums/plane/sum_folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <system_error>
#include <utility>

#include "geometry/plane/exchange/exchange_sums.h"
#include "geometry/plane/exchange/swept_vertices.h"
#include "io/files/disk_space.h"
#include "io/files/text_file.h"
#include "kernel/support/failure.h"
#include "kernel/support/parallel.h"
#include "kernel/support/stopwatch.h"
#include "kernel/version.h"
#include "solver/cached_pairs.h"
#include "solver/plane/methods/method_catalogue.h"
#include "solver/plane/simulation/cached_factors.h"
#include "solver/store_key.h"

namespace hottel {
namespace {

namespace fs = std::filesystem;

constexpr const char* kEnding = ".sums";
// Another one wherever sums of the same scene are others, or in another order, than before.
constexpr const char* kKind = "plane sums 1";
constexpr std::uint64_t kBytesInTable = 96;  // of a sum, while it is summed up

// Two lists by key, as one.
std::vector<PairSum2> added(const std::vector<PairSum2>& a, const std::vector<PairSum2>& b) {
  std::vector<PairSum2> result;
  result.reserve(a.size() + b.size());
  auto x = a.begin(), y = b.begin();
  while (x != a.end() && y != b.end()) {
    if (x->key != y->key) {
      result.push_back(x->key < y->key ? *x++ : *y++);
      continue;
    }
    result.push_back(*x++);
    result.back().add(*y++);
  }
  result.insert(result.end(), x, a.end());
  result.insert(result.end(), y, b.end());
  return result;
}

}  // namespace

std::uint64_t disk_for_sums_2(std::uint64_t pairs) { return pairs * kBytesOfSumOnDisk; }

std::size_t ranges_for_sums_2(std::uint64_t pairs, std::uint64_t memory) {
  constexpr std::uint64_t kMost = 256;
  const std::uint64_t by_memory = 8 * disk_for_sums_2(pairs) / std::max<std::uint64_t>(memory, 1);
  const std::uint64_t by_size = 2 * pairs / SumsInMemory2::kEntriesInRange;
  return static_cast<std::size_t>(std::min(kMost, 1 + std::max(by_memory, by_size)));
}

std::string sums_key(const PreparedScene2& prepared, const ElementTable2& table, const ExchangeRequest& request) {
  const StoreTable factors = store_table_2(*methods_2().make("exact"), prepared, request);
  StoreKey key(kKind);
  key.add(factors.key);
  key.add_division(prepared.scene);
  key.add_elements(factors.elements);
  for (std::uint32_t label = 0; label < table.count(); ++label)
    if (!table.has_row(label)) key.add_count(label);
  return sha256(key.text());
}

SumFolder2::SumFolder2(SumFolderRequest asked, const PreparedScene2& prepared, const ElementTable2& table,
                       const ExchangeRequest& request, ExchangeReport& report)
    : asked_(std::move(asked)),
      prepared_(prepared),
      table_(table),
      memory_(request.memory),
      key_(sums_key(prepared, table, request)),
      estimated_pairs_(estimated_sight(prepared.arrangement, table).pairs),
      cuts_(table.count(), ranges_for_sums_2(estimated_pairs_, memory_)),
      folder_(asked_.folder) {
  if (!asked_.stays) own_.emplace(asked_.folder);
  Stopwatch watch;
  require_hold();
  take_chunks();
  require_room();
  sweep(request);
  report.seconds["sweep"] = watch.lap();
  for (const Chunk& chunk : chunks_) {
    report.gaps += chunk.head.counts.gaps;
    report.terms += chunk.head.counts.updates;
  }
}

SumFolder2::~SumFolder2() {
  if (asked_.stays || own_) return;
  std::error_code ignored;
  for (const Chunk& chunk : chunks_) fs::remove(chunk.file, ignored);
}

// Two runs in one folder would remove, and write anew, what the other reads.
void SumFolder2::require_hold() {
  if (own_) return;
  hold_ = FolderHold(place());
  if (hold_.is_held()) return;
  throw InputError({place().string(), 0}, "another run keeps its sums there until it ends",
                   {"wait for it, or name another folder"});
}

// Takes what an earlier run left, in the order of their places; of two that have a place in common the first.
void SumFolder2::take_chunks() {
  for (const auto& entry : fs::directory_iterator(place()))
    if (entry.path().extension() == kEnding) take(entry.path());
  std::ranges::sort(chunks_, {}, [](const Chunk& chunk) { return chunk.head.begin; });
  std::uint64_t end = 0;
  std::vector<Chunk> taken;
  for (Chunk& chunk : chunks_) {
    if (chunk.head.begin < end) {
      fs::remove(chunk.file);
      continue;
    }
    end = chunk.head.end;
    taken.push_back(std::move(chunk));
  }
  chunks_ = std::move(taken);
}

void SumFolder2::take(const fs::path& file) {
  SumChunkHead2 head = read_sum_chunk_head_2(file);
  require_own(file, head);
  if (chunks_.empty()) cuts_ = RowCuts(table_.count(), head.segments.size());
  if (head.segments.size() == cuts_.count()) chunks_.push_back({file, std::move(head)});
}

void SumFolder2::require_own(const fs::path& file, const SumChunkHead2& head) const {
  if (head.key == key_) return;
  throw InputError({file.string(), 0},
                   fmt::format("holds sums of {}, which is another scene, or version of it or of hottel, or was asked "
                               "for other rows; remove {} or name another folder",
                               head.about, asked_.folder.string()));
}

void SumFolder2::require_room() const {
  const std::uint64_t needed = disk_for_sums_2(estimated_pairs_) + estimated_pairs_ * asked_.bytes_beside;
  const std::uint64_t there = bytes();
  if (needed > there)
    require_space(place() / kEnding, needed - there,
                  fmt::format("the sums{} of about {} pairs take about", asked_.bytes_beside > 0 ? " and factors" : "",
                              estimated_pairs_),
                  "");
}

std::vector<fs::path> SumFolder2::files() const {
  std::vector<fs::path> files;
  for (const Chunk& chunk : chunks_) files.push_back(chunk.file);
  return files;
}

std::uint64_t SumFolder2::bytes() const {
  std::uint64_t bytes = 0;
  std::error_code ignored;
  for (const Chunk& chunk : chunks_) bytes += fs::file_size(chunk.file, ignored);
  return bytes;
}

void SumFolder2::sweep(const ExchangeRequest& request) {
  const std::vector<VertexId> order = swept_vertices(prepared_.arrangement, table_);
  std::vector<std::pair<std::size_t, std::size_t>> gaps;  // places that no chunk has
  std::size_t place = 0;
  for (const Chunk& chunk : chunks_) {
    if (place < chunk.head.begin) gaps.emplace_back(place, chunk.head.begin);
    place = chunk.head.end;
  }
  if (place < order.size()) gaps.emplace_back(place, order.size());
  double size = 1024;
  for (const auto& gap : gaps)
    for (std::size_t begin = gap.first, end = 0; begin < gap.second; begin = end) {
      end = std::min(gap.second, begin + static_cast<std::size_t>(size));
      const double at = static_cast<double>(begin) / static_cast<double>(order.size());
      const double part = static_cast<double>(end - begin) / static_cast<double>(order.size());
      const double fits = sweep_chunk(order, begin, end, [&](double done) {
        if (request.progress) request.progress(at + part * done);
      });
      size = std::clamp(fits * static_cast<double>(end - begin), 64.0, 4 * size);
    }
}

// Returns how many times as many vertices would fit memory and time.
double SumFolder2::sweep_chunk(std::span<const VertexId> order, std::size_t begin, std::size_t end,
                               const std::function<void(double)>& progress) {
  Stopwatch watch;
  SumChunkHead2 head{key_, fmt::format("{} by hottel {}", prepared_.scene.file, kVersion), begin, end};
  const PairSums2 sums = sum_pairs_about(order.subspan(begin, end - begin), prepared_.arrangement, table_, progress,
                                         std::numeric_limits<std::uint64_t>::max(), head.counts);
  const fs::path file = place() / fmt::format("{:012}{}", begin, kEnding);
  head = write_sum_chunk(file, std::move(head), sums, table_, cuts_);
  chunks_.push_back({file, std::move(head)});
  const double by_memory = static_cast<double>(memory_) / 4 / static_cast<double>((sums.size() + 1) * kBytesInTable);
  const double by_time = asked_.stays ? asked_.between.count() / std::max(watch.lap(), 1e-3) : by_memory;
  return std::min(by_memory, by_time);
}

std::vector<PairSum2> SumFolder2::sums(std::size_t k) const {
  if (own_) own_->touch();
  std::vector<std::vector<PairSum2>> parts(chunks_.size());
  parallel_for(parts.size(), [&](std::size_t n) { parts[n] = read_sum_segment(chunks_[n].file, chunks_[n].head, k); });
  while (parts.size() > 1) {
    std::vector<std::vector<PairSum2>> halves((parts.size() + 1) / 2);
    parallel_for(halves.size(), [&](std::size_t n) {
      halves[n] = 2 * n + 1 < parts.size() ? added(parts[2 * n], parts[2 * n + 1]) : std::move(parts[2 * n]);
      parts[2 * n] = {};
    });
    parts = std::move(halves);
  }
  return parts.empty() ? std::vector<PairSum2>() : std::move(parts.front());
}

}  // namespace hottel
