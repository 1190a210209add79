// Radiosities that another program computed.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "geometry/exchange_matrix.h"
#include "solver/compare/method_report.h"
#include "solver/compare/method_result.h"
#include "solver/radiosity/radiosity.h"

namespace hottel {

// Radiosities of a file, laid out as the elements of a matrix, and how finely they were written.
struct ExternalRadiosities {
  std::vector<std::vector<double>> by_channel;  // then by element of the matrix; 0 for those without a row
  WrittenDigits digits;
};

// Reads a csv with a head: columns `face` and `radiosity`; `element` where faces are divided, `channel` (r, g, b) where
// there are several. Other columns are left alone, so that a radiosity.csv of hottel is read as it is.
//
//   (1) lines may come in any order; every element with a row has exactly one of each channel
//   (2) without a column `channel` the file is of the one channel there is; with one channel that column
//       is not looked at
// Throws InputError for faces and channels that are unknown, missing or given twice, for lines with more or fewer
// fields than the head, and for what is no finite number. COST: linear, the file in memory.
ExternalRadiosities read_external_radiosities(const std::filesystem::path& file, const ExchangeMatrix& matrix,
                                              const std::vector<std::string>& channels);

// True iff the file is a csv with a column `radiosity`. Throws InputError when it cannot be read. COST: reads it whole.
bool holds_radiosities(const std::filesystem::path& file);

// Reads such a file and holds it against the exact radiosities: max_radiosity_error, and the verdict in words as notes.
// There are no factors and no time, so that all else is NaN. `solution` has the radiosities of the file, and nothing
// else that is the file's. beyond: as in judge_radiosities.
MethodResult judge_radiosity_file(const std::string& file, const ExchangeMatrix& factors,
                                  const RadiositySolution& exact, double beyond);

}  // namespace hottel
