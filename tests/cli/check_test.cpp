// hottel check as a stranger meets it: streams, shape, exit codes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/cli/program.h"

namespace hottel::check_test {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;
using testing_cli::lines_of;
using testing_cli::Outcome;
using testing_cli::Workplace;
using Json = nlohmann::ordered_json;

std::string scene(const std::string& edges, const std::string& rest = "") {
  return "{\"hottel\": 1, \"dimension\": 2, \"materials\": {\"m\": {\"emission\": 1, \"reflectivity\": 0.5}},\n"
         "\"polylines\": [{\"name\": \"room\", \"points\": [[0,0],[0,3],[4,3],[4,0]], \"closed\": true, "
         "\"material\": \"m\"}],\n\"edges\": [\n" +
         edges + "]" + rest + "}\n";
}
const std::string kDoor = R"({"name": "door", "points": [[2, 0], [2, 2.9999]], "material": "m", "back": "m"})";

TEST(Check, JsonHasExactlyTheMembersOfTheContract) {
  const Workplace place;
  place.write("s.json", scene(kDoor));
  const Outcome outcome = place.run("hottel check s.json --json");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.err, "");
  const Json report = Json::parse(outcome.out);
  ASSERT_EQ(report.size(), 1u);
  ASSERT_EQ(report["findings"].size(), 2u);
  for (const Json& finding : report["findings"]) {
    std::vector<std::string> keys;
    for (const auto& [key, value] : finding.items()) keys.push_back(key);
    EXPECT_THAT(keys, testing::ElementsAre("severity", "kind", "surfaces", "at", "line", "message", "suggestion"));
  }
  const Json& miss = report["findings"][0];
  EXPECT_EQ(miss["severity"], "warning");
  EXPECT_EQ(miss["kind"], "near-miss");
  EXPECT_EQ(miss["surfaces"], (Json{"door", "room[1]"}));
  EXPECT_EQ(miss["at"], (Json{2.0, 2.9999}));
  EXPECT_EQ(miss["line"], 4);
}

TEST(Check, TextEndsWithACountAndSaysWhere) {
  const Workplace place;
  place.write("s.json", scene(kDoor));
  const Outcome outcome = place.run("hottel check s.json");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.err, "");
  EXPECT_THAT(outcome.out, StartsWith("s.json:4: warning: near-miss at (2, 2.9999): the end of 'door' is 1e-04 from"));
  EXPECT_EQ(lines_of(outcome.out).back(), "0 errors, 1 warning, 1 note");
  EXPECT_EQ(place.run("hottel check s.json --quiet").out, outcome.out);
}

TEST(Check, ExitsWith1IffThereIsAnError) {
  const Workplace place;
  place.write("open.json",
              scene(R"({"name": "out", "points": [[5, 0], [6, 0]], "material": "m"})", ", \"closed\": true"));
  place.write("conflict.json",
              "{\"hottel\": 1, \"dimension\": 2, \"materials\": {\"m\": {}, \"n\": {\"emission\": 1}}, \"edges\": [\n"
              "{\"name\": \"a\", \"points\": [[0, 0], [2, 0]], \"material\": \"m\"},\n"
              "{\"name\": \"b\", \"points\": [[1, 0], [3, 0]], \"material\": \"n\"}]}\n");
  for (const std::string options : {"", " --json", " --quiet"}) {
    const Outcome open = place.run("hottel check open.json" + options);
    EXPECT_EQ(open.code, 1);
    EXPECT_THAT(open.out, HasSubstr("not-closed"));
    EXPECT_EQ(open.err, "");
    const Outcome conflict = place.run("hottel check conflict.json" + options);
    EXPECT_EQ(conflict.code, 1);
    EXPECT_THAT(conflict.out, HasSubstr("conflicting-claims"));
  }
  EXPECT_EQ(place.run("hottel solve open.json").code, 1);
  EXPECT_EQ(place.run("hottel solve conflict.json").code, 3);
}

TEST(Check, AFileThatIsNoSceneIsRefusedAsEverywhere) {
  const Workplace place;
  place.write("bad.json", "{\"hottel\": 1,\n\"dimension\": 2,\n\"edges\": [{}]}\n");
  for (const std::string options : {"", " --json"}) {
    const Outcome outcome = place.run("hottel check bad.json" + options);
    EXPECT_EQ(outcome.code, 3);
    EXPECT_EQ(outcome.out, "");
    EXPECT_THAT(outcome.err, StartsWith("bad.json:3: "));
  }
  EXPECT_EQ(place.run("hottel check missing.json").code, 3);
  EXPECT_EQ(place.run("hottel check").code, 2);
}

TEST(Check, OfOneKindTwentyAreShownAndTheRestIsCounted) {
  const Workplace place;
  std::string fins;
  for (int k = 1; k <= 30; ++k)
    fins += (k > 1 ? ",\n" : "") + std::string("{\"points\": [[0.") + (k < 10 ? "0" : "") + std::to_string(k) +
            ", 0], [0." + (k < 10 ? "0" : "") + std::to_string(k) + ", 1]], \"material\": \"m\", \"back\": \"m\"}";
  place.write("s.json", scene(fins));
  const Outcome text = place.run("hottel check s.json");
  std::size_t shown = 0;
  for (const std::string& line : lines_of(text.out)) shown += line.find(": t-junction at") != std::string::npos;
  EXPECT_EQ(shown, 20u);
  EXPECT_THAT(text.out, EndsWith("and 10 more of t-junction (--json has them all)\n0 errors, 0 warnings, 30 notes\n"));
  EXPECT_EQ(Json::parse(place.run("hottel check s.json --json").out)["findings"].size(), 30u);
}

TEST(CheckFix, WritesARepairedSceneAndTheChangeOfEveryAffectedFactor) {
  const Workplace place;
  place.write("s.json", scene(kDoor));
  const Outcome outcome = place.run("hottel check s.json --json --fix t.json --within 0.001");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  const Json report = Json::parse(outcome.out);
  EXPECT_EQ(report.size(), 3u);
  EXPECT_EQ(report["repairs"], Json::parse(R"([{"kind": "snapped", "surface": "door",
                            "message": "the end of 'door' went from (2, 2.9999) to (2, 3), on 'room[1]'"}])"));
  // The findings are those of the repaired scene.
  EXPECT_EQ(report["findings"], Json::parse(place.run("hottel check t.json --json").out)["findings"]);
  EXPECT_THAT(place.read("t.json"), HasSubstr(R"({"name": "door", "points": [[2, 0], [2, 3]], "material": "m")"));
  EXPECT_THAT(place.read("t.json"), HasSubstr(R"({"name": "room", "points": [[0, 0], [0, 3], [4, 3], [4, 0]])"));

  // The changes are the lines in which the two lists of factors differ.
  const auto factors = [&place](const std::string& file) {
    std::map<std::string, std::string> result;
    for (const std::string& line : lines_of(place.run("hottel factors " + file + " --quiet").out)) {
      const std::size_t first = line.find(','), second = line.find(',', first + 1);
      result[line.substr(0, second)] = line.substr(second + 1, line.find(',', second + 1) - second - 1);
    }
    return result;
  };
  const auto before = factors("s.json"), after = factors("t.json");
  std::map<std::string, std::pair<double, double>> expected, changes;
  for (const auto* list : {&before, &after})
    for (const auto& [pair, factor] : *list) {
      const double was = before.contains(pair) ? std::strtod(before.at(pair).c_str(), nullptr) : 0;
      const double is = after.contains(pair) ? std::strtod(after.at(pair).c_str(), nullptr) : 0;
      if (was != is) expected[pair] = {was, is};
    }
  for (const Json& change : report["changes"])
    changes[change["from"].get<std::string>() + "," + change["to"].get<std::string>()] = {change["before"],
                                                                                          change["after"]};
  EXPECT_EQ(changes, expected);
  EXPECT_GT(changes.size(), 5u);
}

TEST(CheckFix, ShowsTheSameAsText) {
  const Workplace place;
  place.write("s.json", scene(kDoor));
  const Outcome outcome = place.run("hottel check s.json --fix t.json --within 1/1000");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  const auto lines = lines_of(outcome.out);
  ASSERT_GT(lines.size(), 4u);
  EXPECT_EQ(lines[0], "s.json:4: snapped: the end of 'door' went from (2, 2.9999) to (2, 3), on 'room[1]'");
  EXPECT_EQ(lines[1], "from,to,before,after");
  EXPECT_THAT(outcome.out, EndsWith(place.run("hottel check t.json").out));
}

TEST(CheckFix, TellsOfFacesThatAreGone) {
  const Workplace place;
  place.write("s.json", scene(R"({"name": "a", "points": [[1, 1], [2, 1]], "material": "m"},
                                 {"name": "b", "points": [[1, 1], [2.0001, 1]], "material": "m"})"));
  const Outcome outcome = place.run("hottel check s.json --json --fix t.json --within 0.001");
  EXPECT_EQ(outcome.code, 0);
  const Json report = Json::parse(outcome.out);
  EXPECT_EQ(report["repairs"].back()["kind"], "dropped");
  EXPECT_EQ(report["repairs"].back()["surface"], "b");
  std::size_t gone = 0;
  for (const Json& change : report["changes"]) gone += change["from"] == "b" && change["after"].is_null();
  EXPECT_GT(gone, 0u);
  EXPECT_THAT(place.read("t.json"), testing::Not(HasSubstr("\"b\"")));
}

TEST(CheckFix, ReversesARoomThatIsCertainlyInsideOut) {
  const Workplace place;
  // Walls as edges: a closed polyline of this sense would be solid.
  place.write("s.json", R"({"hottel": 1, "dimension": 2, "materials": {"m": {"emission": 1}, "n": {}}, "edges": [
    {"name": "lamp", "points": [[1, 1], [2, 1]], "material": "m", "back": "m"},
    {"name": "south", "points": [[0, 0], [4, 0]], "material": "n"},
    {"name": "east", "points": [[4, 0], [4, 3]], "material": "n"},
    {"name": "north", "points": [[4, 3], [0, 3]], "material": "n"},
    {"name": "west", "points": [[0, 3], [0, 0]], "material": "n"}]})");
  EXPECT_THAT(place.run("hottel check s.json").out, HasSubstr("warning: inside-out"));
  for (const char* options : {"--fix t.json --within 0.001", "--fix t.json"}) {
    const Outcome outcome = place.run(std::string("hottel check s.json ") + options);
    EXPECT_EQ(outcome.code, 0);
    EXPECT_THAT(outcome.out, HasSubstr("reversed: 'west' goes from (0, 0) to (0, 3) now"));
    EXPECT_THAT(outcome.out, EndsWith("\n0 errors, 0 warnings, 0 notes\n"));
  }
}

TEST(CheckFix, ExitsWith1WhereErrorsRemainAndWritesTheScene) {
  const Workplace place;
  place.write("s.json",
              scene(kDoor + R"(, {"name": "out", "points": [[6, 0], [5, 0]], "material": "m"})", ", \"closed\": true"));
  const Outcome outcome = place.run("hottel check s.json --json --fix t.json --within 0.001");
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(place.files(), testing::ElementsAre("s.json", "t.json"));
}

TEST(CheckFix, RefusesWhatItCannotDoBeforeItWritesAnything) {
  const Workplace place;
  place.write("s.json", scene(kDoor));
  place.write("t.json", "earlier");
  const std::vector<std::pair<std::string, int>> lines = {{"--within 1", 2},
                                                          {"--fix t.json --within 0", 2},
                                                          {"--fix t.json --within -1", 2},
                                                          {"--fix t.json --within near", 2},
                                                          {"--fix - --within 1", 2},
                                                          {"--fix missing/t.json --within 1", 3}};
  for (const auto& [options, code] : lines) {
    const Outcome outcome = place.run("hottel check s.json " + options);
    EXPECT_EQ(outcome.code, code) << options;
    EXPECT_EQ(outcome.out, "") << options;
    EXPECT_NE(outcome.err, "") << options;
  }
  EXPECT_EQ(place.read("t.json"), "earlier");
  EXPECT_EQ(place.files().size(), 2u);
}

// Commands of docs/check.md, and what the page says that they print. View factors in space are estimates, whose last
// digits may differ from machine to machine.
TEST(CheckPage, HasCommandsThatCanBePasted) {
  const std::string sources = HOTTEL_SOURCE_DIR;
  const Workplace place;
  ASSERT_EQ(place.run("ln -s '" + sources + "/scenes' scenes; mkdir tmp").code, 0);
  std::string command;
  Outcome outcome{};
  std::size_t commands = 0, compared = 0;
  for (const std::string& line : lines_of(testing_cli::contents(sources + "/docs/check.md"))) {
    if (line.starts_with("$ ")) {
      command = line.substr(2);
      if (const auto at = command.find("/tmp/"); at != std::string::npos) command.erase(at, 1);
      outcome = place.run(command);
      EXPECT_EQ(outcome.code, 0) << command << '\n' << outcome.err;
      ++commands;
    } else if (line.starts_with("```")) {
      command.clear();
    } else if (!command.empty() && line != "..." &&
               !(line.starts_with("floor,") && command.find("space") != command.npos)) {
      EXPECT_THAT(outcome.out, HasSubstr(line + "\n")) << command;
      ++compared;
    }
  }
  EXPECT_GE(commands, 3u);
  EXPECT_GE(compared, 8u);
}

}  // namespace
}  // namespace hottel::check_test
