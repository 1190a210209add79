#include "solver/check/dark_suns.h"

#include "geometry/name.h"
#include "kernel/support/failure.h"

namespace hottel {

std::string dark_sun_text(const Light& light, const LightShares& shares, const ExchangeMatrix& matrix) {
  HOTTEL_REQUIRE(shares.of_element.size() == matrix.size());
  if (!light.is_sun() || light.power.is_zero()) return "";
  for (std::uint32_t i = 0; i < matrix.size(); ++i)
    if (matrix.has_row(i) && shares.of_element[i].upper > 0) return "";
  return "light " + quoted_name(light.name) + " is a sun that shines on no face with a material";
}

}  // namespace hottel
