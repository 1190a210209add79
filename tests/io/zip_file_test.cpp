// Zip archives, read back record by record.
#include "io/files/zip_file.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

namespace hottel::zip_file_test {
namespace {

std::string archive(const std::vector<std::pair<std::string, std::string>>& entries) {
  std::string bytes;
  ZipWriter zip([&](std::string_view part) { bytes += part; });
  for (const auto& [name, content] : entries) zip.add(name, content);
  zip.finish();
  return bytes;
}

std::uint32_t number(const std::string& bytes, std::size_t at, std::size_t size) {
  std::uint32_t value = 0;
  for (std::size_t k = 0; k < size; ++k)
    value |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes.at(at + k))) << (8 * k);
  return value;
}

TEST(ZipFile, EntriesStandInOrderAsTheyAreWithTheirChecksums) {
  const std::string bytes = archive({{"a.txt", "123456789"}, {"empty", ""}});
  EXPECT_EQ(number(bytes, 0, 4), 0x04034b50u);
  EXPECT_EQ(number(bytes, 8, 2), 0u) << "stored";
  EXPECT_EQ(number(bytes, 14, 4), 0xcbf43926u) << "the check value of CRC-32";
  EXPECT_EQ(number(bytes, 18, 4), 9u);
  EXPECT_EQ(number(bytes, 22, 4), 9u);
  EXPECT_EQ(bytes.substr(30, 14), "a.txt123456789");
  EXPECT_EQ(number(bytes, 44, 4), 0x04034b50u);
  EXPECT_EQ(bytes.substr(74, 5), "empty");
  const std::size_t end = bytes.size() - 22;
  EXPECT_EQ(number(bytes, end, 4), 0x06054b50u);
  EXPECT_EQ(number(bytes, end + 10, 2), 2u) << "entries";
  const std::size_t table = number(bytes, end + 16, 4);
  EXPECT_EQ(table, 79u);
  EXPECT_EQ(table + number(bytes, end + 12, 4), end);
  EXPECT_EQ(number(bytes, table, 4), 0x02014b50u);
  EXPECT_EQ(number(bytes, table + 42, 4), 0u) << "where the first entry begins";
  const std::size_t second = table + 46 + 5;
  EXPECT_EQ(number(bytes, second, 4), 0x02014b50u);
  EXPECT_EQ(number(bytes, second + 42, 4), 44u);
}

TEST(ZipFile, BytesThatDoNotLieInMemoryGiveTheSameArchive) {
  std::string bytes;
  ZipWriter zip([&](std::string_view part) { bytes += part; });
  zip.add("a.txt", [](const ZipWriter::Sink& sink) {
    sink("1234");
    sink("56789");
  });
  zip.finish();
  EXPECT_EQ(bytes, archive({{"a.txt", "123456789"}}));
}

TEST(ZipFile, AnEmptyArchiveIsItsEnd) { EXPECT_EQ(archive({}).size(), 22u); }

TEST(ZipFile, SameEntriesGiveSameBytes) { EXPECT_EQ(archive({{"x", "y"}}), archive({{"x", "y"}})); }

}  // namespace
}  // namespace hottel::zip_file_test
