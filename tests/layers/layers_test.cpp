// The architecture, read off the include lines.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace hottel::layers_test {
namespace {

namespace fs = std::filesystem;

// Each layer may include itself and those before it. The program and the module are doors, which know nothing of each
// other; several processes run the commands of the program.
constexpr std::array<const char*, 8> kLayers{"kernel", "geometry", "solver", "io",
                                             "viewer", "cli",      "python", "parallel"};
constexpr std::size_t kMostCgalUnits = 5;

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

// The dimension a file belongs to, by the folder "plane" or "space" that it stands in; empty when it has none.
std::string slice_of(const fs::path& path) {
  for (const fs::path& part : path)
    if (part == "plane" || part == "space") return part.string();
  return "";
}

// Files that have to know every dimension: doors, and the readers and writers of scenes of either.
bool serves_both(const fs::path& file) {
  if (file == "parallel/main.cpp" || file.string().starts_with("parallel/scene_message")) return true;
  return *file.begin() == "cli" || *file.begin() == "python" || file.string().starts_with("io/scene/scene_json");
}

// Why a file (path from the root) may not include this; empty when it may.
std::string problem(const fs::path& file, const Include& include) {
  const auto layer = layer_of(file);
  if (include.is_quoted && layer) {
    const auto other = layer_of(include.path);
    if (!other) return "is not written from the root";
    if (*other > *layer) return "goes upwards";
    const std::string to_layer = fs::path(include.path).begin()->string();
    if (*file.begin() == "python" && to_layer == "cli") return "goes through the program";
    if (*file.begin() == "parallel" && to_layer == "python") return "goes through the module";
    const std::string from = slice_of(file), to = slice_of(include.path);
    if (!from.empty() && !to.empty() && from != to) return "goes from " + from + " to " + to;
    if (from.empty() && !to.empty() && !serves_both(file)) return "has no dimension and knows the " + to;
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

// The way of a coordinate through a slice of the geometry, from the signs it decides to the factors that are printed.
const std::map<std::string, std::vector<std::string>> kStages{
    {"plane", {"predicates", "scene", "arrangement", "prepared", "visibility", "exchange", "check"}},
    {"space",
     {"predicates", "scene", "arrangement", "contacts", "visibility", "hiding", "vectors", "between", "stretches",
      "moving", "pieces", "integrals", "proven", "unobstructed", "sky", "pairs", "prepared", "exchange", "check"}}};

// The stage of a file of a slice; that of what makes scenes up is none.
std::optional<std::size_t> stage_of(const fs::path& path) {
  std::vector<std::string> parts;
  for (const fs::path& part : path) parts.push_back(part.string());
  if (parts.size() < 4 || parts[0] != "geometry" || slice_of(path).empty()) return std::nullopt;
  const std::vector<std::string>& stages = kStages.at(parts[1]);
  const auto stage = std::find(stages.begin(), stages.end(), parts[2]);
  EXPECT_TRUE(stage != stages.end() || parts[2] == "generate") << path << " stands in no stage";
  if (stage == stages.end()) return std::nullopt;
  return static_cast<std::size_t>(stage - stages.begin());
}

TEST(Layers, ACoordinateGoesOneWay) {
  std::size_t checked = 0;
  for (const Source& source : product_sources())
    for (const Include& include : source.includes) {
      const auto from = stage_of(source.path), to = stage_of(include.path);
      if (!from || !to) continue;
      ++checked;
      EXPECT_LE(*to, *from) << source.path << " includes " << include.path;
    }
  EXPECT_GT(checked, 100u);
}

// The last identifier of what the linker calls a function or variable, and whether it may stand in the slice of a
// dimension: its own name or a type among its parameters ends in the dimension, or it has a namespace of its own.
bool names_its_dimension(const std::string& symbol, char dimension) {
  static const std::regex kOwn(R"re(^hottel::([A-Za-z_]\w*))re");
  std::smatch own;
  if (!std::regex_search(symbol, own, kOwn)) return true;  // of a library
  const std::string first = own[1];
  const std::size_t end = static_cast<std::size_t>(own.length());
  if (first.back() == dimension) return true;
  const bool is_namespace = symbol.compare(end, 2, "::") == 0 && std::islower(static_cast<unsigned char>(first[0]));
  static const std::regex kPlane(R"re(\b[A-Za-z_]\w*2\b)re"), kSpace(R"re(\b[A-Za-z_]\w*3\b)re");
  return is_namespace || std::regex_search(symbol, dimension == '2' ? kPlane : kSpace);
}

// The sources, from the root, that an object is made from: one, or those of a batch, which are of one folder. Empty for
// what an earlier build left behind: CMakeFiles/hottel_geometry.dir/geometry/plane/a.cpp.o of a file that is gone.
std::vector<fs::path> sources_of(const fs::path& object) {
  const std::string text = object.string(), unit = text.substr(0, text.size() - 2);
  const auto begin = text.find(".dir/");
  if (begin == std::string::npos) return {};
  std::vector<fs::path> sources;
  if (std::ifstream batch(unit); unit.ends_with(".cxx") && batch)
    for (const Include& include : includes(batch)) sources.push_back(fs::relative(include.path, HOTTEL_SOURCE_DIR));
  else
    sources.push_back(unit.substr(begin + 5));
  for (const fs::path& source : sources)
    if (!fs::exists(fs::path(HOTTEL_SOURCE_DIR) / source)) return {};
  return sources;
}

// What nm tells of each object that is made from sources of today, and how many sources these are. One nm for all of
// them: to start it takes longer than what it does.
struct ObjectsOfToday {
  std::size_t sources = 0;
  std::map<fs::path, std::vector<std::string>> symbols;

  explicit ObjectsOfToday(const std::string& options) {
    const std::string line = "find '" + (fs::path(HOTTEL_BINARY_DIR) / "CMakeFiles").string() +
                             "' -name '*.o' -exec nm -A " + options + " {} +";
    const std::unique_ptr<FILE, int (*)(FILE*)> output(popen(line.c_str(), "r"), pclose);
    EXPECT_TRUE(output);
    std::string text;
    std::array<char, 1 << 16> part;
    for (std::size_t size = 0; output && (size = std::fread(part.data(), 1, part.size(), output.get())) > 0;)
      text.append(part.data(), size);
    std::istringstream lines(text);
    for (std::string told; std::getline(lines, told);)  // "/.../ball.cpp.o:                 U log"
      if (const auto end = told.find(".o:"); end != std::string::npos)
        symbols[told.substr(0, end + 2)].push_back(told.substr(end + 3));
    std::erase_if(symbols, [this](const auto& object) {
      const std::size_t count = sources_of(object.first).size();
      sources += count;
      return count == 0;
    });
  }
};

TEST(Layers, NamesOfASliceSayTheirDimension) {
  std::size_t names = 0;
  for (const auto& [path, symbols] : ObjectsOfToday("--demangle --defined-only --extern-only").symbols) {
    const std::string slice = slice_of(sources_of(path).front());
    if (slice.empty()) continue;
    for (const std::string& line : symbols) {
      // "0000000000000000 T hottel::name(...)". Weak symbols are inline functions and templates of any header.
      const bool is_own = line.size() > 19 && std::string("TDBR").find(line[17]) != std::string::npos;
      const std::string symbol = is_own ? line.substr(19) : "";
      names += symbol.starts_with("hottel::");
      EXPECT_TRUE(names_its_dimension(symbol, slice == "plane" ? '2' : '3')) << symbol << " in " << path.filename();
    }
  }
  EXPECT_GT(names, 300u);
}

bool is_of_c(const std::string& symbol) { return symbol.find(" U _Z") == std::string::npos; }

// The library's have other last bits on other processors: kernel/plain_functions.h has the same everywhere.
TEST(Layers, LogarithmsAndAnglesAreOurOwn) {
  const std::regex of_library(
      R"re( U (a?(sin|cos|tan)h?|atan2|sincos|exp|expm1|pow|log(2|10|1p)?|[tl]gamma|erfc?)f?(@.*)?$)re");
  // CGAL asks how deep to divide boxes, and Boost where to begin looking for a node of a rule.
  const std::set<std::string> allowed{"meeting_boxes.cpp.o", "gauss_rule.cpp.o"};
  const ObjectsOfToday objects("-u");
  for (const auto& [path, symbols] : objects.symbols)
    for (const std::string& symbol : symbols)
      EXPECT_FALSE(is_of_c(symbol) && std::regex_search(symbol, of_library) &&
                   !allowed.contains(path.filename().string()))
          << path.filename() << " has" << symbol;
  EXPECT_GT(objects.sources, 300u);
}

// GMP ends the process by a signal where it is given an infinity, and rounds as it likes: one source asks it.
TEST(Layers, OneSourceTurnsDoublesIntoExactNumbers) {
  // Of rationals and integers both ways. What CGAL makes of doubles is made of finite ones; mpf is asked after
  // finite().
  const std::regex conversion(R"re( U __gmp[qz]_(init_)?(set|get|cmp)_d$)re");
  const std::set<std::string> allowed{"exact_double.cpp.o",        "overlay.cpp.o",         "triangulation.cpp.o",
                                      "plane_triangulation.cpp.o", "arithmetic_cgal.cpp.o", "meeting_boxes.cpp.o"};
  const ObjectsOfToday objects("-u");
  bool is_seen = false;
  for (const auto& [path, symbols] : objects.symbols)
    for (const std::string& symbol : symbols) {
      if (!is_of_c(symbol) || !std::regex_search(symbol, conversion)) continue;
      is_seen = is_seen || path.filename() == "exact_double.cpp.o";
      EXPECT_TRUE(allowed.contains(path.filename().string()))
          << path.filename() << " has" << symbol << ": kernel/exact_double.h has the answer for every double";
    }
  EXPECT_GT(objects.sources, 300u);
  EXPECT_TRUE(is_seen);
}

TEST(Layers, TheCheckOfNamesSeesWhatItForbids) {
  EXPECT_TRUE(names_its_dimension("hottel::Vertices2::distance(unsigned int) const", '2'));
  EXPECT_TRUE(names_its_dimension("hottel::check_scene(hottel::Scene2 const&, hottel::CheckSources2 const&)", '2'));
  EXPECT_TRUE(names_its_dimension("hottel::generate_2(hottel::Request const&)", '2'));
  EXPECT_TRUE(names_its_dimension("hottel::sampling::below_one(double)", '2'));
  EXPECT_TRUE(names_its_dimension("std::vector<int>::size() const", '2'));
  EXPECT_FALSE(names_its_dimension("hottel::below_one(double)", '2'));
  EXPECT_FALSE(names_its_dimension("hottel::Chance::below(unsigned long)", '2'));
  EXPECT_FALSE(names_its_dimension("hottel::Vertices2::distance(unsigned int) const", '3'));
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

// The types that a header defines at its outermost level: what stands in a namespace, no members.
std::vector<std::string> types_defined_in(std::istream& text) {
  static const std::regex kType(R"(^(?:struct|class|enum class) (\w+)(?: final)?(?: : .*)? \{.*)");
  std::vector<std::string> types;
  std::smatch match;
  for (std::string line; std::getline(text, line);)
    if (std::regex_match(line, match, kType)) types.push_back(match[1]);
  return types;
}

// Two types of one name in one namespace end in crashes that no compiler reports.
TEST(Layers, NoTwoHeadersDefineATypeOfOneName) {
  std::map<std::string, fs::path> header_of;
  for (const auto& [file, all_includes] : product_sources()) {
    if (file.extension() != ".h") continue;
    std::ifstream text(fs::path(HOTTEL_SOURCE_DIR) / file);
    for (const std::string& type : types_defined_in(text)) {
      const auto [first, is_new] = header_of.emplace(type, file);
      EXPECT_TRUE(is_new) << type << " is in " << first->second << " and in " << file;
    }
  }
  EXPECT_GT(header_of.size(), 500U);
}

TEST(Layers, TypesOfHeadersAreSeen) {
  std::istringstream text(
      "struct A {\nclass B;\n  struct C {\nclass D : public A {\nenum class E : unsigned char { kOne };\n");
  EXPECT_EQ(types_defined_in(text), (std::vector<std::string>{"A", "D", "E"}));
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

bool is_of_pybind(const Include& include) { return include.path.starts_with("pybind11/"); }

TEST(Layers, OneFolderKnowsPython) {
  std::set<std::string> folders;
  for (const Source& source : product_sources())
    if (std::any_of(source.includes.begin(), source.includes.end(), is_of_pybind))
      folders.insert(source.path.parent_path().string());
  EXPECT_THAT(folders, testing::ElementsAre("python/bindings"));
}

bool is_of_sdl(const Include& include) { return fs::path(include.path).filename().string().starts_with("SDL"); }

TEST(Layers, OneFileKnowsWhereSdlIs) {
  // The library does without; so do pictures, scripts and tests without a screen.
  std::set<std::string> files;
  for (const Source& source : product_sources())
    if (std::any_of(source.includes.begin(), source.includes.end(), is_of_sdl)) files.insert(source.path.string());
  EXPECT_THAT(files, testing::ElementsAre("viewer/window/sdl_library.h"));
}

TEST(Layers, OneFileKnowsMpi) {
  std::set<std::string> files;
  for (const Source& source : product_sources())
    if (std::any_of(source.includes.begin(), source.includes.end(),
                    [](const Include& include) { return fs::path(include.path).filename() == "mpi.h"; }))
      files.insert(source.path.string());
  EXPECT_THAT(files, testing::ElementsAre("parallel/channel.cpp"));
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
  EXPECT_EQ(problem("python/bindings/a.cpp", {"geometry/plane/scene/scene.h", true}), "");
  EXPECT_EQ(problem("python/bindings/a.cpp", {"cli/command.h", true}), "goes through the program");
  EXPECT_EQ(problem("cli/a.cpp", {"python/bindings/scene.h", true}), "goes upwards");
  EXPECT_EQ(problem("cli/a.cpp", {"parallel/leader.h", true}), "goes upwards");
  EXPECT_EQ(problem("parallel/a.cpp", {"cli/command.h", true}), "");
  EXPECT_EQ(problem("parallel/a.cpp", {"python/bindings/scene.h", true}), "goes through the module");
  EXPECT_EQ(problem("parallel/a.cpp", {"geometry/plane/scene/scene.h", true}), "has no dimension and knows the plane");
  EXPECT_EQ(problem("io/a.cpp", {"b.h", true}), "is not written from the root");
  EXPECT_EQ(problem("geometry/a.h", {"CGAL/Arrangement_2.h", false}), "brings CGAL into a header");
  EXPECT_EQ(problem("geometry/a.h", {"kernel/kernels.h", true}), "brings CGAL into a header");
  EXPECT_EQ(problem("geometry/a.cpp", {"CGAL/Arrangement_2.h", false}), "");
  EXPECT_EQ(problem("kernel/kernels.h", {"CGAL/Epeck.h", false}), "");
  EXPECT_EQ(problem("solver/plane/a.h", {"geometry/space/b.h", true}), "goes from plane to space");
  EXPECT_EQ(problem("solver/space/a.cpp", {"solver/plane/light/b.h", true}), "goes from space to plane");
  EXPECT_EQ(problem("solver/plan.h", {"geometry/plane/scene/scene.h", true}), "has no dimension and knows the plane");
  EXPECT_EQ(problem("viewer/picture/plane/a.h", {"geometry/plane/scene/scene.h", true}), "");
  EXPECT_EQ(problem("cli/plan.cpp", {"geometry/plane/scene/scene.h", true}), "");
  for (const char* header : {"SDL.h", "SDL2/SDL.h", "SDL2/SDL_events.h", "SDL_events.h"})
    EXPECT_TRUE(is_of_sdl({header, false})) << header;
  EXPECT_FALSE(is_of_sdl({"viewer/window/sdl_window.h", true}));
}

}  // namespace
}  // namespace hottel::layers_test
