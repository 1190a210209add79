// What dividing faces gives, by methods: as a file, as JSON and as text for people.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "solver/compare/method_result.h"

namespace hottel {

// What a method came to where each surface was divided into so many elements (in space into their square).
struct DividedResult {
  std::uint32_t divide = 1;
  MethodResult result;
};

// `divide,elements,method,guarantee,seconds,max_error,rms_error,closure,max_radiosity_error,face_radiosity_error`: one
// line a result, in their order. Errors of factors and radiosities are against the exact ones of the same elements,
// those of faces against the finest division: of `exact` that of dividing, of others that of both. Empty for what there
// is none of, as of the finest.
std::string divide_csv(std::span<const DividedResult> results);

// The same as one JSON object and a final newline.
std::string divided_json(const std::string& scene, std::span<const DividedResult> results);

// The same as an aligned table, with the order of convergence of each step: log of the ratio of two errors of faces
// over that of the divisions.
std::string divided_text(std::span<const DividedResult> results);

}  // namespace hottel
