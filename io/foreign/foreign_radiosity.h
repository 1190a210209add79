// Radiosities that another program computed.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "geometry/exchange_matrix.h"
#include "solver/compare/method_result.h"
#include "solver/compare/written_factors.h"
#include "solver/radiosity/radiosity.h"

namespace hottel {

struct ForeignRadiosities {
  std::vector<std::vector<double>> by_channel;  // then by element of the matrix; 0 for those without a row
  WrittenDigits digits;
};

// Reads a csv with a head: columns `face` and `radiosity`; `element` where faces are divided, `channel` (r, g, b) where
// there are several. Other columns are left alone, so that a radiosity.csv of hottel is read as it is.
//
// Throws InputError for faces and channels that are unknown, missing or given twice, and for what is no finite number.
ForeignRadiosities read_foreign_radiosities(const std::filesystem::path& file, const ExchangeMatrix& matrix,
                                            const std::vector<std::string>& channels);

// True iff the file is a csv with a column `radiosity`.
bool holds_radiosities(const std::filesystem::path& file);

// Reads such a file and holds it against the exact radiosities: max_radiosity_error, and the verdict in words as notes.
// There are no factors and no time, so that all else is NaN. beyond: as in judge_radiosities.
MethodResult judge_radiosity_file(const std::string& file, const ExchangeMatrix& factors,
                                  const RadiositySolution& exact, double beyond);

}  // namespace hottel
