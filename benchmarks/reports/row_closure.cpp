// Sums the rows of scenes in space, the sky integrated, and holds how far they are from 1 against the errors that their
// entries state. Writes a table; exit code 1 where a row is farther off.
//
//   report_row_closure [TOLERANCE] SCENES...
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "geometry/space/exchange/exchange_rows.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "io/scene/scene_json.h"
#include "io/scene/space/vs3_reader.h"
#include "kernel/support/failure.h"
#include "kernel/support/stopwatch.h"

namespace hottel {
namespace {

// What the rows of a scene come to.
struct RowSums {
  std::uint64_t rows = 0, under_sky = 0, pairs = 0;
  double farthest = 0, stated = 0;  // from 1: the largest |sum - 1|, and what the entries of that row state
  double most = 0;                  // the largest quotient of both, of all rows
  double seconds = 0;
};

RowSums sums_of(const Scene3& scene, double tolerance) {
  constexpr double kRounding = 0x1p-52;  // of an area that is correctly rounded, and a sum
  const PreparedScene3 prepared = prepare(scene);
  Stopwatch watch;
  ExchangeRows3 rows(prepared,
                     {.granularity = Granularity::kElement, .wants_visibility = false, .tolerance = tolerance});
  rows.add_all();
  RowSums result;
  result.seconds = watch.lap();
  const ElementTable3& table = rows.table();
  std::vector<long double> sums(table.count(), 0), errors(table.count(), 0);
  std::vector<char> sees_sky(table.count(), 0);
  for (const PairSum3& pair : rows.pairs()) {
    if (pair.is_zero()) continue;
    ++result.pairs;
    const auto add = [&](std::uint32_t label) {
      sums[label] += pair.measure;
      errors[label] += pair.error;
    };
    add(pair.i);
    if (pair.j == table.sky())
      sees_sky[pair.i] = 1;
    else if (pair.j != pair.i)
      add(pair.j);
  }
  for (std::uint32_t i = 0; i < table.count(); ++i) {
    if (!table.has_row(i)) continue;
    ++result.rows;
    result.under_sky += sees_sky[i];
    const long double area = table.extent(i).value;
    const auto off = static_cast<double>(std::fabs(sums[i] - area) / area);
    const auto stated = static_cast<double>(errors[i] / area) + kRounding;
    result.most = std::max(result.most, off / stated);
    if (off < result.farthest) continue;
    result.farthest = off;
    result.stated = stated;
  }
  return result;
}

Scene3 scene_of(const std::string& file) { return is_vs3(file) ? read_vs3_3(file, nullptr).scene : read_scene_3(file); }

int run(double tolerance, const std::vector<std::string>& files) {
  fmt::print(
      "| scene | rows | under the sky | pairs | farthest from 1 | its entries state | most of what is stated | s |\n");
  fmt::print("|---|--:|--:|--:|--:|--:|--:|--:|\n");
  RowSums all;
  for (const std::string& file : files) {
    const RowSums sums = sums_of(scene_of(file), tolerance);
    fmt::print("| `{}` | {} | {} | {} | {:.1e} | {:.1e} | {:.2f} | {:.2f} |\n", file, sums.rows, sums.under_sky,
               sums.pairs, sums.farthest, sums.stated, sums.most, sums.seconds);
    std::fflush(stdout);
    all.rows += sums.rows;
    all.under_sky += sums.under_sky;
    all.pairs += sums.pairs;
    all.most = std::max(all.most, sums.most);
    all.farthest = std::max(all.farthest, sums.farthest);
  }
  fmt::print("| all | {} | {} | {} | {:.1e} | | {:.2f} | |\n", all.rows, all.under_sky, all.pairs, all.farthest,
             all.most);
  return all.most <= 1 ? 0 : 1;
}

}  // namespace
}  // namespace hottel

int main(int argc, char** argv) {
  std::vector<std::string> files(argv + 1, argv + argc);
  double tolerance = 1e-9;
  if (!files.empty())
    if (char* end = nullptr; std::strtod(files[0].c_str(), &end) > 0 && *end == 0) {
      tolerance = std::strtod(files[0].c_str(), nullptr);
      files.erase(files.begin());
    }
  if (files.empty()) {
    fmt::print(stderr, "report_row_closure [TOLERANCE] SCENES...\n");
    return 2;
  }
  try {
    return hottel::run(tolerance, files);
  } catch (const std::exception& error) {
    fmt::print(stderr, "report_row_closure: {}\n", error.what());
    return 2;
  }
}
