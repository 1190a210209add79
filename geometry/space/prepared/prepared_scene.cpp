#include "geometry/space/prepared/prepared_scene.h"

#include <utility>

#include "geometry/space/prepared/element_table.h"
#include "kernel/support/parallel.h"
#include "kernel/support/stopwatch.h"

namespace hottel {

PreparedScene3::PreparedScene3(Scene3 its_scene, std::shared_ptr<const Ready> of_it, double took)
    : scene(std::move(its_scene)),
      ready(std::move(of_it)),
      seconds(took),
      tables_(std::make_shared<ElementTables<ElementTable3>>()) {}

std::shared_ptr<const ElementTable3> PreparedScene3::elements(Granularity granularity) const {
  return tables_->of(granularity, [&] { return ElementTable3(scene, arrangement(), occluders(), granularity); });
}

PreparedScene3 prepare(Scene3 scene) {
  const DefaultFloatingPoint arithmetic;
  Stopwatch watch;
  auto ready = std::make_shared<const PreparedScene3::Ready>(scene);
  return {std::move(scene), std::move(ready), watch.lap()};
}

}  // namespace hottel
