// The tasks of docs/library.md: each is compiled and run here, against hottel.h and, for the last, hottel_visibility.h.
#include <gtest/gtest.h>
#include <hottel.h>
#include <hottel_visibility.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

namespace hottel::library_tasks_test {
namespace {

class LibraryTasks : public ::testing::Test {
 protected:
  LibraryTasks() {
    std::filesystem::current_path(HOTTEL_SOURCE_DIR);
    ::testing::internal::CaptureStdout();
  }
  std::string printed() { return ::testing::internal::GetCapturedStdout(); }
};

TEST_F(LibraryTasks, OneViewFactorOfASceneFile) {
  // task
  const Simulation2 simulation(read_scene_2("scenes/analytic/strip_obstructed.json"));
  const Rounded f = view_factor(simulation, "bottom", "top");
  std::printf("F = %.17g in [%.17g, %.17g]\n", f.value, f.enclosure().lower, f.enclosure().upper);
  // end
  EXPECT_EQ(printed(), "F = 0.11803398874989485 in [0.11803398874989485, 0.11803398874989486]\n");
}

TEST_F(LibraryTasks, ASceneMadeInCode) {
  // task
  SceneBuilder2 scene;
  scene.add_material("white", {.reflectivity = "0.7"}).add_material("glow", {.emission = 10});
  scene.add_polyline("room", {{0, 0}, {0, 3}, {4, 3}, {4, 0}}, "white", {.closed = true});
  scene.add_edge("lamp", {1, "2.9"}, {"4/3", "2.9"}, "glow", {.back = "white"});
  std::printf("F = %.12g\n", view_factor(Simulation2(scene.build()), "lamp", "room[3]").value);
  // end
  const Scene2 written = parse_scene_2(write_scene_2(scene.build()), "written");
  EXPECT_EQ(written.edges, scene.build()->edges);
  EXPECT_EQ(written.edges[0].to, (Point2{Rational(4, 3), Rational(29, 10)}));
  EXPECT_EQ(printed(), "F = 0.535653882522\n");
}

TEST_F(LibraryTasks, ASceneInSpace) {
  // task
  const Simulation3 simulation(read_scene_3("scenes/space/cube.json"), {.factors = {.tolerance = 1e-12}});
  const KnownFactor3 f = view_factor(simulation, "floor", "ceiling");
  std::printf("F = %.12f, proven within %.0e\n", f.value, f.bounds.upper - f.bounds.lower);
  std::printf("B = %.9f\n", radiosity_of(simulation, "floor").radiosity);
  // end
  const std::string text = printed();
  EXPECT_EQ(text.substr(0, 19), "F = 0.199824895698,") << text;
  EXPECT_EQ(view_factor(simulation, "floor", "sky").value, 0);
  EXPECT_EQ(view_factor(simulation, "floor", "floor").bounds.upper, 0);
  EXPECT_THROW(view_factor(simulation, "floor:back", "sky"), UsageError);
  EXPECT_THROW(view_factor(simulation, "nobody", "sky"), UsageError);
}

TEST_F(LibraryTasks, RadiositiesAndAnEdit) {
  // task
  const Simulation2 day(read_scene_2("scenes/analytic/square_radiosity.json"));
  Scene2 scene = day.scene();
  material_called(scene, "lit").emission = Spectrum::scalar(2);
  const Simulation2 night = day.with_scene(scene);  // has the same view factors, which are not computed again
  for (const Simulation2& each : {day, night}) std::printf("B = %.6g\n", radiosity_of(each, "bottom").radiosity);
  // end
  EXPECT_EQ(printed(), "B = 1.14446\nB = 2.28892\n");
  EXPECT_EQ(day.factors(), night.factors());
}

TEST_F(LibraryTasks, LightAtAPoint) {
  // task
  const Simulation2 simulation(read_scene_2("scenes/analytic/square_radiosity.json"));
  const PointLight2 light = light_at(simulation, {Rational(1, 2), Rational(1, 3)});
  for (std::size_t c = 0; c < light.mean_irradiance.size(); ++c)
    std::printf("%s: %.12g\n", light.channel_names[c].c_str(), light.mean_irradiance[c]);
  // end
  EXPECT_EQ(printed(), "all: 0.552870134543\n");
}

TEST_F(LibraryTasks, PolygonsOfManyPoints) {
  // task
  const Simulation2 simulation(read_scene_2("scenes/analytic/strip_obstructed.json"));
  const std::vector<Point2> points = {{0, Rational(1, 2)}, {0, Rational(3, 2)}};
  for (const RoundedPolygon2& polygon : visibility_polygons(*simulation.prepared(), points))
    for (const auto& [x, y, after] : polygon.corners)
      std::printf("%g %g %s\n", x, y, polygon_side_name(*simulation.prepared(), after).c_str());
  // end
  EXPECT_EQ(printed(),
            "1 0 sky\n0.5 1 obstruction\n-0.5 1 sky\n-1 0 bottom\n"
            "1 2 top\n-1 2 sky\n-0.5 1 obstruction:back\n0.5 1 sky\n");
}

// The blocks between "// task" and "// end" of this file, or the C++ blocks of a page, as they are indented there.
std::vector<std::string> blocks(const std::string& file, const std::string& begin, const std::string& end) {
  std::ifstream text(file);
  std::vector<std::string> result;
  bool is_inside = false;
  for (std::string line; std::getline(text, line);) {
    const std::string bare = line.substr(std::min(line.size(), line.find_first_not_of(' ')));
    if (!is_inside && bare == begin) {
      is_inside = true;
      result.emplace_back();
    } else if (is_inside && bare == end) {
      is_inside = false;
    } else if (is_inside) {
      result.back() += (line.starts_with("  ") && begin == "// task" ? line.substr(2) : line) + "\n";
    }
  }
  return result;
}

TEST(LibraryPage, ShowsTheTasksThatAreTestedHere) {
  const std::string root = HOTTEL_SOURCE_DIR;
  const auto tested = blocks(root + "/tests/library/library_tasks_test.cpp", "// task", "// end");
  const auto shown = blocks(root + "/docs/library.md", "```cpp", "```");
  ASSERT_EQ(tested.size(), 6u);
  EXPECT_EQ(shown, tested);
  for (const std::string& task : tested) EXPECT_LE(std::count(task.begin(), task.end(), '\n'), 5) << task;
}

}  // namespace
}  // namespace hottel::library_tasks_test
