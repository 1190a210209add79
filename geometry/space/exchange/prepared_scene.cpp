#include "geometry/space/exchange/prepared_scene.h"

#include <utility>

#include "kernel/support/parallel.h"
#include "kernel/support/stopwatch.h"

namespace hottel {

PreparedScene3 prepare(Scene3 scene) {
  const DefaultFloatingPoint arithmetic;
  Stopwatch watch;
  auto ready = std::make_shared<const PreparedScene3::Ready>(scene);
  return {std::move(scene), std::move(ready), watch.lap()};
}

}  // namespace hottel
