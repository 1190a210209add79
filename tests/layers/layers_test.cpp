// The architecture, read off the include lines.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <optional>
#include <regex>
#include <string>
#include <vector>

namespace hottel {
namespace {

namespace fs = std::filesystem;

// Each layer may include itself and those before it.
constexpr std::array<const char*, 6> kLayers{"kernel", "geometry", "solver", "io", "viewer", "cli"};
constexpr std::size_t kMostCgalUnits = 4;

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
