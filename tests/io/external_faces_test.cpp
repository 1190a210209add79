// Names and sizes that tell which faces the rows of a file are.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "geometry/plane/exchange/exchange.h"
#include "tests/io/external_room.h"

namespace hottel::external_faces_test {
namespace {

using testing::Contains;
using testing::HasSubstr;

class ExternalFacesTest : public ExternalRoomTest {
 protected:
  // Squares of numbers as csv, row by row.
  static std::string csv(const ExchangeMatrix& exact, const std::vector<std::uint32_t>& places) {
    std::string text;
    for (const std::uint32_t i : places) {
      for (const std::uint32_t j : places)
        text += (j == places[0] ? "" : ",") +
                (i < exact.size() && exact.has_row(i) ? fmt::format("{}", exact.factor(i, j).value) : "0");
      text += "\n";
    }
    return text;
  }
  static std::string npy(const std::vector<double>& values, int n) {
    std::string head = fmt::format("{{'descr': '<f8', 'fortran_order': False, 'shape': ({0}, {0}), }}", n);
    head += std::string(118 - head.size() - 1, ' ') + "\n";
    return "\x93NUMPY" + std::string("\x01\x00\x76\x00", 4) + head +
           std::string(reinterpret_cast<const char*>(values.data()), 8 * values.size());
  }
};

TEST_F(ExternalFacesTest, ASidecarOfNumPyNamesThem) {
  const PreparedScene2 prepared = room();
  const std::string file = npy({0, 0.1, 0.2, 0, 0, 0, 0, 0.3, 0, 0, 0, 0.4, 0.5, 0, 0, 0}, 4);
  write("g.npy.json", R"({"names": ["d", "c", "b", "a"]})");
  const ExchangeMatrix matrix = matched(prepared, "g.npy", file);
  EXPECT_EQ(matrix.factor("d", "c").value, 0.1);
  EXPECT_EQ(matrix.factor("c", "a").value, 0.3);
  write("g.npy.json", R"({"names": ["d", "c", "b", "lamp"]})");
  EXPECT_EQ(why("g.npy", file), "g.npy.json: the scene has no face 'lamp'");
  write("g.npy.json", R"({"names": ["d", "c", "b"]})");
  EXPECT_EQ(why("g.npy", file), "g.npy.json: names 3 faces for a matrix of 4 x 4");
  write("g.npy.faces.csv", "face\na\nb\nc\nd\n");
  EXPECT_EQ(matched(prepared, "g.npy", file).factor("a", "b").value, 0.1) << "FILE.faces.csv comes first";
  std::filesystem::remove(path("g.npy.faces.csv"));
  for (const char* other : {"{}", "[1]", R"({"names": 7})", R"({"names": [1, 2, 3, 4]})", "no json"}) {
    write("g.npy.json", other);
    EXPECT_EQ(matched(prepared, "g.npy", file).factor("a", "b").value, 0.1) << other;
  }
}

// Five faces with materials and a black one: 6 x 6 is of all, or of those with a material and the sky.
TEST_F(ExternalFacesTest, OfTwoMeaningsTheMoreSymmetricIsTaken) {
  const PreparedScene2 prepared = prepare(parse_scene_2(
      R"({"hottel": 1, "dimension": 2, "materials": {"white": {"reflectivity": 0.5}}, "edges": [
      {"name": "w", "points": [[1, 1], [2, 3]], "material": "white"},
      {"name": "a", "points": [[0, 0], [0, 3]], "material": "white", "back": "white"},
      {"name": "b", "points": [[0, 4], [4, 4]], "material": "white", "back": "white"}]})",
      "six.json"));
  const ExchangeMatrix exact = exact_exchange(prepared);
  ASSERT_EQ(exact.size(), 6u);
  const auto judged = [&](const std::vector<std::uint32_t>& places, const char* taken) {
    const ExchangeMatrix matrix = matched(prepared, "f.csv", csv(exact, places));
    EXPECT_THAT(report_.notes, Contains(HasSubstr(taken)));
    EXPECT_EQ(matrix.factor("a", "w").value, exact.factor("a", "w").value);
    EXPECT_EQ(matrix.factor("w", "b").value, exact.factor("w", "b").value);
  };
  judged({0, 1, 2, 3, 4, 5}, "6 x 6 is taken for all faces (");
  judged({0, 2, 3, 4, 5, 6}, "6 x 6 is taken for the faces with a material and the sky (");
}

}  // namespace
}  // namespace hottel::external_faces_test
