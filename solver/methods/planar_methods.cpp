#include "solver/methods/method_catalogue_2.h"

namespace hottel {

// One line a method; each is a file of its own.
MethodFamily exact_family_2();

MethodCatalogue2 planar_methods() {
  MethodCatalogue2 methods;
  methods.add(exact_family_2());
  return methods;
}

}  // namespace hottel
