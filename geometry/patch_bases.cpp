#include "geometry/patch_bases.h"

#include <algorithm>
#include <unordered_map>

#include "geometry/name.h"
#include "geometry/near_names.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

std::vector<std::string> names_to_lie_on(const SceneTable& table) {
  std::vector<std::string> names;
  for (const Surface& surface : table.surfaces) names.push_back(surface.name);
  for (const Group& group : table.groups) names.push_back(group.name);
  return names;
}

bool is_there(const SceneTable& table, const std::string& name) {
  return table.find(name) || std::ranges::any_of(table.surfaces, [&](const Surface& surface) {
           return table.groups[surface.group].name == name;
         });
}

}  // namespace

PatchBases::PatchBases(const SceneTable& table) {
  const auto& surfaces = table.surfaces;
  if (std::ranges::none_of(surfaces, [](const Surface& surface) { return surface.on.has_value(); })) return;
  bases_ = table.bases;
  surfaces_.resize(bases_.size());
  std::unordered_map<std::string_view, std::vector<std::size_t>> called;
  for (std::size_t k = 0; k < bases_.size(); ++k) called[bases_[k].name].push_back(k);
  for (std::uint32_t s = 0; s < surfaces.size(); ++s) {
    const Surface& surface = surfaces[s];
    base_of_.push_back(surface.on ? std::int64_t{*surface.on} : -1);
    has_back_.push_back(surface.back ? 1 : 0);
    for (const std::string_view name :
         {std::string_view(surface.name), std::string_view(table.groups[surface.group].name)}) {
      const auto found = called.find(name);
      if (found == called.end() || (surface.on && bases_[*surface.on].name == name)) continue;
      for (const std::size_t k : found->second)
        if (surfaces_[k].empty() || surfaces_[k].back() != s) surfaces_[k].push_back(s);
    }
  }
}

bool PatchBases::lies_on(std::uint32_t patch, std::uint32_t surface) const {
  return is_patch(patch) && std::ranges::binary_search(under(patch), surface);
}

bool PatchBases::rests_on(std::uint32_t patch, std::uint32_t surface) const {
  if (!is_patch(patch)) return false;
  return lies_on(patch, surface) ||
         std::ranges::any_of(under(patch), [&](std::uint32_t base) { return rests_on(base, surface); });
}

std::optional<Face> PatchBases::face_under(std::uint32_t patch, std::uint32_t surface) const {
  if (!is_patch(patch)) return std::nullopt;
  if (lies_on(patch, surface)) return Face{surface, is_on_backs(patch)};
  for (const std::uint32_t base : under(patch))
    if (const auto face = face_under(base, surface)) return Face{surface, face->is_back != is_on_backs(patch)};
  return std::nullopt;
}

bool PatchBases::is_front_on(const Face& patch, const Face& base) const {
  return !patch.is_back && lies_on(patch.surface, base.surface) && is_on_backs(patch.surface) == base.is_back;
}

bool PatchBases::has_place(const Face& face, std::span<const Face> there) const {
  if (is_empty()) return true;
  if (face.is_back && is_patch(face.surface) && has_back_[face.surface] == 0) return false;
  return std::ranges::none_of(there, [&](const Face& other) {
    if (is_front_on(other, face)) return true;
    if (!other.is_back || has_back_[other.surface] == 0) return false;
    const std::optional<Face> front = face_under(other.surface, face.surface);
    return front && front->is_back != face.is_back;
  });
}

// Depth first: 1 while what a patch lies on is visited, 2 after that.
bool PatchBases::visit(std::uint32_t patch, std::vector<char>& state, std::vector<std::uint32_t>& order) const {
  if (state[patch] == 2) return true;
  if (state[patch] == 1) return false;
  state[patch] = 1;
  for (const std::uint32_t base : under(patch))
    if (is_patch(base) && !visit(base, state, order)) return false;
  state[patch] = 2;
  order.push_back(patch);
  return true;
}

std::optional<std::vector<std::uint32_t>> PatchBases::outermost_first() const {
  std::vector<char> state(base_of_.size(), 0);
  std::vector<std::uint32_t> order;
  for (std::uint32_t s = 0; s < base_of_.size(); ++s)
    if (is_patch(s) && !visit(s, state, order)) return std::nullopt;
  return order;
}

std::vector<std::uint32_t> PatchBases::resting_on(
    std::span<const std::uint32_t> surfaces,
    const std::function<std::vector<std::uint32_t>(std::uint32_t patch)>& carriers) const {
  std::vector<std::uint32_t> patches;
  const auto order = outermost_first();
  if (is_empty() || !order) return patches;
  std::vector<char> is_listed(base_of_.size(), 0);
  for (const std::uint32_t s : surfaces) is_listed[s] = 1;
  for (const std::uint32_t patch : *order)
    if (std::ranges::any_of(carriers(patch), [&](std::uint32_t s) { return is_listed[s] != 0; })) {
      is_listed[patch] = 1;
      patches.push_back(patch);
    }
  std::ranges::sort(patches);
  return patches;
}

std::vector<Face> silent_fronts(const PatchBases& patches, std::span<const Face> there,
                                const std::function<bool(std::uint32_t surface)>& is_silent) {
  std::vector<Face> silent;
  for (const Face& face : there)
    if (!face.is_back && is_silent(face.surface)) silent.push_back(face);
  for (std::size_t k = 0; k < silent.size() && !patches.is_empty(); ++k)
    for (const Face& face : there)
      if (patches.is_front_on(face, silent[k]) && std::ranges::find(silent, face) == silent.end())
        silent.push_back(face);
  return silent;
}

bool is_part_of_silent(const PatchBases& patches, std::uint32_t surface, std::span<const Face> there,
                       const std::function<bool(std::uint32_t surface)>& is_silent) {
  return patches.is_patch(surface) && std::ranges::any_of(there, [&](const Face& other) {
           return patches.rests_on(surface, other.surface) && is_silent(other.surface);
         });
}

void settle_bases(SceneTable& table) {
  std::vector<PatchBase> bases;
  for (Surface& surface : table.surfaces) {
    if (!surface.on) continue;
    const PatchBase& own = table.bases[*surface.on];
    const auto known = std::ranges::find(bases, own);
    const auto index = static_cast<std::uint32_t>(known - bases.begin());
    if (known == bases.end()) bases.push_back(own);
    surface.on = index;
  }
  table.bases = std::move(bases);
}

std::string base_text(const PatchBase& base) { return (base.is_back ? "the back of " : "") + quoted_name(base.name); }

void refuse_patch(const SceneTable& table, std::uint32_t patch, const std::string& what, const std::string& remedy) {
  const Surface& surface = table.surfaces[patch];
  throw InputError(place_of(table, surface), quoted_name(surface.name) + " " + what, {remedy});
}

void refuse_turned_patch(const SceneTable& table, std::uint32_t patch) {
  const PatchBase& on = table.bases[*table.surfaces[patch].on];
  refuse_patch(table, patch, "looks the other way than " + base_text(on) + ", on which it lies",
               "list its points in the other order, or say that it is on '" + side_text({on.name, !on.is_back}) + "'");
}

std::string patch_hint(const SceneTable& table, const Face& patch, const Face& base) {
  const Surface &own = table.surfaces[patch.surface], &under = table.surfaces[base.surface];
  const std::string& name = own.group == under.group ? under.name : table.groups[under.group].name;
  const std::string key = side_text({name, patch.is_back != base.is_back});
  return "if " + quoted_name(own.name) + " is a part of " + quoted_name(name) +
         ", as a window is of a wall, say so in it: \"on\": \"" + key + "\" (in a drawing data-on=\"" + key + "\")";
}

namespace {

// The patches of which each lies on the next one, and the last on the first: those that the first one leads to.
std::vector<std::uint32_t> ring_of(const PatchBases& bases, std::size_t surfaces) {
  for (std::uint32_t first = 0; first < surfaces; ++first) {
    if (!bases.is_patch(first)) continue;
    std::vector<std::int64_t> from(surfaces, -1);
    std::vector<std::uint32_t> open{first};
    for (std::size_t k = 0; k < open.size(); ++k)
      for (const std::uint32_t base : bases.under(open[k])) {
        if (base == first) {
          std::vector<std::uint32_t> ring;
          for (std::int64_t at = open[k]; at != first; at = from[static_cast<std::size_t>(at)])
            ring.push_back(static_cast<std::uint32_t>(at));
          ring.push_back(first);
          std::ranges::reverse(ring);
          return ring;
        }
        if (!bases.is_patch(base) || from[base] >= 0) continue;
        from[base] = open[k];
        open.push_back(base);
      }
  }
  return {};
}

[[noreturn]] void refuse_ring(const SceneTable& table, const std::vector<std::uint32_t>& ring) {
  std::string text = quoted_name(table.surfaces[ring.front()].name);
  for (std::size_t k = 1; k <= ring.size(); ++k)
    text += (k == 1 ? " lies on " : ", which lies on ") + quoted_name(table.surfaces[ring[k % ring.size()]].name);
  throw InputError(place_of(table, table.surfaces[ring.front()]), text + ": \"on\" leads back to where it began",
                   {"one of them is a surface by itself: take its \"on\" away"});
}

}  // namespace

void validate_bases(const SceneTable& table) {
  const PatchBases bases(table);
  if (bases.is_empty()) return;
  for (std::uint32_t s = 0; s < table.surfaces.size(); ++s) {
    const Surface& surface = table.surfaces[s];
    if (!surface.on) continue;
    const std::string& name = table.bases[*surface.on].name;
    const auto refuse = [&](const std::string& text, std::vector<std::string> hints = {}) {
      throw InputError(place_of(table, surface), quoted_name(surface.name) + " " + text, std::move(hints));
    };
    if (surface.is_obstruction) refuse("is an obstruction and lies on another surface: give it a material");
    if (!bases.under(s).empty()) continue;
    if (is_there(table, name)) refuse("lies on itself: \"on\" names another surface or group");
    refuse("lies on " + quoted_name(name) + ", but there is no surface or group of that name",
           near_name_hints(name, names_to_lie_on(table)));
  }
  if (!bases.outermost_first()) refuse_ring(table, ring_of(bases, table.surfaces.size()));
}

}  // namespace hottel
