// Holds pictures of gathered light, in ten scenes, against full sampling: of 10,000 pixels drawn from all, and of all
// with borders, every point by its own exact map.
//
//   report_gathered FOLDER [SCENE...]      FOLDER/gathered.md, .csv, FOLDER/NAME.png, FOLDER/NAME_off.png
//
// NAME_off.png has in grey how far pixels are from full sampling, white from two steps on; dark blue: not looked at.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <string>
#include <vector>

#include "benchmarks/reports/space/gathered_check.h"
#include "geometry/space/generate/generators.h"
#include "io/files/output_file.h"
#include "io/scene/scene_json.h"
#include "kernel/support/failure.h"
#include "viewer/picture/png_file.h"
#include "viewer/picture/raster.h"
#include "viewer/picture/space/pixel_raster.h"
#include "viewer/picture/space/render_picture.h"

namespace hottel {
namespace {

constexpr double kSteps = 0.5, kMoreSteps = 1;      // that are counted
constexpr double kPart = 0.002, kMorePart = 0.004;  // the same of numbers

// A box that hangs 2^-12 above the floor of a room, and one that stands as far off it and off the wall.
constexpr const char* kNearContacts = R"({
  "hottel": 1, "dimension": 3, "closed": true,
  "about": "A room with a box that all but stands on the floor, and one that all but touches it and the wall",
  "materials": {"white": {"reflectivity": 0.7}, "red": {"reflectivity": [0.7, 0.2, 0.15]},
                "lamp": {"reflectivity": 0.1, "emission": [9, 8, 6]}},
  "polygons": [
    {"name": "floor", "points": [[0,0,0],[4,0,0],[4,4,0],[0,4,0]], "material": "white", "elements": 4},
    {"name": "ceiling", "points": [[0,0,3],[0,4,3],[4,4,3],[4,0,3]], "material": "white", "elements": 4},
    {"name": "lamp", "on": "ceiling", "points": [[1,1,3],[1,2,3],[2,2,3],[2,1,3]], "material": "lamp"},
    {"name": "south", "points": [[0,0,0],[0,0,3],[4,0,3],[4,0,0]], "material": "white", "elements": 4},
    {"name": "north", "points": [[0,4,0],[4,4,0],[4,4,3],[0,4,3]], "material": "white", "elements": 4},
    {"name": "west", "points": [[0,0,0],[0,4,0],[0,4,3],[0,0,3]], "material": "red", "elements": 4},
    {"name": "east", "points": [[4,0,0],[4,0,3],[4,4,3],[4,4,0]], "material": "white", "elements": 4}@BOXES@
  ],
  "camera": {"eye": [0.4, 0.3, 2.2], "target": [2.4, 2.6, 0.4], "up": [0, 0, 1], "field_of_view": 75,
             "pixels": [800, 600]} })";

std::string box(const std::string& name, const std::vector<std::string>& low, const std::vector<std::string>& high) {
  const auto corner = [&](int k) {
    return fmt::format("[{},{},{}]", (k & 1) != 0 ? high[0] : low[0], (k & 2) != 0 ? high[1] : low[1],
                       (k & 4) != 0 ? high[2] : low[2]);
  };
  std::string text;
  const std::vector<std::vector<int>> sides = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                               {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  for (std::size_t k = 0; k < sides.size(); ++k)
    text += fmt::format(
        ",\n    {{\"name\": \"{}{}\", \"points\": [{},{},{},{}], \"material\": \"white\", \"elements\": 2}}", name, k,
        corner(sides[k][0]), corner(sides[k][1]), corner(sides[k][2]), corner(sides[k][3]));
  return text;
}

std::string with(std::string text, const std::string& what, const std::string& instead) {
  const std::size_t at = text.find(what);
  HOTTEL_REQUIRE(at != std::string::npos);
  return text.replace(at, what.size(), instead);
}

std::string text_of(const std::string& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

Scene3 divided(Scene3 scene, std::uint32_t elements) {
  for (Surface& surface : scene.surfaces) surface.elements = elements;
  return scene;
}

struct Case {
  std::string name, story;
  std::function<Scene3()> make;
};

const std::vector<Case>& cases() {
  static const std::vector<Case> kCases = {
      {"cornell_box", "a lamp that shines, 4 x 4 elements a face",
       [] { return divided(read_scene_3("scenes/space/cornell_box.json"), 4); }},
      {"two_boxes", "a lamp that shines, 3 x 3 elements",
       [] { return divided(read_scene_3("scenes/space/two_boxes.json"), 3); }},
      {"stage", "two spots", [] { return read_scene_3("scenes/lights/stage.json"); }},
      {"hall", "a spot and a bulb", [] { return read_scene_3("scenes/lights/hall.json"); }},
      {"city_in_the_sun", "a sun, a sky that shines, 2 x 2 elements",
       [] {
         const std::string sun =
             R"("lights": [{"type": "sun", "name": "sun", "direction": [2, 3, -4], "irradiance": [3, 2.8, 2.4]}], "sky":)";
         return divided(parse_scene_3(with(text_of("scenes/space/city_block.json"), "\"sky\":", sun), "city"), 2);
       }},
      {"satellite_in_sun", "a sun, two bands", [] { return read_scene_3("scenes/heat/satellite_in_sun.json"); }},
      {"furnished_room", "`generate furnished-room`: 348 triangles, an element each, lamps that shine",
       [] {
         return generate_3({"furnished-room", 348, 0, true});
       }},
      {"near_contacts", "boxes 2^-12 of their size off the floor, a wall and each other",
       [] {
         const std::string boxes =
             box("low", {"1.5", "1.5", "0.000244140625"}, {"2.5", "2.5", "0.8"}) +
             box("high", {"2.500244140625", "2", "0.000244140625"}, {"3.999755859375", "3", "1.5"});
         return parse_scene_3(with(kNearContacts, "@BOXES@", boxes), "near contacts");
       }},
      {"attic", "radiation of heat, 3 x 3 elements",
       [] { return divided(read_scene_3("scenes/space/attic.json"), 3); }},
      {"room_touching", "`generate room-touching --n 8`, a ceiling that shines, 2 x 2 elements",
       [] {
         return divided(generate_3({"room-touching", 8, 0, true}), 2);
       }},
  };
  return kCases;
}

void write_file(const std::filesystem::path& path, const std::string& bytes) {
  OutputFile file(path);
  file.write(bytes);
  file.finish();
  file.commit();
}

Raster off_picture(const GatheredCheck3& check) {
  Raster raster(check.picture.width, check.picture.height, 0xFF000040);
  for (const GatheredPixel3& pixel : check.pixels) {
    const auto grey = static_cast<std::uint32_t>(std::min(255.0, 127.5 * pixel.steps));
    raster.pixels[std::size_t{pixel.y} * raster.width + pixel.x] = 0xFF000000 | grey << 16 | grey << 8 | grey;
  }
  return raster;
}

// One row of each table: the pixels for which that is so.
struct Row {
  std::string steps, parts;
};
Row row_of(const std::string& name, const std::string& kind, const GatheredCheck3& check,
           const std::function<bool(const GatheredPixel3&)>& is_meant) {
  std::size_t count = 0, over = 0, more = 0, part_over = 0, part_more = 0;
  double sum = 0;
  const GatheredPixel3 *worst = nullptr, *worst_part = nullptr;
  for (const GatheredPixel3& pixel : check.pixels) {
    if (!is_meant(pixel)) continue;
    ++count;
    sum += pixel.steps;
    over += pixel.steps > kSteps ? 1 : 0;
    more += pixel.steps > kMoreSteps ? 1 : 0;
    part_over += pixel.part > kPart ? 1 : 0;
    part_more += pixel.part > kMorePart ? 1 : 0;
    if (worst == nullptr || pixel.steps > worst->steps) worst = &pixel;
    if (worst_part == nullptr || pixel.part > worst_part->part) worst_part = &pixel;
  }
  if (count == 0) return {};
  const auto share = [count](std::size_t over_it) {
    return fmt::format("{:.2f} %", 100 - 100 * static_cast<double>(over_it) / static_cast<double>(count));
  };
  return {fmt::format("| {} | {} | {} | {:.3f} | {} | {} | {:.2f} at {},{} |\n", name, kind, count,
                      sum / static_cast<double>(count), share(over), share(more), worst->steps, worst->x, worst->y),
          fmt::format("| {} | {} | {} | {} | {:.2g} at {},{} |\n", name, kind, share(part_over), share(part_more),
                      worst_part->part, worst_part->x, worst_part->y)};
}

int run(const std::filesystem::path& folder, const std::vector<std::string>& names) {
  std::string steps =
      "| scene | pixels | number | mean, steps | within half a step | within one | largest "
      "|\n|---|---|--:|--:|--:|--:|--:|\n";
  std::string parts = "| scene | pixels | within 0.2 % | within 0.4 % | largest part |\n|---|---|--:|--:|--:|\n";
  std::string csv = "scene,x,y,drawn,edge,shadow,event,steps,part\n", stories;
  for (const Case& one : cases()) {
    if (!names.empty() && std::ranges::find(names, one.name) == names.end()) continue;
    const Simulation3 simulation(one.make(), {.factors = {.granularity = Granularity::kElement, .tolerance = 1e-4}});
    const GatheredCheck3 check = check_gathered_3(simulation, {});
    std::string here;
    const auto add = [&](const std::string& kind, const std::function<bool(const GatheredPixel3&)>& is_meant) {
      const Row row = row_of(one.name, kind, check, is_meant);
      steps += row.steps;
      parts += row.parts;
      here += row.steps;
    };
    add("drawn", [](const GatheredPixel3& pixel) { return pixel.is_drawn; });
    add("drawn, without borders", [](const GatheredPixel3& pixel) { return pixel.is_drawn && !pixel.borders.any(); });
    add("all on edges", [](const GatheredPixel3& pixel) { return pixel.borders.has_edge; });
    add("all on shadows", [](const GatheredPixel3& pixel) { return pixel.borders.has_shadow; });
    add("all on events", [](const GatheredPixel3& pixel) { return pixel.borders.has_event; });
    stories +=
        fmt::format("- `{}`: {}; {} x {} pixels, {} with borders; the picture took {:.1f} s, full sampling {:.0f} s\n",
                    one.name, one.story, check.picture.width, check.picture.height, check.all_borders,
                    check.seconds_of_picture, check.seconds_of_sampling);
    for (const GatheredPixel3& pixel : check.pixels)
      csv += fmt::format("{},{},{},{},{},{},{},{:.4g},{:.4g}\n", one.name, pixel.x, pixel.y, int{pixel.is_drawn},
                         int{pixel.borders.has_edge}, int{pixel.borders.has_shadow}, int{pixel.borders.has_event},
                         pixel.steps, pixel.part);
    const ToneCurve tone(kUsualTone3, 1, check.picture.values, check.picture.channels);
    write_file(folder / (one.name + ".png"), png_file(pixel_raster_3(check.picture, &tone)));
    write_file(folder / (one.name + "_off.png"), png_file(off_picture(check)));
    std::printf("%s", here.c_str());
    std::fflush(stdout);
  }
  write_file(folder / "gathered.md", stories + "\n" + steps + "\n" + parts);
  write_file(folder / "gathered.csv", csv);
  return 0;
}

}  // namespace
}  // namespace hottel

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fprintf(stderr, "report_gathered FOLDER [SCENE...]\n");
    return 2;
  }
  try {
    return hottel::run(argv[1], {argv + 2, argv + argc});
  } catch (const std::exception& error) {
    std::fprintf(stderr, "report_gathered: %s\n", error.what());
    return 1;
  }
}
