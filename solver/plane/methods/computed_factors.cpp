#include "solver/plane/methods/computed_factors.h"

#include <fmt/format.h>

#include "geometry/exchange_request.h"
#include "geometry/plane/prepared/prepared_scene.h"
#include "kernel/support/failure.h"
#include "solver/plane/methods/exchange_method.h"

namespace hottel {

ComputedFactors2 factors_by(const ExchangeMethod2& method, const PreparedScene2& prepared,
                            const ExchangeRequest& request) {
  ComputedFactors2 result;
  const MethodInfo& info = method.info();
  const bool is_exact = info.guarantee == Guarantee::kExact;
  try {
    result.matrix = method.compute(prepared, request, result.report);
  } catch (const RequestError& error) {
    throw RequestError(
        fmt::format("{}: {}{}", prepared.scene.file, is_exact ? "" : "the method " + info.name + ": ", error.what()));
  }
  if (!is_exact)
    result.report.notes.insert(result.report.notes.begin(), method_sentence(info, result.matrix, result.report));
  return result;
}

}  // namespace hottel
