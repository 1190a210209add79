#include "io/external/space/external_matrix.h"

#include "geometry/space/prepared/element_table.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "io/external/external_method.h"

namespace hottel {

MethodCatalogue3 all_methods_3() {
  MethodCatalogue3 methods = methods_3();
  add_external_methods<ElementMethod3>(methods);
  return methods;
}

}  // namespace hottel
