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

// In both rows: in the matrix, and as a coupling of the solver.
constexpr std::uint64_t kBytesBeside = 2 * (ExchangeMatrix::kBytesAnEntry + sizeof(std::uint32_t) + sizeof(double));

// The folder is there as long as an array may ask for room in it.
struct KeptFolder {
  OutputFolder folder;
  FolderMemory memory;

  explicit KeptFolder(const std::filesystem::path& at) : folder(at), memory(at) {}
};

}  // namespace

ExactOnDisk2::ExactOnDisk2(SumFolderRequest asked) : asked_(std::move(asked)) { asked_.bytes_beside = kBytesBeside; }

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
