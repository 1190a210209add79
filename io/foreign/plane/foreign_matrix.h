// View factors that were computed elsewhere, as methods like any other: from a file, or by a command.
#pragma once

#include "solver/plane/methods/method_catalogue.h"

namespace hottel {

// `file:PATH`: a file as in read_foreign_matrix. compute() reads it anew each time; MethodReport::seconds is nothing.
MethodFamily2 file_family_2();

// `run:CMD`: a command as in run_foreign_command, with PreparedScene2::scene.file as the scene; its time is
// MethodReport::seconds. What it wrote and cannot be read is a RequestError that names the command.
MethodFamily2 run_family_2();

// Returns true for a name of these two families: their rows are as others made them, whatever elements are asked for.
bool is_foreign_2(const std::string& method);

// The methods of the library (methods_2), and these two families.
MethodCatalogue2 all_methods_2();

}  // namespace hottel
