// View factors as files: one function a format, each writing through a sink.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "geometry/exchange_matrix.h"
#include "geometry/plane/arrangement/prepared_scene.h"
#include "geometry/plane/exchange/element_table.h"

namespace hottel {

// What a file cannot hold, for it is beyond the range of doubles (of single precision in View3D's binary format), is
// refused by RequestError, naming the face: areas and coordinates in the files that have them, exchange measures.

// Takes text piece by piece; whatever it throws stops the writing.
using Sink = std::function<void(std::string_view)>;

// What a file of factors is made of.
struct FactorTable {
  const Scene2& scene;
  const ExchangeMatrix& matrix;
  Granularity granularity = Granularity::kFace;
  std::vector<ElementPair> hidden = {};  // pairs with S = 0 < S0, sorted: zeros in the formats that list pairs
  std::optional<int> gray_channel = {};  // the matrix is script-F (gray_exchange.h) of this channel; else view factors
};

// `from,to,factor,lower,upper,visibility,guarantee`: one line a pair, by from, then to. Shortest decimals that read
// back to the same double; names quoted as RFC 4180 asks.
void write_factors_csv(const FactorTable& table, const Sink& sink);

// Matrix Market `coordinate real general`, 1-based, all faces and the sky last; the faces are named by
// write_faces_csv, which goes into FILE.faces.csv.
void write_factors_mtx(const FactorTable& table, const Sink& sink);
void write_faces_csv(const FactorTable& table, const Sink& sink);

// NumPy float64, N x N, row = from, all faces and the sky last.
void write_factors_npy(const FactorTable& table, const Sink& sink);

// View3D's text and binary formats (4.0.0). They know surfaces that radiate only: faces with a material, in order; what
// goes to black backs and to the sky shows as rows that sum to less than 1. Emittance = 1 - reflectivity (mean of the
// channels; for script-F, which is marked as View3D marks it, that of its channel). The text carries 17 digits; the
// binary format is single precision.
void write_factors_view3d_text(const FactorTable& table, const Sink& sink);
void write_factors_view3d_binary(const FactorTable& table, const Sink& sink);

// Dense csv with names in the first row and column, all faces and the sky last: factors, exchange measures (needs
// ExchangeMatrix::measures) or visibilities (NaN where S0 = 0; needs `hidden`).
enum class DenseQuantity { kFactor, kExchange, kVisibility };
void write_dense_csv(const FactorTable& table, DenseQuantity quantity, const Sink& sink);

// The formats that hold every pair, be it visible or not.
enum class DenseFormat { kCsv, kNpy, kView3dText, kView3dBinary };

// Returns how large such a file becomes for all faces, elements or groups of a scene: how many rows it has, and its
// bytes, exactly for the binary formats, at the least for text.
struct DenseSize {
  std::uint64_t rows = 0;
  std::uint64_t bytes = 0;
};
DenseSize dense_size(const Scene2& scene, Granularity granularity, DenseFormat format);

// `from,to,exchange,area`: S(from, to) and A_from as sums of square roots, in scene units; of all pairs that are
// listed, or of one pair (from, to), be it listed or not.
void write_exact_forms_csv(const FactorTable& table, const PreparedScene2& prepared,
                           const std::optional<ElementPair>& only, const Sink& sink);

// The face that an element is a part of: "wall" or "wall:back".
std::string face_name(const Scene2& scene, const Element& element);

// A field of a csv file, quoted when it holds a comma, a quote or a line break.
std::string csv_field(const std::string& text);

}  // namespace hottel
