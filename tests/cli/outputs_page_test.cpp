// docs/outputs.md against the golden files: each is described, and each table of columns is the first line of its csv.
#include <gtest/gtest.h>

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "tests/cli/program.h"

namespace hottel::outputs_page_test {
namespace {

using testing_cli::contents;
using testing_cli::lines_of;
namespace fs = std::filesystem;

const fs::path kGolden = fs::path(HOTTEL_SOURCE_DIR) / "tests/contract";

// What a heading of the page stands over.
struct Section {
  std::string heading, columns;       // "from,to,factor"; empty without a table of columns
  std::vector<std::string> examples;  // file names
};

std::vector<Section> sections() {
  std::vector<Section> result;
  bool is_in_table = false;
  const std::string link = "](../tests/contract/";
  for (const std::string& line : lines_of(contents(fs::path(HOTTEL_SOURCE_DIR) / "docs/outputs.md"))) {
    if (line.starts_with("#")) result.push_back({line, "", {}});
    if (line.starts_with("| column |")) is_in_table = true;
    if (line.empty()) is_in_table = false;
    Section& section = result.back();
    if (is_in_table && line.starts_with("| `"))
      section.columns += (section.columns.empty() ? "" : ",") + line.substr(3, line.find('`', 3) - 3);
    for (std::size_t at = line.find(link); at != std::string::npos; at = line.find(link, at + 1))
      section.examples.push_back(line.substr(at + link.size(), line.find(')', at) - at - link.size()));
  }
  return result;
}

TEST(OutputsPage, HasTheColumnsOfEachCsvInTheirOrder) {
  std::size_t compared = 0;
  for (const Section& section : sections())
    for (const std::string& example : section.examples) {
      if (!example.ends_with(".csv") || section.columns.empty()) continue;
      EXPECT_EQ(lines_of(contents(kGolden / example)).front(), section.columns) << section.heading << ", " << example;
      ++compared;
    }
  EXPECT_GE(compared, 20u);
}

TEST(OutputsPage, TellsOfEveryGoldenFileOnce) {
  std::multiset<std::string> told;
  for (const Section& section : sections()) told.insert(section.examples.begin(), section.examples.end());
  const std::set<std::string> read{"box.json", "shed.json", "night.json", "beacon.json", "deck.vs3", "regenerate"};
  for (const auto& entry : fs::directory_iterator(kGolden)) {
    const std::string name = entry.path().filename().string();
    EXPECT_EQ(told.count(name), read.contains(name) ? 0u : 1u) << name;
  }
  for (const std::string& name : told) EXPECT_TRUE(fs::exists(kGolden / name)) << name;
}

// A csv that has columns has a table of them: all but the dense ones, whose columns are faces.
TEST(OutputsPage, HasATableForEachCsv) {
  for (const Section& section : sections())
    for (const std::string& example : section.examples)
      if (example.ends_with(".csv") && example.find("matrix_") == std::string::npos) {
        EXPECT_NE(section.columns, "") << section.heading << ", " << example;
      }
}

}  // namespace
}  // namespace hottel::outputs_page_test
