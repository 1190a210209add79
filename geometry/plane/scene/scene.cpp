#include "geometry/plane/scene/scene.h"

#include <string_view>
#include <unordered_map>

#include "geometry/name.h"

namespace hottel {

std::optional<std::uint32_t> Scene2::find(const std::string& name) const {
  for (std::size_t i = 0; i < surfaces.size(); ++i)
    if (surfaces[i].name == name) return static_cast<std::uint32_t>(i);
  return std::nullopt;
}

void validate(const Scene2& scene) {
  std::unordered_map<std::string_view, const Surface2*> first;
  first.reserve(scene.surfaces.size());
  for (const Surface2& surface : scene.surfaces) {
    const auto refuse = [&](const std::string& text, std::vector<std::string> hints = {}) {
      throw InputError({scene.file, surface.line}, text, std::move(hints));
    };
    if (const auto problem = name_problem(surface.name); !problem.empty())
      refuse("the name " + quoted_name(surface.name) + " " + std::string(problem));
    if (const auto [other, is_new] = first.emplace(surface.name, &surface); !is_new) {
      const int line = other->second->line;
      refuse("two surfaces have the name " + quoted_name(surface.name) +
             (line > 0 ? ", the other one in line " + std::to_string(line) : ""));
    }
    if (surface.from == surface.to) refuse("surface " + quoted_name(surface.name) + " has length zero");
    if (surface.material >= scene.materials.size() || (surface.back && *surface.back >= scene.materials.size()))
      refuse("surface " + quoted_name(surface.name) + " has a material that is not defined");
    if (surface.group >= scene.groups.size())
      refuse("surface " + quoted_name(surface.name) + " has a group that is not defined");
  }
}

bool is_convex_room(const Scene2& scene) {
  const std::size_t n = scene.surfaces.size();
  if (n < 3) return false;
  // A clockwise closed chain is convex iff it never turns left and its direction goes around once: the sign of its
  // direction along x then changes twice.
  int changes = 0, last = 0, first = 0;
  bool turns = false;
  for (std::size_t k = 0; k < n; ++k) {
    const Surface2 &surface = scene.surfaces[k], &next = scene.surfaces[(k + 1) % n];
    if (surface.back || !(surface.to == next.from)) return false;
    const Rational dx = surface.to.x - surface.from.x, dy = surface.to.y - surface.from.y;
    const Rational ex = next.to.x - next.from.x, ey = next.to.y - next.from.y;
    const Rational turn = dx * ey - dy * ex;
    if (turn > 0 || (turn == 0 && dx * ex + dy * ey < 0)) return false;
    turns |= turn < 0;
    const int sign = sgn(dx);
    if (sign == 0) continue;
    if (last != 0 && sign != last) ++changes;
    if (first == 0) first = sign;
    last = sign;
  }
  if (last != first) ++changes;
  return turns && changes == 2;
}

}  // namespace hottel
