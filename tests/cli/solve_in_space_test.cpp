// hottel solve in space: radiosities of closed forms, channels, thermal rooms, promises, and what is refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>
#include <pugixml.hpp>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tests/cli/csv_table.h"
#include "tests/cli/program.h"

namespace hottel::solve_in_space_test {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using testing_cli::contents;
using testing_cli::lines_of;
using testing_cli::Outcome;
using testing_cli::Workplace;

std::string scene_file(const std::string& name) { return std::string(HOTTEL_SOURCE_DIR) + "/scenes/space/" + name; }

std::vector<std::string> cells_of_line(const std::string& line) {
  std::vector<std::string> result;
  std::istringstream stream(line);
  for (std::string cell; std::getline(stream, cell, ',');) result.push_back(cell);
  return result;
}

struct Radiosity {
  double value, lower, upper;
};

// Of radiosity.csv, by face, element and channel: "floor#0 all".
std::map<std::string, Radiosity> radiosities(const std::string& csv) {
  std::map<std::string, Radiosity> result;
  for (const std::string& line : lines_of(csv)) {
    const std::vector<std::string> cell = cells_of_line(line);
    if (cell[0] == "face") continue;
    result[cell[0] + "#" + cell[1] + " " + cell[2]] = {std::stod(cell[6]), std::stod(cell[7]), std::stod(cell[8])};
  }
  return result;
}

void expect_radiosity(const Radiosity& radiosity, double truth, double slack = 1e-14) {
  EXPECT_LE(radiosity.lower, truth * (1 + slack));
  EXPECT_GE(radiosity.upper, truth * (1 - slack));
  EXPECT_NEAR(radiosity.value, truth, 1e-12 * truth);
}

// A cube, each face with its material.
std::string cube(const std::string& materials, const std::vector<std::string>& of_faces, const std::string& more = "") {
  const std::vector<std::string> points{"[0,0,0],[1,0,0],[1,1,0],[0,1,0]", "[0,0,1],[0,1,1],[1,1,1],[1,0,1]",
                                        "[0,0,0],[0,0,1],[1,0,1],[1,0,0]", "[0,1,0],[1,1,0],[1,1,1],[0,1,1]",
                                        "[0,0,0],[0,1,0],[0,1,1],[0,0,1]", "[1,0,0],[1,0,1],[1,1,1],[1,1,0]"};
  std::string text = R"({"hottel": 1, "dimension": 3, "materials": )" + materials + R"(, "polygons": [)";
  for (std::size_t k = 0; k < of_faces.size(); ++k)
    text += (k == 0 ? "" : ",\n") + std::string(R"({"name": "face)") + std::to_string(k) + R"(", "points": [)" +
            points[k] + R"(], "material": ")" + of_faces[k] + R"("})";
  return text + "]" + more + "}";
}

// The white faces of scenes/space/cube.json reflect 0.7, the ceiling 0.1 and sends 10: by symmetry three unknowns.
TEST(SolveInSpace, RadiositiesOfACubeAreThoseOfItsClosedForms) {
  const Workplace place;
  place.write("cube.json", contents(scene_file("cube.json")));
  const Outcome outcome = place.run("hottel solve cube.json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(place.path("cube-hottel")))
    names.insert(entry.path().filename().string());
  EXPECT_THAT(names, ElementsAre("flux.csv", "radiosity.csv", "radiosity.vtu", "render.png", "report.json"));

  using std::numbers::pi, std::numbers::sqrt2;
  const double a = (std::log(4.0 / 3) + 4 * sqrt2 * std::atan(1 / sqrt2) - pi) / pi, b = (1 - a) / 4;
  double floor = 0, ceiling = 10, side = 0;
  for (int k = 0; k < 2000; ++k) {
    ceiling = 10 + 0.1 * (a * floor + 4 * b * side);
    floor = 0.7 * (a * ceiling + 4 * b * side);
    side = 0.7 * (b * ceiling + b * floor + (a + 2 * b) * side);
  }
  const auto found = radiosities(place.read("cube-hottel/radiosity.csv"));
  ASSERT_EQ(found.size(), 6u);
  expect_radiosity(found.at("floor#0 all"), floor);
  expect_radiosity(found.at("ceiling#0 all"), ceiling);
  for (const char* name : {"front", "rear", "left", "right"})
    expect_radiosity(found.at(name + std::string("#0 all")), side);

  // Nothing stands between: all factors are enclosed, and so are the radiosities of the scene.
  const auto report = nlohmann::json::parse(place.read("cube-hottel/report.json"));
  EXPECT_EQ(report["bounds"]["guarantee"], "enclosed");
  EXPECT_LT(report["bounds"]["max_relative_width"].get<double>(), 1e-10);
  EXPECT_NEAR(report["energy"]["emitted"].get<double>(), 10, 1e-14);
  EXPECT_NEAR(report["energy"]["absorbed"].get<double>(), 10, 1e-11);
  EXPECT_EQ(report["energy"]["to_sky"], 0);
  EXPECT_EQ(report["counts"]["pairs"], 15);
  EXPECT_EQ(report["tiers"].size(), 3u);
  EXPECT_TRUE(report["tiers"].contains("filter"));
  EXPECT_THAT(place.run("hottel solve cube.json --json --quiet").out, HasSubstr("\"guarantee\": \"enclosed\""));
}

std::vector<double> numbers(const std::string& text) {
  std::vector<double> result;
  std::istringstream stream(text);
  for (double value; stream >> value;) result.push_back(value);
  return result;
}

// Of a box on an uncut floor: what it covers is cut out of the polygons of the floor.
TEST(SolveInSpace, TheGridForParaViewHasTheSameNumbers) {
  const Workplace place;
  ASSERT_EQ(place.run("hottel generate room-boxes --n 2 --seed 3 -o room.json").code, 0);
  ASSERT_EQ(place.run("hottel solve room.json -o out --no-picture").code, 0);
  pugi::xml_document document;
  ASSERT_TRUE(document.load_string(place.read("out/radiosity.vtu").c_str()));
  const pugi::xml_node piece = document.child("VTKFile").child("UnstructuredGrid").child("Piece");
  const auto array = [](const pugi::xml_node& parent, const char* name) {
    return numbers(parent.find_child_by_attribute("DataArray", "Name", name).child_value());
  };
  const std::vector<double> points = numbers(piece.child("Points").child("DataArray").child_value());
  const std::vector<double> ends = array(piece.child("Cells"), "offsets");
  const pugi::xml_node data = piece.child("CellData");
  const std::size_t cells = ends.size();
  EXPECT_EQ(piece.attribute("NumberOfCells").as_ullong(), cells);
  EXPECT_EQ(piece.attribute("NumberOfPoints").as_ullong() * 3, points.size());
  EXPECT_EQ(array(piece.child("Cells"), "connectivity").size(), points.size() / 3);
  for (const double type : array(piece.child("Cells"), "types")) EXPECT_EQ(type, 7);
  // Areas and radiosities by surface.
  const std::vector<double> surface = array(data, "surface"), is_back = array(data, "is_back");
  std::map<std::size_t, double> area;
  std::map<std::size_t, std::size_t> cell_of;
  for (std::size_t k = 0, begin = 0; k < cells; begin = static_cast<std::size_t>(ends[k++])) {
    EXPECT_EQ(is_back[k], 0);
    const auto at = [&](std::size_t p, std::size_t c) { return points[3 * p + c] - points[3 * begin + c]; };
    double normal[3] = {0, 0, 0};
    for (std::size_t p = begin + 2; p < static_cast<std::size_t>(ends[k]); ++p)
      for (std::size_t c = 0; c < 3; ++c)
        normal[c] += at(p - 1, (c + 1) % 3) * at(p, (c + 2) % 3) - at(p - 1, (c + 2) % 3) * at(p, (c + 1) % 3);
    area[static_cast<std::size_t>(surface[k])] += std::hypot(normal[0], normal[1], normal[2]) / 2;
    cell_of[static_cast<std::size_t>(surface[k])] = k;
  }
  const auto scene = nlohmann::json::parse(place.read("room.json"));
  std::size_t lines = 0;
  for (const std::string& line : lines_of(place.read("out/radiosity.csv"))) {
    const std::vector<std::string> cell = cells_of_line(line);
    if (cell[0] == "face") continue;
    std::size_t s = 0;
    while (scene["polygons"][s]["name"] != cell[0]) ++s;
    const std::size_t channel = cell[2] == "r" ? 0 : cell[2] == "g" ? 1 : 2;
    ++lines;
    EXPECT_NEAR(area.at(s), std::stod(cell[3]), 1e-13 * std::stod(cell[3])) << cell[0];
    EXPECT_EQ(array(data, "radiosity").at(3 * cell_of.at(s) + channel), std::stod(cell[6])) << cell[0];
    EXPECT_EQ(array(data, "lower").at(3 * cell_of.at(s) + channel), std::stod(cell[7])) << cell[0];
    EXPECT_EQ(array(data, "net").at(3 * cell_of.at(s) + channel), std::stod(cell[10])) << cell[0];
  }
  EXPECT_EQ(lines, 3 * area.size());
}

TEST(SolveInSpace, InAFurnaceAllRadiositiesAreOne) {
  const Workplace place;
  place.write("furnace.json",
              cube(R"({"m": {"reflectivity": 0.75, "emission": 1}, "n": {"reflectivity": 0.5, "emission": 2}})",
                   {"m", "n", "m", "n", "m", "m"}, R"(, "closed": true)"));
  for (const char* solver : {"auto", "lu", "gauss-seidel", "shooting"}) {
    const Outcome outcome = place.run(std::string("hottel solve furnace.json -o out --solver ") + solver);
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    for (const auto& [name, radiosity] : radiosities(place.read("out/radiosity.csv"))) {
      EXPECT_LE(radiosity.lower, 4) << name;
      EXPECT_GE(radiosity.upper, 4) << name;
      EXPECT_NEAR(radiosity.value, 4, 1e-9) << name;
    }
  }
}

// All at one temperature: nobody gains or loses, whatever it reflects and whatever stands in the room.
TEST(SolveInSpace, IsothermalRoomsHaveNoNetFlux) {
  const Workplace place;
  ASSERT_EQ(place.run("hottel generate room-turned --n 3 --seed 1 -o turned.json").code, 0);
  auto room = nlohmann::json::parse(place.read("turned.json"));
  double reflectivity = 0.1;
  for (auto& material : room["materials"]) {
    material = {{"emissivity", 1 - reflectivity}, {"temperature", 300}};
    reflectivity += 0.2;
  }
  room["closed"] = true;
  place.write("room.json", room.dump());
  const Outcome outcome = place.run("hottel solve room.json -o out");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const double black = 5.670374419e-8 * std::pow(300.0, 4);
  for (const std::string& line : lines_of(place.read("out/flux.csv"))) {
    const std::vector<std::string> cell = cells_of_line(line);
    if (cell[0] == "per") continue;
    EXPECT_NEAR(std::stod(cell[4]), 0, 1e-11 * black * std::stod(cell[3])) << line;
  }
  for (const auto& [name, radiosity] : radiosities(place.read("out/radiosity.csv")))
    EXPECT_NEAR(radiosity.value, black, 1e-11 * black) << name;
  // What is seen past boxes is estimated: the bounds are those of these factors.
  EXPECT_THAT(outcome.err, HasSubstr("view factors are estimates"));
  EXPECT_EQ(nlohmann::json::parse(place.read("out/report.json"))["bounds"]["guarantee"], "estimated");
}

TEST(SolveInSpace, HasChannelsElementsAndASky) {
  const Workplace place;
  place.write("open.json", cube(R"({"m": {"reflectivity": [0.5, 0.25, 0]}})", {"m"}, R"(, "sky": {"emission": 2})"));
  const Outcome outcome = place.run("hottel solve open.json -o out --elements 2");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto found = radiosities(place.read("out/radiosity.csv"));
  ASSERT_EQ(found.size(), 12u);
  for (int k = 0; k < 4; ++k) {
    const std::string name = "face0#" + std::to_string(k);
    expect_radiosity(found.at(name + " r"), 1);
    expect_radiosity(found.at(name + " g"), 0.5);
    EXPECT_EQ(found.at(name + " b").value, 0);
  }
}

TEST(SolveInSpace, APromiseThatIsBrokenIsAnErrorAndABlackBackAWarning) {
  const Workplace place;
  place.write("open.json",
              cube(R"({"m": {"reflectivity": 0.5, "emission": 1}})", {"m", "m", "m", "m", "m"}, R"(, "closed": true)"));
  const Outcome broken = place.run("hottel solve open.json");
  EXPECT_EQ(broken.code, 1);
  EXPECT_THAT(broken.err, HasSubstr("the scene promises to be closed, but the front of 'face0' sees the sky (F = "));
  // A plate in a room with its black back to the lamp.
  place.write("plate.json", R"({"hottel": 1, "dimension": 3, "materials": {"m": {"reflectivity": 0.5, "emission": 1}},
    "polygons": [{"name": "lamp", "points": [[0,0,0],[1,0,0],[1,1,0],[0,1,0]], "material": "m"},
                 {"name": "plate", "points": [[0,0,1],[1,0,1],[1,1,1],[0,1,1]], "material": "m"}]})");
  const Outcome plate = place.run("hottel solve plate.json -o out");
  EXPECT_EQ(plate.code, 0) << plate.err;
  EXPECT_THAT(plate.err, HasSubstr("warning: black-back"));
  EXPECT_THAT(plate.err, HasSubstr("the back of 'plate' is black"));
  EXPECT_THAT(place.read("out/report.json"), HasSubstr("warning: black-back"));
}

TEST(SolveInSpace, ThePictureHasTheSizeAndTheToneAskedFor) {
  const Workplace place;
  place.write("cube.json", contents(scene_file("cube.json")));
  ASSERT_EQ(place.run("hottel solve cube.json -o log").code, 0);
  ASSERT_EQ(place.run("hottel solve cube.json -o small --size 120").code, 0);
  ASSERT_EQ(place.run("hottel solve cube.json -o bright --tone max --exposure 3").code, 0);
  const auto side = [&](const std::string& file, std::size_t at) {
    const std::string bytes = place.read(file);
    EXPECT_TRUE(bytes.starts_with("\x89PNG"));
    return static_cast<unsigned char>(bytes[at + 2]) * 256 + static_cast<unsigned char>(bytes[at + 3]);
  };
  for (const std::size_t at : {16, 20}) {
    EXPECT_EQ(side("log/render.png", at), 600);
    EXPECT_EQ(side("small/render.png", at), 120);
  }
  EXPECT_NE(place.read("log/render.png"), place.read("bright/render.png"));
  const auto report = nlohmann::json::parse(place.read("bright/report.json"));
  // The lamp is the brightest thing in it.
  const double lamp = radiosities(place.read("bright/radiosity.csv")).at("ceiling#0 all").value;
  EXPECT_NEAR(report["picture"]["scale"].get<double>() * lamp, 3, 1e-12);
  ASSERT_EQ(place.run("hottel generate room-boxes --n 1 --seed 1 -o box.json").code, 0);
  auto box = nlohmann::json::parse(place.read("box.json"));
  std::vector<double> middle(3, 0);
  for (std::size_t k = 6; k < 12; ++k)
    for (const auto& point : box["polygons"][k]["points"])
      for (std::size_t c = 0; c < 3; ++c) middle[c] += point[c].get<double>() / 24;
  box["camera"] = {{"eye", middle}, {"target", {9, 9, 9}}};
  place.write("box.json", box.dump());
  const Outcome blind = place.run("hottel solve box.json -o blind");
  EXPECT_EQ(blind.code, 1);
  EXPECT_THAT(blind.err, HasSubstr("the camera's eye is in the solid"));
}

TEST(SolveInSpace, LightInAVolumeHasAFileForParaViewAndNoPicture) {
  const Workplace place;
  std::string scene = contents(scene_file("cube.json"));
  scene.replace(scene.find("\"closed\""), 8,
                R"("grid": [{"name": "air", "origin": [0, 0, 0], "u": [1, 0, 0], "v": [0, 1, 0], "w": [0, 0, 1],
                             "cells": [3, 2, 4]},
                            {"name": "level", "origin": [0, 0, 0.5], "u": [1, 0, 0], "v": [0, 1, 0], "cells": [3, 2]}],
                   "closed")");
  place.write("cube.json", scene);
  const Outcome outcome = place.run("hottel solve cube.json -o out --show irradiance --views seen.mtx");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(place.read("out/illumination-air.npy"), HasSubstr("'shape': (4, 2, 3, 1)"));
  const auto sidecar = nlohmann::json::parse(place.read("out/illumination-air.npy.json"));
  EXPECT_EQ(sidecar["axes"], (std::vector<std::string>{"w", "v", "u", "channel"}));
  EXPECT_EQ(sidecar["region"]["w"], (std::vector<double>{0, 0, 1}));
  EXPECT_THAT(place.read("out/illumination-air.vti"), HasSubstr("WholeExtent=\"0 3 0 2 0 4\""));
  EXPECT_THAT(place.read("seen-air.mtx"), HasSubstr("3 x 2 x 4 cells"));
  EXPECT_THAT(outcome.err, AllOf(HasSubstr("shown-level.npy"), Not(HasSubstr("shown-air")),
                                 HasSubstr("illumination-level.png"), Not(HasSubstr("illumination-air.png"))));
  EXPECT_THAT(place.run("hottel plan cube.json --grid 2x2x2").out, HasSubstr("14 cells"));
  EXPECT_THAT(place.run("hottel solve cube.json -o out --illumination average").err, HasSubstr("has none"));
  EXPECT_THAT(place.run("hottel solve cube.json -o out --grid 2x2x2x2").err, HasSubstr("--grid takes"));
  EXPECT_THAT(place.run("hottel compare cube.json -o compared --grid-file out/illumination-air.npy").err,
              HasSubstr("is light in a volume"));
}

TEST(SolveInSpace, LightOnAPlanarGridIsWrittenAsInThePlane) {
  const Workplace place;
  std::string scene = contents(scene_file("cube.json"));
  scene.replace(scene.find("\"closed\""), 8,
                R"("grid": {"origin": [0, 0, 0.5], "u": [1, 0, 0], "v": [0, 1, 0], "cells": [3, 2]}, "closed")");
  place.write("cube.json", scene);
  const Outcome outcome = place.run("hottel solve cube.json -o out");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const std::string npy = place.read("out/illumination.npy");
  EXPECT_THAT(npy, HasSubstr("'shape': (2, 3, 1)"));
  std::vector<double> values(6);
  ASSERT_EQ(npy.size(), 128 + 6 * sizeof(double));
  std::memcpy(values.data(), npy.data() + 128, 6 * sizeof(double));
  const auto sidecar = nlohmann::json::parse(place.read("out/illumination.npy.json"));
  EXPECT_EQ(sidecar["axes"], (std::vector<std::string>{"v", "u", "channel"}));
  EXPECT_EQ(sidecar["region"]["origin"], (std::vector<double>{0, 0, 0.5}));
  EXPECT_EQ(sidecar["region"]["u"], (std::vector<double>{1, 0, 0}));
  EXPECT_EQ(sidecar["shape"], (std::vector<int>{2, 3, 1}));
  EXPECT_TRUE(place.read("out/illumination.png").starts_with("\x89PNG"));
  // The room is the same from both sides, and lit from above: between the radiosities of its faces.
  const auto found = radiosities(place.read("out/radiosity.csv"));
  for (const double value : values) {
    EXPECT_GT(value, found.at("left#0 all").value);
    EXPECT_LT(value, found.at("ceiling#0 all").value);
  }
  EXPECT_NEAR(values[0], values[2], 1e-13);
  EXPECT_NEAR(values[0], values[3], 1e-13);
  EXPECT_NEAR(values[1], values[4], 1e-13);
  EXPECT_GT(values[1], values[0]);
  EXPECT_TRUE(nlohmann::json::parse(place.read("out/report.json"))["seconds"].contains("illumination"));
  EXPECT_THAT(place.run("hottel plan cube.json").out, HasSubstr("light between the faces, 6 cells"));
  ASSERT_EQ(place.run("hottel solve cube.json -o none --no-illumination").code, 0);
  EXPECT_FALSE(std::filesystem::exists(place.path("none/illumination.npy")));
  EXPECT_FALSE(std::filesystem::exists(place.path("none/render.png")));
}

// The sky's emission is 0 here.
TEST(SolveInSpace, ViewsTimesRadiositiesIsTheLight) {
  const Workplace place;
  std::string scene = contents(scene_file("two_boxes.json"));
  scene.insert(scene.find('{') + 1,
               R"("grid": {"origin": ["1/20", "1/20", 1], "u": [5.4, 0, 0], "v": [0, 5.4, 0], "cells": [7, 5]},)");
  place.write("boxes.json", scene);
  const Outcome outcome = place.run("hottel solve boxes.json --elements 2 --tolerance 1e-4 -o out --views h.mtx");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const std::string npy = place.read("out/illumination.npy");
  std::vector<double> light((npy.size() - 128) / sizeof(double));
  std::memcpy(light.data(), npy.data() + 128, light.size() * sizeof(double));
  const auto radiosity = testing_cli::table(place.read("out/radiosity.csv"), 3);
  const auto faces = testing_cli::table(place.read("h.mtx.faces.csv"), 1);
  const auto lines = lines_of(place.read("h.mtx"));
  std::size_t k = 0, rows = 0, columns = 0, count = 0;
  while (lines.at(k).starts_with("%")) ++k;
  std::istringstream(lines.at(k++)) >> rows >> columns >> count;
  EXPECT_EQ(rows, 35u);
  EXPECT_EQ(columns, faces.size() - 1);
  ASSERT_EQ(count, lines.size() - k);
  std::vector<double> product(light.size(), 0), sum(rows, 0);
  for (; k < lines.size(); ++k) {
    std::size_t row = 0;
    std::string column;
    double fraction = 0;
    std::istringstream(lines[k]) >> row >> column >> fraction;
    sum.at(row - 1) += fraction;
    const std::vector<std::string>& face = faces.at(column);
    for (std::size_t c = 0; c < 3; ++c)
      if (const auto found = radiosity.find(face.at(1) + "," + face.at(2) + "," + "rgb"[c]); found != radiosity.end())
        product[(row - 1) * 3 + c] += fraction * std::stod(found->second.at(6));
  }
  for (std::size_t cell = 0; cell < rows; ++cell) {
    EXPECT_NEAR(sum[cell], 1, 1e-13) << cell;
    for (std::size_t c = 0; c < 3; ++c)
      if (!std::isnan(light[3 * cell + c])) {
        EXPECT_NEAR(product[3 * cell + c], light[3 * cell + c], 1e-12 * (1 + light[3 * cell + c])) << cell;
      }
  }
  EXPECT_LT(std::ranges::count_if(light, [](double value) { return std::isnan(value); }), 20) << "in the boxes";
}

TEST(SolveInSpace, TheCellsOfTheGridAreAsAskedFor) {
  const Workplace place;
  const std::string plain = contents(scene_file("cube.json"));
  const auto with_cells = [&](const std::string& cells) {
    std::string scene = plain;
    scene.replace(
        scene.find("\"closed\""), 8,
        R"("grid": {"origin": [0, 0, 0.5], "u": [1, 0, 0], "v": [0, 1, 0], "cells": )" + cells + R"(}, "closed")");
    return scene;
  };
  place.write("cube.json", with_cells("[3, 2]"));
  place.write("finer.json", with_cells("[5, 4]"));
  ASSERT_EQ(place.run("hottel solve cube.json -o asked --grid 5x4").code, 0);
  ASSERT_EQ(place.run("hottel solve finer.json -o typed").code, 0);
  for (const char* file : {"illumination.npy", "illumination.npy.json", "illumination.png", "radiosity.csv"})
    EXPECT_EQ(place.read(std::string("asked/") + file), place.read(std::string("typed/") + file)) << file;

  place.write("plain.json", plain);
  const Outcome without = place.run("hottel solve plain.json -o none --grid 5x4");
  EXPECT_EQ(without.code, 2);
  EXPECT_THAT(without.err, HasSubstr("this scene has none: add \"grid\": {\"origin\""));
  EXPECT_EQ(place.run("hottel solve cube.json -o none --grid 5").code, 2);
  EXPECT_EQ(place.run("hottel solve cube.json -o none --grid 5x99999").code, 2);
  EXPECT_FALSE(std::filesystem::exists(place.path("none")));
}

// A scene with the members of a grid, or a list of them, in place of none.
std::string with_grid(const std::string& grid) {
  std::string scene = contents(scene_file("cube.json"));
  return scene.replace(scene.find("\"closed\""), 8, "\"grid\": " + grid + ", \"closed\"");
}
const std::string kLow = R"("origin": [0, 0, 0.25], "u": [1, 0, 0], "v": [0, 1, 0], "cells": [3, 2]})";
const std::string kHigh = R"("origin": [0, 0, 0.75], "u": [1, 0, 0], "v": [0, 1, 0], "cells": [4, 4]})";

TEST(SolveInSpace, EachGridOfAListHasItsOwnFiles) {
  const Workplace place;
  place.write("both.json", with_grid("[{\"name\": \"low\", " + kLow + ", {\"name\": \"high\", " + kHigh + "]"));
  place.write("low.json", with_grid("{" + kLow));
  place.write("high.json", with_grid("{" + kHigh));
  const Outcome both = place.run("hottel solve both.json -o both --show irradiance --views seen.mtx");
  ASSERT_EQ(both.code, 0) << both.err;
  EXPECT_THAT(both.err, HasSubstr(" illumination-low.npy illumination-high.npy illumination-low.npy.json"));
  EXPECT_THAT(place.files(), Contains("seen-high.mtx"));
  for (const std::string name : {"low", "high"}) {
    ASSERT_EQ(place.run("hottel solve " + name + ".json -o " + name + " --show irradiance --views one.mtx").code, 0);
    EXPECT_EQ(place.read("both/illumination-" + name + ".npy"), place.read(name + "/illumination.npy"));
    EXPECT_EQ(place.read("both/illumination-" + name + ".png"), place.read(name + "/illumination.png"));
    EXPECT_EQ(place.read("both/shown-" + name + ".npy"), place.read(name + "/shown.npy"));
    EXPECT_EQ(place.read("seen-" + name + ".mtx"), place.read("one.mtx"));
    EXPECT_THAT(place.read("both/illumination-" + name + ".npy.json"), HasSubstr("\"grid\": \"" + name + "\""));
  }
  const Outcome less = place.run("hottel solve low.json -o both");
  EXPECT_THAT(less.err, HasSubstr("of an earlier run, and left as it was: illumination-high.npy illumination-low.npy"));
  const Outcome judged = place.run("hottel compare both.json --grid-file both/illumination-high.npy -o judged");
  EXPECT_EQ(judged.code, 0) << judged.err;
  const Outcome unknown = place.run("hottel compare both.json --grid-file high/illumination.npy -o judged");
  EXPECT_EQ(unknown.code, 3);
  EXPECT_THAT(unknown.err, HasSubstr("its name does not say which: 'low', 'high'"));
}

TEST(SolveInSpace, AveragesHaveTheirBoundsBesideThem) {
  const Workplace place;
  place.write("low.json", with_grid("{" + kLow));
  const Outcome outcome = place.run("hottel solve low.json -o out --illumination average");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("illumination: averages over cells, each within "));
  EXPECT_THAT(place.read("out/illumination.npy.json"), HasSubstr("\"quantity\": \"irradiance\""));
  EXPECT_THAT(place.read("out/illumination_error.npy"), HasSubstr("'shape': (2, 3), "));
}

TEST(SolveInSpace, ContoursAreDrawnOverAGrid) {
  const Workplace place;
  place.write("high.json", with_grid("{" + kHigh));
  for (const std::string more : {"", " --show irradiance"}) {
    ASSERT_EQ(place.run("hottel solve high.json -o plain" + more).code, 0);
    ASSERT_EQ(place.run("hottel solve high.json -o lines --contours 5" + more).code, 0);
    EXPECT_NE(place.read("plain/illumination.png"), place.read("lines/illumination.png"));
    EXPECT_EQ(place.read("plain/illumination.npy"), place.read("lines/illumination.npy"));
  }
}

TEST(SolveInSpace, WhatIsOfThePlaneIsRefused) {
  const Workplace place;
  place.write("cube.json", contents(scene_file("cube.json")));
  const Outcome outcome = place.run("hottel solve cube.json --illumination inverse-square");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("is only for scenes in the plane"));
  EXPECT_EQ(place.files(), std::vector<std::string>{"cube.json"});
  EXPECT_EQ(place.run("hottel solve cube.json --no-illumination --no-picture -o out").code, 0);
  EXPECT_FALSE(std::filesystem::exists(place.path("out/render.png")));
}

}  // namespace
}  // namespace hottel::solve_in_space_test
