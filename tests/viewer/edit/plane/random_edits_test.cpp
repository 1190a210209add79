// Long rows of edits: whatever is done, what is saved is what is seen.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

#include "geometry/name.h"
#include "geometry/plane/generate/generators.h"
#include "kernel/support/failure.h"
#include "tests/viewer/edit/plane/edited_scenes.h"
#include "viewer/edit/edit_history.h"
#include "viewer/edit/plane/file_order.h"
#include "viewer/edit/plane/scene_edits.h"
#include "viewer/edit/plane/snapping.h"

namespace hottel::random_edits_test {
namespace {

// Edits a scene at random.
class RandomHand {
 public:
  RandomHand(const Scene2& scene, std::uint64_t seed) : scene_(scene), random_(seed) {}

  Scene2 edit() {
    if (scene_.surfaces.empty()) return add_edge(scene_, {point(), point()}, 0).scene;
    switch (below(13)) {
      case 0:
      case 1: {
        const Edge2& edge = scene_.edges[surface()];
        const std::vector<PointMove2> moves{{edge.from, point()}, {scene_.edges[surface()].to, point()}};
        return move_points(scene_, moves);
      }
      case 2:
        return move_end(scene_, surface(), below(2) == 0, snapped_point());
      case 3:
        return move_surfaces(scene_, surfaces(), number(), number());
      case 4:
        return rotate_surfaces(scene_, surfaces(), point(), number() * 10, static_cast<int>(below(5)));
      case 5:
        return rotate_surfaces(scene_, surfaces(), point(), Rational(90 * static_cast<long>(below(9))), 0);
      case 6:
        return reverse_surfaces(scene_, surfaces());
      case 7:
        return duplicate_surfaces(scene_, surfaces(), number(), number()).scene;
      case 8:
        return scene_.surfaces.size() < 5 ? scene_ : erase_surfaces(scene_, surfaces());
      case 9:
        return add_lamp(scene_, point(), abs(number()) + 1).scene;
      case 10: {
        const std::vector<Point2> points{point(), point(), snapped_point()};
        return add_polyline(scene_, points, below(2) == 0, material()).scene;
      }
      case 11:
        return set_material(scene_, material(), {"", Spectrum::scalar(Rational(1) / (1 + below(9))), {}});
      default: {
        const auto copy = copy_material(scene_, {surface(), below(3) == 0});
        return copy ? copy->scene : add_edge(scene_, {point(), point()}, material()).scene;
      }
    }
  }

 private:
  std::size_t below(std::size_t n) { return random_() % n; }
  std::uint32_t surface() { return static_cast<std::uint32_t>(below(scene_.surfaces.size())); }
  std::uint32_t material() { return static_cast<std::uint32_t>(below(scene_.materials.size())); }
  Rational number() { return (Rational(static_cast<long>(below(2000))) - 1000) / (below(2) ? 100 : 7); }
  Point2 point() { return {number(), number()}; }

  Point2 snapped_point() {
    SnapRequest2 request;
    request.reach = 3;
    const Point2 near = point();
    return snapped(scene_, {to_double(near.x), to_double(near.y)}, request).at;
  }

  // Some surfaces, or a whole group, or both.
  std::vector<std::uint32_t> surfaces() {
    std::vector<std::uint32_t> chosen;
    if (below(2)) chosen.push_back(surface());
    if (const std::uint32_t group = scene_.surfaces[surface()].group; chosen.empty() || below(2))
      for (std::uint32_t s = 0; s < scene_.surfaces.size(); ++s)
        if (scene_.surfaces[s].group == group) chosen.push_back(s);
    return chosen;
  }

  const Scene2& scene_;
  std::mt19937_64 random_;
};

bool is_valid(const Scene2& scene) {
  try {
    validate(scene);
    return true;
  } catch (const InputError&) {
    return false;
  }
}

void expect_good_names(const Scene2& scene) {
  std::set<std::string> names;
  for (const Surface& surface : scene.surfaces) {
    ASSERT_TRUE(names.insert(surface.name).second) << surface.name;
    ASSERT_EQ(name_problem(surface.name), "");
  }
  std::set<std::string> groups;
  for (const Group& group : scene.groups) ASSERT_TRUE(groups.insert(group.name).second) << group.name;
  std::set<std::string> materials;
  for (const Material& material : scene.materials) ASSERT_TRUE(materials.insert(material.name).second);
}

// A row of edits, and all the way back. Returns how many were made.
std::size_t edit_and_undo(const Scene2& start, std::size_t edits, std::uint64_t seed) {
  EditHistory<Scene2> history(start);
  std::size_t made = 0;
  for (std::size_t k = 0; k < edits; ++k) {
    const Scene2& before = *history.scene();
    Scene2 edited = RandomHand(before, seed * 100'000 + k).edit();
    EXPECT_EQ(difference(as_read(edited), edited), "") << seed << ", " << k;
    expect_good_names(edited);
    if (!is_valid(edited) || edited.surfaces.size() > 700) continue;
    const Scene2 read = saved_and_read(edited);
    EXPECT_EQ(difference(read, edited), "") << seed << ", " << k;
    if (testing::Test::HasFailure()) return made;
    history.set(std::move(edited), "edit");
    ++made;
  }
  while (history.undo()) {
  }
  if (made <= EditHistory<Scene2>::kMostSteps) {
    EXPECT_FALSE(history.is_changed());
    EXPECT_EQ(difference(*history.scene(), start), "");
  }
  return made;
}

TEST(RandomEdits2, AreSavedAsTheyAreSeenOnShowcaseScenes) {
  std::size_t made = 0;
  for (const char* name : {"apartment", "maze", "museum"})
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      made += edit_and_undo(read_scene_2(showcase(name)), 150, seed);
      if (HasFailure()) return;
    }
  EXPECT_GT(made, 1000u);
}

TEST(RandomEdits2, AreSavedAsTheyAreSeenOnGeneratedScenes) {
  std::size_t made = 0;
  std::uint64_t seed = 100;
  for (const GeneratorKind2& kind : generator_kinds_2()) {
    GeneratorRequest2 request;
    request.kind = kind.name;
    request.n = std::max<std::uint64_t>(40, kind.min_edges);
    request.seed = ++seed;
    made += edit_and_undo(generate_2(request), 200, seed);
    if (HasFailure()) return;
  }
  EXPECT_GT(made, 1000u);
}

TEST(RandomEdits2, AreSavedAsTheyAreSeenInASmallRoom) {
  std::size_t made = 0;
  for (std::uint64_t seed = 200; seed < 220; ++seed) {
    made += edit_and_undo(small_room(), 200, seed);
    if (HasFailure()) return;
  }
  EXPECT_GT(made, 3000u);
}

TEST(RandomEdits2, AreSavedAsTheyAreSeenOfPatches) {
  std::size_t made = 0;
  for (std::uint64_t seed = 300; seed < 320; ++seed) {
    made += edit_and_undo(patched_room(), 200, seed);
    if (HasFailure()) return;
  }
  EXPECT_GT(made, 2000u);
}

}  // namespace
}  // namespace hottel::random_edits_test
