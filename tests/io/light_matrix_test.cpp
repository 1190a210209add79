// The matrix of what cells see as a file, read back and held against the light.
#include "io/results/plane/light_matrix.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <sstream>

#include "geometry/plane/prepared/element_table.h"
#include "geometry/plane/prepared/prepared_scene.h"
#include "io/scene/scene_json.h"
#include "kernel/support/failure.h"
#include "kernel/support/parallel.h"
#include "solver/plane/light/illumination_grid.h"

namespace hottel::light_matrix_test {
namespace {

// A room with a solid box on its floor, a thin screen with a black back, and an opening to the sky.
PreparedScene2 room() {
  return prepare(parse_scene_2(R"({"hottel":1,"dimension":2,
    "materials":{"lamp":{"emission":[4,2,1],"reflectivity":0.25},"white":{"reflectivity":0.5}},"sky":{"emission":[1,2,3]},
    "edges":[{"name":"lamp","points":[[0,0],[0,2]],"material":"lamp","elements":3},
             {"name":"screen","points":[[3,1],[3,2]],"material":"white"}],
    "polylines":[{"name":"wall","points":[[1,3],[4,3],[4,0],[0,0]],"material":"white"},
                 {"name":"box","points":[[1,0],[2,0],[2,1],[1,1]],"closed":true,"material":"white"}]})",
                               "room"),
                 Divided2::kYes);
}

struct Written {
  std::vector<std::string> comments;
  std::uint64_t rows = 0, columns = 0, entries = 0;
  std::vector<std::pair<std::uint64_t, std::uint64_t>> places;  // from 0
  std::vector<double> values;
};

std::string text_of(const LightMatrix2& matrix) {
  std::string text;
  write_light_matrix_mtx(matrix, light_matrix_size(matrix), {}, [&](std::string_view part) { text += part; });
  return text;
}

Written read(const std::string& text) {
  Written result;
  std::istringstream in(text);
  std::string line;
  while (std::getline(in, line) && line.starts_with("%")) result.comments.push_back(line);
  std::istringstream(line) >> result.rows >> result.columns >> result.entries;
  std::uint64_t row = 0, column = 0;
  for (double value = 0; in >> row >> column >> value;) {
    result.places.emplace_back(row - 1, column - 1);
    result.values.push_back(value);
  }
  return result;
}

const Grid2 kCells{{-1, -1}, {5, 4}, 24, 20};  // centres at odd multiples of 1/8: none on an edge
const Grid2 kOnEdges{{Rational(-1, 2), Rational(-1, 2)}, {Rational(9, 2), Rational(7, 2)}, 10, 8};  // and on some

TEST(LightMatrix, TimesTheRadiositiesIsTheLight) {
  const PreparedScene2 prepared = room();
  const ElementTable2& table = *prepared.elements(Granularity::kElement);
  std::vector<double> by_element;
  for (std::uint32_t k = 0; k < 3 * table.count(); ++k) by_element.push_back(1 + k * 7 % 10);
  const SentOut2 sent_out(table, by_element, std::vector<double>{5, 0, 0.5});
  for (const Grid2& cells : {kCells, kOnEdges}) {
    const Written written = read(text_of({prepared, cells, table, 1 << 30}));
    ASSERT_EQ(written.rows, std::uint64_t{cells.nx} * cells.ny);
    ASSERT_EQ(written.columns, table.count() + 1u);
    ASSERT_EQ(written.entries, written.values.size());
    std::vector<double> light(3 * written.rows, 0), sum(written.rows, 0);
    for (std::size_t k = 0; k < written.values.size(); ++k) {
      const auto [row, column] = written.places[k];
      sum[row] += written.values[k];
      for (std::uint32_t c = 0; c < 3; ++c)
        light[3 * row + c] += written.values[k] * sent_out.of(static_cast<std::uint32_t>(column), c);
    }
    const IlluminationGrid2 points = illuminate_points(prepared, cells, table, sent_out);
    std::size_t solid = 0;
    for (std::size_t row = 0; row < written.rows; ++row) {
      const bool is_solid = std::isnan(points.values[3 * row]);
      solid += is_solid ? 1 : 0;
      EXPECT_NEAR(sum[row], is_solid ? 0 : 1, 1e-15) << row;
      for (std::size_t c = 0; c < 3 && !is_solid; ++c)
        EXPECT_NEAR(light[3 * row + c], points.values[3 * row + c], 1e-14) << row;
    }
    EXPECT_GT(solid, 0u);
    EXPECT_NE(written.comments.back().find("% " + std::to_string(solid) + " of "), std::string::npos);
  }
}

TEST(LightMatrix, HasEachEntryOnceByRowThenByColumn) {
  const PreparedScene2 prepared = room();
  for (const Granularity granularity : {Granularity::kFace, Granularity::kElement}) {
    const ElementTable2& table = *prepared.elements(granularity);
    const Written written = read(text_of({prepared, kCells, table, 1 << 30}));
    EXPECT_EQ(written.comments.front(), "%%MatrixMarket matrix coordinate real general");
    EXPECT_TRUE(std::ranges::is_sorted(written.places, std::less_equal<>()));
    EXPECT_GT(written.entries, 1000u);
  }
}

TEST(LightMatrix, HasTheSameBytesForAnyNumberOfThreads) {
  const PreparedScene2 prepared = room();
  const ElementTable2& table = *prepared.elements(Granularity::kElement);
  const Grid2 cells{{-1, -1}, {5, 4}, 190, 150};
  const LightMatrix2 matrix{prepared, cells, table, 1 << 30};
  const std::string once = text_of(matrix);
  for (const int threads : {1, 3}) {
    const ThreadLimit limit(threads);
    EXPECT_EQ(text_of(matrix), once);
  }
  const double bytes = static_cast<double>(light_matrix_bytes(matrix, light_matrix_size(matrix)));
  EXPECT_NEAR(bytes / static_cast<double>(once.size()), 1, 0.2);
}

TEST(LightMatrix, IsRefusedWhenRowsTakeMoreMemoryThanIsAllowed) {
  const PreparedScene2 prepared = room();
  const ElementTable2& table = *prepared.elements(Granularity::kElement);
  EXPECT_THROW(text_of({prepared, kCells, table, 10000}), RequestError);
  EXPECT_NO_THROW(text_of({prepared, kCells, table, 1000000}));
}

}  // namespace
}  // namespace hottel::light_matrix_test
