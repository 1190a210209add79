#include "cli/deck_requests.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "geometry/name.h"

namespace hottel {
namespace {

constexpr std::size_t kFactorsInALine = 10;

// The elements of the front of a surface, or of its group.
std::vector<std::uint32_t> labels_of(const FactorTable& table, std::uint32_t surface) {
  std::vector<std::uint32_t> labels;
  for (std::uint32_t i = 0; i < table.matrix.size(); ++i) {
    const Element& element = table.matrix.elements()[i];
    const auto& surfaces = table.scene.surfaces;
    const bool is_own = table.granularity == Granularity::kGroup
                            ? surfaces[element.surface].group == surfaces[surface].group
                            : element.surface == surface;
    if (is_own && !element.is_back) labels.push_back(i);
  }
  return labels;
}

// The surface by name, and the group that stands for it.
std::string told(const FactorTable& table, std::uint32_t surface) {
  const Surface& own = table.scene.surfaces[surface];
  const std::string& group = table.scene.groups[own.group].name;
  return quoted_name(own.name) + (table.granularity == Granularity::kGroup && group != own.name
                                      ? ", which is combined in " + quoted_name(group)
                                      : "");
}

void take_row(const FactorsOptions& options, const Streams& streams, FactorTable& table) {
  const DeckOutput3& deck = options.deck;
  if (!deck.row) return;
  const FactorFormat format = options.format();
  if (!options.matrix.empty() || format == FactorFormat::kNpy) {
    streams.note(fmt::format("row and col of the deck are for lists and View3D's files: {} has all",
                             options.matrix.empty() ? ".npy" : "--matrix"));
    return;
  }
  if (!options.rows.empty()) {
    streams.note("row and col of the deck are not obeyed: --rows says which rows are listed");
    return;
  }
  table.only_rows = labels_of(table, *deck.row);
  if (deck.column) table.only_columns = labels_of(table, *deck.column);
  streams.note("row: of all rows that of " + told(table, *deck.row) + " is written" +
               (deck.column ? "; col: of that its factor to " + told(table, *deck.column) : ""));
}

// Where the ending of -o and the deck do not agree.
void note_format(const FactorsOptions& options, const Streams& streams) {
  if (!options.deck.out) return;
  if (options.deck.out == 2U)
    return streams.note(
        "out=2, a sparse list, is not written as such: .csv and .mtx list the pairs that see each other");
  const FactorFormat asked = options.deck.out == 0U ? FactorFormat::kView3dText : FactorFormat::kView3dBinary;
  if (options.format() == asked) return;
  streams.note(fmt::format("out={} asks for View3D's {}; the ending of -o decides: {}", *options.deck.out,
                           asked == FactorFormat::kView3dText ? "text, .txt" : "binary file, .bin",
                           options.out.empty() || options.out == "-" ? "without a file it is csv"
                                                                     : "'" + options.out + "' is something else"));
}

std::string listing(const FactorsOptions& options, const FactorTable& table, const std::vector<Polygon3>& polygons) {
  const ExchangeMatrix& matrix = table.matrix;
  std::string text = "rows: number, name, area, emittance, sum of its factors to rows, and to all else";
  std::vector<double> row(matrix.size() + std::size_t{1});
  std::size_t number = 0;
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    const Element& element = matrix.elements()[i];
    if (!element.material) continue;
    ++number;
    if (!table.only_rows.empty() && !std::binary_search(table.only_rows.begin(), table.only_rows.end(), i)) continue;
    std::fill(row.begin(), row.end(), 0.0);
    double to_rows = 0, to_others = 0;
    for (const FactorEntry& entry : matrix.row(i)) {
      row[entry.to] = entry.factor.value;
      const bool is_row = entry.to != matrix.sky() && matrix.elements()[entry.to].material;
      (is_row ? to_rows : to_others) += entry.factor.value;
    }
    const double emittance = to_double(table.scene.materials[*element.material].surface_emissivity());
    text += fmt::format("\n{:5} {:>12} {:11.4e} {:5.3f} {:9.6f} {:9.6f}", number, element.name, element.area.value,
                        emittance, to_rows, to_others);
    if (options.deck.list >= 3 && table.granularity == Granularity::kFace) {
      text += "\n     ";
      for (const Point3& corner : polygons[element.surface].points) text += " " + place_text(corner);
    }
    if (options.deck.list < 2) continue;
    std::size_t count = 0;
    for (std::uint32_t j = 0; j < matrix.size(); ++j)
      if (matrix.elements()[j].material)
        text += fmt::format("{}{:8.6f}", count++ % kFactorsInALine == 0 ? "\n      " : " ", row[j]);
  }
  return text;
}

}  // namespace

void obey_deck(const FactorsOptions& options, const Streams& streams, FactorTable& table,
               const std::vector<Polygon3>& polygons) {
  take_row(options, streams, table);
  note_format(options, streams);
  if (options.deck.list > 0) streams.note(listing(options, table, polygons));
}

}  // namespace hottel
