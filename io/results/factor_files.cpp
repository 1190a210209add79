#include "io/results/factor_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <numeric>

#include "geometry/scene_names.h"
#include "io/results/csv_field.h"
#include "io/results/listed_factors.h"
#include "io/results/npy.h"
#include "io/results/short_digits.h"
#include "io/results/text_buffer.h"
#include "kernel/rational.h"
#include "kernel/support/failure.h"
#include "kernel/written_double.h"

namespace hottel {
namespace {

static_assert(std::endian::native == std::endian::little, "binary formats are written as the machine holds them");

// Calls visit(row as dense vector) for each of the size() + 1 rows; rows that do not exist are zeros.
template <class Visit>
void for_each_dense_row(const ExchangeMatrix& matrix, const Visit& visit) {
  std::vector<double> dense(matrix.size() + 1);
  for (std::uint32_t i = 0; i <= matrix.size(); ++i) {
    std::fill(dense.begin(), dense.end(), 0.0);
    if (i < matrix.size())
      for (const FactorEntry& entry : matrix.row(i)) dense[entry.to] = entry.factor.value;
    visit(i, dense);
  }
}

std::vector<std::uint32_t> radiating(const ExchangeMatrix& matrix) {
  std::vector<std::uint32_t> result;
  for (std::uint32_t i = 0; i < matrix.size(); ++i)
    if (matrix.elements()[i].material) result.push_back(i);
  return result;
}

double emittance(const FactorTable& table, std::uint32_t label) {
  const Material& material = table.scene.materials[*table.matrix.elements()[label].material];
  if (!table.gray_channel) return to_double(material.surface_emissivity());
  return to_double(1 - material.surface_reflectivity().value[static_cast<std::size_t>(*table.gray_channel)]);
}

std::string view3d_header(const FactorTable& table, int format, std::size_t count) {
  return fmt::format("{:<30}", fmt::format("View3D 4.0.0 {} 0 {} {}", format, table.gray_channel ? 1 : 0, count));
}

// Throws RequestError where single precision has an infinity or 0 for what is neither. value: as written_double has it.
template <class Name>
void require_single(double value, const Name& name) {
  const auto single = static_cast<float>(value);
  const bool is_below = std::isnan(value) || (single == 0 && value != 0);
  if (is_below || std::isinf(single))
    throw RequestError(name() + " is " + (is_below ? "below" : "beyond") +
                       " the range of single precision, which is that of this format");
}

// Calls visit(factors of the row, by label) for each of these that is asked for.
template <class Visit>
void for_each_radiating_row(const FactorTable& table, const std::vector<std::uint32_t>& faces, const Visit& visit) {
  const ExchangeMatrix& matrix = table.matrix;
  std::vector<double> dense(matrix.size() + 1);
  for (const std::uint32_t i : faces) {
    if (!is_asked(table.only_rows, i)) continue;
    std::fill(dense.begin(), dense.end(), 0.0);
    for (const FactorEntry& entry : matrix.row(i)) dense[entry.to] = entry.factor.value;
    visit(dense);
  }
}

}  // namespace

void write_factors_mtx(const FactorTable& table, const Sink& sink) {
  const ExchangeMatrix& matrix = table.matrix;
  TextBuffer out(sink);
  const std::size_t n = matrix.size() + 1;
  const std::vector<std::uint64_t> counts = listed_counts(table);
  const std::uint64_t count = std::accumulate(counts.begin(), counts.end(), std::uint64_t{0});
  out << "%%MatrixMarket matrix coordinate real general\n"
      << (table.gray_channel ? "% gray-body exchange factors script-F" : "% view factors F")
      << "(row, column), faces as in the .faces.csv beside this file, the sky last\n"
      << fmt::format("{} {} {}\n", n, n, count);
  for_each_listed(table, [&](std::uint32_t from, const FactorEntry& entry, const Enclosure&, Guarantee) {
    out << fmt::format("{} {} ", from + 1, entry.to + 1) << entry.factor.value << "\n";
  });
  out.flush();
}

void write_faces_csv(const FactorTable& table, std::span<const std::vector<std::array<double, 4>>> pieces,
                     const Sink& sink) {
  const ExchangeMatrix& matrix = table.matrix;
  HOTTEL_REQUIRE(pieces.size() == matrix.size());
  TextBuffer out(sink);
  out << "index,face,element,area,material,x0,y0,x1,y1\n";
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    const Element& element = matrix.elements()[i];
    const std::string face = table.granularity == Granularity::kGroup
                                 ? element.name
                                 : face_name(table.scene, {element.surface, element.is_back});
    out << fmt::format("{},{},{},", i + 1, csv_field(face), element.node().text())
        << required_double(element.area, area_of(matrix, i)) << ","
        << (element.material ? csv_field(table.scene.materials[*element.material].name) : "");
    for (std::size_t coordinate = 0; coordinate < 4; ++coordinate) {
      out << ",";
      for (const std::array<double, 4>& piece : pieces[i]) {
        require_double(piece[coordinate], "a coordinate of '" + element.name + "'");
        if (&piece != pieces[i].data()) out << "|";
        out << piece[coordinate];
      }
    }
    out << "\n";
  }
  out << fmt::format("{},sky,0,,,,,,\n", matrix.size() + 1);
  out.flush();
}

void write_factors_npy(const FactorTable& table, const Sink& sink) {
  const std::size_t n = table.matrix.size() + 1;
  TextBuffer out(sink);
  out << npy_header(std::array{n, n});
  for_each_dense_row(table.matrix, [&](std::uint32_t, const std::vector<double>& row) {
    out << std::string_view(reinterpret_cast<const char*>(row.data()), row.size() * sizeof(double));
  });
  out.flush();
}

std::string factors_sidecar(const FactorTable& table) {
  const std::size_t n = table.matrix.size() + std::size_t{1};
  nlohmann::ordered_json sidecar;
  sidecar["quantity"] = table.gray_channel ? "script-F" : "view factor";
  sidecar["shape"] = {n, n};
  sidecar["order"] = "C";
  sidecar["axes"] = {"from", "to"};
  nlohmann::ordered_json names = nlohmann::ordered_json::array(), areas = nlohmann::ordered_json::array();
  for (const Element& element : table.matrix.elements()) {
    names.push_back(element.name);
    const double area = written_double(element.area);
    areas.push_back(std::isfinite(area) ? nlohmann::ordered_json(area) : nlohmann::ordered_json());
  }
  names.push_back(table.matrix.name(table.matrix.sky()));
  areas.push_back(nullptr);
  sidecar["names"] = std::move(names);
  sidecar["areas"] = std::move(areas);
  return sidecar.dump(2) + "\n";
}

void write_factors_view3d_text(const FactorTable& table, const Sink& sink) {
  const ExchangeMatrix& matrix = table.matrix;
  const std::vector<std::uint32_t> faces = radiating(matrix);
  for (const std::uint32_t i : faces) required_double(matrix.elements()[i].area, area_of(matrix, i));
  TextBuffer out(sink);
  const auto line = [&](const auto& value_of, const std::vector<std::uint32_t>& only = {}) {
    bool is_first = true;
    for (const std::uint32_t j : faces) {
      if (!is_asked(only, j)) continue;
      out << fmt::format("{}{:.17g}", is_first ? "" : " ", value_of(j));
      is_first = false;
    }
    out << "\n";
  };
  out << view3d_header(table, 0, faces.size()) << "\n";
  line([&](std::uint32_t i) { return matrix.elements()[i].area.value; });
  for_each_radiating_row(table, faces, [&](const std::vector<double>& row) {
    line([&](std::uint32_t j) { return row[j]; }, table.only_columns);
  });
  line([&](std::uint32_t i) { return emittance(table, i); });
  out.flush();
}

void write_factors_view3d_binary(const FactorTable& table, const Sink& sink) {
  const ExchangeMatrix& matrix = table.matrix;
  const std::vector<std::uint32_t> faces = radiating(matrix);
  for (const std::uint32_t i : faces)
    require_single(written_double(matrix.elements()[i].area), [&] { return area_of(matrix, i); });
  for_each_listed(table, [&](std::uint32_t from, const FactorEntry& entry, const Enclosure&, Guarantee) {
    const auto name = [&] { return "the factor from '" + matrix.name(from) + "' to '" + matrix.name(entry.to) + "'"; };
    if (entry.to != matrix.sky() && matrix.elements()[entry.to].material)
      require_single(written_double(entry.factor), name);
  });
  TextBuffer out(sink);
  out << view3d_header(table, 1, faces.size()) << "\r\n";
  for (const std::uint32_t i : faces) out.raw(static_cast<float>(matrix.elements()[i].area.value));
  for_each_radiating_row(table, faces, [&](const std::vector<double>& row) {
    for (const std::uint32_t j : faces)
      if (is_asked(table.only_columns, j)) out.raw(static_cast<float>(row[j]));
  });
  for (const std::uint32_t i : faces) out.raw(static_cast<float>(emittance(table, i)));
  out.flush();
}

void write_dense_csv(const FactorTable& table, DenseQuantity quantity, const Sink& sink) {
  const ExchangeMatrix& matrix = table.matrix;
  const std::vector<std::string> names = csv_names(matrix);
  TextBuffer out(sink);
  for (const std::string& name : names) out << "," << name;
  out << "\n";
  const double absent = quantity == DenseQuantity::kVisibility ? std::numeric_limits<double>::quiet_NaN() : 0.0;
  std::vector<double> dense(names.size());
  // Where the matrix has no measures: of the doubles that it has.
  const auto measure = [&](std::uint32_t i, std::size_t k) {
    return matrix.measures(i).empty() ? matrix.elements()[i].area.value * matrix.row(i)[k].factor.value
                                      : matrix.measures(i)[k];
  };
  if (quantity == DenseQuantity::kExchange)  // before the first byte, which may go to standard output
    for (std::uint32_t i = 0; i < matrix.size(); ++i)
      for (std::size_t k = 0; k < matrix.row(i).size(); ++k)
        if (const double s = measure(i, k); !(s > 0) || std::isinf(s)) {
          const FactorEntry& entry = matrix.row(i)[k];
          const bool is_nothing = entry.factor == Rounded{};  // of other methods
          require_double(is_nothing ? s : written_double(Rounded{s, 1}),
                         "the direct exchange area of '" + matrix.name(i) + "' and '" + matrix.name(entry.to) + "'",
                         matrix.guarantee() == Guarantee::kExact ? "; --exact-form gives it" : "");
        }
  auto hidden = table.hidden.begin();
  for (std::uint32_t i = 0; i < names.size(); ++i) {
    std::fill(dense.begin(), dense.end(), absent);
    for (; hidden != table.hidden.end() && hidden->first == i; ++hidden) dense[hidden->second] = 0;
    if (i < matrix.size()) {
      const auto row = matrix.row(i);
      for (std::size_t k = 0; k < row.size(); ++k)
        dense[row[k].to] = quantity == DenseQuantity::kFactor     ? row[k].factor.value
                           : quantity == DenseQuantity::kExchange ? measure(i, k)
                                                                  : row[k].visibility;
    }
    out << names[i];
    for (const double value : dense) {
      out << ",";
      if (std::isnan(value))
        out << "NaN";
      else if (!table.digits)
        out << value;
      else
        out << (quantity == DenseQuantity::kVisibility ? short_visibility(value, table.digits)
                                                       : short_digits(value, table.digits));
    }
    out << "\n";
  }
  out.flush();
}

DenseSize dense_size(const SceneTable& scene, Granularity granularity, FactorFormat format) {
  std::uint64_t all = 0, radiating = 0;  // labels, and those with a material
  const auto add = [&](std::uint64_t count, bool radiates) {
    all += count;
    if (radiates) radiating += count;
  };
  if (granularity == Granularity::kGroup) {
    std::vector<char> has_back(scene.groups.size(), 0);
    for (const Surface& surface : scene.surfaces)
      if (surface.back) has_back[surface.group] = 1;
    for (const char back : has_back) {
      add(1, true);
      add(1, back != 0);
    }
  } else {
    for (const Surface& surface : scene.surfaces) {
      const std::uint64_t parts = granularity == Granularity::kElement ? surface.elements : 1;
      add(parts, true);
      add(surface.back ? parts : 1, surface.back.has_value());
    }
  }
  return dense_size(all, radiating, format);
}

DenseSize dense_size(std::uint64_t faces, std::uint64_t radiating, FactorFormat format) {
  const std::uint64_t n = faces + 1, m = radiating;  // the sky too; View3D knows faces with a material only
  const auto size = [](std::uint64_t side, std::uint64_t head, std::uint64_t each, std::uint64_t more) {
    constexpr std::uint64_t kMost = std::numeric_limits<std::uint64_t>::max();
    const double about = static_cast<double>(side) * static_cast<double>(side) * static_cast<double>(each);
    return DenseSize{side, about < 1e19 ? head + each * (side * side + more * side) : kMost};
  };
  switch (format) {
    case FactorFormat::kNpy: {
      const auto side = static_cast<std::size_t>(n);
      return size(n, npy_header(std::array{side, side}).size(), sizeof(double), 0);
    }
    case FactorFormat::kView3dBinary:
      return size(m, 32, sizeof(float), 2);
    case FactorFormat::kView3dText:
      return size(m, 0, 2, 0);
    case FactorFormat::kCsv:
      return size(n, 0, 2, 0);
    case FactorFormat::kMtx:
    case FactorFormat::kHdf5:
      break;
  }
  throw ContractViolation("a list of pairs is as long as there are pairs");
}

const FactorFormatRow& row_of(FactorFormat format) {
  return *std::ranges::find(kFactorFormats, format, &FactorFormatRow::format);
}

std::optional<FactorFormat> factor_format(const std::filesystem::path& file) {
  const auto row = std::ranges::find(kFactorFormats, file.extension().string(), &FactorFormatRow::ending);
  return row == kFactorFormats.end() ? std::nullopt : std::optional(row->format);
}

namespace {

// The pairs (from, to) of a table of closed forms, in its order.
std::vector<ElementPair> exact_form_rows(const FactorTable& table, const std::optional<ElementPair>& only) {
  if (only) return {*only};
  std::vector<ElementPair> rows;
  for_each_listed(table, [&](std::uint32_t from, const FactorEntry& entry, const Enclosure&, Guarantee) {
    rows.emplace_back(from, entry.to);
  });
  return rows;
}

ElementPair smaller_first(const ElementPair& pair) { return std::minmax(pair.first, pair.second); }

}  // namespace

std::vector<ElementPair> exact_form_pairs(const FactorTable& table, const std::optional<ElementPair>& only) {
  std::vector<ElementPair> pairs = exact_form_rows(table, only);
  std::transform(pairs.begin(), pairs.end(), pairs.begin(), smaller_first);
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

void write_exact_forms_csv(const FactorTable& table, const std::optional<ElementPair>& only,
                           std::span<const ElementPair> pairs, std::span<const RootSum> measures,
                           std::span<const RootSum> areas, const Sink& sink) {
  const ExchangeMatrix& matrix = table.matrix;
  HOTTEL_REQUIRE(measures.size() == pairs.size() && areas.size() == matrix.size());
  TextBuffer out(sink);
  out << "from,to,exchange,area\n";
  for (const ElementPair& row : exact_form_rows(table, only)) {
    const auto place = std::lower_bound(pairs.begin(), pairs.end(), smaller_first(row)) - pairs.begin();
    out << csv_field(matrix.name(row.first)) << "," << csv_field(matrix.name(row.second)) << ","
        << measures[static_cast<std::size_t>(place)].to_string() << ","
        << (row.first == matrix.sky() ? "" : areas[row.first].to_string()) << "\n";
  }
  out.flush();
}

}  // namespace hottel
