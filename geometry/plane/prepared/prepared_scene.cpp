#include "geometry/plane/prepared/prepared_scene.h"

#include "geometry/plane/prepared/element_table.h"
#include "kernel/support/parallel.h"
#include "kernel/support/stopwatch.h"

namespace hottel {

PreparedScene2::PreparedScene2(Scene2 s, Division2 d, std::shared_ptr<const Arrangement2> a, double took)
    : scene(std::move(s)),
      division(std::move(d)),
      shared(std::move(a)),
      arrangement(*shared),
      seconds(took),
      tables_(std::make_shared<ElementTables<ElementTable2>>()) {}

std::shared_ptr<const ElementTable2> PreparedScene2::elements(Granularity granularity) const {
  return tables_->of(granularity, [&] { return ElementTable2(scene, arrangement, division, granularity); });
}

PreparedScene2 prepare(Scene2 scene, Divided2 divided) {
  const DefaultFloatingPoint arithmetic;
  Stopwatch watch;
  const Division2 nowhere(scene.surfaces.size());
  auto arrangement = std::make_shared<const Arrangement2>(scene, nowhere);
  PreparedScene2 undivided(std::move(scene), nowhere, std::move(arrangement), watch.lap());
  if (divided == Divided2::kNo) return undivided;
  return prepare_divided(undivided, undivided.scene);
}

PreparedScene2 prepare_divided(const PreparedScene2& undivided, Scene2 scene) {
  const DefaultFloatingPoint arithmetic;
  Stopwatch watch;
  Division2 division = division_of(scene);
  auto arrangement = is_cut(division)
                         ? std::make_shared<const Arrangement2>(undivided.arrangement.cut_into(scene, division))
                         : undivided.shared;
  return {std::move(scene), std::move(division), std::move(arrangement), undivided.seconds + watch.lap()};
}

}  // namespace hottel
