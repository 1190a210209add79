// What other programs write, read back: every format, every layout, and what is wrong with it.
#include "io/external/plane/external_matrix.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <functional>
#include <random>

#include "geometry/plane/exchange/exchange.h"
#include "geometry/plane/generate/generators.h"
#include "geometry/plane/prepared/element_pieces.h"
#include "geometry/plane/prepared/prepared_scene.h"
#include "io/external/matched_matrix.h"
#include "io/results/factor_files.h"
#include "io/results/npy.h"
#include "kernel/support/failure.h"
#include "tests/io/external_numbers.h"
#include "tests/io/external_room.h"

namespace hottel::external_matrix_test {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

class ExternalMatrixTest : public ExternalRoomTest {};

std::string written(const std::function<void(const Sink&)>& write) {
  std::string text;
  write([&text](std::string_view piece) { text += piece; });
  return text;
}

TEST_F(ExternalMatrixTest, ReadsWhatHottelWrites) {
  Scene2 scene = read_scene_2(std::string(HOTTEL_SOURCE_DIR) + "/tests/contract/box.json");
  for (const Divided2 divided : {Divided2::kNo, Divided2::kYes}) {
    const PreparedScene2 prepared = prepare(scene, divided);
    const ExchangeMatrix exact =
        exact_exchange(prepared, {.granularity = Granularity::kElement, .wants_measures = true});
    const FactorTable table{prepared.scene, exact, Granularity::kElement, {}};
    expect_same(matched(prepared, "f.csv", written([&](const Sink& s) { write_factors_csv(table, s); })), exact);
    expect_same(matched(prepared, "f.npy", written([&](const Sink& s) { write_factors_npy(table, s); })), exact);
    const std::string dense = written([&](const Sink& s) { write_dense_csv(table, DenseQuantity::kFactor, s); });
    expect_same(matched(prepared, "d.csv", dense), exact);
    const std::string mtx = written([&](const Sink& s) { write_factors_mtx(table, s); });
    expect_same(matched(prepared, "f.mtx", mtx), exact);
    EXPECT_THAT(report_.notes, testing::IsEmpty());
    write("g.mtx.faces.csv",
          written([&](const Sink& s) { write_faces_csv(table, element_pieces(prepared, Granularity::kElement), s); }));
    expect_same(matched(prepared, "g.mtx", mtx), exact);
    EXPECT_THAT(report_.notes, testing::IsEmpty());

    // View3D knows faces that radiate.
    const auto radiates = [&](std::uint32_t j) { return j < exact.size() && exact.elements()[j].material; };
    const std::string text = written([&](const Sink& s) { write_factors_view3d_text(table, s); });
    expect_same(matched(prepared, "f.txt", text), exact, 0, radiates);
    EXPECT_THAT(report_.notes, testing::Contains(HasSubstr("there is no column for the sky")));
    const std::string binary = written([&](const Sink& s) { write_factors_view3d_binary(table, s); });
    expect_same(matched(prepared, "f.bin", binary), exact, 6e-8, radiates);
    EXPECT_EQ(report_.written->digits.relative, std::ldexp(1.0, -24));
    EXPECT_FALSE(report_.written->has_column[exact.sky()]);
  }
}

TEST_F(ExternalMatrixTest, NamesMayComeInAnyOrder) {
  const PreparedScene2 prepared = room();
  const ExchangeMatrix exact = exact_exchange(prepared);
  const std::uint32_t order[] = {4, 0, 6, 2};  // c a d b
  std::string dense = "face";
  for (const std::uint32_t j : order) dense += "," + exact.elements()[j].name;
  for (const std::uint32_t i : order) {
    dense += "\r\n" + exact.elements()[i].name;
    for (const std::uint32_t j : order) dense += "," + shortest(exact.factor(i, j).value);
  }
  expect_same(matched(prepared, "f.csv", dense), exact);

  std::string list = "\xEF\xBB\xBFvalue of nothing,to,from,factor\n";
  for (const std::uint32_t i : order)
    for (const std::uint32_t j : order)
      if (i != j)
        list += ",\"" + exact.elements()[j].name + "\"," + exact.elements()[i].name + "," +
                shortest(exact.factor(i, j).value) + "\n\n";
  expect_same(matched(prepared, "g.csv", list), exact);

  std::string names = "face\n", numbers;
  for (const std::uint32_t i : order) {
    names += exact.elements()[i].name + "\n";
    for (const std::uint32_t j : order) numbers += (j == 4 ? "" : ",") + shortest(exact.factor(i, j).value);
    numbers += "\n";
  }
  write("h.csv.faces.csv", names);
  expect_same(matched(prepared, "h.csv", numbers), exact);
}

TEST_F(ExternalMatrixTest, ReadsBothPrecisionsAndOrdersOfNumPy) {
  const PreparedScene2 prepared = room();
  const ExchangeMatrix expected = numbers_in_order(prepared);
  expect_same(matched(prepared, "a.npy", numpy<double>("<f8", false, 4, 4, number)), expected);
  expect_same(matched(prepared, "b.npy", numpy<double>("<f8", true, 4, 4, number, 2)), expected);
  expect_same(matched(prepared, "c.npy", numpy<float>("<f4", false, 4, 4, number, 3)), expected);
  expect_same(matched(prepared, "d.npy", numpy<float>("<f4", true, 4, 4, number)), expected);
}

TEST_F(ExternalMatrixTest, WithoutNamesSizesTellWhichFacesAreThere) {
  const PreparedScene2 prepared = room();
  ExchangeMatrix expected = numbers_in_order(prepared);
  const auto of_all = [](std::uint32_t i, std::uint32_t j) {
    return i % 2 == 0 && j % 2 == 0 && i < 8 && j < 8 ? number(i / 2, j / 2) : 0;
  };
  const auto of_four = [](std::uint32_t i, std::uint32_t j) { return i < 4 && j < 4 ? number(i, j) : 0; };
  for (const auto& [rows, columns] : std::vector<std::pair<std::uint32_t, std::uint32_t>>{{4, 5}, {5, 5}, {4, 4}})
    expect_same(matched(prepared, "a.npy", numpy<double>("<f8", false, rows, columns, of_four)), expected);
  for (const auto& [rows, columns] : std::vector<std::pair<std::uint32_t, std::uint32_t>>{{8, 8}, {8, 9}, {9, 9}})
    expect_same(matched(prepared, "a.npy", numpy<double>("<f8", false, rows, columns, of_all)), expected);
  for (const auto& [rows, columns] :
       std::vector<std::pair<std::uint32_t, std::uint32_t>>{{3, 3}, {5, 4}, {6, 6}, {10, 10}, {4, 1}, {1, 4}})
    EXPECT_THAT(why("a.npy", numpy<double>("<f8", false, rows, columns, of_four)),
                StartsWith("a.npy: is " + std::to_string(rows) + " x " + std::to_string(columns) +
                           ", which does not fit the scene's 8 faces, 4 of them with a material"));
}

TEST_F(ExternalMatrixTest, ReadsAllOfMatrixMarketThatHoldsRealNumbers) {
  const PreparedScene2 prepared = room();
  const ExchangeMatrix expected = numbers_in_order(prepared);
  std::string array = "%%MatrixMarket MATRIX Array Real General\n% by columns\n%\n4 4\n";
  std::string coordinates = "%%MatrixMarket matrix coordinate real general\r\n4 4 12\r\n";
  for (std::uint32_t j = 0; j < 4; ++j)
    for (std::uint32_t i = 0; i < 4; ++i) {
      array += shortest(number(i, j)) + "\n";
      if (i != j)
        coordinates += std::to_string(i + 1) + " " + std::to_string(j + 1) + " +" + shortest(number(i, j)) + "\r\n";
    }
  expect_same(matched(prepared, "a.mtx", array), expected);
  expect_same(matched(prepared, "b.mtx", coordinates), expected);

  const ExchangeMatrix lower =
      matched(prepared, "c.mtx", "%%MatrixMarket matrix coordinate integer symmetric\n4 4 2\n2 1 3\n4 4 7\n");
  EXPECT_EQ(lower.factor(0, 2).value, 3);
  EXPECT_EQ(lower.factor(2, 0).value, 3);
  EXPECT_EQ(lower.factor(6, 6).value, 7);
  EXPECT_EQ(lower.entry_count(), 3u);
  const ExchangeMatrix triangle =
      matched(prepared, "d.mtx", "%%MatrixMarket matrix array real symmetric\n4 4\n0 1 2 3 0 4 5 0 6 0\n");
  EXPECT_EQ(triangle.factor(4, 6).value, 6);
  EXPECT_EQ(triangle.factor(6, 4).value, 6);
  EXPECT_EQ(triangle.factor(0, 6).value, 3);
}

TEST_F(ExternalMatrixTest, ReadsView3dAsItPrints) {
  const PreparedScene2 prepared = room();
  const std::string head = "View3D 4.0.0 0 1 0 4          \n";
  const std::string rows =
      "0.000000 0.333333 0.333333 0.333333\n0.250000 0.000000 0.250000 0.500000\n"
      "0.333333 0.333333 0.000000 0.333333\n0.250000 0.500000 0.250000 0.000000\n";
  const ExchangeMatrix matrix = matched(prepared, "v.txt", head + "3 4 3 4\n" + rows + "0.5 0.5 0.5 0.5\n");
  EXPECT_EQ(matrix.factor(0, 2).value, 0.333333);
  EXPECT_EQ(report_.written->digits.rounding(0.5), 5e-7);
  EXPECT_THAT(report_.notes, testing::Contains(HasSubstr("rescaled the rows")));
  EXPECT_EQ(report_.row_defect, 1 - (0.333333 + 0.333333 + 0.333333));
  matched(prepared, "v.txt", head + "4 3 3 4\n" + rows + "0.5 0.5 0.5 0.5\n");
  EXPECT_THAT(report_.notes, testing::Contains("areas differ, as if the order of the faces or the unit of length were "
                                               "another: 'a (4 in the file, 3 in the scene)', 'b (3 in the file, 4 in "
                                               "the scene)'"));
}

TEST_F(ExternalMatrixTest, CountsTheDigitsThatWerePrinted) {
  const PreparedScene2 prepared = room();
  const auto rounding = [&](const std::string& a, const std::string& b, double value) {
    matched(prepared, "f.csv", "from,to,factor\na,b," + a + "\na,c," + b + "\n");
    return report_.written->digits.rounding(value);
  };
  EXPECT_DOUBLE_EQ(rounding("0.333333", "0.000012", 0.000012), 5e-7);    // %.6f
  EXPECT_DOUBLE_EQ(rounding("0.333333", "0.00123457", 0.333333), 5e-7);  // %.6g
  EXPECT_DOUBLE_EQ(rounding("0.333333", "0.00123457", 0.00123457), 5e-9);
  EXPECT_DOUBLE_EQ(rounding("3.3333e-01", "1.2346e-05", 1.2346e-05), 5e-10);  // %.4e
  EXPECT_DOUBLE_EQ(rounding("0.5", "1", 0.5), 5e-4);
  EXPECT_LT(rounding("0.33333333333333331", "1", 0.33), 1e-16);
  EXPECT_DOUBLE_EQ(rounding("0.3333", "0", 0), 5e-5);
}

TEST_F(ExternalMatrixTest, SaysWhichNamesAreUnknownOrMissing) {
  EXPECT_EQ(why("f.csv", "from,to,factor\na,b,0.5\na,x,0.5\n\"b\",y,0.1\n"), "f.csv:3: the scene has no face 'x', 'y'");
  EXPECT_EQ(why("f.csv", ",a,b,c\na,0,1,0\nb,1,0,0\nc,0,0,0\n"), "f.csv: has no row of the face 'd'");
  EXPECT_EQ(why("f.csv", ",a,b,c\na,0,1,0\nb,1,0,0\nc,0,0,0\nd,0,0,1\n"), "f.csv: has no column of the face 'd'");
  EXPECT_EQ(why("f.csv", ",a,b,a\na,0,1,0\n"), "f.csv:1: the face 'a' is named twice");
  write("g.npy.faces.csv", "index,face\n1,a\n2,b\n3,c\n5,d\n");
  const std::string four = numpy<double>("<f8", false, 4, 4, number);
  EXPECT_EQ(why("g.npy", four), "g.npy.faces.csv:5: the index 4 is missing");
  write("g.npy.faces.csv", "index,face\n1,a\n2,b\n3,c\n3,d\n");
  EXPECT_EQ(why("g.npy", four), "g.npy.faces.csv:5: the index 3 is given twice");
  write("g.npy.faces.csv", "face\na\nb\nc\nd\nsky\n");
  EXPECT_EQ(why("g.npy", four), "g.npy.faces.csv: names 5 faces for a matrix of 4 x 4");
  write("g.npy.faces.csv", "face\na\nb\nc\nlamp\n");
  EXPECT_EQ(why("g.npy", four), "g.npy.faces.csv:5: the scene has no face 'lamp'");
}

TEST_F(ExternalMatrixTest, SaysThatFacesAreDivided) {
  Scene2 scene = read_scene_2(write("room.json", kRoom));
  scene.surfaces[1].elements = 2;
  const PreparedScene2 prepared = prepare(std::move(scene), Divided2::kYes);
  try {
    matched(prepared, "f.csv", "from,to,factor\na,b,0.5\n");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("the scene has no face 'b'"));
    EXPECT_THAT(error.hints(), testing::Contains(HasSubstr("--per element")));
  }
}

TEST_F(ExternalMatrixTest, RefusesWhatIsNoNumberAndWhatBreaksOff) {
  const auto with = [](const std::string& number) { return "from,to,factor\na,b,0.5\na,c," + number + "\n"; };
  EXPECT_EQ(why("f.csv", with("nan")), "f.csv:3: 'nan' is not a finite number");
  EXPECT_EQ(why("f.csv", with("-inf")), "f.csv:3: '-inf' is not a finite number");
  EXPECT_EQ(why("f.csv", with("1e999")), "f.csv:3: '1e999' is too large");
  EXPECT_EQ(why("f.csv", with("")), "f.csv:3: '' is not a number");
  EXPECT_EQ(why("f.csv", with("0,5")), "f.csv:3: 4 fields where 3 are expected");
  EXPECT_EQ(why("f.csv", with("1D-3")), "f.csv:3: '1D-3' is not a number");
  EXPECT_EQ(why("f.csv", with("\"0.5")), "f.csv:3: a quoted field is not closed");
  EXPECT_EQ(why("f.csv", with("\"0.5\"x")), "f.csv:3: a comma or a line end must follow a quoted field");
  EXPECT_EQ(why("f.csv", with("1e-999")), "nothing is wrong");
  EXPECT_EQ(why("f.csv", "from,to,factor\na,b,0.5\na,b,0.5\n"),
            "f.csv:3: the factor from 'a' to 'b' is given twice, first in line 2");
  EXPECT_EQ(why("f.csv", "from,to,value\na,b,0.5\n"),
            "f.csv:1: a list of pairs needs a column 'factor' beside 'from' and 'to'");
  EXPECT_THAT(why("f.csv", ""), StartsWith("f.csv: is empty"));
  EXPECT_EQ(why("f.csv", "face,radiosity\na,1\n"), "f.csv:1: holds radiosities, not view factors");

  const std::string market = "%%MatrixMarket matrix coordinate real general\n";
  EXPECT_EQ(why("f.mtx", market + "4 4 2\n1 2 0.5\n"), "f.mtx:4: breaks off: more numbers are expected");
  EXPECT_EQ(why("f.mtx", market + "4 4 1\n1 2 0.5\n3"), "f.mtx:4: goes on after the last entry");
  EXPECT_EQ(why("f.mtx", market + "4 4 1\n1 5 0.5\n"), "f.mtx:3: a column must be a whole number from 1 to 4, not '5'");
  EXPECT_THAT(why("f.mtx", market + "4 4 4000000000000\n"), StartsWith("f.mtx:2: the number of entries must be"));
  EXPECT_THAT(why("f.mtx", market + "4 4 4000000000\n"), StartsWith("f.mtx:3: breaks off"));
  EXPECT_EQ(why("f.mtx", "%%MatrixMarket matrix coordinate complex general\n1 1 0\n"),
            "f.mtx:1: the numbers must be real or integer, not 'complex'");
  EXPECT_EQ(why("f.mtx", "4 4 1\n1 2 0.5\n"), "f.mtx: holds no view factors in a format that hottel reads");
  EXPECT_EQ(why("f.mtx", "%%MatrixMarket matrix array real symmetric\n4 3\n"),
            "f.mtx:2: a symmetric matrix must be square");

  EXPECT_EQ(why("f.npy", "NUMPY"), "f.npy: holds no view factors in a format that hottel reads");
  std::string array = numpy<double>("<f8", false, 4, 4, number);
  EXPECT_EQ(why("f.npy", array.substr(0, array.size() - 1)),
            "f.npy: has 127 bytes of numbers; 4 x 4 of 8 bytes are expected");
  EXPECT_THAT(why("f.npy", array.substr(0, 20)), StartsWith("f.npy: ends within NumPy's header"));
  for (const char* type : {"<c16", "|b1", "<f2", "|i3", "f", ""})
    EXPECT_THAT(why("f.npy", numpy_head(type, false, "4, 4")),
                StartsWith("f.npy: holds numbers of the type " +
                           (*type == 0 ? std::string("of no name") : "'" + std::string(type) + "'") + ";"));
  EXPECT_THAT(why("f.npy", numpy<double>("<f8", false, 4, 4, [](auto, auto) { return std::nan(""); })),
              StartsWith("f.npy: the number in row 1, column 1 is not finite"));
  EXPECT_EQ(why("f.npy", numpy_head("<f8", false, "2147483647, 2147483647")),
            "f.npy: has 0 bytes of numbers; 2147483647 x 2147483647 of 8 bytes are expected");
  EXPECT_EQ(why("f.npy", numpy_head("<f8", false, "4,")),
            "f.npy: holds an array of 1 dimension; a matrix, of 2, is expected");

  const std::string view3d = "View3D 4.0.0 0 0 0 2\n3 3\n0 0\n0 0\n0.5 0.5\n";
  EXPECT_THAT(why("f.txt", view3d), StartsWith("f.txt: is 2 x 2, which does not fit"));
  EXPECT_EQ(why("f.txt", view3d.substr(0, 30)), "f.txt:4: breaks off: View3D's text of 2 surfaces has more numbers");
  EXPECT_EQ(why("f.txt", view3d + "1"), "f.txt:6: goes on after the emittances of 2 surfaces");
  EXPECT_EQ(why("f.txt", "View3D 4.0.0 0 0 1 1\n3\n0\n0.5\n"), "f.txt:1: holds Hottel's script-F, not view factors");
  EXPECT_THAT(why("f.txt", "View3D 4.0.0 0 0 0 2000000000\n3\n0\n0.5\n"), StartsWith("f.txt:5: breaks off"));
  EXPECT_THAT(why("f.bin", "View3D 4.0.0 1 0 0 2000000000\r\n"), StartsWith("f.bin: has 0 bytes"));
}

TEST_F(ExternalMatrixTest, NegativeFactorsAndRowsNotUsedAreReported) {
  const PreparedScene2 prepared = room();
  const ExchangeMatrix matrix =
      matched(prepared, "f.csv", "from,to,factor\na,b,-0.5\nb,sky,0.25\nsky,a,0.5\na:back,sky,1\n");
  EXPECT_EQ(matrix.factor(0, 2).value, -0.5);
  EXPECT_EQ(matrix.factor(2, 8).value, 0.25);
  EXPECT_EQ(matrix.entry_count(), 2u);
  EXPECT_THAT(report_.notes, testing::ElementsAre("rows of faces without a material are not used: 'sky', 'a:back'",
                                                  "1 factor is negative"));
  EXPECT_EQ(report_.row_defect, 1.5);
}

// Whatever the bytes: a matrix, or an InputError. Memory stays proportional to the file (a bad_alloc would fail this).
TEST_F(ExternalMatrixTest, AnyBytesAreReadOrRefused) {
  const PreparedScene2 prepared = room();
  const ExchangeMatrix exact = exact_exchange(prepared);
  const FactorTable table{prepared.scene, exact, Granularity::kElement, {}};
  const std::vector<std::pair<std::string, std::string>> files = {
      {"f.csv", written([&](const Sink& s) { write_factors_csv(table, s); })},
      {"d.csv", written([&](const Sink& s) { write_dense_csv(table, DenseQuantity::kFactor, s); })},
      {"f.mtx", written([&](const Sink& s) { write_factors_mtx(table, s); })},
      {"f.npy", numpy<double>("<f8", false, 4, 4, number)},
      {"g.npy", numpy<float>("<f4", true, 4, 4, number, 2)},
      {"f.txt", written([&](const Sink& s) { write_factors_view3d_text(table, s); })},
      {"f.bin", written([&](const Sink& s) { write_factors_view3d_binary(table, s); })}};
  std::mt19937 random(7);
  std::size_t refused = 0, read = 0;
  for (const auto& [name, text] : files)
    for (int k = 0; k < 3000; ++k) {
      std::string broken = text;
      if (k % 3 == 0) broken.resize(random() % broken.size());
      for (std::uint32_t flips = random() % 4; flips > 0 && !broken.empty(); --flips)
        broken[random() % std::min<std::size_t>(broken.size(), k % 2 == 0 ? 64 : broken.size())] =
            static_cast<char>(k % 5 == 0 ? "0123456789,.\n "[random() % 14] : random());
      try {
        MethodReport report;
        match_external_matrix(parse_external_matrix(name, broken), exact.elements(), report);
        ++read;
      } catch (const InputError&) {
        ++refused;
      }
    }
  EXPECT_GT(refused, 3000u);
  EXPECT_GT(read, 3000u);
}

}  // namespace
}  // namespace hottel::external_matrix_test
