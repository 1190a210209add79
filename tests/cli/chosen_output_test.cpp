// What is written of a result: some rows, so many digits, where elements lie, and the grid for ParaView.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <pugixml.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "tests/cli/program.h"

namespace hottel::chosen_output_test {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing_cli::lines_of;
using testing_cli::Outcome;
using testing_cli::Workplace;

const std::string kScenes = std::string(HOTTEL_SOURCE_DIR) + "/scenes/";

std::vector<std::string> fields_of(const std::string& line, char separator = ',') {
  std::vector<std::string> fields;
  std::istringstream in(line + separator);
  for (std::string field; std::getline(in, field, separator);) fields.push_back(field);
  return fields;
}

double number(const std::string& text) { return std::strtod(text.c_str(), nullptr); }

// The lines of a list of factors whose first name is of fronts, or begins so.
std::string rows_from(const std::string& csv, const std::string& beginning, bool fronts_only) {
  std::string result;
  for (const std::string& line : lines_of(csv)) {
    const std::string from = fields_of(line)[0];
    if (from == "from" || (from.starts_with(beginning) && !(fronts_only && from.find(":back") != std::string::npos)))
      result += line + "\n";
  }
  return result;
}

TEST(ChosenOutput, RowsAreThoseOfTheWholeList) {
  const Workplace place;
  for (const char* scene : {"showcase/apartment.json", "space/two_boxes.json"})
    for (const char* options :
         {"", " --pairs facing", " --per element --elements 2", " --script-f --channel g", " --method center"}) {
      if (std::string(options).starts_with(" --script-f") && std::string(scene) == "showcase/apartment.json") continue;
      const std::string line = "hottel factors " + kScenes + scene + options + " --quiet";
      const Outcome all = place.run(line), fronts = place.run(line + " --rows fronts"),
                    some = place.run(line + " --rows 'l*'");
      ASSERT_EQ(all.code, 0) << all.err;
      EXPECT_EQ(fronts.out, rows_from(all.out, "", true)) << line;
      EXPECT_EQ(some.code == 0 ? some.out : "from", some.code == 0 ? rows_from(all.out, "l", false) : "from") << line;
    }
}

TEST(ChosenOutput, RowsOfAMatrixMarketFileAreItsEntries) {
  const Workplace place;
  ASSERT_EQ(place.run("hottel factors " + kScenes + "space/two_boxes.json --rows lamp -o some.mtx").code, 0);
  ASSERT_EQ(place.run("hottel factors " + kScenes + "space/two_boxes.json -o all.mtx").code, 0);
  EXPECT_EQ(place.read("some.mtx.faces.csv"), place.read("all.mtx.faces.csv"));
  const auto some = lines_of(place.read("some.mtx")), all = lines_of(place.read("all.mtx"));
  EXPECT_LT(some.size(), all.size());
  for (std::size_t k = 3; k < some.size(); ++k) EXPECT_THAT(all, ::testing::Contains(some[k]));
}

TEST(ChosenOutput, StoresServeRowsAndTheWholeAlike) {
  const Workplace place;
  const std::string line = "hottel factors " + kScenes + "space/two_boxes.json --quiet --store s";
  const Outcome alone = place.run("hottel factors " + kScenes + "space/two_boxes.json --quiet");
  ASSERT_EQ(place.run(line + " --rows lamp").code, 0);
  EXPECT_EQ(place.run(line).out, alone.out);
  EXPECT_EQ(place.run(line + " --rows fronts").out, rows_from(alone.out, "", true));
  const std::string plane = "hottel factors " + kScenes + "showcase/apartment.json --quiet";
  const Outcome whole = place.run(plane);
  ASSERT_EQ(place.run(plane + " --store p --rows 'window*'").code, 0);
  EXPECT_EQ(place.run(plane + " --store p").out, whole.out);
}

TEST(ChosenOutput, APromiseIsKeptToByRowsToo) {
  const Workplace place;
  place.write("open.json", R"({"hottel": 1, "dimension": 3, "materials": {"m": {}}, "closed": true, "polygons": [
    {"name": "low", "points": [[0,0,0],[1,0,0],[1,1,0],[0,1,0]], "material": "m"},
    {"name": "high", "points": [[0,0,1],[0,1,1],[1,1,1],[1,0,1]], "material": "m"}]})");
  const Outcome outcome = place.run("hottel factors open.json --rows high");
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(outcome.err, HasSubstr("closed"));
}

TEST(ChosenOutput, RowsThatThereAreNotAreTold) {
  const Workplace place;
  const std::string scene = "hottel factors " + kScenes + "space/two_boxes.json ";
  const Outcome none = place.run(scene + "--rows lmap");
  EXPECT_EQ(none.code, 2);
  EXPECT_THAT(none.err, AllOf(HasSubstr("no surface of"), HasSubstr("did you mean 'lamp'")));
  const Outcome black = place.run(scene + "--rows floor:back");
  EXPECT_EQ(black.code, 2);
  EXPECT_THAT(black.err, HasSubstr("--rows floor:back: none of these has a row"));
  EXPECT_THAT(place.run(scene + "--rows fronts").err, HasSubstr("--rows fronts: "));
}

TEST(ChosenOutput, DigitsRoundBoundsOutward) {
  const Workplace place;
  for (const char* scene : {"showcase/apartment.json", "space/two_boxes.json"}) {
    const std::string line = "hottel factors " + kScenes + scene + " --areas --quiet";
    const auto whole = lines_of(place.run(line).out), rounded = lines_of(place.run(line + " --digits 3").out);
    ASSERT_EQ(whole.size(), rounded.size());
    for (std::size_t k = 1; k < whole.size(); ++k) {
      const auto a = fields_of(whole[k]), b = fields_of(rounded[k]);
      EXPECT_NEAR(number(a[2]), number(b[2]), 5.1e-3 * number(a[2])) << rounded[k];
      EXPECT_LE(number(b[3]), number(a[3])) << rounded[k];
      EXPECT_GE(number(b[4]), number(a[4])) << rounded[k];
      EXPECT_EQ(a[5] == "1", b[5] == "1") << rounded[k];
      EXPECT_LE(b[2].size(), 8u) << rounded[k];
    }
  }
}

TEST(ChosenOutput, DigitsReachTheFilesOfSolve) {
  const Workplace place;
  const std::string line = "hottel solve " + kScenes + "heat/street_canyon.json --no-illumination --quiet -o ";
  ASSERT_EQ(place.run(line + "all").code, 0);
  ASSERT_EQ(place.run(line + "some --digits 4").code, 0);
  const std::map<std::string, std::size_t> lower_of{{"radiosity.csv", 7}, {"flux.csv", 5}, {"temperature.csv", 4}};
  for (const auto& [file, lower] : lower_of) {
    const auto whole = lines_of(place.read("all/" + file)), rounded = lines_of(place.read("some/" + file));
    ASSERT_EQ(whole.size(), rounded.size());
    EXPECT_EQ(whole[0], rounded[0]);
    for (std::size_t k = 1; k < whole.size(); ++k) {
      const auto a = fields_of(whole[k]), b = fields_of(rounded[k]);
      EXPECT_LE(number(b[lower]), number(a[lower])) << rounded[k];
      EXPECT_GE(number(b[lower + 1]), number(a[lower + 1])) << rounded[k];
      EXPECT_NEAR(number(b[lower - 1]), number(a[lower - 1]), 5.1e-4 * std::fabs(number(a[lower - 1]))) << rounded[k];
    }
  }
}

// ---- where elements lie

// The area of outlines less that of holes: "x y z;...|...||..." in a plane of constant z.
double area_of(const std::string& points) {
  double area = 0;
  std::string loop;
  std::istringstream in(points);
  while (std::getline(in, loop, '|')) {
    if (loop.empty()) continue;
    std::vector<std::vector<std::string>> corners;
    for (const std::string& corner : fields_of(loop, ';')) corners.push_back(fields_of(corner, ' '));
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const auto &a = corners[k], &b = corners[(k + 1) % corners.size()];
      area += (number(a[0]) * number(b[1]) - number(b[0]) * number(a[1])) / 2;
    }
  }
  return area;
}

// A floor with a box in its middle and one across its border, a wall with a window cut out, and a strip between.
const char* const kCovered = R"({"hottel": 1, "dimension": 3, "materials": {"m": {"reflectivity": 0.5}}, "polygons": [
  {"name": "floor", "points": [[0,0,0],[9,0,0],[9,9,0],[0,9,0]], "material": "m", "elements": 3},
  {"name": "frame", "points": [[0,0,5],[0,4,5],[4,4,5],[4,0,5]], "holes": [[[1,1,5],[3,1,5],[3,3,5],[1,3,5]]], "material": "m"},
  {"name": "top", "group": "box", "points": [[4,4,2],[5,4,2],[5,5,2],[4,5,2]], "material": "m"},
  {"name": "bottom", "group": "box", "points": [[4,4,0],[4,5,0],[5,5,0],[5,4,0]], "material": "m"},
  {"name": "south", "group": "box", "points": [[4,4,0],[5,4,0],[5,4,2],[4,4,2]], "material": "m"},
  {"name": "north", "group": "box", "points": [[5,5,0],[4,5,0],[4,5,2],[5,5,2]], "material": "m"},
  {"name": "west", "group": "box", "points": [[4,5,0],[4,4,0],[4,4,2],[4,5,2]], "material": "m"},
  {"name": "east", "group": "box", "points": [[5,4,0],[5,5,0],[5,5,2],[5,4,2]], "material": "m"}]})";

TEST(ChosenOutput, OutlinesAreOfWhatIsLeft) {
  const Workplace place;
  place.write("covered.json", kCovered);
  ASSERT_EQ(place.run("hottel factors covered.json -o f.mtx").code, 0);
  std::map<std::string, std::vector<std::string>> faces;
  for (const std::string& line : lines_of(place.read("f.mtx.faces.csv"))) faces[fields_of(line)[1]] = fields_of(line);
  EXPECT_EQ(std::count(faces["floor"][5].begin(), faces["floor"][5].end(), '|'), 1) << faces["floor"][5];
  EXPECT_EQ(area_of(faces["floor"][5]), 80);
  EXPECT_EQ(number(faces["floor"][3]), 80);
  EXPECT_EQ(area_of(faces["frame"][5]), -12);  // seen from above; its front looks down
  EXPECT_EQ(area_of(faces["frame:back"][5]), 12);
  EXPECT_EQ(faces["bottom"][5], "");  // nothing is left of it
  EXPECT_EQ(faces["top"][5], "4 4 2;5 4 2;5 5 2;4 5 2");

  ASSERT_EQ(place.run("hottel factors covered.json --per element -o e.mtx").code, 0);
  double sum = 0;
  for (const std::string& line : lines_of(place.read("e.mtx.faces.csv"))) {
    const auto fields = fields_of(line);
    if (fields[1] != "floor") continue;
    EXPECT_EQ(area_of(fields[5]), number(fields[3])) << line;
    sum += number(fields[3]);
  }
  EXPECT_EQ(sum, 80);
}

TEST(ChosenOutput, PiecesOfThePlaneAreOfWhatIsLeft) {
  const Workplace place;
  place.write("flat.json", R"({"hottel": 1, "dimension": 2, "materials": {"m": {"reflectivity": 0.5}}, "edges": [
    {"name": "floor", "points": [[9, 0], [0, 0]], "material": "m", "back": "m"}], "polylines": [
    {"name": "box", "points": [[4, 0], [5, 0], [5, 2], [4, 2]], "closed": true, "material": "m"}]})");
  ASSERT_EQ(place.run("hottel factors flat.json -o f.mtx").code, 0);
  const auto lines = lines_of(place.read("f.mtx.faces.csv"));
  EXPECT_EQ(lines[1], "1,floor,0,8,m,9|4,0|0,5|0,0|0");
  EXPECT_EQ(lines[2], "2,floor:back,0,9,m,9,0,0,0");
  EXPECT_THAT(lines, ::testing::Contains("3,box[0],0,0,m,,,,"));
}

// ---- the grid for ParaView

class VtuFile {
 public:
  explicit VtuFile(const std::string& text) {
    EXPECT_TRUE(document_.load_string(text.c_str()));
    data_ = document_.child("VTKFile").child("UnstructuredGrid").child("Piece").child("CellData");
  }
  pugi::xml_node array(const char* name) const { return data_.find_child_by_attribute("DataArray", "Name", name); }
  std::vector<double> numbers(const char* name) const {
    std::vector<double> result;
    std::istringstream stream(array(name).child_value());
    for (double value; stream >> value;) result.push_back(value);
    return result;
  }
  std::vector<std::string> texts(const char* name) const {
    EXPECT_STREQ(array(name).attribute("type").value(), "String");
    std::vector<std::string> result{""};
    for (const double code : numbers(name)) {
      if (code == 0)
        result.emplace_back();
      else
        result.back() += static_cast<char>(code);
    }
    result.pop_back();
    return result;
  }

 private:
  pugi::xml_document document_;
  pugi::xml_node data_;
};

TEST(ChosenOutput, CellsForParaViewNameTheirRow) {
  const Workplace place;
  place.write("covered.json", kCovered);
  std::string bands = kCovered;
  bands.replace(bands.find("{\"reflectivity\": 0.5}"), 21,
                R"({"emissivity": 0.9, "temperature": 300, "solar": {"reflectivity": 0.2, "emission": 3}})");
  place.write("bands.json", bands);
  for (const std::string name : {"covered", "bands"}) {
    ASSERT_EQ(place.run("hottel solve " + name + ".json -o " + name + " --no-picture --quiet").code, 0);
    const auto rows = lines_of(place.read(name + "/radiosity.csv"));
    const VtuFile grid(place.read(name + "/radiosity.vtu"));
    const std::size_t channels = name == "bands" ? 2 : 1;
    EXPECT_STREQ(grid.array("radiosity").attribute("ComponentName0").value(), channels == 2 ? "solar" : "all");
    const auto id = grid.numbers("id"), radiosity = grid.numbers("radiosity"), flux = grid.numbers("net_flux"),
               area = grid.numbers("area"), sky = grid.numbers("sky_view_factor");
    const auto face = grid.texts("face"), material = grid.texts("material"), group = grid.texts("group"),
               element = grid.texts("name");
    const std::size_t cells = id.size(), components = channels == 2 ? 3 : 1;
    ASSERT_EQ(face.size(), cells);
    ASSERT_EQ(radiosity.size(), channels * cells);
    ASSERT_EQ(flux.size(), components * cells);
    std::vector<char> is_met((rows.size() - 1) / channels, 0);
    for (std::size_t k = 0; k < cells; ++k) {
      const auto place_of = static_cast<std::size_t>(id[k]);
      is_met.at(place_of) = 1;
      for (std::size_t c = 0; c < channels; ++c) {
        const auto fields = fields_of(rows.at(1 + channels * place_of + c));
        EXPECT_EQ(fields[0], face[k]);
        EXPECT_EQ(number(fields[3]), area[k]);
        EXPECT_EQ(number(fields[6]), radiosity[channels * k + c]);
        EXPECT_EQ(number(fields[10]) * number(fields[3]), flux[components * k + c]);
      }
      EXPECT_EQ(material[k], "m");
      EXPECT_EQ(group[k], face[k].size() > 4 && face[k] != "floor" && face[k] != "frame" ? "box"
                          : face[k] == "top" || face[k] == "west" || face[k] == "east"   ? "box"
                                                                                         : face[k]);
      EXPECT_TRUE(element[k].starts_with(face[k]));
      EXPECT_GE(sky[k], 0);
    }
    EXPECT_EQ(std::count(is_met.begin(), is_met.end(), 0), 0) << "every row has a cell";
    const auto temperature = grid.numbers("temperature");
    if (channels == 1) {
      EXPECT_THAT(temperature, IsEmpty());
    } else {
      EXPECT_EQ(temperature.size(), cells);
      for (const double kelvin : temperature) EXPECT_EQ(kelvin, 300);
      for (const double has : grid.numbers("has_temperature")) EXPECT_EQ(has, 1);
    }
  }
}

}  // namespace
}  // namespace hottel::chosen_output_test
