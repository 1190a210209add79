// What solids leave of faces, and what more of them would: against arrangements made with them.
#include "geometry/plane/check/face_cover.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "geometry/plane/check/behind_remedies.h"
#include "geometry/plane/check/contact_findings.h"
#include "geometry/plane/prepared/element_table.h"
#include "geometry/plane/prepared/prepared_scene.h"
#include "tests/geometry/plane/exchange_scenes.h"

namespace hottel::face_cover_test {
namespace {

using namespace testing_scenes;

// Boxes, boxes without a side, rooms and edges on a small lattice: full of overlaps.
Scene2 lattice_of_boxes(unsigned seed, unsigned materials) {
  std::mt19937 chance(seed);
  const auto draw = [&chance](unsigned below) { return static_cast<int>(chance() % below); };
  Scene2 scene;
  scene.file = "test.json";
  scene.materials = four_materials();
  for (int g = 0; g < 9; ++g) {
    const int x0 = draw(6), y0 = draw(6), x1 = x0 + 1 + draw(3), y1 = y0 + 1 + draw(3);
    std::vector<Point2> points{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}, {x0, y0}};
    std::rotate(points.begin(), points.begin() + draw(4), points.end() - 1);
    points.back() = points.front();
    if (draw(3) == 0) std::reverse(points.begin(), points.end());
    if (draw(3) == 0) points.erase(points.begin(), points.begin() + 1 + draw(2));
    scene.groups.emplace_back("g" + std::to_string(g), draw(12) == 0 ? Behind::kOpen : Behind::kByOutline);
    const auto material = static_cast<std::uint32_t>(draw(materials));
    const bool has_back = draw(6) == 0;
    for (std::size_t k = 0; k + 1 < points.size(); ++k) {
      Surface surface;
      surface.name = scene.groups.back().name + "[" + std::to_string(k) + "]";
      surface.material = material;
      if (has_back) surface.back = material;
      surface.group = static_cast<std::uint32_t>(g);
      scene.add(surface, {points[k], points[k + 1]});
    }
  }
  return scene;
}

std::optional<PreparedScene2> prepared(const Scene2& scene) {
  try {
    return prepare(scene);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

std::size_t covered_sides(const Arrangement2& arrangement) {
  std::size_t count = 0;
  for (const PieceSideId side : arrangement.sides()) count += arrangement.is_covered(side);
  return count;
}

TEST(FaceCover2, AConflictIsToldIffTheArrangementRefusesTheScene) {
  std::size_t refused = 0;
  for (unsigned seed = 1; seed <= 300; ++seed) {
    const Scene2 scene = lattice_of_boxes(seed, 2);
    const bool told = has_error(contact_findings(scene, find_contacts(scene)));
    EXPECT_EQ(told, !prepared(scene)) << seed;
    refused += told;
  }
  EXPECT_GT(refused, 30u);
  EXPECT_LT(refused, 295u);
}

TEST(FaceCover2, AFaceHasAnAreaIffItHasOneInTheMatrix) {
  std::size_t without = 0, held = 0;
  for (unsigned seed = 1; seed <= 200; ++seed) {
    const auto scene = prepared(lattice_of_boxes(seed, 1));
    ASSERT_TRUE(scene);
    const FaceCover2 cover(scene->scene, scene->arrangement);
    const ElementTable2& table = *scene->elements(Granularity::kFace);
    for (const Element& element : table.elements()) {
      const std::uint32_t face = Face{element.surface, element.is_back}.number();
      EXPECT_EQ(cover.has_area[face] != 0, element.area.value > 0) << seed << " " << element.name;
      without += cover.has_area[face] == 0;
    }
    held += std::ranges::count_if(cover.holder, [](std::uint32_t holder) { return holder != Solids2::kNone; });
  }
  EXPECT_GT(without, 100u);
  EXPECT_GT(held, 10u);
}

TEST(BehindRemedies2, ARegionIsWhatStatingItWouldFillAndNothingWhereThatIsRefused) {
  std::size_t accepted = 0, refused = 0;
  for (unsigned seed = 1; seed <= 300; ++seed) {
    const auto scene = prepared(lattice_of_boxes(seed, 2));
    if (!scene) continue;
    const Arrangement2& before = scene->arrangement;
    const FreeRegions2 free_regions(before.triangulation(), before.side_count());
    const auto regions = before.regions_behind(scene->scene, free_regions);
    for (std::uint32_t group = 0; group < regions.size(); ++group) {
      if (scene->scene.groups[group].behind != Behind::kByOutline) continue;
      Scene2 changed = scene->scene;
      changed.groups[group].behind = Behind::kSolid;
      const auto after = prepared(changed);
      std::size_t filled = 0;
      for (const std::uint32_t free_region : regions[group]) filled += free_regions.sides(free_region).size();
      EXPECT_TRUE(after || filled == 0) << seed << " " << group;
      if (after) {
        EXPECT_EQ(covered_sides(after->arrangement), covered_sides(before) + filled) << seed << " " << group;
      }
      (after && filled > 0 ? accepted : refused) += 1;
    }
  }
  EXPECT_GT(accepted, 50u);
  EXPECT_GT(refused, 50u);
}

}  // namespace
}  // namespace hottel::face_cover_test
