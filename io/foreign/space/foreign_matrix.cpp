#include "io/foreign/space/foreign_matrix.h"

#include "geometry/space/prepared/element_table.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "io/foreign/foreign_method.h"

namespace hottel {

MethodCatalogue3 all_methods_3() {
  MethodCatalogue3 methods = methods_3();
  add_foreign_methods<ElementMethod3>(methods);
  return methods;
}

}  // namespace hottel
