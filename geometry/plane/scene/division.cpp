#include "geometry/plane/scene/division.h"

#include <algorithm>

#include "kernel/support/failure.h"

namespace hottel {
namespace {

// The least n with n^2 >= squared.
Integer root_above(const Rational& squared) {
  Integer whole;
  mpz_cdiv_q(whole.get_mpz_t(), squared.get_num_mpz_t(), squared.get_den_mpz_t());
  Integer n = sqrt(whole);
  if (n * n < whole) ++n;
  return n;
}

Rational quotient(std::uint32_t k, std::uint32_t n) {
  Rational t(k, n);
  t.canonicalize();
  return t;
}

bool has_trees(const Scene2& scene) {
  return std::any_of(scene.surfaces.begin(), scene.surfaces.end(),
                     [](const Surface& surface) { return !surface.trees.is_empty(); });
}

}  // namespace

void divide_into(Scene2& scene, std::uint32_t n) {
  HOTTEL_REQUIRE(n > 0);
  for (Surface& surface : scene.surfaces) surface.elements = n;
}

std::optional<std::uint32_t> divide_by_length(Scene2& scene, const Rational& h, std::uint32_t most) {
  HOTTEL_REQUIRE(h > 0);
  for (std::uint32_t s = 0; s < scene.surfaces.size(); ++s) {
    Surface& surface = scene.surfaces[s];
    const auto& [from, to] = scene.edges[s];
    const Rational dx = to.x - from.x, dy = to.y - from.y;
    const Integer n = root_above((dx * dx + dy * dy) / (h * h));
    if (n > most) return s;
    surface.elements = static_cast<std::uint32_t>(n.get_ui());
  }
  return std::nullopt;
}

void divide_into(ValidScene2& scene, std::uint32_t n) {
  HOTTEL_REQUIRE(n <= kMaxElements && !has_trees(scene.scene_));
  divide_into(scene.scene_, n);
}

std::optional<std::uint32_t> divide_by_length(ValidScene2& scene, const Rational& h, std::uint32_t most) {
  HOTTEL_REQUIRE(most <= kMaxElements && !has_trees(scene.scene_));
  return divide_by_length(scene.scene_, h, most);
}

EdgeSpan2 EdgeSpan2::of(std::uint32_t parts, const TreeNode& node) {
  EdgeSpan2 span{quotient(node.part, parts), quotient(node.part + 1, parts)};
  for (int level = 0; level < node.path.depth(); ++level) {
    const Rational middle = (span.from + span.to) / 2;
    (node.path.digit(level) == 0 ? span.to : span.from) = middle;
  }
  return span;
}

EdgeSpan2 EdgeSpan2::of(const Element& element) { return EdgeSpan2::of(element.parts, element.node()); }

SurfaceCuts2::SurfaceCuts2(std::uint32_t equal_parts) {
  HOTTEL_REQUIRE(equal_parts > 0);
  for (std::uint32_t k = 1; k < equal_parts; ++k) at.push_back(quotient(k, equal_parts));
}

SurfaceCuts2::SurfaceCuts2(const Surface& surface) : SurfaceCuts2(surface.elements) {
  if (surface.trees.is_empty()) return;
  for (const bool is_back : {false, true})
    for (const TreeNode& leaf : surface.trees.of(is_back)) at.push_back(EdgeSpan2::of(surface.elements, leaf).from);
  std::ranges::sort(at);
  at.erase(std::unique(at.begin(), at.end()), at.end());
  if (!at.empty() && at.front() == 0) at.erase(at.begin());
}

Division2 division_of(const Scene2& scene) {
  Division2 division;
  for (const Surface& surface : scene.surfaces) division.emplace_back(surface);
  return division;
}

bool is_cut(const Division2& division) { return std::ranges::any_of(division, &SurfaceCuts2::is_cut); }

}  // namespace hottel
