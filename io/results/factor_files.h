// View factors as files: one function a format, each writing through a sink.
//
//   const Simulation2 simulation(read_scene_2("scenes/analytic/strip_obstructed.json"));
//   const auto factors = simulation.factors();
//   std::ofstream file("factors.csv");
//   write_factors_csv({simulation.scene(), factors->matrix}, [&](std::string_view text) { file << text; });
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/results/factor_table.h"
#include "kernel/root_sum.h"

namespace hottel {

// Every writer throws RequestError, naming the face, for a number that its file cannot hold: one that is beyond the
// range of doubles or, though not 0, below it; in View3D's binary format the range is that of single precision. Such
// numbers are areas, coordinates and direct exchange areas, and in single precision factors.

// `from,to,factor,lower,upper,visibility,guarantee`: one line a pair, by from, then to. Shortest decimals that read
// back to the same double, or no more digits than are asked for, bounds rounded outward; names quoted as RFC 4180 asks.
// With table.has_areas two columns more, `from_area,to_area`: lengths in the plane, empty for the sky.
void write_factors_csv(const FactorTable& table, const Sink& sink);

// Matrix Market `coordinate real general`, 1-based, all faces and the sky last; the faces are named by
// write_faces_csv, which goes into FILE.faces.csv.
void write_factors_mtx(const FactorTable& table, const Sink& sink);
// pieces: what is left of each element, x0, y0, x1, y1 each (element_pieces), those of several with "|" between their
// numbers, column by column.
void write_faces_csv(const FactorTable& table, std::span<const std::vector<std::array<double, 4>>> pieces,
                     const Sink& sink);

// NumPy float64, N x N, row = from, all faces and the sky last.
void write_factors_npy(const FactorTable& table, const Sink& sink);

// Returns a JSON object of `quantity`, `shape`, `order`, `axes`, and of `names` and `areas` of rows and columns alike,
// the sky last; an area that is beyond the range of doubles or below it, as that of the sky, is null.
std::string factors_sidecar(const FactorTable& table);

// View3D's text and binary formats (4.0.0). They know surfaces that radiate only: faces with a material, in order; what
// goes to black backs and to the sky shows as rows that sum to less than 1. Emittance = 1 - reflectivity, the mean of
// the channels; for script-F, which is marked as View3D marks it, that of its channel. The text carries 17 digits; the
// binary format is single precision. With only_rows the file has fewer lines between areas and emittances than its head
// says, and with only_columns these lines are shorter: a program that reads the whole notices that it has a part.
void write_factors_view3d_text(const FactorTable& table, const Sink& sink);
void write_factors_view3d_binary(const FactorTable& table, const Sink& sink);

// What a dense csv holds: F, S or Vis.
enum class DenseQuantity { kFactor, kExchange, kVisibility };
// Dense csv with names in the first row and column, all faces and the sky last: factors, direct exchange areas,
// or visibilities (needs `hidden`).
//
//   (1) what has no entry is 0; of visibilities NaN, but 0 for the pairs of `hidden`
//   (2) direct exchange areas are those of the matrix, or A_i F_ij of the doubles where it has none; one that is beyond
//       the range of doubles, or below it, throws RequestError before anything is written
//   (3) the row of the sky has no entries
void write_dense_csv(const FactorTable& table, DenseQuantity quantity, const Sink& sink);

// What factors are written as. View3D's formats and .npy hold every pair, be it visible or not.
enum class FactorFormat : unsigned char { kCsv, kMtx, kNpy, kHdf5, kView3dText, kView3dBinary };

struct FactorFormatRow {
  FactorFormat format;
  const char* ending;
  const char* whose;  // "" or the program whose format it is
  bool lists_pairs;   // only those that see each other; else the file holds all pairs
  bool is_text;
  const char* beside;  // the ending of a file beside it, which says what its rows are; null: there is none
};
inline constexpr std::array<FactorFormatRow, 6> kFactorFormats{
    {{FactorFormat::kCsv, ".csv", "", true, true, nullptr},
     {FactorFormat::kMtx, ".mtx", "", true, true, ".faces.csv"},
     {FactorFormat::kNpy, ".npy", "", false, false, ".json"},
     {FactorFormat::kHdf5, ".h5", "", true, false, nullptr},
     {FactorFormat::kView3dText, ".txt", "View3D", false, true, nullptr},
     {FactorFormat::kView3dBinary, ".bin", "View3D", false, false, nullptr}}};
const FactorFormatRow& row_of(FactorFormat format);
// Returns the format of a file by its ending; nothing for others.
std::optional<FactorFormat> factor_format(const std::filesystem::path& file);

// How large a file becomes for all faces, elements or groups of a scene: its rows, and its bytes, exactly for the
// binary formats, at least so many for text.
struct DenseSize {
  std::uint64_t rows = 0;
  std::uint64_t bytes = 0;
};
// Returns that size; for csv, of the dense table. REQUIRES: neither .mtx nor .h5, whose size depends on the factors.
DenseSize dense_size(const SceneTable& scene, Granularity granularity, FactorFormat format);
// The same of so many faces, and of so many of them that have a material. (In space a surface has more elements than
// its table says.)
DenseSize dense_size(std::uint64_t faces, std::uint64_t radiating, FactorFormat format);

// The pairs whose direct exchange areas are asked for in closed form: all that are listed, or one pair (from, to), be
// it listed or not; each once, the smaller number first, sorted.
std::vector<ElementPair> exact_form_pairs(const FactorTable& table, const std::optional<ElementPair>& only);

// `from,to,exchange,area`: S(from, to) and A_from as sums of square roots, in scene units. pairs:
// exact_form_pairs(table, only), measures: theirs, one each; areas: of all elements.
void write_exact_forms_csv(const FactorTable& table, const std::optional<ElementPair>& only,
                           std::span<const ElementPair> pairs, std::span<const RootSum> measures,
                           std::span<const RootSum> areas, const Sink& sink);

}  // namespace hottel
