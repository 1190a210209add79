// Rows of view factors in space, made of sums of pairs.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "geometry/exchange_matrix.h"
#include "geometry/exchange_request.h"
#include "geometry/row_ranges.h"
#include "geometry/space/exchange/exchange_report.h"
#include "geometry/space/exchange/narrow_by_rows.h"
#include "geometry/space/exchange/pair_source.h"
#include "geometry/space/prepared/element_table.h"
#include "geometry/space/prepared/prepared_scene.h"

namespace hottel {

// The rows of exact_exchange(), a range at a time, from sums that may be anywhere.
//
//   (1) entries, their bounds and guarantees are those of exact_exchange(), bit for bit, however rows are cut into
//       ranges; so is the report
//   (2) everything is refused before any range is loaded
//   (3) where there is one range its pairs are asked for once
// COST: all pairs are read once to know where rows begin, once more where bounds are proven, as rows narrow them, and
// once for each load; a range that was read last is not read again. The memory of one range.
class MeasuredRows3 final : public RowRanges {
 public:
  // is_chosen: by element, the sky last: whose rows are asked for. without_sky: pairs with the sky that could not be
  // measured, by i. Throws as ExchangeRows3::matrix().
  // REQUIRES that scene, table, request and pairs outlive this; what pairs of groups exchange alone where visibilities
  // are wanted.
  MeasuredRows3(const PreparedScene3& prepared, const ElementTable3& table, const ExchangeRequest& request,
                std::vector<char> is_chosen, PairSource3& pairs, std::vector<FailedPair3> without_sky,
                ExchangeReport3& report);

  std::size_t count() const override { return pairs_.cuts().count(); }
  std::span<const std::size_t> begins() const override { return begins_; }
  const ExchangeMatrix& matrix() const override { return matrix_; }
  RowRange load(std::size_t k) override;

  // What is guaranteed of all entries: the weakest there is.
  Guarantee guarantee() const { return guarantee_; }
  // The rows that were loaded last, and what they were made of is dropped: the matrix, where there is one range.
  ExchangeMatrix take_matrix();

 private:
  // What is found while pairs are read for the first time.
  struct FirstReading {
    std::vector<FailedPair3> failures;
    std::optional<SkyByClosure> sky;
  };
  struct Held {
    std::size_t number;
    RowRange rows;
    std::vector<PairSum3> pairs;  // ascending
    bool is_narrowed = false;
  };

  Held& hold(std::size_t k, FirstReading* reading = nullptr);
  void tell_skies(Held& held, FirstReading* reading) const;
  void count(const Held& held, ExchangeReport3& report);
  void narrow(ExchangeReport3& report);
  bool is_enclosed(const PairSum3& pair) const;
  bool has_row(std::uint32_t label) const { return is_chosen_[label] != 0 && table_.has_row(label); }
  bool has_all_rows() const;
  template <class Visit>
  void for_each_entry(const Held& held, const Visit& visit) const;

  const PreparedScene3& prepared_;
  const ElementTable3& table_;
  const ExchangeRequest& request_;
  std::vector<char> is_chosen_;
  PairSource3& pairs_;
  std::vector<FailedPair3> without_sky_;
  double told_;  // an exchange area in m², or squares of the unit of the scene, over the measure of a pair
  std::vector<std::size_t> begins_;
  std::optional<RowBounds3> narrowing_;  // where some pair becomes narrower
  std::optional<Held> held_;
  Guarantee guarantee_ = Guarantee::kEstimated;
  ExchangeMatrix matrix_;
};

// The factor of a pair from one of its elements, and its bounds, as rows have them. REQUIRES a pair that is not 0.
Enclosure factor_bounds_3(const ElementTable3& table, const PairSum3& pair, std::uint32_t from);
double factor_of_3(const ElementTable3& table, const PairSum3& pair, std::uint32_t from, const Enclosure& bounds);

}  // namespace hottel
