#include "solver/plane/methods/method_catalogue.h"

namespace hottel {

// One line a method; each is a file of its own.
MethodFamily exact_family_2();
MethodFamily center_family_2();
MethodFamily center_vis_family_2();
MethodFamily vertex_quadrature_family_2();
MethodFamily strings_family_2();
MethodFamily gauss_family_2();
MethodFamily hemicube_family_2();
MethodFamily rays_family_2();
MethodFamily arithmetic_family_2();

MethodCatalogue2 planar_methods() {
  MethodCatalogue2 methods;
  methods.add(exact_family_2());
  methods.add(center_family_2());
  methods.add(center_vis_family_2());
  methods.add(vertex_quadrature_family_2());
  methods.add(strings_family_2());
  methods.add(gauss_family_2());
  methods.add(hemicube_family_2());
  methods.add(rays_family_2());
  methods.add(arithmetic_family_2());
  return methods;
}

}  // namespace hottel
