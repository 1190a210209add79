#include "io/sums/plane/exact_on_disk.h"

#include <memory>
#include <system_error>
#include <utility>

#include "geometry/plane/exchange/exact_rows.h"
#include "geometry/plane/exchange/requested_sums.h"
#include "geometry/plane/prepared/element_table.h"
#include "io/files/output_file.h"
#include "kernel/support/failure.h"
#include "kernel/support/stopwatch.h"

namespace hottel {
namespace {

// Of a pair, in both rows. Where sums do not stay they are gone before the solver has its couplings, which are smaller.
constexpr std::uint64_t kBytesInMatrix = 2 * ExchangeMatrix::kBytesAnEntry;
constexpr std::uint64_t kBytesOfCouplings = 2 * (sizeof(std::uint32_t) + sizeof(double));
static_assert(kBytesOfCouplings <= kBytesOfSumOnDisk);

std::uint64_t bytes_beside(bool sums_stay) { return kBytesInMatrix + (sums_stay ? kBytesOfCouplings : 0); }

// The folder is there as long as an array may ask for room in it.
struct KeptFolder {
  OutputFolder folder;
  FolderMemory memory;

  explicit KeptFolder(const std::filesystem::path& at) : folder(at), memory(at) {}
};

}  // namespace

std::uint64_t disk_for_radiosities_2(std::uint64_t pairs, bool sums_stay) {
  return disk_for_sums_2(pairs) + pairs * bytes_beside(sums_stay);
}

ExactOnDisk2::ExactOnDisk2(SumFolderRequest asked) : asked_(std::move(asked)) {
  asked_.bytes_beside = bytes_beside(asked_.stays);
}

ExchangeMatrix ExactOnDisk2::compute(const PreparedScene2& prepared, const ExchangeRequest& request,
                                     MethodReport& report) const {
  HOTTEL_REQUIRE(!request.wants_measures);
  ExchangeReport& counts = report.counts;
  const auto kept = std::make_shared<const KeptFolder>(asked_.folder);
  Stopwatch watch;
  const std::shared_ptr<const ElementTable2> table = table_with_rows(prepared, request);
  counts.seconds["prepare"] = prepared.seconds;
  counts.seconds["label"] = watch.lap();
  const SumFolder2 sums(asked_, prepared, *table, request, counts);
  left_ = sums.files();
  bytes_of_sums_ = sums.bytes();
  report_scene(prepared, *table, counts);
  ExactRows2 rows(prepared, *table, request, sums, counts);
  watch.lap();
  ExchangeMatrix matrix = whole_matrix(rows, {kept, &kept->memory});
  counts.seconds["matrix"] = watch.lap();
  return matrix;
}

void ExactOnDisk2::forget() const {
  std::error_code ignored;
  for (const std::filesystem::path& file : left_) std::filesystem::remove(file, ignored);
}

}  // namespace hottel
