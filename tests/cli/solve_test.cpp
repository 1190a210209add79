// hottel solve and hottel plan, from outside.
#include <gmock/gmock.h>

#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "tests/cli/program.h"

namespace hottel::solve_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;
using testing_cli::contents;
using testing_cli::lines_of;
using testing_cli::Outcome;
using testing_cli::Workplace;

const std::string kScenes = std::string(HOTTEL_SOURCE_DIR) + "/scenes/";

// A square room of a lamp and three walls of one material; `wall` is the material's text.
std::string square(const std::string& wall, const std::string& more = "") {
  return R"({"hottel": 1, "dimension": 2,
 "materials": {"wall": )" +
         wall + R"(, "lamp": {"emission": 1, "reflectivity": "1/2"}},
 "edges": [{"name": "lamp", "points": [[1, 0], [0, 0]], "material": "lamp"}],
 "polylines": [{"name": "walls", "points": [[0, 0], [0, 1], [1, 1], [1, 0]], "material": "wall"}])" +
         more + "}";
}

std::map<std::string, std::string> plan_of(const nlohmann::json& report) {
  std::map<std::string, std::string> used;
  for (const auto& effect : report.at("plan"))
    used[effect.at("effect")] = effect.at("used").get<bool>() ? "used" : "not";
  return used;
}

TEST(Solve, WritesSixFilesInAFolderNamedAfterTheScene) {
  const Workplace place;
  place.write("room.json", square(R"({"reflectivity": "1/2"})"));
  const Outcome outcome = place.run("hottel solve room.json --grid 8x4");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  EXPECT_THAT(place.files(), ElementsAre("room-hottel", "room.json"));
  EXPECT_THAT(place.read("room-hottel/illumination.npy"), HasSubstr("'shape': (4, 8, 1), "));
  EXPECT_THAT(place.read("room-hottel/illumination.png"), StartsWith("\x89PNG"));
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(place.path("room-hottel")))
    names.insert(entry.path().filename().string());
  EXPECT_THAT(names, ElementsAre("flux.csv", "illumination.npy", "illumination.npy.json", "illumination.png",
                                 "radiosity.csv", "report.json"));
  const auto lines = lines_of(place.read("room-hottel/radiosity.csv"));
  ASSERT_EQ(lines.size(), 5u);
  EXPECT_EQ(lines[0], "face,element,channel,area,emission,reflectivity,radiosity,lower,upper,irradiance,net");
  EXPECT_THAT(lines[1], StartsWith("lamp,0,all,1,1,0.5,1.14446141898327"));
  EXPECT_THAT(lines[3], StartsWith("walls[1],0,all,1,0,0.5,0.316034294237087"));
}

TEST(Solve, TellsWhichFilesInItsFolderAreOfAnEarlierRun) {
  const Workplace place;
  place.write("room.json", square(R"({"reflectivity": "1/2"})"));
  EXPECT_THAT(place.run("hottel solve room.json -o out --grid 4x4").err, Not(HasSubstr("of an earlier run")));
  EXPECT_THAT(place.run("hottel solve room.json -o out --grid 4x4").err, Not(HasSubstr("of an earlier run")));
  const Outcome outcome = place.run("hottel solve room.json -o out --no-illumination");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("of an earlier run, and left as it was: illumination.npy illumination.npy.json "
                                     "illumination.png\n"));
  EXPECT_THAT(place.read("out/illumination.png"), StartsWith("\x89PNG"));
}

TEST(Solve, ReportsWhatTheContractNames) {
  const Workplace place;
  place.write("room.json", square(R"({"reflectivity": [0.5, 0.25, 0]})"));
  const Outcome outcome = place.run("hottel solve room.json -o out --grid 4x4 --json --quiet");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_EQ(outcome.out, place.read("out/report.json"));
  const auto report = nlohmann::json::parse(outcome.out);
  for (const char* key :
       {"hottel", "scene", "plan", "counts", "tiers", "seconds", "closure", "reciprocity", "energy", "bounds", "notes"})
    EXPECT_TRUE(report.contains(key)) << key;
  EXPECT_EQ(report["hottel"], 1);
  EXPECT_TRUE(report["version"].is_string());
  EXPECT_EQ(report["hottel"],
            nlohmann::json::parse(place.run("hottel factors room.json --json --quiet").out)["hottel"]);
  EXPECT_EQ(report["hottel"], nlohmann::json::parse(place.run("hottel plan room.json --json").out)["hottel"]);
  for (const auto& [object, keys] :
       std::map<std::string, std::vector<std::string>>{{"counts", {"surfaces", "elements", "vertices", "pairs"}},
                                                       {"tiers", {"double", "double_double", "ball", "root_sum"}},
                                                       {"closure", {"max_defect", "exact"}},
                                                       {"reciprocity", {"max_defect"}},
                                                       {"energy", {"emitted", "absorbed", "to_sky", "defect"}},
                                                       {"bounds", {"max_relative_width"}}})
    for (const std::string& key : keys) EXPECT_TRUE(report[object].contains(key)) << object << " " << key;
  for (const auto& effect : report["plan"])
    for (const char* key : {"effect", "used", "reason", "seconds_estimate"}) EXPECT_TRUE(effect.contains(key)) << key;
  EXPECT_EQ(report["counts"]["surfaces"], 4);
  EXPECT_EQ(report["closure"]["exact"], true);
  EXPECT_LT(report["bounds"]["max_relative_width"].get<double>(), 1e-14);
  EXPECT_EQ(plan_of(report)["channels"], "used");
  EXPECT_EQ(lines_of(place.read("out/radiosity.csv")).size(), 1 + 4 * 3u);
}

// A lamp in the open over a wall with two sides, in elements, under a sky that shines.
constexpr const char* kOpen = R"({"hottel": 1, "dimension": 2,
  "materials": {"lamp": {"emission": [9, 8, 6], "reflectivity": 0.1}, "white": {"reflectivity": 0.7}},
  "sky": {"emission": 0.5},
  "edges": [{"name": "lamp", "points": [[1, 3], [2, 3]], "material": "lamp"},
            {"name": "wall", "points": [[2, 0], [2, 2]], "material": "white", "back": "white", "elements": 3},
            {"name": "floor", "points": [[4, 0], [0, 0]], "material": "white"}]})";

// What is not needed is not run, and changes no number: occlusion in a convex room, one channel, no subdivision.
TEST(Solve, SimulatingEverythingGivesTheSameNumbers) {
  const Workplace place;
  place.write("open.json", kOpen);
  place.write("black.json", square(R"({"emission": 0.25})"));
  place.write("dark.json", square(R"({"reflectivity": [0.5, 0.25, 0]})", R"(, "closed": true)"));
  for (const std::string& scene :
       {kScenes + "analytic/square_radiosity.json", kScenes + "analytic/furnace.json",
        kScenes + "analytic/parallel_plates_w10.json", kScenes + "showcase/maze.json", std::string("open.json"),
        std::string("open.json --elements 2"), std::string("black.json"), std::string("dark.json")}) {
    const std::string solve = "hottel solve " + scene + " --grid 16x16 --quiet ";
    ASSERT_EQ(place.run(solve + "-o auto && " + solve + "-o all --simulate everything").code, 0) << scene;
    for (const std::string file : {"radiosity.csv", "flux.csv", "illumination.npy"})
      EXPECT_EQ(place.read("auto/" + file), place.read("all/" + file)) << scene << " " << file;
    const auto report = nlohmann::json::parse(place.read("all/report.json"));
    EXPECT_EQ(report["estimate_of_dividing"],
              nlohmann::json::parse(place.read("auto/report.json"))["estimate_of_dividing"])
        << scene;
    const std::set<std::string> of_lights{"lights", "beams", "movement"};
    for (const auto& effect : report["plan"])
      EXPECT_EQ(effect["used"], !of_lights.contains(effect["effect"])) << scene << " " << effect["effect"];
  }
}

// Beside the bounds, and not under them.
TEST(Solve, EstimatesWhatDividingWouldChange) {
  const Workplace place;
  const std::string solve = "hottel solve '" + kScenes + "analytic/square_radiosity.json' --no-illumination -o out ";
  const Outcome divided = place.run(solve + "--elements 4");
  ASSERT_EQ(divided.code, 0) << divided.err;
  EXPECT_THAT(divided.err, HasSubstr("bounds for these elements within"));
  EXPECT_THAT(divided.err,
              HasSubstr("estimate: dividing every element once more would change radiosities by an rms of"));
  EXPECT_THAT(divided.err, HasSubstr("it does not see shadows finer than half an element"));
  const auto report = nlohmann::json::parse(place.read("out/report.json"));
  EXPECT_EQ(report["bounds"]["of"], "these elements");
  const auto& estimate = report["estimate_of_dividing"];
  EXPECT_EQ(estimate["elements"], 16);
  EXPECT_EQ(estimate["looked_at"], 16);
  EXPECT_GT(estimate["pointwise"]["all"]["rms"], 0);
  EXPECT_LT(estimate["pointwise"]["all"]["relative"], 0.05);
  EXPECT_LT(estimate["face_means"]["all"]["relative"], 0.001);
  EXPECT_EQ(estimate["face_means"]["all"]["face"], "bottom");
  EXPECT_TRUE(report["seconds"].contains("dividing"));

  const Outcome whole = place.run(solve);
  EXPECT_THAT(whole.err, HasSubstr("for it merges pairs of elements: 'bottom' is one element"));
  const auto lone = nlohmann::json::parse(place.read("out/report.json"))["estimate_of_dividing"];
  EXPECT_TRUE(lone["face_means"].is_null());
  EXPECT_EQ(lone["why_no_face_means"], "'bottom' is one element");

  const Outcome other = place.run(solve + "--elements 2 --method center");
  EXPECT_THAT(other.err,
              HasSubstr("no estimate of how radiosities change within elements: the factors are approximate"));
  EXPECT_EQ(place.run("hottel solve '" + kScenes + "space/cube.json' --elements 2 --no-picture -o out").code, 0);
  const auto cube = nlohmann::json::parse(place.read("out/report.json"))["estimate_of_dividing"];
  EXPECT_EQ(cube["looked_at"], 24);
  EXPECT_GT(cube["pointwise"]["all"]["rms"], 0);
  EXPECT_GT(cube["face_means"]["all"]["largest"], 0);
}

TEST(Solve, StagesThatDoNotRunAreAbsentFromTheReport) {
  const Workplace place;
  place.write("black.json", square(R"({"emission": 0.25})"));
  std::string black = place.read("black.json");
  black.replace(black.find("\"1/2\""), 5, "0");
  place.write("black.json", black);
  const std::string solve = " --grid 4x4 --quiet -o out ";
  const auto report_of = [&](const std::string& scene) {
    EXPECT_EQ(place.run("hottel solve " + scene + solve).code, 0);
    return nlohmann::json::parse(place.read("out/report.json"));
  };
  // A convex room whose faces reflect nothing: no sweep, nothing to settle exactly, no system to solve.
  const auto lean = report_of("black.json");
  EXPECT_EQ(plan_of(lean)["occlusion"], "not");
  EXPECT_EQ(plan_of(lean)["interreflection"], "not");
  for (const char* stage : {"sweep", "radiosity", "certificate", "dividing"})
    EXPECT_FALSE(lean["seconds"].contains(stage)) << stage;
  EXPECT_FALSE(lean.contains("solver"));
  for (const char* stage : {"read", "prepare", "strings", "round", "irradiance", "illumination", "picture", "write"})
    EXPECT_TRUE(lean["seconds"].contains(stage)) << stage;
  const auto full = report_of(kScenes + "showcase/maze.json");
  for (const char* stage : {"sweep", "radiosity", "certificate"}) EXPECT_TRUE(full["seconds"].contains(stage)) << stage;
  EXPECT_FALSE(full["seconds"].contains("strings"));
  EXPECT_TRUE(full.contains("solver"));
}

struct FluxLine {
  std::string granularity, name, channel;
  double area, net, lower, upper;
};

std::vector<FluxLine> flux_lines(const std::string& csv) {
  std::vector<FluxLine> result;
  for (const std::string& line : lines_of(csv)) {
    std::vector<std::string> fields;
    std::istringstream in(line);
    for (std::string field; std::getline(in, field, ',');) fields.push_back(field);
    EXPECT_EQ(fields.size(), 7u) << line;
    const auto number = [&](std::size_t k) { return std::atof(fields[k].c_str()); };
    if (fields[0] != "per")
      result.push_back({fields[0], fields[1], fields[2], number(3), number(4), number(5), number(6)});
  }
  return result;
}

TEST(Solve, WritesNetFluxesThatSumToZeroPerFaceAndPerGroup) {
  const Workplace place;
  place.write("open.json", kOpen);
  ASSERT_EQ(place.run("hottel solve open.json --grid 4x4 -o out --quiet").code, 0);
  const std::string csv = place.read("out/flux.csv");
  EXPECT_EQ(lines_of(csv)[0], "per,name,channel,area,net,lower,upper");
  std::map<std::string, double> sum;
  for (const FluxLine& line : flux_lines(csv)) {
    sum[line.granularity + line.channel] += line.net;
    EXPECT_LE(line.lower, line.net) << line.name;
    EXPECT_GE(line.upper, line.net) << line.name;
    if (line.name == "lamp") {
      EXPECT_GT(line.lower, 0);
    }
    if (line.name == "wall:back") {
      EXPECT_EQ(line.area, 2);
    }
  }
  EXPECT_EQ(sum.size(), 6u);
  for (const auto& [half, total] : sum) EXPECT_NEAR(total, 0, 1e-14) << half;
  EXPECT_THAT(place.run("hottel solve open.json --grid 4x4 -o out").err, HasSubstr("net flux: "));

  // With lights, sky and black backs have what these send them, in the plane and in space.
  const std::string plane = R"({"hottel": 1, "dimension": 2, "materials": {"m": {"reflectivity": 0.5}},
    "edges": [{"name": "floor", "points": [[1,0],[0,0]], "material": "m"},
              {"name": "screen", "points": [[0,1],[0,0.5]], "material": "m"}],
    "lights": [{"type": "point", "name": "bulb", "position": [0.5,0.5], "power": 8},
               {"type": "spot", "name": "spot", "position": [-1,0.75], "direction": [1,0], "focus": 20, "power": 3}]})";
  const std::string space = R"({"hottel": 1, "dimension": 3, "materials": {"m": {"reflectivity": [0.5,0.2,0]}},
    "polygons": [{"name": "floor", "points": [[0,0,0],[1,0,0],[1,1,0],[0,1,0]], "material": "m"},
                 {"name": "screen", "points": [[0,0,0.2],[0,1,0.2],[1,1,0.2],[1,0,0.2]], "material": "m"}],
    "lights": [{"type": "point", "name": "bulb", "position": [0.5,0.5,0.1], "power": 8},
               {"type": "point", "name": "above", "position": [0.5,0.5,2], "power": [3,2,1]}]})";
  for (const std::string& lit : {plane, space}) {
    place.write("lit.json", lit);
    ASSERT_EQ(place.run("hottel solve lit.json --no-illumination -o out --quiet").code, 0);
    std::map<std::string, double> of_half, sky;
    bool has_dark_back = false;
    for (const FluxLine& line : flux_lines(place.read("out/flux.csv"))) {
      EXPECT_LE(line.lower, line.net) << line.name;
      EXPECT_GE(line.upper, line.net) << line.name;
      of_half[line.granularity + line.channel] += line.net;
      if (line.granularity == "face" && line.name == "sky") sky[line.channel] = line.net;
      has_dark_back |= line.name == "screen:back" && line.upper < 0;
    }
    EXPECT_TRUE(has_dark_back);
    double to_sky = 0;
    for (const auto& [channel, net] : sky) {
      EXPECT_NEAR(of_half["face" + channel] + of_half["light" + channel], 0, 1e-12) << channel;
      EXPECT_NEAR(of_half["group" + channel] + of_half["light" + channel], 0, 1e-12) << channel;
      to_sky -= net;
    }
    EXPECT_NEAR(nlohmann::json::parse(place.read("out/report.json"))["energy"]["to_sky"].get<double>(), to_sky, 1e-12);
  }

  // A polyline is one group; its net is that of its faces.
  place.write("room.json", square(R"({"reflectivity": "1/2"})"));
  ASSERT_EQ(place.run("hottel solve room.json --grid 4x4 -o out --quiet").code, 0);
  double faces = 0, group = 0;
  for (const FluxLine& line : flux_lines(place.read("out/flux.csv")))
    (line.granularity == "group" ? group : faces) += line.name.starts_with("walls") ? line.net : 0;
  EXPECT_NEAR(faces, group, 1e-15);
  EXPECT_LT(group, 0);
}

TEST(Solve, EverySolverComesWithinItsBounds) {
  const Workplace place;
  for (const std::string solver : {"auto", "cholesky", "cg", "lu", "bicgstab", "jacobi", "gauss-seidel", "shooting"}) {
    const Outcome outcome = place.run("hottel solve " + kScenes +
                                      "analytic/square_radiosity.json -o out --grid 2x2 --quiet --solver " + solver);
    ASSERT_EQ(outcome.code, 0) << solver << ": " << outcome.err;
    const auto fields = [&] {
      std::vector<double> values;
      std::istringstream line(lines_of(place.read("out/radiosity.csv"))[1]);
      for (std::string field; std::getline(line, field, ',');) values.push_back(std::atof(field.c_str()));
      return values;
    }();
    EXPECT_LE(fields[7], 1.144461418983277110496) << solver;
    EXPECT_GE(fields[8], 1.144461418983277110496) << solver;
    EXPECT_NEAR(fields[6], 1.144461418983277110496, 1e-11) << solver;
  }
}

TEST(Solve, AFewIterationsGiveWideButTrueBounds) {
  const Workplace place;
  ASSERT_EQ(place
                .run("hottel solve " + kScenes +
                     "analytic/square_radiosity.json -o out --grid 2x2 --quiet --solver jacobi --iterations 3")
                .code,
            0);
  const auto report = nlohmann::json::parse(place.read("out/report.json"));
  EXPECT_EQ(report["solver"]["residual_history"]["all"].size(), 4u);
  EXPECT_GT(report["bounds"]["max_relative_width"].get<double>(), 1e-3);
}

TEST(Solve, NetIsTheDifferenceOfWhatIsPrinted) {
  const Workplace place;
  for (const std::string options :
       {"", "--solver jacobi --iterations 3", "--solver shooting --iterations 5", "--method hemicube:64",
        "--method arithmetic:bounds", "--method gauss:4:normalised --solver bicgstab --iterations 1"}) {
    const Outcome outcome =
        place.run("hottel solve " + kScenes + "../tests/contract/box.json -o out --grid 2x2 --quiet " + options);
    ASSERT_EQ(outcome.code, 0) << options << ": " << outcome.err;
    const auto lines = lines_of(place.read("out/radiosity.csv"));
    for (std::size_t k = 1; k < lines.size(); ++k) {
      std::vector<double> last;  // net first
      std::istringstream line(lines[k]);
      for (std::string field; std::getline(line, field, ',');) last.insert(last.begin(), std::atof(field.c_str()));
      EXPECT_EQ(last[0], last[4] - last[1]) << options << ": " << lines[k];
      EXPECT_GE(last[3], last[6]) << options << ": " << lines[k];
    }
  }
}

TEST(Solve, NotesAreInTheReportAndOnTheTerminal) {
  const Workplace place;
  for (const std::string options : {"--solver jacobi --iterations 3", "--method gauss:4 --iterations 1"}) {
    const Outcome outcome =
        place.run("hottel solve " + kScenes + "analytic/square_radiosity.json -o out --grid 2x2 " + options);
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const auto report = nlohmann::json::parse(place.read("out/report.json"));
    ASSERT_GE(report["notes"].size(), 1u) << options;
    for (const auto& note : report["notes"])
      EXPECT_THAT(outcome.err, HasSubstr("note: " + note.get<std::string>() + "\n")) << options;
  }
}

TEST(Solve, ABrokenPromiseToBeClosedNamesTheFace) {
  const Workplace place;
  std::string open = square(R"({"reflectivity": "1/2"})", R"(, "closed": true)");
  open.replace(open.find("[1, 1], [1, 0]"), 14, "[1, 1]");
  place.write("open.json", open);
  const Outcome outcome = place.run("hottel solve open.json -o out");
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(outcome.err,
              HasSubstr("open.json:3: the scene promises to be closed, but the front of 'lamp' sees the sky"));
  EXPECT_FALSE(std::filesystem::exists(place.path("out")));
}

TEST(Solve, ARoomThatReflectsEverythingHasNoSolutionWhenItEmits) {
  const Workplace place;
  std::string mirror = square(R"({"reflectivity": 1})");
  mirror.replace(mirror.find("\"1/2\""), 5, "1");
  place.write("mirror.json", mirror);
  const Outcome outcome = place.run("hottel solve mirror.json -o out --quiet");
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(outcome.err, HasSubstr("lamp"));
  mirror.replace(mirror.find("\"emission\": 1"), 13, "\"emission\": 0");
  place.write("dark.json", mirror);
  ASSERT_EQ(place.run("hottel solve dark.json -o out --quiet").code, 0);
  EXPECT_THAT(lines_of(place.read("out/radiosity.csv"))[1], StartsWith("lamp,0,all,1,0,1,0,0,0,0,"));
}

TEST(Solve, TooLittleMemoryIsAnUnmetRequestAndLeavesEarlierFiles) {
  const Workplace place;
  const std::string solve = "hottel solve " + kScenes + "showcase/museum.json -o out --grid 4x4 --quiet";
  ASSERT_EQ(place.run(solve).code, 0);
  const std::string before = place.read("out/radiosity.csv");
  const Outcome outcome = place.run(solve + " --memory 1000");
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(outcome.err, StartsWith(kScenes + "showcase/museum.json: "));
  EXPECT_THAT(outcome.err, HasSubstr("bytes"));
  EXPECT_EQ(place.read("out/radiosity.csv"), before);
}

TEST(Solve, RefusesWhatItDoesNotKnow) {
  const Workplace place;
  const std::string solve = "hottel solve " + kScenes + "analytic/furnace.json -o out ";
  for (const std::string bad :
       {"--solver magic", "--method magic", "--tone magic", "--grid 4", "--grid 0x4", "--grid 4x99999",
        "--illumination magic", "--simulate nothing", "--exposure 0", "--iterations -1"}) {
    const Outcome outcome = place.run(solve + bad);
    EXPECT_EQ(outcome.code, 2) << bad << ": " << outcome.err;
    EXPECT_FALSE(std::filesystem::exists(place.path("out"))) << bad;
  }
}

TEST(Solve, ResultsDoNotDependOnTheNumberOfThreads) {
  const Workplace place;
  const std::string solve = "hottel solve " + kScenes + "showcase/apartment.json --grid 40x30 --quiet ";
  for (const std::string threads : {"1", "2", "3", "7"})
    ASSERT_EQ(place.run(solve + "-o out" + threads + " --threads " + threads).code, 0);
  for (const std::string threads : {"2", "3", "7"})
    for (const std::string file : {"/radiosity.csv", "/illumination.npy", "/illumination.png"})
      EXPECT_EQ(place.read("out1" + file), place.read("out" + threads + file)) << threads << file;
}

TEST(Plan, SaysWhatIsLeftOutAndWhy) {
  const Workplace place;
  const Outcome text = place.run("hottel plan " + kScenes + "analytic/square_radiosity.json");
  EXPECT_EQ(text.code, 0);
  EXPECT_THAT(text.out, HasSubstr("nothing can hide anything"));
  const auto apartment =
      nlohmann::json::parse(place.run("hottel plan --json " + kScenes + "showcase/apartment.json").out);
  EXPECT_EQ(plan_of(apartment)["occlusion"], "used");
  EXPECT_EQ(plan_of(apartment)["sky"], "not");
}

// A square room as large as `side`, its lamp and its sky as bright as said.
std::string room_of(const std::string& side, const std::string& lamp, const std::string& sky = "0") {
  std::string text = R"({"hottel": 1, "dimension": 2,
 "materials": {"wall": {"reflectivity": "1/2"}, "lamp": {"emission": "LAMP", "reflectivity": "1/2"}},
 "edges": [{"name": "lamp", "points": [["S", 0], [0, 0]], "material": "lamp"}],
 "polylines": [{"name": "walls", "points": [[0, 0], [0, "S"], ["S", "S"], ["S", 0]], "material": "wall"}],
 "sky": {"emission": "SKY"}})";
  for (const auto& [what, by] : std::map<std::string, std::string>{{"\"S\"", side}, {"LAMP", lamp}, {"SKY", sky}})
    for (std::size_t at; (at = text.find(what)) != std::string::npos;)
      text.replace(at, what.size(), what == "\"S\"" ? "\"" + by + "\" " : by);
  return text;
}

TEST(Solve, BalancesNearTheEndsOfTheRangeOfDoubles) {
  const Workplace place;
  for (const auto& [side, lamp, emitted] :
       {std::tuple("1e300", "1", 1e300), {"1", "1e305", 1e305}, {"1e-300", "1", 1e-300}, {"1e300", "1e-300", 1.0}}) {
    place.write("room.json", room_of(side, lamp));
    const Outcome outcome = place.run("hottel solve room.json -o room --grid 4x4 --quiet");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    for (const std::string& line : lines_of(place.read("room/flux.csv"))) {
      EXPECT_THAT(line, Not(HasSubstr("nan"))) << side << " " << lamp;
      EXPECT_THAT(line, Not(HasSubstr("inf"))) << side << " " << lamp;
    }
    const auto report = nlohmann::json::parse(place.read("room/report.json"));
    EXPECT_EQ(report.at("energy").at("emitted"), emitted);
    EXPECT_NEAR(report.at("energy").at("absorbed").get<double>() / emitted, 1, 1e-14);
  }
}

TEST(Solve, RefusesWhatDoublesCannotTellAndNamesTheFile) {
  const Workplace place;
  const std::string inverse_square = " --illumination inverse-square";
  for (const auto& [scene, options] : {std::pair(room_of("1", "1e400"), std::string()),
                                       {room_of("1", "1.7e308"), ""},
                                       {room_of("1", "1e400"), " --method strings"},
                                       {room_of("1", "1", "1e400"), ""},
                                       {room_of("1e400", "1"), ""},
                                       {room_of("1e-400", "1"), ""},
                                       {room_of("1e-300", "1"), inverse_square}}) {
    place.write("room.json", scene);
    const Outcome outcome = place.run("hottel solve room.json -o room --grid 4x4 --quiet" + options);
    EXPECT_EQ(outcome.code, 1) << scene << options;
    EXPECT_THAT(outcome.err, StartsWith("room.json:"));
    EXPECT_THAT(outcome.err, HasSubstr(" the range of doubles"));
    EXPECT_FALSE(std::filesystem::exists(place.path("room"))) << scene << options;
  }
}

TEST(Solve, SaysThatNothingEndsOnFacesWithoutLights) {
  const Workplace place;
  place.write("scene.json", square("{}"));
  const Outcome outcome = place.run("hottel solve scene.json -o out --no-illumination --light-levels 2");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.err, HasSubstr("--light-levels changes nothing: scene.json lists no lights\n"));
}

TEST(Solve, SaysThatNoCellOfAGridHasLight) {
  const Workplace place;
  place.write("scene.json",
              square("{}", R"(, "closed": true, "grid": {"min": [5, 5], "max": [6, 6], "cells": [4, 4]})"));
  EXPECT_THAT(place.run("hottel solve scene.json -o out --no-picture").err,
              HasSubstr("no cell of the grid has light: all lie in solids, or outside of the closed scene\n"));
}

TEST(Plan, EstimatesAreThoseOfTheMachineWhichIsMeasuredOnce) {
  const Workplace place;
  place.write("s.json", contents(std::string(HOTTEL_SOURCE_DIR) + "/scenes/analytic/furnace.json"));
  const std::string here = "unset HOTTEL_SPEED; export XDG_CACHE_HOME=$PWD/cache; ",
                    plan = "hottel plan s.json --json --threads 1";
  const Outcome first = place.run(here + plan);
  ASSERT_EQ(first.code, 0) << first.err;
  const std::string kept = place.read("cache/hottel/speed");
  EXPECT_EQ(place.run(here + plan).out, first.out);
  EXPECT_EQ(place.read("cache/hottel/speed"), kept);

  ASSERT_EQ(place.run("sed -i 's/ [0-9].*/ 3/' cache/hottel/speed").code, 0);
  const std::string thrice = place.run(here + plan).out;
  EXPECT_EQ(thrice, place.run("HOTTEL_SPEED=3 " + plan).out);
  EXPECT_NE(thrice, place.run("HOTTEL_SPEED=1 " + plan).out);

  // Another version measures anew, and what cannot be kept is no failure.
  ASSERT_EQ(place.run("echo '0.0.1 3' > cache/hottel/speed; cp cache/hottel/speed before; " + here + plan).code, 0);
  EXPECT_NE(place.read("cache/hottel/speed"), place.read("before"));
  EXPECT_EQ(place.run("unset HOTTEL_SPEED; export XDG_CACHE_HOME=/dev/null/no; " + plan).code, 0);
}

}  // namespace
}  // namespace hottel::solve_test
