#include "geometry/plane/scene/division.h"

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

Point2 part_begin(const Edge2& edge, std::uint32_t k, std::uint32_t parts) {
  Rational t(k, parts);
  t.canonicalize();
  return point_at(edge, t);
}

std::vector<std::array<double, 4>> element_ends(const Scene2& scene, const std::vector<Element>& elements) {
  std::vector<std::array<double, 4>> ends;
  ends.reserve(elements.size());
  for (const Element& element : elements) {
    const Edge2& edge = scene.edges[element.surface];
    const Point2 from = part_begin(edge, element.part, element.parts);
    const Point2 to = part_begin(edge, element.part + 1, element.parts);
    ends.push_back({to_double(from.x), to_double(from.y), to_double(to.x), to_double(to.y)});
  }
  return ends;
}

}  // namespace hottel
