// The methods that the program knows, for the commands that compute by any of them.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "geometry/plane/exchange/exchange.h"
#include "solver/plane/methods/method_catalogue.h"

namespace hottel {

// Those of the library, and file: and run:.
MethodCatalogue2 program_methods();

// The method of this name. Throws UnknownName with near names when there is none, UsageError when its variant makes no
// sense.
std::unique_ptr<ExchangeMethod2> make_method(const MethodCatalogue2& methods, const std::string& name);

// The families for --help, a line each.
std::string methods_text(const MethodCatalogue2& methods);

// The names in lists "A,B,...". What follows `run:` or `file:` after a comma and begins no method belongs to the
// command or the path. Throws UsageError for an empty name.
std::vector<std::string> method_names(const std::vector<std::string>& lists, const MethodCatalogue2& methods);

// What a method made of a scene, for a report.
struct ComputedFactors {
  ExchangeMatrix matrix;
  ExchangeReport counts;  // of the scene and the matrix; no tiers, no gaps
  MethodReport report;    // the notes begin with one sentence about the method
};

// Whether a method computes rows as they are asked for (a file has them as it has them), or by elements, however they
// are put together afterwards.
bool has_rows_of_its_own(const std::string& method);

// View factors by a method that is not `exact`, by elements of `prepared`, or put together per face or group.
// Throws RequestError naming the method when it cannot be run.
ComputedFactors factors_by(const ExchangeMethod2& method, const PreparedScene2& prepared, Granularity granularity);

}  // namespace hottel
