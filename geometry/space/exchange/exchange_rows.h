// View factors of a scene in space row by row, in any order.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "geometry/exchange_matrix.h"
#include "geometry/exchange_request.h"
#include "geometry/space/exchange/exchange_report.h"
#include "geometry/space/exchange/measured_rows.h"
#include "geometry/space/exchange/pair_source.h"
#include "geometry/space/exchange/pair_sum.h"
#include "geometry/space/prepared/element_table.h"
#include "geometry/space/prepared/prepared_scene.h"

namespace hottel {

// Computes a matrix row by row, in any order: the pairs of some elements with all others, then of others, until all are
// there.
//
//   (1) a row that has come holds the factors of that element to all that it sees
//   (2) matrix() is that of exact_exchange, bit for bit, in whatever order and parts rows came; so are the counts
//   (3) of the rows that the request asks for alone, if not of all: others never come, and have no entries. Those that
//       come are the same, bit for bit
//   (4) an element whose pair with the sky cannot be measured has none until all rows are there (take_rest_for_sky);
//       where the sky is told by closure no element has any but those that are checked
//   (5) where a keeper is given it gets the pairs as they are done, and they are nowhere else: what add() returns and
//       pairs() are empty
// Throws as exact_exchange does, of pairs with the sky at the end. REQUIRES that the scene outlives it.
class ExchangeRows3 {
 public:
  // Of the request progress is not called. REQUIRES that the keeper, if any, outlives this.
  ExchangeRows3(const PreparedScene3& prepared, const ExchangeRequest& request, PairKeeper3* keeper = nullptr);
  ExchangeRows3(const ExchangeRows3&) = delete;

  const ElementTable3& table() const { return table_; }
  // Whether the element has a row that is asked for, and it is not there yet.
  bool is_missing(std::uint32_t label) const { return is_asked(label) && has_come_[label] == 0; }
  std::uint32_t missing() const { return missing_; }

  // Measures all pairs of these elements that were not measured before. Returns them, until the next call. progress:
  // fraction done, from any thread; may throw to stop: then nothing has come.
  // COST: that of the pairs, and some ns for each pair of elements that there is.
  std::span<const PairSum3> add(std::span<const std::uint32_t> labels,
                                const std::function<void(double)>& progress = {});
  // From now on add() hands on the pairs that are done while it measures others, those of elements of several patches
  // with what they would exchange alone: every few seconds, and before it returns or throws. Not those that were taken.
  void hand_on(PairSink3 sink, std::chrono::duration<double> between = std::chrono::seconds(2));

  // All that are missing.
  void add_all(const std::function<void(double)>& progress = {});

  // Takes pairs that were measured before, by another object of the same scene and request: they are not measured
  // again, and not among those that add() returns. known: which pairs these are; those of them that are not in the list
  // exchange nothing. Where it has all pairs, all rows have come. Those with the sky are integrals, however the sky is
  // told here. REQUIRES that nothing was added or taken before.
  void take(std::vector<PairSum3> pairs, PairRanges known);
  // Where visibilities are wanted: measures elements of several patches as if nothing else were there, all pairs that
  // have come and not again. matrix() does so too.
  void measure_alone();
  // All pairs that were taken or have come, in no order. REQUIRES that matrix() was not called.
  std::span<const PairSum3> pairs() const { return pairs_; }

  // F(from, to) of a pair, as a double in its matrix.
  double factor(const PairSum3& pair, std::uint32_t from) const;

  // As element_corners.
  std::vector<std::vector<std::array<double, 3>>> corners() const;

  // REQUIRES missing() == 0, and no keeper; may be called once.
  ExchangeMatrix matrix(ExchangeReport3* report = nullptr);
  // The rows of that matrix, a range at a time, of what the keeper has. REQUIRES missing() == 0, and that this outlives
  // them; may be called once. Throws as matrix() does.
  std::unique_ptr<MeasuredRows3> rows(ExchangeReport3* report = nullptr);

 private:
  bool is_asked(std::uint32_t label) const { return is_chosen_[label] != 0 && table_.has_row(label); }
  bool is_by_closure() const { return request_.sky == SkyBy::kClosure; }
  void measure(const PairTurn3& turn, const std::function<void(double)>& progress);
  void measure_skies();
  std::vector<char> skies_left();
  void keep(std::span<const PairSum3> pairs);
  std::vector<FailedPair3> failed_skies();
  void measure_alone(std::span<PairSum3> pairs) const;

  const PreparedScene3& prepared_;
  const ExchangeRequest request_;
  PairKeeper3* const keeper_;
  const std::uint64_t most_;  // pairs
  const ElementTable3& table_;
  ExchangeReport3 report_;
  std::vector<char> is_chosen_;  // by element, the sky last: whose rows are asked for
  std::vector<char> has_come_;   // the same
  std::vector<char> checks_;     // the same: whose sky is integrated to compare, where it is told by closure
  bool has_skies_ = false;       // by closure: what has to be integrated besides has been
  std::uint32_t missing_ = 0;
  std::vector<PairSum3> pairs_;
  std::uint64_t kept_ = 0;  // pairs that the keeper has
  PairRanges known_;        // from elsewhere
  PairSink3 sink_;          // gets what is done
  std::chrono::duration<double> between_{2};
  std::vector<FailedPair3> without_sky_;  // pairs with the sky that could not be measured
};

// Says which rows come first, and is told when they have come.
class RowWatch3 {
 public:
  virtual ~RowWatch3() = default;

  // Returns some elements whose rows are missing. REQUIRES that there are some.
  virtual std::vector<std::uint32_t> next(const ExchangeRows3& rows) = 0;
  // They have come, with these pairs.
  virtual void have_come(const ExchangeRows3& rows, std::span<const PairSum3> pairs) = 0;
};

}  // namespace hottel
