#include "geometry/space/prepared/element_table.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "solver/normalised_method.h"
#include "solver/space/methods/method_catalogue.h"

namespace hottel {

template std::unique_ptr<ExchangeMethod3> normalised_method(std::unique_ptr<ExchangeMethod3> raw);

// One line a method; each is a file of its own.
MethodFamily3 exact_family_3();
MethodFamily3 center_family_3();
MethodFamily3 center_vis_family_3();
MethodFamily3 disk_family_3();
MethodFamily3 vertex_quadrature_family_3();
MethodFamily3 gauss_family_3();
MethodFamily3 points_family_3();
MethodFamily3 hemicube_family_3();
MethodFamily3 rays_family_3();

MethodCatalogue3 methods_3() {
  MethodCatalogue3 methods("in space");
  methods.add(exact_family_3());
  methods.add(center_family_3());
  methods.add(center_vis_family_3());
  methods.add(disk_family_3());
  methods.add(vertex_quadrature_family_3());
  methods.add(gauss_family_3());
  methods.add(points_family_3());
  methods.add(hemicube_family_3());
  methods.add(rays_family_3());
  return methods;
}

}  // namespace hottel
