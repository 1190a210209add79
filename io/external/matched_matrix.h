// A matrix that was computed elsewhere, laid out as the elements of a scene.
#pragma once

#include <vector>

#include "geometry/exchange_matrix.h"
#include "io/external/external_file.h"
#include "solver/compare/method_report.h"

namespace hottel {

// Lays an external matrix out as the elements of a scene; a matrix of guarantee kEstimated.
//
// With names, each is looked for among the elements; the order does not matter, and "sky" is the sky. All elements with
// a material must be there (a list of pairs may leave out faces). Without names the sizes tell, with n elements of
// which m have a material, the first of these that fits:
//
//   rows     n+1 | n | m+1 | m   all elements and the sky | all | those with a material and the sky | those alone
//   columns  n+1 | n | m+1 | m   the same
//
// but no fewer columns than rows. Of a square size that has several meanings the one in which A F is
// the most symmetric is taken, and a note says so. Rows of the sky and of faces without a material are not used. Rows
// and columns that the file does not have stay empty (WrittenFactors::has_row, has_column); nothing is completed,
// rescaled or symmetrised. Notes say so.
//
//   (1) a list of pairs has the rows of the faces that it names as `from`, and the columns of all faces with a
//       material; those of black faces and of the sky where it names them as `to`
//   (2) other files have all rows
//
// Throws InputError for names that the scene does not have or the file lacks, and sizes that do not fit.
ExchangeMatrix match_external_matrix(const ExternalMatrix& external, std::vector<Element> elements,
                                     MethodReport& report);

}  // namespace hottel
