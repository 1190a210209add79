#include "geometry/plane/prepared/element_table.h"
#include "geometry/plane/prepared/prepared_scene.h"
#include "solver/normalised_method.h"
#include "solver/plane/methods/method_catalogue.h"

namespace hottel {

template std::unique_ptr<ExchangeMethod2> normalised_method(std::unique_ptr<ExchangeMethod2> raw);

// One line a method; each is a file of its own.
MethodFamily2 exact_family_2();
MethodFamily2 center_family_2();
MethodFamily2 center_vis_family_2();
MethodFamily2 vertex_quadrature_family_2();
MethodFamily2 strings_family_2();
MethodFamily2 gauss_family_2();
MethodFamily2 hemicube_family_2();
MethodFamily2 rays_family_2();
MethodFamily2 arithmetic_family_2();

MethodCatalogue2 methods_2() {
  MethodCatalogue2 methods("in the plane");
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
