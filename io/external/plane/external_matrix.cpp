#include "io/external/plane/external_matrix.h"

#include "geometry/plane/prepared/element_table.h"
#include "geometry/plane/prepared/prepared_scene.h"
#include "io/external/external_method.h"

namespace hottel {

MethodCatalogue2 all_methods_2() {
  MethodCatalogue2 methods = methods_2();
  add_external_methods<ElementMethod2>(methods);
  return methods;
}

}  // namespace hottel
