// View factors of a scene: what every method, exact or approximate, returns, and what radiosities are computed from.
//
//   const Simulation2 simulation(read_scene_2("scenes/analytic/strip_obstructed.json"));
//   const auto factors = simulation.factors();
//   const ExchangeMatrix& matrix = factors->matrix;
//   std::printf("F = %.17g\n", matrix.factor("bottom", "top").value);
//   for (std::uint32_t i = 0; i < matrix.size(); ++i)
//     for (const FactorEntry& entry : matrix.row(i))
//       std::printf("%s -> %s: %.17g\n", matrix.name(i).c_str(), matrix.name(entry.to).c_str(), entry.factor.value);
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "geometry/element.h"
#include "geometry/factor_entries.h"
#include "kernel/enclosure.h"

namespace hottel {

// View factors F_ij by rows, sparse.
//
//   (1) the entries of a row ascend by `to`; the sky is the last column, index sky()
//   (2) an entry that is kExact is correctly rounded, its enclosure at most one ulp wide; where both entries of a pair
//       are kExact, the two real numbers that they round satisfy A_i F_ij = A_j F_ji
//   (3) where an entry is kEnclosed, bounds() contain the real factor and the double
//   (4) where an entry is kEstimated, bounds() contain the real factor; the double is an estimate without proof
//   (5) only elements with a material and an area have a row; pairs that exchange nothing have no entry. Conversely,
//       a pair without an entry provably exchanges nothing, unless all entries are estimated, or its row was not chosen
//       (ExchangeRequest::rows): such a row is empty, and says nothing
//   (6) where guarantee() is kExact or has_closed_rows(), the real factors of each row that was chosen sum to 1 with
//       that of the sky
//   (7) rows are compressed: entry k of row i stands at begins()[i] + k of columns(), factors(), visibilities(), and of
//       measures, bounds and guarantees if the matrix has these
// COST: 20 bytes per entry, two entries per visible pair of elements with materials. Each entry takes 1 byte more if
// entries are exact, 8 with measures, 16 with bounds, 1 if guarantees differ between entries.
class ExchangeMatrix {
 public:
  // The most bytes that one entry takes, not counting measures, bounds and guarantees.
  static constexpr std::size_t kBytesAnEntry = sizeof(std::uint32_t) + 2 * sizeof(double) + 1;

  // A matrix without elements: the sky alone.
  ExchangeMatrix() = default;
  // A matrix of these elements without entries: every factor is 0 until assign(). `guarantee` holds for every entry,
  // unless assign() gets one for each.
  ExchangeMatrix(std::vector<Element> elements, Guarantee guarantee)
      : elements_(std::move(elements)), begin_(elements_.size() + 1, 0), guarantee_(guarantee) {}

  const std::vector<Element>& elements() const { return elements_; }
  // The name of an element, or of the sky: "sky". Throws ContractViolation for a number that is neither.
  const std::string& name(std::uint32_t column) const;
  std::uint32_t size() const { return static_cast<std::uint32_t>(elements_.size()); }
  std::uint32_t sky() const { return size(); }

  // Returns the guarantee that holds for every entry: the weakest of them all.
  Guarantee guarantee() const { return guarantee_; }
  // Returns what is guaranteed of the k-th entry of row i.
  Guarantee guarantee(std::uint32_t i, std::size_t k) const {
    return guarantees_.empty() ? guarantee_ : guarantees_[begin_[i] + k];
  }

  // True iff the element has a material and an area.
  bool has_row(std::uint32_t i) const {
    const Rounded& area = elements_[i].area;
    return elements_[i].material.has_value() && (area.value > 0 || area.side > 0);  // the double may underflow
  }
  // The entries of row i, ascending by `to`; empty where the element has no row, or exchanges nothing, or its row was
  // not chosen. REQUIRES i < size(), for the sky has no row; has_row() and all that take a row by number require it
  // too.
  FactorRow row(std::uint32_t i) const {
    const std::size_t b = begin_[i];
    return {entries_.columns_.data() + b, entries_.factors_.data() + b,
            entries_.sides_.empty() ? nullptr : entries_.sides_.data() + b, entries_.visibilities_.data() + b,
            begin_[i + 1] - b};
  }
  // True iff promise_closed_rows() was called: the maker of the matrix promises (6). False of exact matrices too, which
  // need no promise.
  bool has_closed_rows() const { return has_closed_rows_; }
  void promise_closed_rows() { has_closed_rows_ = true; }
  std::size_t entry_count() const { return entries_.size(); }

  // The arrays themselves, for scipy.sparse, HDF5, PETSc and the like. They live as long as the matrix.
  std::span<const std::size_t> begins() const { return begin_; }  // size() + 1 of them; none of a default matrix
  std::span<const std::uint32_t> columns() const { return entries_.columns_; }
  std::span<const double> factors() const { return entries_.factors_; }
  // Vis = S / S0 of each entry; as many as factors. Exactly 1 iff nothing hides a part. In the plane the nearest
  // double, but 0 or 1 only where Vis is; in space as good as S and S0, without bounds. NaN where they were not asked
  // for, and of methods that have none; the exact methods always give that of the sky, which is F itself.
  std::span<const double> visibilities() const { return entries_.visibilities_; }
  // Where the arrays are stored: null for the heap. A caller who makes arrays of this size
  // should store them there too.
  const std::shared_ptr<const FolderMemory>& memory() const { return memory_; }

  // The direct exchange area S(from, to) = A_from F(from, to) for each entry of the row [m²; in the plane m; as
  // Element::area]. Correctly rounded where the entry is kExact, else within the tolerance, as the factor is. Empty
  // unless measures were asked for, of the exact method.
  std::span<const double> measures(std::uint32_t i) const {
    return measures_.empty() ? std::span<const double>()
                             : std::span(measures_).subspan(begin_[i], begin_[i + 1] - begin_[i]);
  }

  // Returns proven bounds of the k-th entry of row i: at most one ulp apart if it is exact; those given to
  // assign() if it is enclosed or estimated; [0, 1] if it is estimated and none were given.
  Enclosure bounds(std::uint32_t i, std::size_t k) const;

  // Returns F(from, to); 0 where there is no entry. Only of an entry that is kExact do `side` and enclosure() hold; of
  // others `side` is 0 and tells nothing, and bounds() has what is proven. COST: O(log n) for n entries of the row.
  Rounded factor(std::uint32_t from, std::uint32_t to) const;
  // The same by name. Throws UnknownName where there is no such element, UsageError where `from` is the sky or has no
  // row.
  Rounded factor(const std::string& from, const std::string& to) const;
  // Returns the index of the first element of that name; sky() for "sky"; nothing when there is none. COST: linear.
  std::optional<std::uint32_t> find(const std::string& name) const;

  // Fills the matrix: entries by rows, row i in [begin[i], begin[i + 1]). Measures, bounds and guarantees are lists
  // with one member for each entry, or empty. Without guarantees every entry has that of the constructor. Bounds are
  // required for enclosed entries, and ignored for exact ones. Throws ContractViolation, which names the row where one
  // is at fault,
  //
  //   where a row or column is not one of this matrix, or they do not ascend,
  //   where an exact factor is not positive,
  //   where bounds of an enclosed factor are not 0 <= lower <= double <= upper, or of an estimated one not
  //   0 <= lower <= upper,
  //   where a list is neither empty nor as long as the entries.
  //
  // The matrix must not be used after such a throw.
  void assign(std::vector<std::size_t> begin, FactorEntries entries, std::vector<double> measures = {},
              std::vector<Enclosure> bounds = {}, std::vector<Guarantee> guarantees = {});

 private:
  void require_order() const;
  void require_lists() const;
  void require_guarantee(std::uint32_t i, std::size_t k) const;

  std::vector<Element> elements_;
  std::vector<std::size_t> begin_;
  FactorEntries entries_;  // without sides where all are 0
  std::shared_ptr<const FolderMemory> memory_;
  std::vector<double> measures_;
  std::vector<Enclosure> bounds_;      // empty: none but what the entries say
  std::vector<Guarantee> guarantees_;  // empty: all alike
  Guarantee guarantee_ = Guarantee::kEstimated;
  bool has_closed_rows_ = false;
};

// The place of an element (or of the sky, matrix.sky()) by name. Throws UnknownName when there is none.
std::uint32_t require_element(const ExchangeMatrix& matrix, const std::string& name);

}  // namespace hottel
