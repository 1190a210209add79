#include "geometry/plane/check/wording.h"

#include "geometry/name.h"
#include "kernel/decimal.h"

namespace hottel {
namespace {

constexpr std::size_t kShortFraction = 11;  // characters of p/q
constexpr std::size_t kMostNames = 4;

}  // namespace

std::string short_text(const Rational& value) {
  std::string decimal = decimal_text(value);
  if (const auto read = parse_rational(decimal); read && *read == value) return decimal;
  std::string fraction = to_string(value);
  return fraction.size() <= kShortFraction ? fraction : decimal;
}

std::string place_text(const Point2& point) { return "(" + short_text(point.x) + ", " + short_text(point.y) + ")"; }

std::string length_text(const Rational& squared) {
  RootSum length;
  length.add(1, squared);
  return decimal_text(length);
}

std::string names_text(const Scene2& scene, const std::vector<std::uint32_t>& surfaces) {
  const std::size_t named = surfaces.size() <= kMostNames ? surfaces.size() : kMostNames - 1;
  std::string text;
  for (std::size_t k = 0; k < named; ++k) {
    if (k > 0) text += k + 1 == surfaces.size() ? " and " : ", ";
    text += quoted_name(scene.surfaces[surfaces[k]].name);
  }
  if (named < surfaces.size()) text += " and " + std::to_string(surfaces.size() - named) + " more";
  return text;
}

std::string solid_text(const Scene2& scene, std::uint32_t group) {
  return "the solid " + quoted_name(scene.groups[group].name);
}

}  // namespace hottel
