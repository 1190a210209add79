// A matrix of view factors, and what a file of it is to have.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "geometry/exchange_matrix.h"
#include "geometry/scene_table.h"

namespace hottel {

class RowRanges;

// Takes text piece by piece; whatever it throws stops the writing.
using Sink = std::function<void(std::string_view)>;

// What a file of factors is made of.
struct FactorTable {
  const SceneTable& scene;
  const ExchangeMatrix& matrix;
  Granularity granularity = Granularity::kFace;
  std::vector<ElementPair> hidden = {};  // pairs with S = 0 < S0, sorted: zeros in the formats that list pairs
  // Where these are not empty, of lists and of View3D's files only these rows are written, and of them these columns;
  // ascending. Other files hold all.
  std::vector<std::uint32_t> only_rows = {}, only_columns = {};
  std::optional<int> gray_channel = {};  // the matrix is script-F (gray_exchange.h) of this channel; else view factors
  bool has_areas = false;                // the list of pairs has the areas of both
  // The most significant digits of numbers in csv (short_digits); nothing: as many as tell the doubles.
  std::optional<int> digits = {};
  // Where there are some, `matrix` is theirs, and files that list pairs load one range after another.
  RowRanges* ranges = nullptr;
};

}  // namespace hottel
