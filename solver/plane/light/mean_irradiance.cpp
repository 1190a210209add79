#include "solver/plane/light/mean_irradiance.h"

namespace hottel {

void mean_irradiance(const Vertices2& vertices, const LightColumns2& columns, const SentOut2& sent_out, const Eye2& eye,
                     const Location2& location, const View2& view, std::span<double> result) {
  LightRowFinder2 finder;
  finder.begin(vertices, columns, Blacks2::kLeftOut);
  finder.add(eye, location, view);
  finder.measure();
  sent_out.light(finder.row(0), result);
}

}  // namespace hottel
