// What dividing faces gives, by methods: as a file, as JSON and as text for people.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "solver/compare/method_result.h"

namespace hottel {

// What a method came to where each surface was divided into so many elements (in space into their square).
struct DividedResult {
  std::uint32_t divide = 1;
  MethodResult result;
  // The largest change of the mean radiosity of a face since the division before, over the largest mean; and the order
  // of this change and the one before (order_of_changes). Nothing for the first one, and the first two.
  std::optional<double> change{}, order{};
};

// The mean radiosity of a face by the divisions of a method, and how it converges.
struct DividedMean {
  std::string method, face, channel;
  std::vector<std::uint32_t> divisions{};  // at which it has one, ascending
  std::vector<double> means{};
  double resolution = 0;  // what they are known to
};

// `divide,elements,method,guarantee,seconds,max_error,rms_error,closure,max_radiosity_error,face_radiosity_error,
// face_radiosity_change,order`: one line a result, in their order. Errors of factors and radiosities are against the
// exact ones of the same elements, those of faces against the finest division: of `exact` that of dividing, of others
// that of both. Empty for what there is none of, as of the finest.
std::string divide_csv(std::span<const DividedResult> results);

// `method,face,channel,divide,mean,order,extrapolated,convergence`: one line for each mean and division, with what the
// divisions up to this one tell (division_orders).
std::string divide_faces_csv(std::span<const DividedMean> means);

// The same as one JSON object and a final newline.
std::string divided_json(const std::string& scene, std::span<const DividedResult> results,
                         std::span<const DividedMean> means);

// The same as an aligned table, then the means of the faces by the exact factors: up to six that are furthest from what
// they are extrapolated to, and which orders are irregular.
std::string divided_text(std::span<const DividedResult> results, std::span<const DividedMean> means);

}  // namespace hottel
