// What comparing methods came to: as files, as JSON and as text for people.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/exchange_matrix.h"
#include "io/results/texel_report.h"
#include "solver/compare/explained_pair.h"
#include "solver/compare/method_result.h"
#include "solver/compare/reference_errors.h"
#include "solver/compare/work_precision.h"

namespace hottel {

// Everything that is said about one run of `compare`. What it refers to outlives it.
struct ComparisonReport {
  std::string scene;
  std::size_t surfaces = 0;
  double seconds_to_prepare = 0;
  ReferenceErrors reference{};     // how far `exact` may be off itself
  const ExchangeMatrix& exact;     // of the elements that all methods have
  std::string why_no_radiosities;  // empty where there are exact ones
  std::span<const MethodResult> results;
  std::span<const WorkReading> readings;          // times at which errors are reached
  ErrorKind errors_read = ErrorKind::kMaxFactor;  // of the readings
  std::span<const std::string> told{};   // methods whose notes the reader has seen already: the text leaves them out
  std::string grid_file{};               // light of others on a grid; empty: none
  std::span<const std::string> light{};  // what is said of it
  const JudgedTexels* texels = nullptr;  // a lightmap of others; null: none
};

// Returns the report as one JSON object and a final newline. What is not known is null; what is no UTF-8 in
// a name is replaced.
std::string comparison_json(const ComparisonReport& report);

// Returns an aligned table, a line a method, with the spread of the times. Above it stands the size of the matrix,
// below it notes, each once with the methods it is said of, and readings.
std::string comparison_text(const ComparisonReport& report);

// "812 elements, 5852 view factors": elements that have a row, and the factors in these rows.
std::string size_text(const ExchangeMatrix& matrix);

// `method,guarantee,seconds,max_error,rms_error,closure,max_radiosity_error`: one line a method. Shortest decimals that
// read back to the same double; `inf` where a matrix has no radiosities, nothing where the scene has none.
std::string compare_csv(std::span<const MethodResult> results);

// `method,from,to,value,exact,error,visibility,distance,angle,reason`: distance in scene units between the middles,
// angle in degrees between the normals; empty where there is none (the sky; faces that do not face each other).
std::string worst_csv(std::span<const ExplainedPair> pairs);

// `error,family,seconds,exact_seconds`: the least time in which each family reaches each error, empty where it does
// not; times between the points of a sweep are interpolated (seconds_to_reach).
//
//   (1) one line for each error and family, by errors, families in the order of the curves
//   (2) exact_seconds is empty where the method `exact` is not among them
std::string readings_csv(std::span<const WorkCurve> curves, std::span<const double> errors);

}  // namespace hottel
