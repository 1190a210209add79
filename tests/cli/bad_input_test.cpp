// Every input that CONTRACT forbids: the documented exit code, one line that names the file, earlier outputs intact.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/cli/program.h"

namespace hottel::bad_input_test {
namespace {

using testing_cli::lines_of;
using testing_cli::Outcome;
using testing_cli::Workplace;

// A good scene; bad ones are made of it by replacing one of its lines.
const std::vector<std::string> kScene = {
    "{ \"hottel\": 1,",
    "\"dimension\": 2,",
    "\"materials\": { \"m\": {\"reflectivity\": 0.5}, \"n\": {\"reflectivity\": 0.25} },",
    "\"edges\": [ {\"name\": \"a\", \"points\": [[0, 0], [2, 0]], \"material\": \"m\"},",
    "{\"name\": \"b\", \"points\": [[2, 1], [0, 1]], \"material\": \"n\"} ],",
    "\"polylines\": [ {\"name\": \"p\", \"points\": [[5, 0], [6, 0], [6, 1]], \"material\": \"m\"} ],",
    "\"sky\": {\"emission\": 0} }"};

std::string scene_with(std::size_t line, const std::string& text) {
  std::string scene;
  for (std::size_t k = 0; k < kScene.size(); ++k) scene += (k + 1 == line ? text : kScene[k]) + "\n";
  return scene;
}

std::string edge(const std::string& members) { return "\"edges\": [ {\"name\": \"a\", " + members + "},"; }
std::string material(const std::string& members) {
  return "\"materials\": { \"m\": {" + members + "}, \"n\": {\"reflectivity\": 0.25} },";
}
std::string coordinate(const std::string& number) {
  return edge("\"points\": [[" + number + ", 0], [2, 0]], \"material\": \"m\"");
}
std::string named(const std::string& name) {
  return "\"edges\": [ {\"name\": \"" + name + "\", \"points\": [[0, 0], [2, 0]], \"material\": \"m\"},";
}

// One line of the good scene replaced; the message is about that line, or about `at`.
struct BadScene {
  const char* name;
  std::size_t line;
  std::string text;
  std::size_t at = 0;  // 0: as line
};

void PrintTo(const BadScene& bad, std::ostream* out) { *out << bad.name; }

const std::vector<BadScene>& bad_scenes() {
  static const std::vector<BadScene> scenes = {
      {"not_json", 2, "dimension: 2,"},
      {"nan", 4, coordinate("NaN")},
      {"infinity", 4, coordinate("Infinity")},
      {"nan_in_a_string", 4, coordinate("\"nan\"")},
      {"comment", 2, "\"dimension\": 2, // two"},
      {"cut_off", 7, "\"sky\": {\"emission\": 0}"},
      {"more_after_the_end", 7, "\"sky\": {\"emission\": 0} } }"},
      {"other_version", 1, "{ \"hottel\": 2,"},
      {"version_as_text", 1, "{ \"hottel\": \"1\","},
      {"no_version", 1, "{"},
      {"dimension_four", 2, "\"dimension\": 4,"},
      {"dimension_one_and_a_half", 2, "\"dimension\": 1.5,"},
      {"no_dimension", 2, "", 1},
      {"duplicate_key", 2, "\"dimension\": 2, \"dimension\": 2,"},
      {"duplicate_key_in_an_edge", 4, edge("\"points\": [[0, 0], [2, 0]], \"material\": \"m\", \"material\": \"m\"")},
      {"duplicate_material", 3, "\"materials\": {\"m\": {}, \"n\": {},\"m\": {}},"},
      {"unknown_key", 2, "\"dimension\": 2, \"dimensions\": 2,"},
      {"unknown_key_in_an_edge", 4, edge("\"points\": [[0, 0], [2, 0]], \"material\": \"m\", \"front\": \"m\"")},
      {"unknown_key_in_a_material", 3, material("\"albedo\": 0.5")},
      {"unknown_key_in_the_sky", 7, "\"sky\": {\"colour\": 0} }"},
      {"materials_as_a_list", 3, "\"materials\": [\"m\", \"n\"],"},
      {"points_as_text", 4, edge("\"points\": \"0 0 2 0\", \"material\": \"m\"")},
      {"coordinate_as_truth", 4, coordinate("true")},
      {"coordinate_as_null", 4, coordinate("null")},
      {"coordinate_as_words", 4, coordinate("\"one half\"")},
      {"coordinate_with_blanks", 4, coordinate("\" 1\"")},
      {"coordinate_over_zero", 4, coordinate("\"1/0\"")},
      {"coordinate_as_fraction_of_decimals", 4, coordinate("\"1.5/2\"")},
      {"coordinate_too_long", 4, coordinate("\"" + std::string(4097, '1') + "\"")},
      {"exponent_too_large", 4, coordinate("\"1e4097\"")},
      {"exponent_too_small", 4, coordinate("\"1e-4097\"")},
      {"exponent_huge", 4, coordinate("\"1e99999999999999999999\"")},
      {"three_coordinates", 4, edge("\"points\": [[0, 0, 0], [2, 0, 0]], \"material\": \"m\"")},
      {"missing_material", 4, edge("\"points\": [[0, 0], [2, 0]]")},
      {"material_not_defined", 4, edge("\"points\": [[0, 0], [2, 0]], \"material\": \"x\"")},
      {"back_not_defined", 4, edge("\"points\": [[0, 0], [2, 0]], \"material\": \"m\", \"back\": \"x\"")},
      {"duplicate_name", 4, named("b"), 5},
      {"name_of_a_piece", 4, named("p[1]"), 6},
      {"name_of_a_polyline", 4, named("p"), 6},
      {"name_empty", 4, named("")},
      {"name_sky", 4, named("sky")},
      {"name_with_a_number_sign", 4, named("a#1")},
      {"name_with_a_control_character", 4, named("a\\u0007")},
      {"name_of_a_back", 4, named("a:back")},
      {"name_not_utf8", 4, named("\xff")},
      {"one_point", 4, edge("\"points\": [[0, 0]], \"material\": \"m\"")},
      {"one_point_in_a_polyline", 6, "\"polylines\": [ {\"points\": [[5, 0]], \"material\": \"m\"} ],"},
      {"zero_length", 4, edge("\"points\": [[0.5, 0], [\"1/2\", 0]], \"material\": \"m\"")},
      {"zero_length_in_a_polyline", 6,
       "\"polylines\": [ {\"points\": [[5, 0], [5, 0], [6, 1]], \"material\": \"m\"} ],"},
      {"zero_length_by_closing", 6,
       "\"polylines\": [ {\"points\": [[5, 0], [6, 0], [5, 0]], \"closed\": true, \"material\": \"m\"} ],"},
      {"reflectivity_above_one", 3, material("\"reflectivity\": \"10001/10000\"")},
      {"reflectivity_below_zero", 3, material("\"reflectivity\": [0, -0.1, 0]")},
      {"reflectivity_of_two_channels", 3, material("\"reflectivity\": [0, 0.1]")},
      {"negative_emission", 3, material("\"emission\": -1")},
      {"negative_emission_of_the_sky", 7, "\"sky\": {\"emission\": [0, 0, -1]} }"},
      {"emissivity_above_one", 3, material("\"emissivity\": 1.1, \"temperature\": 300")},
      {"negative_temperature", 3, material("\"emissivity\": 1, \"temperature\": -1")},
      {"reflectivity_and_emissivity", 3, material("\"reflectivity\": 0.5, \"emissivity\": 0.5")},
      {"emission_and_temperature", 3, material("\"emission\": 1, \"emissivity\": 0.5, \"temperature\": 300")},
      {"no_elements", 4, edge("\"points\": [[0, 0], [2, 0]], \"material\": \"m\", \"elements\": 0")},
      {"half_an_element", 4, edge("\"points\": [[0, 0], [2, 0]], \"material\": \"m\", \"elements\": 1.5")},
      {"closed_as_number", 7, "\"closed\": 1 }"},
      {"light_on_an_edge", 7,
       "\"lights\": [ {\"type\": \"point\", \"name\": \"torch\", \"position\": [1, 0], \"power\": 5} ] }"},
      {"deep_nesting", 7, "\"sky\": " + std::string(1000000, '[') + std::string(1000000, ']') + " }"},
      {"deep_nesting_without_end", 7, "\"sky\": " + std::string(1000000, '[')},
      {"conflicting_claims", 5, "{\"name\": \"b\", \"points\": [[1, 0], [3, 0]], \"material\": \"n\"} ],"},
      {"conflicting_claims_by_a_back", 5,
       "{\"name\": \"b\", \"points\": [[3, 0], [1, 0]], \"material\": \"m\", \"back\": \"n\"} ],"},
  };
  return scenes;
}

// One line on stderr, at most three hints, nothing on stdout, and what was there before still is.
void expect_one_line(const Outcome& outcome, int code) {
  EXPECT_EQ(outcome.code, code) << outcome.err.substr(0, 500);
  EXPECT_EQ(outcome.out, "");
  const auto lines = lines_of(outcome.err);
  ASSERT_GE(lines.size(), 1u);
  EXPECT_LE(lines.size(), 4u) << outcome.err;
  EXPECT_FALSE(lines[0].starts_with(" ")) << lines[0];
  EXPECT_LE(lines[0].size(), 1000u);
  for (std::size_t k = 1; k < lines.size(); ++k) EXPECT_TRUE(lines[k].starts_with("  ")) << lines[k];
}

class BadScenes : public testing::TestWithParam<BadScene> {};

TEST_P(BadScenes, AreRefusedAtTheirLineAndLeaveEarlierOutputs) {
  const BadScene& bad = GetParam();
  const Workplace place;
  place.write("bad.json", scene_with(bad.line, bad.text));
  place.write("earlier.csv", "earlier");
  const std::string at = "bad.json:" + std::to_string(bad.at > 0 ? bad.at : bad.line) + ": ";
  for (const char* line : {"hottel factors bad.json", "hottel factors bad.json -o earlier.csv --quiet",
                           "hottel visibility bad.json --at 1,1"}) {
    const Outcome outcome = place.run(line);
    expect_one_line(outcome, 3);
    EXPECT_TRUE(outcome.err.starts_with(at)) << outcome.err.substr(0, 500);
  }
  EXPECT_EQ(place.read("earlier.csv"), "earlier");
  EXPECT_EQ(place.files(), (std::vector<std::string>{"bad.json", "earlier.csv"}));
}

INSTANTIATE_TEST_SUITE_P(, BadScenes, testing::ValuesIn(bad_scenes()),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(BadInput, TheGoodSceneIsAccepted) {
  const Workplace place;
  place.write("good.json", scene_with(0, ""));
  const Outcome outcome = place.run("hottel factors good.json --quiet -o good.csv");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.out + outcome.err, "");
}

TEST(BadInput, ConflictsNameBothSurfacesTheSideAndThePiece) {
  const Workplace place;
  place.write("bad.json", scene_with(5, "{\"name\": \"b\", \"points\": [[1, 0], [3, 0]], \"material\": \"n\"} ],"));
  const std::string message = lines_of(place.run("hottel factors bad.json").err).at(0);
  for (const char* part : {"'a'", "'b'", "front", "(1, 0)", "(2, 0)"})
    EXPECT_NE(message.find(part), std::string::npos) << message;
}

TEST(BadInput, NumbersAtTheLimitsAreRead) {
  const Workplace place;
  for (const std::string number : {"1e4096", "-1e-4096", "-0.1e1", "4/3"}) {
    place.write("good.json", scene_with(4, coordinate("\"" + number + "\"")));
    EXPECT_EQ(place.run("hottel factors good.json --quiet").code, 0) << number;
  }
}

// A shell line that fails, and what its message begins with.
struct BadLine {
  const char* name;
  const char* line;
  int code;
  const char* message;
};

void PrintTo(const BadLine& bad, std::ostream* out) { *out << bad.line; }

const BadLine kBadLines[] = {
    {"no_command", "hottel", 2, "hottel: no command is given"},
    {"unknown_command", "hottel factor good.json", 2, "hottel: there is no command 'factor'"},
    {"unknown_option", "hottel factors good.json --colour", 2, "hottel: "},
    {"option_without_value", "hottel factors good.json -o", 2, "hottel: "},
    {"no_scene", "hottel factors", 2, "hottel: factors needs a scene"},
    {"two_scenes", "hottel factors good.json good.json", 2, "hottel: "},
    {"unknown_ending", "hottel factors good.json -o earlier.xls", 2, "hottel: "},
    {"no_ending", "hottel factors good.json -o earlier", 2, "hottel: "},
    {"dense_matrix_as_npy", "hottel factors good.json --matrix factor -o earlier.npy", 2, "hottel: "},
    {"exact_forms_as_mtx", "hottel factors good.json --exact-form -o earlier.mtx", 2, "hottel: "},
    {"exact_forms_of_one", "hottel factors good.json --exact-form a", 2, "hottel: --exact-form"},
    {"exact_forms_of_nobody", "hottel factors good.json --exact-form a nobody -o earlier.csv", 2, "hottel: "},
    {"exact_forms_and_matrix", "hottel factors good.json --exact-form --matrix factor", 2, "hottel: "},
    {"unknown_method", "hottel factors good.json --method magic", 2, "hottel: there is no method called 'magic'"},
    {"no_value", "hottel check good.json --fix", 2, "hottel: --fix wants a value: --fix OUT"},
    {"twice", "hottel factors good.json --elements 2 --elements 3", 2, "hottel: --elements is given more than once"},
    {"unknown_per", "hottel factors good.json --per room", 2, "hottel: --per"},
    {"unknown_pairs", "hottel factors good.json --pairs all", 2, "hottel: --pairs"},
    {"unknown_matrix", "hottel factors good.json --matrix view", 2, "hottel: --matrix"},
    {"tolerance_of_words", "hottel factors good.json --tolerance small", 2, "hottel: --tolerance"},
    {"no_elements", "hottel factors good.json --elements 0", 2, "hottel: --elements"},
    {"elements_below_zero", "hottel factors good.json --elements -4", 2, "hottel: --elements"},
    {"half_an_element", "hottel factors good.json --elements 2.5", 2, "hottel: --elements"},
    {"elements_of_words", "hottel factors good.json --elements many", 2, "hottel: --elements"},
    {"element_size_zero", "hottel factors good.json --element-size 0", 2, "hottel: --element-size"},
    {"element_size_below_zero", "hottel factors good.json --element-size -1", 2, "hottel: --element-size"},
    {"element_size_of_words", "hottel factors good.json --element-size 1/0", 2, "hottel: --element-size"},
    {"element_size_too_small", "hottel factors good.json --element-size 1e-30", 2, "hottel: --element-size"},
    {"elements_and_size", "hottel factors good.json --elements 2 --element-size 1", 2, "hottel: "},
    {"json_and_data_on_stdout", "hottel factors good.json --json -o -", 2, "hottel: --json"},
    {"no_threads", "hottel factors good.json --threads 0", 2, "hottel: --threads"},
    {"exposure_of_no_number", "hottel solve good.json --exposure nan", 2, "hottel: --exposure"},
    {"until_no_number", "hottel solve good.json --until nan", 2, "hottel: --until"},
    {"memory_below_zero", "hottel solve good.json --memory -5", 2, "hottel: --memory"},
    {"worst_below_zero", "hottel compare good.json --methods exact --worst -1", 2, "hottel: --worst"},
    {"file_of_no_name", "hottel compare good.json --methods file:", 2, "hottel: the method file: needs a path"},
    {"empty_method", "hottel compare good.json --methods exact,", 2, "hottel: --methods has an empty name"},
    {"empty_method_between", "hottel compare good.json --methods exact,,strings", 2, "hottel: --methods has an empty"},
    {"empty_method_first", "hottel compare good.json --methods ,exact", 2, "hottel: --methods has an empty name"},
    {"no_method", "hottel compare good.json --methods ''", 2, "hottel: --methods is empty"},
    {"solve_to_standard_output", "hottel solve good.json -o -", 2, "hottel: results are several files"},
    {"compare_to_standard_output", "hottel compare good.json -o -", 2, "hottel: results are several files"},
    {"seed_below_zero", "hottel generate room --seed -1", 2, "hottel: --seed"},
    {"number_of_edges_below_zero", "hottel generate room --n -5", 2, "hottel: --n"},
    {"digits_below_zero", "hottel generate room --digits -1", 2, "hottel: --digits"},
    {"lattice_below_zero", "hottel generate lattice --k -1", 2, "hottel: --k"},
    {"drawing_of_no_picture", "hottel visibility good.json --at 1,1 -o x.gif", 2, "hottel: a drawing is written as"},
    {"unknown_kind", "hottel generate castle", 2, "hottel: "},
    {"point_of_one_number", "hottel visibility good.json --at 1", 2, "hottel: --at"},
    {"point_of_nobody", "hottel visibility good.json --on nobody --at 1/2", 2, "hottel: "},
    {"missing_file", "hottel factors nowhere.json", 3, "nowhere.json: "},
    {"directory", "hottel factors sub", 3, "sub: "},
    {"empty_file", "hottel factors /dev/null", 3, "/dev/null: "},
    {"output_directory", "hottel factors good.json -o sub.csv", 3, "sub.csv: "},
    {"output_in_no_directory", "hottel factors good.json -o nowhere/out.csv", 3, "nowhere/out.csv: "},
    {"output_below_a_file", "hottel factors good.json -o good.json/out.csv", 3, "good.json/out.csv: "},
    {"standard_output_full", "hottel factors good.json > /dev/full", 3, "standard output: "},
    {"report_on_a_full_device", "hottel factors good.json -o earlier.csv --json > /dev/full", 3, "standard output: "},
    {"version_on_a_full_device", "hottel --version > /dev/full", 3, "standard output: "},
    {"faces_file_in_the_way", "hottel factors good.json -o faces.mtx", 3, "faces.mtx.faces.csv: "},
    {"picture_in_no_directory", "hottel factors good.json -o earlier.csv --picture nowhere/x.png --toward a", 3,
     "nowhere/x.png: "},
    {"scene_in_no_directory", "hottel generate lattice --n 10 -o nowhere/x.json", 3, "nowhere/x.json: "},
};

class BadLines : public testing::TestWithParam<BadLine> {};

TEST_P(BadLines, EndWithTheirCodeAndLeaveEarlierOutputs) {
  const Workplace place;
  place.write("good.json", scene_with(0, ""));
  for (const char* name : {"earlier.csv", "earlier.npy", "earlier.mtx", "earlier", "earlier.xls", "faces.mtx"})
    place.write(name, "earlier");
  for (const char* name : {"sub", "sub.csv", "faces.mtx.faces.csv"})
    std::filesystem::create_directory(place.path(name));
  const auto before = place.files();
  const Outcome outcome = place.run(GetParam().line);
  expect_one_line(outcome, GetParam().code);
  EXPECT_TRUE(outcome.err.starts_with(GetParam().message)) << outcome.err;
  EXPECT_EQ(place.files(), before);
  for (const char* name : {"earlier.csv", "earlier.npy", "earlier.mtx", "earlier", "earlier.xls", "faces.mtx"})
    EXPECT_EQ(place.read(name), "earlier") << name;
}

INSTANTIATE_TEST_SUITE_P(, BadLines, testing::ValuesIn(kBadLines),
                         [](const auto& test) { return std::string(test.param.name); });

// A disk that is full after 4 KiB, for every format.
class FullDisk : public testing::TestWithParam<std::string> {};

TEST_P(FullDisk, LeavesTheEarlierFile) {
  const Workplace place;
  ASSERT_EQ(place.run("hottel generate lattice --n 100 --seed 3 --quiet -o room.json").code, 0);
  const std::string file = "out." + GetParam();
  place.write(file, "earlier");
  place.write(file + ".faces.csv", "earlier");
  const auto before = place.files();
  const Outcome outcome = place.run("ulimit -f 4; hottel factors room.json -o " + file);
  expect_one_line(outcome, 3);
  EXPECT_TRUE(outcome.err.starts_with(file)) << outcome.err;
  EXPECT_EQ(place.read(file), "earlier");
  EXPECT_EQ(place.read(file + ".faces.csv"), "earlier");
  EXPECT_EQ(place.files(), before);
}

INSTANTIATE_TEST_SUITE_P(, FullDisk, testing::Values("csv", "mtx", "npy", "txt", "bin"),
                         [](const auto& test) { return test.param; });

// Permissions hold for ordinary users only.
TEST(BadInput, UnreadableAndUnwritableFilesAreNamed) {
  const Workplace place;
  place.write("good.json", scene_with(0, ""));
  place.write("secret.json", scene_with(0, ""));
  place.write("kept.csv", "earlier");
  ASSERT_EQ(place.run("chmod 000 secret.json; chmod 444 kept.csv; mkdir shut; chmod 555 shut").code, 0);
  const bool is_root = ::geteuid() == 0;
  const std::string as_nobody = is_root ? "chmod 755 .. .; setpriv --reuid 65534 --regid 65534 --clear-groups " : "";
  const Outcome unreadable = place.run(as_nobody + "hottel factors secret.json");
  expect_one_line(unreadable, 3);
  EXPECT_TRUE(unreadable.err.starts_with("secret.json: ")) << unreadable.err;
  const Outcome unwritable = place.run(as_nobody + "hottel factors good.json -o kept.csv");
  expect_one_line(unwritable, 3);
  EXPECT_TRUE(unwritable.err.starts_with("kept.csv: ")) << unwritable.err;
  EXPECT_EQ(place.read("kept.csv"), "earlier");
  const Outcome shut = place.run(as_nobody + "hottel factors good.json -o shut/new.csv");
  expect_one_line(shut, 3);
  EXPECT_TRUE(shut.err.starts_with("shut/new.csv: ")) << shut.err;
  EXPECT_EQ(place.run("chmod 755 shut").code, 0);
}

}  // namespace
}  // namespace hottel::bad_input_test
