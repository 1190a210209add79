#include "geometry/space/between/known_patch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <random>
#include <vector>

#include "geometry/space/arrangement/whole_patch.h"
#include "geometry/space/between/pair_occluders.h"
#include "geometry/space/between/vertex_numbers.h"
#include "geometry/space/generate/generators.h"
#include "geometry/space/prepared/prepared_scene.h"

namespace hottel::known_patch_test {
namespace {

// Both sides of all surfaces of a room with boxes, and the sky.
std::vector<Patch3> all_patches(const Occluders3& occluders) {
  std::vector<Patch3> result;
  for (std::uint32_t s = 0; s < occluders.size(); ++s)
    for (const bool is_back : {false, true}) result.push_back(whole_patch(occluders, s, is_back));
  result.push_back(Patch3::all_of_the_sky());
  return result;
}

TEST(KnownPatch, TellsWhichCornersAreVerticesAndWhichSideIsTheFront) {
  const PreparedScene3 scene = prepare(generate_3({"room-turned", 2, 1, true}));
  const Occluders3& occluders = scene.occluders();
  for (std::uint32_t s = 0; s < occluders.size(); ++s)
    for (const bool is_back : {false, true}) {
      Patch3 patch = whole_patch(occluders, s, is_back);
      const KnownPatch3 whole(occluders, patch);
      EXPECT_EQ(whole.turn, is_back ? -1 : 1);
      for (std::size_t k = 0; k < patch.corners.size(); ++k)
        EXPECT_EQ(occluders.vertices().exact(whole.vertices[k]), patch.corners[k]);
      // Cut from the first corner to the middle of a side: one corner is no vertex.
      for (IntegerVector& corner : patch.corners) corner = multiple(2, corner);
      patch.weight = 2;
      patch.corners[2] = {(patch.corners[1].x + patch.corners[2].x) / 2, (patch.corners[1].y + patch.corners[2].y) / 2,
                          (patch.corners[1].z + patch.corners[2].z) / 2};
      patch.corners.resize(3);
      const KnownPatch3 part(occluders, patch);
      EXPECT_FALSE(part.vertices[0].is_none());
      EXPECT_EQ(part.vertices[1], whole.vertices[1]);
      EXPECT_TRUE(part.vertices[2].is_none());
      EXPECT_EQ(part.normal, whole.normal);
      EXPECT_EQ(part.turn, whole.turn);
    }
}

// (1) Kept for many pairs, in any order, as made for one.
TEST(KnownPatch, GivesTheSameBitsHoweverOftenItServes) {
  for (const char* kind : {"room-boxes", "room-touching", "town"}) {
    const PreparedScene3 scene = prepare(generate_3({kind, 3, 1, true}));
    const std::vector<Patch3> patches = all_patches(scene.occluders());
    std::vector<PairPatch3> known;
    for (const Patch3& patch : patches) known.emplace_back(scene.measurer(), patch);
    const PairRequest3 request{.tolerance = 1e-6, .effort = Effort3::kUsual};
    for (std::size_t i = 0; i + 1 < patches.size(); i += 5) {
      PairRow3 row(scene.measurer(), patches[i]);
      for (std::size_t j = patches.size(); j-- > i + 1;) {
        const PairResult3 kept = row.measure(known[j], request);
        const PairResult3 alone = scene.measurer().measure(patches[i], patches[j], request);
        ASSERT_EQ(kept.measure, alone.measure) << kind << ' ' << i << ' ' << j;
        ASSERT_EQ(kept.error, alone.error);
        ASSERT_EQ(kept.bounds, alone.bounds);
        ASSERT_EQ(kept.sight, alone.sight);
      }
    }
  }
}

// What is not looked at, as nothing is in the box around both patches, or in front of both, would not stand between.
TEST(KnownPatch, ClearPairsHaveNothingBetweenThemThatIsInFrontOfBoth) {
  const PreparedScene3 scene = prepare(generate_3({"room-boxes", 4, 1, false}));
  const Occluders3& occluders = scene.occluders();
  const SurfaceBoxes3 boxes(occluders);
  std::size_t clear = 0;
  const std::vector<Patch3> patches = all_patches(occluders);
  for (std::size_t i = 0; i + 1 < patches.size(); ++i)
    for (std::size_t j = i + 1; j + 1 < patches.size(); ++j) {
      const PairOccluders3 setting(occluders, boxes, patches[i], patches[j]);
      if (setting.sight != PairVisibility3::kClear) continue;
      ++clear;
      // Every surface in the box around both, by all planes of the hull.
      PairGeometry3 bodies(occluders, patches[i], patches[j]);
      Box3 box = bodies.known(0).box;
      box.include(bodies.known(1).box);
      for (std::uint32_t s = 0; s < occluders.size(); ++s) {
        if (s == patches[i].surface || s == patches[j].surface || !box.meets(boxes.of(s))) continue;
        if (!bodies.add_between(occluders, s)) continue;
        const std::vector<std::uint32_t>& corners = bodies.bodies.back().corners;
        const auto is_beside = [&](std::uint32_t p, std::uint32_t q, std::uint32_t r) {
          int inside = 0;
          for (const std::uint32_t patch : {0U, 1U})
            for (const std::uint32_t corner : bodies.bodies[patch].corners) {
              const int sign = bodies.orientation(p, q, r, corner);
              if (sign * inside < 0) return false;
              if (sign != 0) inside = sign;
            }
          return inside != 0 && std::ranges::none_of(corners, [&](std::uint32_t corner) {
                   return bodies.orientation(p, q, r, corner) * inside > 0;
                 });
        };
        bool is_told_off = false;
        for (const std::uint32_t patch : {0U, 1U}) {
          const auto &own = bodies.bodies[patch].corners, &others = bodies.bodies[1 - patch].corners;
          for (std::size_t k = 0; k < own.size(); ++k)
            for (const std::uint32_t other : others)
              is_told_off = is_told_off || is_beside(own[k], own[(k + 1) % own.size()], other);
        }
        EXPECT_TRUE(is_told_off) << i << ' ' << j << ' ' << s;
        bodies.drop_last();
      }
    }
  EXPECT_GT(clear, 20u);
}

TEST(VertexNumbers, AreThoseOfAMap) {
  std::mt19937_64 engine(1);
  for (int round = 0; round < 50; ++round) {
    VertexNumbers3 numbers;
    std::map<std::int32_t, std::uint32_t> known;
    const std::uint64_t most = 1 + engine() % 2000;
    for (std::uint32_t k = 0; k < 300; ++k) {
      const auto vertex = static_cast<std::int32_t>(engine() % most);
      const bool is_new = known.emplace(vertex, k).second;
      const auto [number, was_new] = numbers.try_number(VertexId3(vertex), k);
      ASSERT_EQ(number, known[vertex]);
      ASSERT_EQ(was_new, is_new);
    }
  }
}

}  // namespace
}  // namespace hottel::known_patch_test
