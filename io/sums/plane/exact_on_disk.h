// Exact view factors of a scene in the plane, for a matrix that is larger than memory.
//
//   SimulationRequest2 request;
//   request.method = std::make_shared<const ExactOnDisk2>(SumFolderRequest{.folder = "/scratch"});
//   request.memory = 4'000'000'000;
//   const Simulation2 simulation(read_scene_2("town.json"), request);
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "io/sums/plane/sum_folder.h"
#include "solver/plane/methods/exchange_method.h"

namespace hottel {

// The method `exact`, by sums in files (SumFolder2). Its matrix stands in files too, and what a solver makes of its
// entries (ExchangeMatrix::memory()): the system keeps in memory what is used, and nothing is left when the process
// ends.
//
//   (1) the matrix is that of exact_exchange(), bit for bit
//   (2) beside the prepared scene sums take the memory of the request; what else grows with the pairs is on disk
//   (3) sums that stay do so until forget(), the others until they are a matrix
// Throws what SumFolder2 throws, before the sweep where the disk has no room (disk_for_radiosities_2). COST: that of
// the exact method.
class ExactOnDisk2 final : public ExchangeMethod2 {
 public:
  // Of the request the folder, and whether sums stay there.
  explicit ExactOnDisk2(SumFolderRequest asked);

  const MethodInfo& info() const override { return info_; }
  ExchangeMatrix compute(const PreparedScene2& prepared, const ExchangeRequest& request,
                         MethodReport& report) const override;
  std::optional<double> declared_error(const PreparedScene2&) const override { return 0; }
  bool keeps_pairs_on_disk() const override { return true; }

  // The bytes that sums took on disk in the last call.
  std::uint64_t bytes_of_sums() const { return bytes_of_sums_; }
  // The results are whole: the sums are of no more use.
  void forget() const;

 private:
  SumFolderRequest asked_;
  mutable std::vector<std::filesystem::path> left_;  // of sums, by the last call
  mutable std::uint64_t bytes_of_sums_ = 0;
  MethodInfo info_{"exact", "exact", 0, Guarantee::kExact, "docs/design/plane/exchange.md"};
};

// The disk that sums, matrix and solver take of so many pairs, in bytes: at the most at one time.
std::uint64_t disk_for_radiosities_2(std::uint64_t pairs, bool sums_stay);

}  // namespace hottel
