#include "geometry/space/exchange/face_sight.h"

#include <algorithm>
#include <cstdint>
#include <span>

#include "geometry/name.h"
#include "geometry/scene_names.h"
#include "geometry/space/exchange/facing.h"
#include "geometry/space/pairs/pair_integrator.h"
#include "geometry/space/prepared/element_table.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "kernel/support/failure.h"
#include "kernel/support/interrupt.h"
#include "kernel/support/parallel.h"
#include "kernel/support/progress_count.h"

namespace hottel {
namespace {

class FaceSights {
 public:
  FaceSights(const PreparedScene3& prepared, const Face& face)
      : prepared_(prepared), table_(*prepared.elements(Granularity::kFace)), face_(face) {}

  std::uint32_t sky() const { return table_.sky(); }

  SeenFace3 toward(std::uint32_t label) const {
    SeenFace3 sight{label == sky() ? std::nullopt : std::optional(Face::of(label)), false, true};
    for (const ElementTable3::Contact& contact : table_.contacts())
      sight.is_seen |= std::minmax(contact.mask, contact.base) == std::minmax(face_.number(), label);
    const bool are_free = label != sky() && table_.is_partly_covered(label) && table_.is_partly_covered(face_.number());
    for (const ElementTable3::Part& i : parts(face_.number(), are_free))
      for (const ElementTable3::Part& j : parts(label, are_free)) add(i, j, sight);
    return sight;
  }

 private:
  std::span<const ElementTable3::Part> parts(std::uint32_t label, bool are_free) const {
    return are_free ? table_.free_parts(label) : table_.parts(label);
  }

  void add(const ElementTable3::Part& i, const ElementTable3::Part& j, SeenFace3& sight) const {
    if (!j.patch.is_sky() && i.patch.surface == j.patch.surface) return;
    const PairResult3 found = prepared_.measurer().measure(i.patch, j.patch, {.tolerance = kCoarseTolerance});
    if (found.is_undecided)
      throw RequestError("whether " + quoted_name(face_name(prepared_.scene, face_)) + " sees " +
                         (j.patch.is_sky() ? "the sky" : quoted_name(table_.elements()[j.label].name)) +
                         " could not be decided: " + found.problem);
    const bool is_seen = found.sight != PairVisibility3::kHidden && found.bounds.upper > 0;
    sight.is_seen |= is_seen;
    sight.is_whole &= is_seen ? found.is_whole : !is_facing(i, j);
  }

  bool is_facing(const ElementTable3::Part& i, const ElementTable3::Part& j) const {
    return j.patch.is_sky() || face_each_other(prepared_.occluders(), i, j);
  }

  const PreparedScene3& prepared_;
  const ElementTable3& table_;
  const Face face_;
};

}  // namespace

void require_free(const PreparedScene3& prepared, const Face& face) {
  const ElementTable3& table = *prepared.elements(Granularity::kFace);
  if (table.parts(face.number()).empty() && !table.has_contact(face.number()))
    throw RequestError(quoted_name(face_name(prepared.scene, face)) +
                       " has no area: it lies in solids, or others have all of its place");
}

SeenFace3 sight_between(const PreparedScene3& prepared, const Face& from, const std::optional<Face>& to) {
  const DefaultFloatingPoint arithmetic;
  const FaceSights sights(prepared, from);
  return sights.toward(to ? to->number() : sights.sky());
}

std::vector<SeenFace3> faces_seen_by(const PreparedScene3& prepared, const Face& face,
                                     const std::function<void(double)>& progress) {
  const FaceSights sights(prepared, face);
  std::vector<SeenFace3> found(sights.sky() + 1);
  ProgressCount count(progress, found.size());
  parallel_for(
      found.size(),
      [&](std::size_t label) {
        throw_if_interrupted();
        found[label] = sights.toward(static_cast<std::uint32_t>(label));
        count.add(1);
      },
      1);
  std::erase_if(found, [](const SeenFace3& sight) { return !sight.is_seen; });
  return found;
}

}  // namespace hottel
