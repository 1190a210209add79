// Scenes with numbers at the ends of doubles, and far beyond, in every place that takes one: commands are done, refuse,
// or find the file wrong; none ends by a signal, and none breaks a contract of its own.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "tests/cli/program.h"

namespace hottel::extreme_numbers_test {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing_cli::Outcome;
using testing_cli::Workplace;

// Scenes whose numbers are ordinary, or large or small in all, and some of them anything.
class ExtremeScenes {
 public:
  explicit ExtremeScenes(std::uint64_t seed, int dimension) : engine_(seed), dimension_(dimension) {
    share_ = std::vector{0, 0, 5, 20, 60}[below(5)];
    scale_ = std::vector<std::string>{"", "", "", "e300", "e-300", "e-330", "e400", "e308", "e-160", "e160"}[below(10)];
  }

  std::string scene() {
    std::string text = "{\"hottel\": 1, \"dimension\": " + std::to_string(dimension_) + ",\n\"materials\": {";
    for (int k = 0; k < 3; ++k) text += (k > 0 ? ", " : "") + material(k);
    text += "},\n" + (dimension_ == 2 ? edges() : polygons());
    if (chance(50)) text += ",\n\"sky\": {\"" + any({"emission", "temperature"}) + "\": " + number(true) + "}";
    if (chance(20)) text += ",\n\"closed\": true";
    if (chance(40)) text += ",\n\"grid\": " + grid();
    if (chance(70)) text += ",\n\"lights\": [" + light(0) + (chance(50) ? ", " + light(1) : "") + "]";
    if (dimension_ == 3 && chance(30))
      text += ",\n\"camera\": {\"eye\": " + point() + ", \"target\": " + point() + ", \"up\": " + point() +
              ", \"field_of_view\": " + any({"40", "\"1e-330\"", "179"}) + ", \"pixels\": [8, 6]}";
    return text + "}\n";
  }
  // Of an eye on the command line.
  std::string place() {
    std::string text;
    for (int k = 0; k < dimension_; ++k) text += (k > 0 ? "," : "") + plain(40);
    return text;
  }

 private:
  std::size_t below(std::size_t n) { return static_cast<std::size_t>(engine_() % n); }
  bool chance(std::size_t percent) { return below(100) < percent; }
  std::string any(const std::vector<std::string>& list) { return list[below(list.size())]; }

  std::string plain(std::size_t share) {
    if (chance(share))
      return any({"1e308", "-1e308", "1e-330", "-1e-330", "1e400", "-1e400", "1e4000", "-1e4000", "1e-4000",
                  "1.7976931348623157e308", "5e-324", "1e154", "1e-160", "1e-200", "1e200", "3e307"});
    return any({"0", "1", "2", "3", "1/3", "-1", "0.5", "4", "-2", "1.5"});
  }
  std::string number(bool is_positive = false) {
    std::string text = plain(static_cast<std::size_t>(share_));
    if (is_positive && text[0] == '-') text.erase(0, 1);
    return "\"" + text + "\"";
  }
  std::string coordinate() {
    std::string text = plain(static_cast<std::size_t>(share_));
    if (text != "0" && text.find_first_of("/e") == std::string::npos) text += scale_;
    return "\"" + text + "\"";
  }
  std::string list(const std::vector<std::string>& items) {
    std::string text = "[";
    for (std::size_t k = 0; k < items.size(); ++k) text += (k > 0 ? ", " : "") + items[k];
    return text + "]";
  }
  std::string point() {
    std::vector<std::string> coordinates;
    for (int k = 0; k < dimension_; ++k) coordinates.push_back(coordinate());
    return list(coordinates);
  }

  std::string material(int k) {
    std::string text = "\"m" + std::to_string(k) + "\": ";
    if (chance(15))
      return text + "{\"emissivity\": " + any({"0.5", "1", "\"1e-330\""}) + ", \"temperature\": " + number(true) + "}";
    text += "{\"reflectivity\": " + any({"0", "0.5", "1", "\"1/3\"", "\"1e-400\"", "\"0.99999999999999999999\""});
    return text + (chance(50) ? ", \"emission\": " + number(true) + "}" : "}");
  }
  std::string surface(int k, const std::string& points) {
    return "{\"name\": \"s" + std::to_string(k) + "\", \"points\": " + points + ", \"material\": \"m" +
           std::to_string(below(3)) + "\"" + (chance(50) ? ", \"back\": \"m" + std::to_string(below(3)) + "\"" : "") +
           (chance(20) ? ", \"elements\": 2" : "") + "}";
  }
  std::string edges() {
    std::vector<std::string> all;
    for (int k = 0; k < 1 + static_cast<int>(below(6)); ++k) all.push_back(surface(k, list({point(), point()})));
    std::string text = "\"edges\": " + list(all);
    if (chance(40)) {
      const std::string w = number(true), h = number(true);
      text += ",\n\"polylines\": [{\"name\": \"room\", \"points\": [[0, 0], [0, " + h + "], [" + w + ", " + h + "], [" +
              w + ", 0]], \"closed\": true, \"material\": \"m0\"}]";
    }
    return text;
  }
  std::string polygons() {
    std::vector<std::string> all;
    for (int k = 0; k < 1 + static_cast<int>(below(5)); ++k) {
      if (chance(50)) {
        all.push_back(surface(k, list({point(), point(), point()})));
        continue;
      }
      const std::string a = coordinate(), b = coordinate(), c = coordinate(), d = coordinate(), z = coordinate();
      const std::size_t axis = below(3);
      std::vector<std::string> corners;
      for (const auto& [u, v] : {std::pair{a, b}, {c, b}, {c, d}, {a, d}})
        corners.push_back(axis == 0 ? list({z, u, v}) : axis == 1 ? list({u, z, v}) : list({u, v, z}));
      all.push_back(surface(k, list(corners)));
    }
    return "\"polygons\": " + list(all);
  }
  std::string grid() {
    if (dimension_ == 2) return "{\"min\": " + point() + ", \"max\": " + point() + ", \"cells\": [3, 2]}";
    return "{\"origin\": " + point() + ", \"u\": " + point() + ", \"v\": " + point() + ", \"cells\": [2, 2]}";
  }
  std::string light(int k) {
    std::string text = "{\"name\": \"l" + std::to_string(k) + "\", \"power\": " + number(true);
    if (chance(60)) {
      std::vector<std::string> direction;
      for (int c = 0; c < dimension_; ++c) direction.push_back("\"" + plain(30) + "\"");
      text += ", \"type\": \"spot\", \"direction\": " + list(direction);
      if (chance(70))
        text += ", \"focus\": " + any({"10", "90", "45", "180", "\"1e-330\"", "\"1e-4000\"", "179.99", "\"1e-20\""});
      if (chance(70))
        text += ", \"falloff\": " + any({"1", "\"1/2\"", "2.5", "1000", "1000000", "\"1e-330\"", "999999.5", "65"});
    } else {
      text += ", \"type\": \"point\"";
    }
    if (chance(40)) text += ", \"rotation\": " + (dimension_ == 2 ? number() : list({number(), number(), number()}));
    if (chance(40))
      return text + ", \"path\": {\"points\": " + list({point(), point()}) + ", \"seconds\": " + number(true) + "}}";
    return text + ", \"position\": " + point() + "}";
  }

  std::mt19937_64 engine_;
  int dimension_, share_;
  std::string scale_;
};

constexpr int kTimeIsOver = 124;

void run_all_on_extremes(int dimension, std::uint64_t first, std::uint64_t scenes) {
  const Workplace place;
  std::vector<std::string> lines{"check s.json",
                                 "plan s.json",
                                 "factors s.json -o f.csv --areas",
                                 "factors s.json -o f.mtx",
                                 "factors s.json -o f.bin",
                                 "factors s.json --matrix exchange",
                                 "solve s.json -o solved GRID",
                                 "animate s.json --frames 2 --fps 5 -o film GRID",
                                 "convert s.json t.json",
                                 "compare s.json --methods center --repeat 1 -o compared",
                                 "reference set s.json",
                                 "visibility s.json --at PLACE",
                                 "visibility s.json --at PLACE -o seen.png"};
  const std::vector<std::string> of_plane{"visibility s.json --events",
                                          "visibility s.json --graph",
                                          "solve s.json -o averages --grid 3x2 --illumination average",
                                          "solve s.json -o tested --lights centroid --grid 3x2",
                                          "solve s.json -o squares --grid 3x2 --illumination inverse-square",
                                          "factors s.json --script-f"};
  const std::vector<std::string> of_space{"convert s.json t.stl", "convert s.json t.obj", "convert s.json t.vs3",
                                          "solve s.json -o tested --lights vertices"};
  for (const std::string& line : dimension == 2 ? of_plane : of_space) lines.push_back(line);
  for (std::uint64_t seed = first; seed < first + scenes; ++seed) {
    ExtremeScenes extreme(seed, dimension);
    const std::string text = extreme.scene();
    place.write("s.json", text);
    for (std::size_t k = 0; k < 4; ++k) {  // in turn
      std::string line = lines[(seed * 4 + k) % lines.size()];
      const bool has_lights = text.find("\"lights\"") != std::string::npos;
      if (!has_lights && line.find("--lights") != std::string::npos) continue;  // wrong use
      if (const std::size_t at = line.find("PLACE"); at != std::string::npos) line.replace(at, 5, extreme.place());
      if (const std::size_t at = line.find("GRID"); at != std::string::npos)
        line.replace(at, 4, dimension == 2 ? "--grid 3x2" : "");
      const Outcome outcome = place.run("timeout 5 hottel " + line);
      if (outcome.code == kTimeIsOver) continue;  // numbers of thousands of digits beside short ones take their time
      EXPECT_TRUE(outcome.code == 0 || outcome.code == 1 || outcome.code == 3)
          << outcome.code << " of hottel " << line << ", seed " << seed << ": " << outcome.err << "\n"
          << text;
      EXPECT_THAT(outcome.err, Not(HasSubstr("required:"))) << line << ", seed " << seed << "\n" << text;
    }
  }
}

TEST(ExtremeNumbers, EndNoCommandByASignalInThePlane) { run_all_on_extremes(2, 1, 24); }
TEST(ExtremeNumbers, EndNoCommandByASignalInSpace) { run_all_on_extremes(3, 1, 24); }

// What once divided by zero in a conversion.
TEST(ExtremeNumbers, LightsBeyondDoublesAreTold) {
  const Workplace place;
  place.write("wide.json", R"({"hottel": 1, "dimension": 2, "materials": {"m": {}},
 "edges": [{"name": "e", "points": [["-1e308", "3e308"], ["2e308", "3e308"]], "material": "m"}],
 "lights": [{"type": "point", "position": [0, 0], "power": 1}]})");
  const Outcome wide = place.run("hottel check wide.json");
  EXPECT_EQ(wide.code, 1);
  EXPECT_THAT(wide.out, HasSubstr("beyond-doubles"));
  const auto path = [](const std::string& first, const std::string& dimension) {
    const bool is_plane = dimension == "2";
    return R"({"hottel": 1, "dimension": )" + dimension + R"(, "materials": {"m": {}},)" +
           (is_plane
                ? R"("edges": [{"name": "x", "points": [[2, 1], [2, 2]], "material": "m"}],)"
                : R"("polygons": [{"name": "x", "points": [[2, 1, 0], [2, 2, 0], [3, 1, 0]], "material": "m"}],)") +
           "\n\"lights\": [{\"type\": \"point\", \"name\": \"p\", \"power\": 1, \"path\": {\"points\": [[\"" + first +
           "\", 1" + (is_plane ? "" : ", 1") + "], [\"-1e400\", 2" + (is_plane ? "" : ", 2") + "]], \"seconds\": 1}}]}";
  };
  for (const std::string dimension : {"2", "3"})
    for (const std::string first : {"1e400", "1e308"}) {
      place.write("far.json", path(first, dimension));
      const Outcome far = place.run("hottel animate far.json --frames 2 --fps 5 -o film");
      EXPECT_EQ(far.code, 1) << far.err;
      EXPECT_THAT(far.err, HasSubstr("light 'p': its place on its path is beyond the range of doubles"));
    }
}

TEST(ExtremeNumbers, DirectionsOfBeamsAreOfAnyLength) {
  const Workplace place;
  const auto scene = [](const std::string& length) {
    return R"({"hottel": 1, "dimension": 2, "materials": {"m": {}}, "edges": [{"name": "e", "points": [[-1, 2], [1, 2]],
 "material": "m"}], "lights": [{"type": "spot", "position": [0, 0], "direction": ["0", ")" +
           length + R"("], "power": 1, "focus": 10}]})";
  };
  place.write("plain.json", scene("1"));
  const Outcome plain = place.run("hottel check plain.json");
  EXPECT_EQ(plain.code, 0) << plain.out;
  EXPECT_EQ(place.run("hottel solve plain.json -o plain").code, 0);
  for (const std::string length : {"1e-330", "1e400", "1e300", "1e-4000"}) {
    place.write("s.json", scene(length));
    EXPECT_EQ(place.run("hottel check s.json").code, 0) << length;
    EXPECT_EQ(place.run("hottel solve s.json -o s").code, 0) << length;
    EXPECT_EQ(place.read("s/radiosity.csv"), place.read("plain/radiosity.csv")) << length;
  }
}

}  // namespace
}  // namespace hottel::extreme_numbers_test
