#include "solver/cached_pairs.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "kernel/support/failure.h"

namespace hottel {

std::string element_id(const Element& element) {
  return element.is_part() ? element.name + " of " + std::to_string(element.parts) : element.name;
}

std::vector<std::string> element_ids(const std::vector<Element>& elements) {
  std::vector<std::string> ids;
  ids.reserve(elements.size());
  for (const Element& element : elements) ids.push_back(element_id(element));
  return ids;
}

std::vector<ColumnRange> known_columns(const CachedRows& kept, const CachedRow& row, std::uint32_t elements) {
  std::vector<ColumnRange> result;
  if (row.row + std::size_t{1} >= kept.place.size()) return result;  // of the sky
  const std::uint32_t i = kept.place[row.row];
  if (i == CachedRows::kNoPlace) return result;
  for (const ColumnRange& range : row.known)
    for (std::uint32_t column = range.begin; column < range.end; ++column) {
      const std::uint32_t j = kept.place[column];
      if (j == CachedRows::kNoPlace) continue;
      const bool ascends = j >= i && j <= elements && (result.empty() || j >= result.back().end);
      if (!ascends) return {};
      if (!result.empty() && result.back().end == j)
        ++result.back().end;
      else
        result.push_back({j, j + 1});
    }
  return result;
}

namespace {

// Rows are kept when they take so many bytes: a fraction of a second of work.
constexpr std::size_t kBytesAtATime = std::size_t{1} << 22;

// What a byte before the numbers of a pair says of them.
constexpr std::uint8_t kForth = 1, kBack = 2, kBackIsFar = 4, kMeasure = 8;
constexpr int kVisibilityShift = 4, kSideShift = 6;
enum class Seen : std::uint8_t { kNone, kAll, kFactor, kPart };

constexpr std::uint64_t kSignBit = std::uint64_t{1} << 63;

// The place of a double among all doubles that are not negative; nothing of others.
std::optional<std::int64_t> place_of(double value) {
  const auto bits = std::bit_cast<std::uint64_t>(value);
  if (!std::isfinite(value) || (bits & kSignBit) != 0) return std::nullopt;
  return static_cast<std::int64_t>(bits);
}

// F(j, i) as it follows from F(i, j), nearly: S is the same.
double expected_back(double forth, double area_i, double area_j) { return forth * area_i / area_j; }

// One byte of both sides: -1, 0, 1 each.
std::uint8_t sides(const Rounded& a, const Rounded& b) {
  return static_cast<std::uint8_t>((a.side + 1) + 3 * (b.side + 1));
}

std::optional<FactorEntry> entry_of(const ExchangeMatrix& matrix, std::uint32_t from, std::uint32_t to,
                                    double* measure) {
  if (from == matrix.sky()) return std::nullopt;
  const FactorRow row = matrix.row(from);
  const auto place = row.place_of(to);
  if (!place) return std::nullopt;
  if (const auto measures = matrix.measures(from); !measures.empty()) *measure = measures[*place];
  return row[*place];
}

Seen seen_of(double visibility, double factor) {
  if (std::isnan(visibility)) return Seen::kNone;
  if (visibility == 1) return Seen::kAll;
  return visibility == factor ? Seen::kFactor : Seen::kPart;
}

bool is_same(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

void write_pair(const ExchangeMatrix& matrix, const std::optional<FactorEntry>& forth,
                const std::optional<FactorEntry>& back, std::uint32_t i, std::uint32_t j, std::optional<double> measure,
                NumberWriter& out) {
  const FactorEntry& known = forth ? *forth : *back;
  std::optional<std::int64_t> away;
  if (forth && back) {
    const auto expected =
        place_of(expected_back(forth->factor.value, matrix.elements()[i].area.value, matrix.elements()[j].area.value));
    const auto there = place_of(back->factor.value);
    if (expected && there && std::abs(*there - *expected) <= 127) away = *there - *expected;
  }
  const Seen seen = seen_of(known.visibility, known.factor.value);
  const Rounded none;
  const bool has_sides = (forth && forth->factor.side != 0) || (back && back->factor.side != 0);
  out.byte(static_cast<std::uint8_t>((forth ? kForth : 0) | (back ? kBack : 0) | (back && !away ? kBackIsFar : 0) |
                                     (measure ? kMeasure : 0) | (static_cast<int>(seen) << kVisibilityShift) |
                                     (has_sides ? 1 << kSideShift : 0)));
  if (has_sides) out.byte(sides(forth ? forth->factor : none, back ? back->factor : none));
  if (forth) out.number(forth->factor.value);
  if (away)
    out.byte(static_cast<std::uint8_t>(*away + 128));
  else if (back)
    out.number(back->factor.value);
  if (seen == Seen::kPart) out.number(known.visibility);
  if (measure) out.number(*measure);
}

// A pair before its elements are known: what is kept of F(j, i) then follows.
struct ReadPair : CachedFactors {
  std::optional<int> away;
};

ReadPair read_pair(NumberReader& in) {
  ReadPair pair;
  const std::uint8_t head = in.byte();
  pair.has_forth = (head & kForth) != 0;
  pair.has_back = (head & kBack) != 0;
  if ((head >> kSideShift & 1) != 0) {
    const std::uint8_t both = in.byte();
    pair.forth.side = static_cast<signed char>(both % 3 - 1);
    pair.back.side = static_cast<signed char>(both / 3 - 1);
  }
  if (pair.has_forth) pair.forth.value = in.number();
  if (pair.has_back && (head & kBackIsFar) == 0)
    pair.away = in.byte() - 128;
  else if (pair.has_back)
    pair.back.value = in.number();
  const double factor = pair.has_forth ? pair.forth.value : pair.back.value;
  switch (static_cast<Seen>(head >> kVisibilityShift & 3)) {
    case Seen::kNone:
      pair.visibility = std::numeric_limits<double>::quiet_NaN();
      break;
    case Seen::kAll:
      pair.visibility = 1;
      break;
    case Seen::kFactor:
      pair.visibility = factor;
      break;
    case Seen::kPart:
      pair.visibility = in.number();
      break;
  }
  if ((head & kMeasure) != 0) pair.measure = in.number();
  return pair;
}

}  // namespace

bool keep_matrix(const ExchangeMatrix& matrix, const PairRanges& known,
                 const std::function<void(std::span<const CachedRow>)>& keep) {
  const std::uint32_t n = matrix.size();
  // The columns from i on of each row i, whoever of both has a row.
  std::vector<std::vector<std::uint32_t>> columns(n);
  bool has_bounds = false;
  for (std::uint32_t i = 0; i < n; ++i)
    for (std::size_t k = 0; k < matrix.row(i).size(); ++k) {
      const std::uint32_t to = matrix.row(i)[k].to;
      if (to >= i)
        columns[i].push_back(to);
      else if (!matrix.has_row(to))
        columns[to].push_back(i);
      const Guarantee guarantee = matrix.guarantee(i, k);
      has_bounds = has_bounds || guarantee != matrix.guarantee() || guarantee == Guarantee::kEnclosed ||
                   (guarantee == Guarantee::kEstimated && matrix.bounds(i, k) != Enclosure{0, 1});
    }
  if (has_bounds) return false;
  // Of rows that are not symmetric the other one alone may have the entry.
  for (std::uint32_t i = 0; i < n; ++i)
    for (const FactorEntry& entry : matrix.row(i))
      if (entry.to < i && matrix.has_row(entry.to)) {
        double ignored = 0;
        if (!entry_of(matrix, entry.to, i, &ignored)) columns[entry.to].push_back(i);
      }
  std::vector<CachedRow> rows;
  std::size_t bytes = 0;
  for (std::uint32_t i = 0; i < n; ++i) {
    CachedRow row{.row = i, .known = known.missing(i), .to = {}, .numbers = {}};
    if (row.known.empty()) continue;
    std::ranges::sort(columns[i]);
    NumberWriter out(row.numbers);
    for (const std::uint32_t j : columns[i]) {
      if (known.has(i, j)) continue;
      double measure = 0;
      const bool has_measure = !matrix.measures(i).empty() || (j < n && !matrix.measures(j).empty());
      const std::optional<FactorEntry> forth = entry_of(matrix, i, j, &measure);
      const std::optional<FactorEntry> back = j == i ? std::nullopt : entry_of(matrix, j, i, &measure);
      if (forth && back && !is_same(forth->visibility, back->visibility)) return false;
      row.to.push_back(j);
      write_pair(matrix, forth, back, i, j, has_measure ? std::optional(measure) : std::nullopt, out);
    }
    bytes += row.numbers.size() + row.to.size();
    rows.push_back(std::move(row));
    if (bytes < kBytesAtATime) continue;
    keep(rows);
    rows.clear();
    bytes = 0;
  }
  if (!rows.empty()) keep(rows);
  return true;
}

std::optional<ExchangeMatrix> cached_matrix(const std::vector<CachedRows>& kept, const std::vector<Element>& elements,
                                            Guarantee guarantee, std::uint32_t what, PairRanges& known) {
  std::vector<ReadPair> pairs;
  take_pairs<ReadPair>(kept, known, pairs, read_pair);
  if (!known.has_all()) return std::nullopt;
  ExchangeMatrix matrix(elements, guarantee);
  const std::uint32_t sky = matrix.sky();
  for (ReadPair& pair : pairs) {
    if (!pair.away) continue;
    const double expected = expected_back(pair.forth.value, elements[pair.i].area.value, elements[pair.j].area.value);
    pair.back.value = std::bit_cast<double>(std::bit_cast<std::int64_t>(expected) + *pair.away);
  }
  std::ranges::sort(pairs, {}, [](const ReadPair& pair) { return std::pair(pair.i, pair.j); });
  std::vector<std::size_t> begin(elements.size() + 1, 0);
  for (const ReadPair& pair : pairs) {
    begin[pair.i + 1] += pair.has_forth ? 1 : 0;
    if (pair.has_back) ++begin[pair.j + 1];
  }
  for (std::size_t i = 0; i < elements.size(); ++i) begin[i + 1] += begin[i];
  const bool with_measures = (what & kKeptMeasures) != 0;
  FactorEntries entries(begin.back());
  std::vector<double> measures(with_measures ? begin.back() : 0);
  std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
  const auto set = [&](std::uint32_t from, std::uint32_t to, const Rounded& factor, const ReadPair& pair) {
    const bool is_seen = to == sky || (what & kKeptVisibilities) != 0;
    const std::size_t place = next[from]++;
    entries.set(place, {to, factor, is_seen ? pair.visibility : std::numeric_limits<double>::quiet_NaN()});
    if (with_measures) measures[place] = pair.measure;
  };
  for (const ReadPair& pair : pairs) {
    if (pair.has_forth) set(pair.i, pair.j, pair.forth, pair);
    if (pair.has_back) set(pair.j, pair.i, pair.back, pair);
  }
  matrix.assign(std::move(begin), std::move(entries), std::move(measures));
  return matrix;
}

}  // namespace hottel
