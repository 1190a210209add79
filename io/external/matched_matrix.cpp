#include "io/external/matched_matrix.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>

#include "geometry/name.h"
#include "geometry/near_names.h"
#include "kernel/rational.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

constexpr std::uint32_t kUnused = std::numeric_limits<std::uint32_t>::max();

// What a square matrix without names may be of: the elements that the rows and columns stand for, the sky by the number
// of elements.
struct SizeMeaning {
  std::string words;                  // "all faces and the sky"
  std::vector<std::uint32_t> places;  // empty: of faces that the scene divides, which are not compared
  double asymmetry = 0;               // of A_i F_ij over all pairs of rows, from 0 to 1
};

// What a row may be of.
struct Side {
  std::uint32_t place = 0;
  double area = 0;
  bool has_material = false;
};

// The faces of elements that follow each other.
std::vector<Side> whole_faces(const std::vector<Element>& elements) {
  std::vector<Side> faces;
  const Element* before = nullptr;
  for (const Element& element : elements) {
    if (!before || before->surface != element.surface || before->is_back != element.is_back) faces.emplace_back();
    faces.back().area += element.area.value;
    faces.back().has_material = element.material.has_value();
    before = &element;
  }
  return faces;
}

// How far A_i F_ij is from the same both ways, of all that is exchanged between rows; the sky and black backs aside.
double asymmetry(const ExternalMatrix& external, const std::vector<Side>& sides) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, double> differences;
  double sum = 0;
  for (const ExternalEntry& entry : external.entries) {
    if (entry.row >= sides.size() || entry.column >= sides.size() || entry.row == entry.column) continue;
    if (!sides[entry.row].has_material || !sides[entry.column].has_material) continue;
    const double exchange = sides[entry.row].area * entry.value;
    sum += std::abs(exchange);
    differences[std::minmax(entry.row, entry.column)] += entry.row < entry.column ? exchange : -exchange;
  }
  double difference = 0;
  for (const auto& each : differences) difference += std::abs(each.second);
  return sum > 0 ? difference / sum : 0;
}

// Returns what a square matrix of this size may be of, in this order: all elements, with the sky, those with a
// material, with the sky; where the scene divides faces, the same four of whole faces. COST: a sort of the entries for
// each.
std::vector<SizeMeaning> size_meanings(const ExternalMatrix& external, const std::vector<Element>& elements) {
  std::vector<Side> parts;
  for (const Element& element : elements)
    parts.push_back({static_cast<std::uint32_t>(parts.size()), element.area.value, element.material.has_value()});
  const std::vector<Side> wholes = whole_faces(elements);
  const bool is_divided = wholes.size() < parts.size();
  const char* const noun = is_divided ? "elements" : "faces";
  std::vector<SizeMeaning> meanings;
  const auto add = [&](std::vector<Side> sides, bool is_whole, bool has_all, bool has_sky) {
    if (!has_all) std::erase_if(sides, [](const Side& side) { return !side.has_material; });
    if (sides.size() + (has_sky ? 1 : 0) != external.rows) return;
    SizeMeaning meaning;
    meaning.words = std::string(has_all ? "all " : "the ") + (is_whole ? "undivided faces" : noun) +
                    (has_all ? "" : " with a material") + (has_sky ? " and the sky" : "");
    meaning.asymmetry = asymmetry(external, sides);
    if (!is_whole)
      for (const Side& side : sides) meaning.places.push_back(side.place);
    if (!is_whole && has_sky) meaning.places.push_back(static_cast<std::uint32_t>(elements.size()));
    for (const SizeMeaning& other : meanings)
      if (!is_whole && other.places == meaning.places) return;
    meanings.push_back(std::move(meaning));
  };
  for (const bool is_whole : {false, true})
    for (const bool has_all : {true, false})
      for (const bool has_sky : {false, true})
        if (!is_whole || is_divided) add(is_whole ? wholes : parts, is_whole, has_all, has_sky);
  return meanings;
}

// Which element each row and column of a file is; kUnused where none.
struct Places {
  std::vector<std::uint32_t> row, column;
  std::string note;  // where the size of the file has more than one meaning
};

class Matching {
 public:
  Matching(const ExternalMatrix& external, const std::vector<Element>& elements)
      : external_(external), elements_(elements), sky_(static_cast<std::uint32_t>(elements.size())) {
    for (std::uint32_t i = 0; i < sky_; ++i)
      if (elements[i].material) with_material_.push_back(i);
  }

  Places places() const {
    if (external_.column_names.empty() && !external_.is_list) return by_order();
    Places places{by_name(external_.row_names), by_name(external_.column_names), ""};
    if (!external_.is_list) {
      require_all(places.row, "row");
      require_all(places.column, "column");
    }
    return places;
  }

 private:
  std::vector<std::uint32_t> by_name(const std::vector<ExternalName>& names) const;
  void require_all(const std::vector<std::uint32_t>& places, const char* what) const;
  Places by_order() const;
  std::optional<Places> by_best_meaning() const;
  std::vector<std::uint32_t> in_order(std::uint32_t size) const;

  const ExternalMatrix& external_;
  const std::vector<Element>& elements_;
  const std::uint32_t sky_;
  std::vector<std::uint32_t> with_material_;
};

std::vector<std::uint32_t> Matching::by_name(const std::vector<ExternalName>& names) const {
  std::unordered_map<std::string, std::uint32_t> index{{"sky", sky_}};
  for (std::uint32_t i = 0; i < sky_; ++i) index.emplace(elements_[i].name, i);
  std::vector<std::uint32_t> places;
  std::vector<std::string> unknown;
  int line = 0;
  for (const ExternalName& name : names) {
    const auto found = index.find(name.name);
    places.push_back(found == index.end() ? kUnused : found->second);
    if (found != index.end()) continue;
    if (unknown.empty()) line = name.line;
    unknown.push_back(name.name);
  }
  if (unknown.empty()) return places;
  std::vector<std::string> known;
  for (const std::uint32_t i : with_material_) known.push_back(elements_[i].name);
  std::vector<std::string> hints = near_name_hints(unknown.front(), known);
  hints.push_back("its faces are " + listed_names(known));
  if (index.contains(unknown.front() + "#0"))
    hints.push_back("the scene divides its faces: `hottel factors --per element` writes them as they are compared");
  throw InputError({external_.names_file, line}, "the scene has no face " + listed_names(unknown), std::move(hints));
}

void Matching::require_all(const std::vector<std::uint32_t>& places, const char* what) const {
  std::vector<char> is_there(sky_ + 1, 0);
  for (const std::uint32_t place : places) is_there[place] = 1;
  std::vector<std::string> missing;
  for (const std::uint32_t i : with_material_)
    if (!is_there[i]) missing.push_back(elements_[i].name);
  if (!missing.empty())
    throw InputError({external_.names_file, 0}, fmt::format("has no {} of the face {}", what, listed_names(missing)));
}

// The elements that `size` rows or columns stand for; empty when it fits none.
std::vector<std::uint32_t> Matching::in_order(std::uint32_t size) const {
  std::vector<std::uint32_t> places;
  if (size == sky_ || size == sky_ + 1)
    for (std::uint32_t i = 0; i < sky_; ++i) places.push_back(i);
  else if (size == with_material_.size() || size == with_material_.size() + 1)
    places = with_material_;
  else
    return {};
  if (places.size() < size) places.push_back(sky_);
  return places;
}

// Of a square matrix whose size has several meanings the one in which A F is the most symmetric; of equal ones the
// first.
std::optional<Places> Matching::by_best_meaning() const {
  if (external_.rows != external_.columns) return std::nullopt;
  const std::vector<SizeMeaning> meanings = size_meanings(external_, elements_);
  const SizeMeaning* best = nullptr;
  for (const SizeMeaning& each : meanings)
    if (!each.places.empty() && (!best || each.asymmetry < best->asymmetry)) best = &each;
  if (!best || meanings.size() < 2) return std::nullopt;
  Places places{best->places, best->places, ""};
  for (const SizeMeaning& each : meanings)
    if (&each != best)
      places.note += fmt::format("{}{} (A F would be off its transpose by {:.2g})", places.note.empty() ? "" : ", ",
                                 each.words, each.asymmetry);
  places.note = fmt::format(
      "without names {0} x {0} is taken for {1} (A F is off its transpose by {2:.2g} of it); it may "
      "be {3}, and names in {4}.faces.csv settle it",
      external_.rows, best->words, best->asymmetry, places.note, external_.file);
  return places;
}

Places Matching::by_order() const {
  if (auto places = by_best_meaning()) return *places;
  Places places{in_order(external_.rows), in_order(external_.columns), ""};
  if (!places.row.empty() && !places.column.empty() && external_.columns >= external_.rows) return places;
  const std::size_t n = sky_, m = with_material_.size();
  const auto sizes = [](std::size_t k) { return fmt::format("{0} x {0}, {0} x {1}, {1} x {1}", k, k + 1); };
  throw InputError(
      {external_.file, 0},
      fmt::format("is {} x {}, which does not fit the scene's {} faces, {} of them with a material", external_.rows,
                  external_.columns, n, m),
      {"without names, faces are taken in the order of the scene: " + sizes(m) + (m == n ? "" : ", " + sizes(n)),
       "names stand in the first row and column of a csv, or in " + external_.file + ".faces.csv"});
}

// Areas that the file gives and the scene does not have: a sign of another order or unit.
void compare_areas(const ExternalMatrix& external, const Places& places, const std::vector<Element>& elements,
                   MethodReport& report) {
  constexpr double kSixDigits = 1e-5;
  std::vector<std::string> different;
  for (std::size_t k = 0; k < external.areas.size(); ++k) {
    if (places.row[k] >= elements.size()) continue;
    const Element& element = elements[places.row[k]];
    if (std::abs(external.areas[k] - element.area.value) > kSixDigits * element.area.value)
      different.push_back(fmt::format("{} ({} in the file, {} in the scene)", element.name, shortest(external.areas[k]),
                                      shortest(element.area.value)));
  }
  if (!different.empty())
    report.notes.push_back("areas differ, as if the order of the faces or the unit of length were another: " +
                           listed_names(different));
}

// What was read and is not used, and what the file has no place for (a gap, where light goes or not); a list has one
// for whatever it names.
void note_gaps(const ExchangeMatrix& matrix, const std::vector<std::uint32_t>& unused_rows, bool is_list,
               const WrittenFactors& written, MethodReport& report) {
  std::vector<std::string> names;
  for (const std::uint32_t i : unused_rows) names.push_back(matrix.name(i));
  if (!names.empty()) report.notes.push_back("rows of faces without a material are not used: " + listed_names(names));
  if (!is_list && !written.has_column[matrix.sky()])
    report.gaps.push_back("there is no column for the sky: what rows lack of 1 is not counted as going there");
  names.clear();
  for (std::uint32_t i = 0; i < matrix.size(); ++i)
    if (!is_list && !written.has_column[i]) names.push_back(matrix.elements()[i].name);
  if (!names.empty()) report.gaps.push_back("there are no columns for " + listed_names(names));
  report.notes.insert(report.notes.end(), report.gaps.begin(), report.gaps.end());
  std::size_t negative = 0;
  for (std::uint32_t i = 0; i < matrix.size(); ++i)
    for (const FactorEntry& entry : matrix.row(i)) negative += entry.factor.value < 0;
  if (negative > 0)
    report.notes.push_back(negative == 1 ? "1 factor is negative" : fmt::format("{} factors are negative", negative));
}

}  // namespace

ExchangeMatrix match_external_matrix(const ExternalMatrix& external, std::vector<Element> elements,
                                     MethodReport& report) {
  const Places places = Matching(external, elements).places();
  ExchangeMatrix matrix(std::move(elements), Guarantee::kEstimated);
  if (!places.note.empty()) report.notes.push_back(places.note);
  compare_areas(external, places, matrix.elements(), report);

  std::vector<ExternalEntry> entries;
  std::vector<std::uint32_t> unused_rows;
  for (ExternalEntry entry : external.entries) {
    entry.row = places.row[entry.row];
    entry.column = places.column[entry.column];
    const bool is_used = entry.row != matrix.sky() && matrix.has_row(entry.row);
    if (is_used)
      entries.push_back(entry);
    else if (unused_rows.empty() || unused_rows.back() != entry.row)
      unused_rows.push_back(entry.row);
  }
  std::sort(entries.begin(), entries.end(), [](const ExternalEntry& a, const ExternalEntry& b) {
    return a.row != b.row ? a.row < b.row : a.column < b.column;
  });
  std::vector<std::size_t> begin(matrix.size() + 1, 0);
  FactorEntries factors;
  for (const ExternalEntry& entry : entries) {
    ++begin[entry.row + 1];
    factors.push_back({entry.column, {entry.value, 0}, std::numeric_limits<double>::quiet_NaN()});
  }
  for (std::uint32_t i = 0; i < matrix.size(); ++i) begin[i + 1] += begin[i];
  matrix.assign(std::move(begin), std::move(factors));

  WrittenFactors written{external.digits, std::vector<char>(matrix.size() + 1, 0), {}};
  for (std::size_t k = 0; k < places.column.size(); ++k)
    written.has_column[places.column[k]] = !external.is_list || external.has_column[k];
  if (external.is_list) {
    written.has_row.resize(matrix.size() + 1, 0);
    for (std::uint32_t i = 0; i < matrix.size(); ++i)
      written.has_column[i] = static_cast<char>(written.has_column[i] || matrix.has_row(i));
    for (std::size_t k = 0; k < places.row.size(); ++k) written.has_row[places.row[k]] = external.has_row[k];
  }
  report.notes.insert(report.notes.end(), external.notes.begin(), external.notes.end());
  note_gaps(matrix, unused_rows, external.is_list, written, report);
  report.written = std::move(written);
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    if (!matrix.has_row(i) || (!report.written->has_row.empty() && !report.written->has_row[i])) continue;
    double sum = 0;
    for (const FactorEntry& entry : matrix.row(i)) sum += entry.factor.value;
    report.row_defect = std::max(report.row_defect, std::abs(sum - 1));
  }
  return matrix;
}

}  // namespace hottel
