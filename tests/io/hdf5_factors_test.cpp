// View factors as HDF5 files: what is written, what is read, and what is refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <random>
#include <string>

#include "geometry/plane/exchange/exchange.h"
#include "geometry/plane/prepared/prepared_scene.h"
#include "io/external/external_file.h"
#include "io/files/hdf5.h"
#include "io/files/text_file.h"
#include "io/results/factor_hdf5.h"
#include "io/scene/scene_json.h"
#include "kernel/support/failure.h"
#include "tests/io/listed_in_hdf5.h"
#include "tests/temporary_folder.h"

namespace hottel::hdf5_factors_test {
namespace {

const std::string kScenes = std::string(HOTTEL_SOURCE_DIR) + "/scenes/";

TEST(Hdf5, IsToldByTheFirstBytes) {
  EXPECT_TRUE(is_hdf5("\x89HDF\r\n\x1a\n..."));
  EXPECT_FALSE(is_hdf5("HDF") || is_hdf5(""));
}

#ifdef HOTTEL_HDF5

class Hdf5Factors : public ::testing::Test {
 protected:
  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  std::string written(const std::string& name, const FactorTable& table, const FactorOrigin& origin = {}) const {
    OutputFile out(path(name));
    write_factors_hdf5(table, origin, out);
    out.commit();
    return read_text_file(path(name));
  }
  std::string why(const std::string& bytes) const {
    try {
      parse_external_matrix("f.h5", bytes);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }
  // What a writer of others might leave out or say.
  std::string of_others(std::vector<std::uint64_t> begin, std::vector<std::uint32_t> column, std::vector<double> factor,
                        std::uint32_t layout = 1) const {
    const OutputFile out(path("other"));
    Hdf5Writer file(out.place(), "other");
    file.say("layout", layout);
    file.begin("begin", Hdf5Number::kUint64, begin.size());
    file.append("begin", begin.data(), begin.size());
    file.begin("column", Hdf5Number::kUint32, column.size());
    file.append("column", column.data(), column.size());
    file.begin("factor", Hdf5Number::kFloat64, factor.size());
    file.append("factor", factor.data(), factor.size());
    file.finish();
    return read_text_file(out.place());
  }

  TemporaryFolder folder_;
};

TEST_F(Hdf5Factors, HoldWhatTheListHasInThePlane) {
  for (const Granularity granularity : {Granularity::kFace, Granularity::kElement, Granularity::kGroup}) {
    const PreparedScene2 prepared = prepare(read_scene_2(kScenes + "showcase/apartment.json"));
    const ExchangeMatrix matrix = exact_exchange(prepared, {.granularity = granularity});
    const FactorTable table{prepared.scene, matrix, granularity};
    const std::string bytes = written("f.h5", table, {2, "exact", "{}"});
    expect_as_listed(bytes, table);
    const Hdf5Reader file("f.h5", bytes);
    EXPECT_FALSE(file.has("lower"));
    EXPECT_EQ(file.said_number("layout"), 1u);
    EXPECT_EQ(file.said_text("method"), "exact");
    EXPECT_EQ(file.said_text("area_unit"), "m");
    EXPECT_EQ(file.texts("scene"), std::vector<std::string>{"{}"});
    EXPECT_EQ(file.texts("names").back(), "sky");
    EXPECT_EQ(file.numbers("area").front(), matrix.elements().front().area.value);
  }
}

TEST_F(Hdf5Factors, AreReadAsAListOfAllNames) {
  const PreparedScene2 prepared = prepare(read_scene_2(kScenes + "showcase/apartment.json"));
  const ExchangeMatrix matrix = exact_exchange(prepared);
  written("f.h5", {prepared.scene, matrix});
  const ExternalMatrix read = read_external_matrix(path("f.h5"));
  ASSERT_EQ(read.entries.size(), matrix.entry_count());
  EXPECT_EQ(read.rows, matrix.size() + 1);
  EXPECT_TRUE(read.is_list);
  for (std::uint32_t i = 0; i <= matrix.size(); ++i) EXPECT_EQ(read.row_names[i].name, matrix.name(i));
  for (const ExternalEntry& entry : read.entries) EXPECT_EQ(entry.value, matrix.factor(entry.row, entry.column).value);
}

TEST_F(Hdf5Factors, TellWhichRowsTheyHave) {
  const PreparedScene2 prepared = prepare(read_scene_2(kScenes + "showcase/apartment.json"));
  const ExchangeMatrix matrix = exact_exchange(prepared);
  FactorTable table{prepared.scene, matrix};
  table.only_rows = {0};
  const ExternalMatrix read = parse_external_matrix("f.h5", written("f.h5", table));
  EXPECT_EQ(read.entries.size(), matrix.row(0).size());
  EXPECT_TRUE(read.has_row[0]);
  EXPECT_EQ(std::count(read.has_row.begin(), read.has_row.end(), 1), 1);
}

// A matrix of some chunks, whose numbers mean nothing.
ExchangeMatrix large_matrix(std::uint32_t size) {
  std::vector<Element> elements;
  for (std::uint32_t i = 0; i < size; ++i)
    elements.push_back({.name = "e" + std::to_string(i), .material = 0, .area = {1, 0}});
  ExchangeMatrix matrix(elements, Guarantee::kExact);
  std::vector<std::size_t> begin{0};
  FactorEntries entries;
  for (std::uint32_t i = 0; i < size; ++i) {
    for (std::uint32_t j = 0; j < size; ++j) entries.push_back({j, {1.0 / (1 + i + j), 1}});
    begin.push_back(entries.size());
  }
  matrix.assign(begin, entries);
  return matrix;
}

TEST_F(Hdf5Factors, TakeThirteenBytesAnEntryAndAreTheSameBytesEveryTime) {
  const ExchangeMatrix matrix = large_matrix(1024);  // eight chunks, exactly
  const SceneTable scene;
  const FactorTable table{scene, matrix};
  const std::string bytes = written("f.h5", table);
  EXPECT_LT(static_cast<double>(bytes.size()), 13.0 * static_cast<double>(matrix.entry_count()) + 6e4);
  EXPECT_EQ(bytes, written("g.h5", table));
  expect_as_listed(bytes, table);
}

TEST_F(Hdf5Factors, LeaveZerosBehindTheLastEntry) {
  const ExchangeMatrix matrix = large_matrix(400);
  const SceneTable scene;
  const FactorTable table{scene, matrix};
  const std::string bytes = written("f.h5", table);
  EXPECT_EQ(bytes, written("g.h5", table));
  expect_as_listed(bytes, table);
}

TEST_F(Hdf5Factors, OfNothingAreAFileToo) {
  const ExchangeMatrix matrix;
  const SceneTable scene;
  const ExternalMatrix read = parse_external_matrix("f.h5", written("f.h5", {scene, matrix}));
  EXPECT_EQ(read.rows, 1u);
  EXPECT_TRUE(read.entries.empty());
}

TEST_F(Hdf5Factors, OfOthersNeedThreeArrays) {
  const ExternalMatrix read = parse_external_matrix("f.h5", of_others({0, 1, 2}, {1, 0}, {0.5, 0.25}));
  EXPECT_EQ(read.rows, 2u);
  EXPECT_FALSE(read.is_list);
  EXPECT_EQ(read.entries.at(1).value, 0.25);
  EXPECT_THAT(why(of_others({0, 1, 2}, {1, 2}, {0.5, 0.25})), testing::HasSubstr("row 1 has the column 2 of 2"));
  EXPECT_THAT(why(of_others({0, 1, 1}, {1, 0}, {0.5, 0.25})), testing::HasSubstr("do not begin one after the other"));
  EXPECT_THAT(why(of_others({0, 1, 2}, {1}, {0.5, 0.25})), testing::HasSubstr("1 columns and 2 factors"));
  EXPECT_THAT(why(of_others({0, 1, 2}, {1, 0}, {0.5, NAN})), testing::HasSubstr("row 1, column 0 is not finite"));
  EXPECT_THAT(why(of_others({0, 1, 2}, {1, 0}, {0.5, 0.25}, 2)), testing::HasSubstr("has the layout 2"));
}

TEST_F(Hdf5Factors, WithoutTheArraysAreRefused) {
  const OutputFile out(path("empty"));
  Hdf5Writer file(out.place(), "empty");
  file.finish();
  EXPECT_THAT(why(read_text_file(out.place())), testing::HasSubstr("there is no array `begin`"));
}

TEST_F(Hdf5Factors, ThatAreDamagedAnywhereAreRefusedOrTheSame) {
  const PreparedScene2 prepared = prepare(read_scene_2(kScenes + "analytic/triangle_345.json"));
  const ExchangeMatrix matrix = exact_exchange(prepared);
  const std::string bytes = written("f.h5", {prepared.scene, matrix}, {2, "exact", "{}"});
  const ExternalMatrix whole = parse_external_matrix("f.h5", bytes);
  std::mt19937 random(3);
  std::size_t refused = 0;
  for (int k = 0; k < 1500; ++k) {
    std::string broken = bytes;
    if (k % 3 == 0)
      broken.resize(random() % broken.size());
    else
      broken[random() % broken.size()] ^= static_cast<char>(1 << random() % 8);
    try {
      const ExternalMatrix read = parse_external_matrix("f.h5", broken);
      ASSERT_EQ(read.entries.size(), whole.entries.size());
      for (std::size_t e = 0; e < whole.entries.size(); ++e) EXPECT_EQ(read.entries[e].value, whole.entries[e].value);
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), testing::StartsWith("f.h5: "));
      ++refused;
    }
  }
  EXPECT_GT(refused, 600u);
}

TEST_F(Hdf5Factors, GoIntoRegularFilesOnly) {
  const ExchangeMatrix matrix;
  const SceneTable scene;
  EXPECT_THROW(write_factors_hdf5({scene, matrix}, {}, OutputFile("/dev/null")), OutputError);
}

#else

TEST(Hdf5Factors, AreRefusedWithoutHdf5) {
  EXPECT_THROW(require_hdf5("f.h5"), UsageError);
  EXPECT_THROW(parse_external_matrix("f.h5", "\x89HDF\r\n\x1a\n..."), InputError);
}

#endif

}  // namespace
}  // namespace hottel::hdf5_factors_test
