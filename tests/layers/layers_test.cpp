// The architecture, read off the include lines.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <optional>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace hottel {
namespace {

namespace fs = std::filesystem;

// Each layer may include itself and those before it.
constexpr std::array<const char*, 6> kLayers{"kernel", "geometry", "solver", "io", "viewer", "cli"};
constexpr std::size_t kMostCgalUnits = 4;

// Folders that know no dimension, subfolders `plane` and `space` aside.
constexpr std::array<const char*, 4> kWithoutDimension{"kernel", "geometry", "solver/radiosity", "solver/compare"};

std::optional<std::size_t> layer_of(const fs::path& path) {
  const auto layer = std::find(kLayers.begin(), kLayers.end(), path.begin()->string());
  if (layer == kLayers.end()) return std::nullopt;
  return static_cast<std::size_t>(layer - kLayers.begin());
}

struct Include {
  std::string path;
  bool is_quoted = false;
};

// The includes of a text, in order.
std::vector<Include> includes(std::istream& text) {
  static const std::regex kInclude(R"re(^\s*#\s*include\s*([<"])([^>"]+)[>"])re");
  std::vector<Include> result;
  std::smatch match;
  for (std::string line; std::getline(text, line);)
    if (std::regex_search(line, match, kInclude)) result.push_back({match[2], match[1] == "\""});
  return result;
}

// Why a file (path from the root) may not include this; empty when it may.
std::string problem(const fs::path& file, const Include& include) {
  const auto layer = layer_of(file);
  if (include.is_quoted && layer) {
    const auto other = layer_of(include.path);
    if (!other) return "is not written from the root";
    if (*other > *layer) return "goes upwards";
  }
  const bool is_cgal = include.path.rfind("CGAL/", 0) == 0 || include.path == "kernel/kernels.h";
  if (is_cgal && file.extension() == ".h" && file != "kernel/kernels.h") return "brings CGAL into a header";
  return "";
}

struct Source {
  fs::path path;  // from the root
  std::vector<Include> includes;
};

std::vector<Source> product_sources() {
  std::vector<Source> result;
  for (const char* layer : kLayers) {
    const fs::path folder = fs::path(HOTTEL_SOURCE_DIR) / layer;
    if (!fs::exists(folder)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
      const std::string ending = entry.path().extension().string();
      if (ending != ".h" && ending != ".cpp") continue;
      std::ifstream text(entry.path());
      result.push_back({fs::relative(entry.path(), HOTTEL_SOURCE_DIR), includes(text)});
    }
  }
  return result;
}

TEST(Layers, NothingIncludesUpwardsAndNoHeaderBringsCgal) {
  const auto sources = product_sources();
  EXPECT_GT(sources.size(), 40u);
  for (const Source& source : sources)
    for (const Include& include : source.includes)
      EXPECT_EQ(problem(source.path, include), "") << source.path << " includes " << include.path;
}

// True iff a folder of this name is on the path.
bool lies_in(const fs::path& path, const char* folder) {
  return std::find(path.begin(), path.end(), folder) != path.end();
}

bool knows_the_dimension(const fs::path& path) { return lies_in(path, "plane") || lies_in(path, "space"); }

TEST(Layers, WhatHasNoDimensionIncludesNothingThatHas) {
  for (const Source& source : product_sources()) {
    const std::string path = source.path.string();
    const bool is_without = std::any_of(kWithoutDimension.begin(), kWithoutDimension.end(),
                                        [&](const std::string& folder) { return path.rfind(folder + "/", 0) == 0; });
    if (!is_without || knows_the_dimension(source.path)) continue;
    for (const Include& include : source.includes)
      EXPECT_FALSE(knows_the_dimension(include.path)) << path << " includes " << include.path;
  }
}

// A unit is a header and the source of the same name: "kernel/ball".
using Units = std::map<std::string, std::set<std::string>>;  // by name: the units it includes

Units units_of(const std::vector<Source>& sources) {
  const auto unit = [](fs::path path) { return path.replace_extension().string(); };
  Units units;
  for (const Source& source : sources) units[unit(source.path)];
  for (const Source& source : sources)
    for (const Include& include : source.includes)
      if (const std::string to = unit(include.path); include.is_quoted && to != unit(source.path) && units.count(to))
        units[unit(source.path)].insert(to);
  return units;
}

// Returns units each of which includes the next, the first one again at the end; empty when there is no circle.
std::vector<std::string> circle_of(const Units& units) {
  std::set<std::string> done;
  std::vector<std::string> way;
  const std::function<bool(const std::string&)> leads_back = [&](const std::string& unit) {
    const bool is_on_the_way = std::find(way.begin(), way.end(), unit) != way.end();
    way.push_back(unit);
    if (is_on_the_way) return true;
    for (const std::string& next : units.at(unit))
      if (!done.count(next) && leads_back(next)) return true;
    way.pop_back();
    done.insert(unit);
    return false;
  };
  for (const auto& [unit, includes] : units) {
    if (done.count(unit) || !leads_back(unit)) continue;
    way.erase(way.begin(), std::find(way.begin(), way.end(), way.back()));
    return way;
  }
  return {};
}

TEST(Layers, NoCirclesOfUnits) {
  const Units units = units_of(product_sources());
  EXPECT_GT(units.size(), 100u);
  EXPECT_THAT(circle_of(units), testing::IsEmpty());
}

TEST(Layers, CirclesAreFound) {
  const auto circle = [](const std::vector<Source>& sources) { return circle_of(units_of(sources)); };
  EXPECT_THAT(circle({{"a.h", {}}, {"a.cpp", {{"a.h", true}}}, {"b.h", {{"a.h", true}}}}), testing::IsEmpty());
  EXPECT_THAT(circle({{"a.h", {{"b.h", true}}},
                      {"b.h", {}},
                      {"b.cpp", {{"b.h", true}, {"c.h", true}}},
                      {"c.h", {{"d.h", true}}},
                      {"d.cpp", {{"b.h", true}}},
                      {"d.h", {}}}),
              testing::ElementsAre("b", "c", "d", "b"));
}

TEST(Layers, FewUnitsOfTheProductCompileCgal) {
  std::vector<std::string> units;
  for (const Source& source : product_sources())
    if (source.path.extension() == ".cpp" &&
        std::any_of(source.includes.begin(), source.includes.end(),
                    [](const Include& i) { return i.path.rfind("CGAL/", 0) == 0 || i.path == "kernel/kernels.h"; }))
      units.push_back(source.path.string());
  EXPECT_LE(units.size(), kMostCgalUnits) << ::testing::PrintToString(units);
}

TEST(Layers, TheOracleKnowsNothingOfTheKernel) {
  // The brute force is a second opinion: it may share plain structs and nothing that computes.
  const fs::path folder = fs::path(HOTTEL_SOURCE_DIR) / "tests/oracle";
  if (!fs::exists(folder)) return;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    if (entry.path().filename().string().find("_test") != std::string::npos) continue;
    std::ifstream text(entry.path());
    for (const Include& include : includes(text)) {
      const std::string first = fs::path(include.path).begin()->string();
      EXPECT_TRUE(first != "kernel" && first != "geometry" && first != "CGAL")
          << entry.path() << " includes " << include.path;
    }
  }
}

TEST(Layers, TheCheckSeesWhatItForbids) {
  EXPECT_EQ(problem("kernel/a.h", {"geometry/b.h", true}), "goes upwards");
  EXPECT_EQ(problem("io/a.cpp", {"viewer/picture/b.h", true}), "goes upwards");
  EXPECT_EQ(problem("cli/a.cpp", {"kernel/b.h", true}), "");
  EXPECT_EQ(problem("io/a.cpp", {"b.h", true}), "is not written from the root");
  EXPECT_EQ(problem("geometry/a.h", {"CGAL/Arrangement_2.h", false}), "brings CGAL into a header");
  EXPECT_EQ(problem("geometry/a.h", {"kernel/kernels.h", true}), "brings CGAL into a header");
  EXPECT_EQ(problem("geometry/a.cpp", {"CGAL/Arrangement_2.h", false}), "");
  EXPECT_EQ(problem("kernel/kernels.h", {"CGAL/Epeck.h", false}), "");
}

}  // namespace
}  // namespace hottel
