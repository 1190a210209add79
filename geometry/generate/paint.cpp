#include "geometry/generate/paint.h"

#include <utility>

namespace hottel {
namespace {

Spectrum rgb(const Rational& r, const Rational& g, const Rational& b) { return {{r, g, b}, false}; }

}  // namespace

std::vector<Material> paints() {
  const auto hundredths = [](int v) {
    Rational value(v, 100);
    value.canonicalize();
    return value;
  };
  const Spectrum none;
  return {{"white", Spectrum::scalar(hundredths(70)), none},
          {"red", rgb(hundredths(70), hundredths(20), hundredths(15)), none},
          {"blue", rgb(hundredths(20), hundredths(30), hundredths(70)), none},
          {"grey", Spectrum::scalar(hundredths(50)), none},
          {"lamp", Spectrum::scalar(hundredths(10)), rgb(9, 8, 6)},
          {"glow", Spectrum::scalar(hundredths(50)), Spectrum::scalar(hundredths(25))},
          {"wood", rgb(hundredths(55), hundredths(35), hundredths(20)), none}};
}

void drop_unused_materials(SceneTable& table) {
  std::vector<char> used(table.materials.size(), 0);
  for (const Surface& s : table.surfaces) used[s.material] = used[s.back.value_or(s.material)] = 1;
  std::vector<std::uint32_t> place(used.size(), 0);
  std::vector<Material> kept;
  for (std::size_t m = 0; m < used.size(); ++m) {
    place[m] = static_cast<std::uint32_t>(kept.size());
    if (used[m]) kept.push_back(std::move(table.materials[m]));
  }
  table.materials = std::move(kept);
  for (Surface& s : table.surfaces) {
    s.material = place[s.material];
    if (s.back) s.back = place[*s.back];
  }
}

}  // namespace hottel
