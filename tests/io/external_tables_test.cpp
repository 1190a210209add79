// Tables of factors as numerical programs write them: csv of any separator, NumPy's arrays of any type.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "io/external/plane/external_matrix.h"
#include "kernel/rational.h"
#include "tests/io/external_numbers.h"
#include "tests/io/external_room.h"

namespace hottel::external_tables_test {
namespace {

class ExternalTables : public ExternalRoomTest {};

TEST_F(ExternalTables, ReadsTablesAsOthersWriteThem) {
  const PreparedScene2 prepared = room();
  const ExchangeMatrix expected = numbers_in_order(prepared);
  // What stands before, between and after the numbers of a row.
  for (const auto& [before, between, after] : std::vector<std::array<std::string, 3>>{{"", ", ", "\n"},
                                                                                      {"", ",   ", "\r\n"},
                                                                                      {"", ";", "\n"},
                                                                                      {"", "; ", "\n"},
                                                                                      {"", "\t", "\n"},
                                                                                      {"", " ", "\n"},
                                                                                      {"  ", "   ", " \r\n"},
                                                                                      {" ", " ,", " \n"}}) {
    std::string numbers = "# a comment, of np.savetxt\n",
                named = "face" + between + "a" + between + "b" + between + "c" + between + "d" + after;
    std::string list = "from" + between + "to" + between + "factor" + after;
    for (std::uint32_t i = 0; i < 4; ++i) {
      named += std::string(1, static_cast<char>('a' + i));
      numbers += before;
      for (std::uint32_t j = 0; j < 4; ++j) {
        numbers += (j == 0 ? "" : between) + shortest(number(i, j));
        named += between + shortest(number(i, j));
        if (i != j)
          list += std::string(1, static_cast<char>('a' + i)) + between + static_cast<char>('a' + j) + between +
                  shortest(number(i, j)) + after;
      }
      numbers += after;
      named += after;
    }
    expect_same(matched(prepared, "f.csv", numbers), expected);
    expect_same(matched(prepared, "f.txt", numbers), expected);
    if (between == " ,") continue;  // blanks before commas belong to names
    expect_same(matched(prepared, "g.csv", named), expected);
    expect_same(matched(prepared, "h.csv", list), expected);
  }
}

TEST_F(ExternalTables, ReadsArraysOfEitherByteOrderAndOfIntegers) {
  const PreparedScene2 prepared = room();
  const ExchangeMatrix expected = numbers_in_order(prepared);
  const std::string little = numpy<double>("<f8", false, 4, 4, number),
                    little4 = numpy<float>("<f4", false, 4, 4, number);
  for (const auto& [text, bytes] : {std::pair{little, 8u}, {little4, 4u}}) {
    std::string big = text;
    const auto begin = big.end() - 16 * static_cast<std::ptrdiff_t>(bytes);
    for (auto at = begin; at != big.end(); at += bytes) std::reverse(at, at + bytes);
    big.replace(big.find('<'), 1, ">");
    expect_same(matched(prepared, "f.npy", big), expected);
  }
  const auto whole = [](std::uint32_t i, std::uint32_t j) { return i == j ? 0.0 : i == 0 ? 1 : 0; };
  const auto negative = [](std::uint32_t i, std::uint32_t j) { return i == 0 && j == 1 ? -2.0 : 0.0; };
  EXPECT_EQ(matched(prepared, "i.npy", numpy<std::int32_t>("<i4", false, 4, 4, whole)).factor(0, 2).value, 1);
  EXPECT_EQ(matched(prepared, "i.npy", numpy<std::uint8_t>("|u1", false, 4, 4, whole)).factor(0, 2).value, 1);
  EXPECT_EQ(matched(prepared, "i.npy", numpy<std::int8_t>("|i1", false, 4, 4, negative)).factor(0, 2).value, -2);
  EXPECT_EQ(matched(prepared, "i.npy", numpy<std::int64_t>("<i8", true, 4, 4, negative)).factor(0, 2).value, -2);
}

TEST_F(ExternalTables, AListWithoutItsFirstLineIsToldWhatThatMustBe) {
  const std::string told = "f.csv:1: the first line must be from,to,factor, or the names of a matrix' columns";
  for (const char* list : {"a,b,0.5\nb,a,0.5\n", "x,y,F\na,b,0.5\n", "a,b,0.5,0.5,0.5\n", "a b 0.5\n"})
    EXPECT_EQ(why("f.csv", list), told) << list;
}

}  // namespace
}  // namespace hottel::external_tables_test
