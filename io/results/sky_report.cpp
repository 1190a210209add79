#include "io/results/sky_report.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "geometry/name.h"
#include "kernel/support/counted.h"

namespace hottel {

std::string sky_text(const SkyByClosure& sky) {
  std::string text = "the sky by closure: " + counted(sky.told, "row") + " told by " +
                     (sky.told == 1 ? "its" : "their") + " other pairs";
  if (sky.told > 0)
    text += fmt::format(", off by {:.1e} at most as these state, by {:.1e} as they may be", sky.max_error, sky.within);
  text += fmt::format("; {} integrated to compare, {} as too little is left to tell", sky.checked, sky.integrated);
  if (sky.checked > 0)
    text += sky.max_difference == 0 ? "; no difference"
                                    : fmt::format("; the largest difference is {:.1e}, of {}", sky.max_difference,
                                                  quoted_name(sky.farthest));
  if (sky.beyond > 0)
    text += fmt::format("\nwarning: {} by more than {} pairs state, by less than they may",
                        sky.beyond == 1 ? "a row differs" : counted(sky.beyond, "row") + " differ",
                        sky.beyond == 1 ? "its" : "their");
  return text;
}

std::string sky_json(const SkyByClosure& sky) {
  const nlohmann::ordered_json json = {{"by", "closure"},
                                       {"rows", sky.told},
                                       {"integrated", sky.integrated},
                                       {"max_error", sky.max_error},
                                       {"within", sky.within},
                                       {"checked", sky.checked},
                                       {"max_difference", sky.max_difference},
                                       {"farthest", sky.farthest},
                                       {"beyond_stated", sky.beyond}};
  return json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace hottel
