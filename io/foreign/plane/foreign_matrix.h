// View factors that were computed elsewhere, as methods like any other: from a file, or by a command.
#pragma once

#include "io/foreign/foreign_file.h"
#include "solver/plane/methods/method_catalogue.h"

namespace hottel {

// Lays a foreign matrix out as the elements of a scene; a matrix of guarantee kEstimated.
//
// With names, each is looked for among the elements; the order does not matter, and "sky" is the sky. All elements with
// a material must be there (a list of pairs may leave out faces). Without names the sizes tell, with n elements of
// which m have a material, the first of these that fits:
//
//   rows     n+1 | n | m+1 | m   all elements and the sky | all | those with a material and the sky | those alone
//   columns  n+1 | n | m+1 | m   the same
//
// but no fewer columns than rows. Rows of the sky and of faces without a material are not used. Columns that the file
// does not have stay empty (WrittenFactors::has_column); nothing is completed, rescaled or symmetrised. Notes say so.
//
// Throws InputError for names that the scene does not have or the file lacks, and sizes that do not fit.
ExchangeMatrix match_foreign_matrix(const ForeignMatrix& foreign, std::vector<Element> elements, MethodReport& report);

// `file:PATH`: a file as in read_foreign_matrix. compute() reads it anew each time; MethodReport::seconds is nothing.
MethodFamily2 file_family_2();

// `run:CMD`: a command as in run_foreign_command, with PreparedScene2::scene.file as the scene; its time is
// MethodReport::seconds. What it wrote and cannot be read is a RequestError that names the command.
MethodFamily2 run_family_2();

// Returns true for a name of these two families: their rows are as others made them, whatever elements are asked for.
bool is_foreign(const std::string& method);

}  // namespace hottel
