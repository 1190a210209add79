#include "io/sums/space/pair_folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <string_view>
#include <system_error>
#include <utility>

#include "geometry/space/exchange/pair_estimate.h"
#include "io/files/crc32.h"
#include "io/files/disk_space.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

constexpr std::size_t kRanges = 256;

// A pair as it stands in a file.
struct WrittenPair {
  std::uint32_t i, j;
  double measure, error, lower, upper, alone;
  std::uint64_t is_whole;
};
static_assert(sizeof(WrittenPair) == 56);

WrittenPair written(const PairSum3& pair) {
  return {pair.i, pair.j, pair.measure, pair.error, pair.bounds.lower, pair.bounds.upper, pair.alone, pair.is_whole};
}

PairSum3 read(const WrittenPair& pair) {
  return {.i = pair.i,
          .j = pair.j,
          .measure = pair.measure,
          .error = pair.error,
          .bounds = {pair.lower, pair.upper},
          .alone = pair.alone,
          .is_whole = pair.is_whole != 0};
}

std::string_view bytes_of(const std::vector<WrittenPair>& pairs) {
  return {reinterpret_cast<const char*>(pairs.data()), pairs.size() * sizeof(WrittenPair)};
}

// About how many pairs there will be, of the rows that are asked for; 0 where that is not known.
double pairs_to_come(const PreparedScene3& prepared, const ElementTable3& table, const ExchangeRequest& request) {
  if (request.granularity == Granularity::kGroup) return 0;
  const std::vector<CountedFace> faces = counted_faces_3(prepared.scene, request.granularity);
  if (pair_counts(faces).pairs == 0) return 0;
  const SampledPairs sampled = estimated_pairs_3(prepared.scene, faces);
  if (!sampled.is_known) return 0;
  const auto rows = static_cast<double>(request.rows.labels(table.elements()).size());
  return sampled.pairs * std::min(1.0, 2 * rows / static_cast<double>(table.count()));
}

}  // namespace

std::uint64_t disk_for_pairs_3(std::uint64_t pairs) { return 2 * pairs * sizeof(WrittenPair); }

PairFolder3::PairFolder3(const std::filesystem::path& folder, const PreparedScene3& prepared,
                         const ElementTable3& table, const ExchangeRequest& request)
    : rows_(table.count()), cuts_(rows_, kRanges), folder_(folder), own_(folder), segments_(cuts_.count()) {
  const auto pairs = static_cast<std::uint64_t>(pairs_to_come(prepared, table, request));
  if (pairs > 0)
    require_space(file(0), disk_for_pairs_3(pairs), fmt::format("the sums of about {} pairs take about", pairs), "");
}

std::filesystem::path PairFolder3::file(std::size_t k) const { return own_.path() / fmt::format("{:03}.pairs", k); }

std::uint64_t PairFolder3::bytes() const {
  std::uint64_t count = 0;
  for (const Segment& segment : segments_) count += segment.count;
  return count * sizeof(WrittenPair);
}

void PairFolder3::keep(std::span<const PairSum3> pairs) {
  std::vector<std::vector<WrittenPair>> ranges(cuts_.count());
  for (const PairSum3& pair : pairs) {
    const std::size_t of_i = cuts_.of(pair.i);
    ranges[of_i].push_back(written(pair));
    if (pair.j >= rows_) continue;  // the sky
    if (const std::size_t of_j = cuts_.of(pair.j); of_j != of_i) ranges[of_j].push_back(written(pair));
  }
  own_.touch();
  for (std::size_t k = 0; k < ranges.size(); ++k) {
    if (ranges[k].empty()) continue;
    const std::string_view bytes = bytes_of(ranges[k]);
    std::ofstream out(file(k), std::ios::binary | std::ios::app);
    out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    out.close();
    if (!out) throw OutputError(file(k).string(), "cannot be written: " + std::system_category().message(errno));
    segments_[k].count += ranges[k].size();
    segments_[k].sum = crc32_of(bytes, segments_[k].sum);
  }
}

std::vector<PairSum3> PairFolder3::pairs(std::size_t k) {
  if (segments_[k].count == 0) return {};
  std::vector<WrittenPair> all(segments_[k].count);
  const auto size = static_cast<std::streamsize>(all.size() * sizeof(WrittenPair));
  std::ifstream in(file(k), std::ios::binary);
  in.read(reinterpret_cast<char*>(all.data()), size);
  if (!in || in.peek() != std::ifstream::traits_type::eof() || crc32_of(bytes_of(all)) != segments_[k].sum)
    throw InputError({file(k).string(), 0}, "does not hold the sums that were written to it");
  std::ranges::sort(all, {}, [](const WrittenPair& pair) { return std::pair(pair.i, pair.j); });
  std::vector<PairSum3> result;
  result.reserve(all.size());
  for (const WrittenPair& pair : all) result.push_back(read(pair));
  return result;
}

}  // namespace hottel
