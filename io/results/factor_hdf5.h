// View factors as an HDF5 file: rows in compressed arrays, and all that tells what they are.
#pragma once

#include <string>

#include "io/files/output_file.h"
#include "io/results/factor_table.h"

namespace hottel {

// What a file that stands for itself says of where its factors are from.
struct FactorOrigin {
  int dimension = 2;
  std::string method;  // exact, or as --method has it
  std::string scene;   // JSON
};
// HDF5: rows in compressed arrays (CSR) of all faces and the sky last, and what tells of them, as docs/hdf5_files.md
// has it: 13 bytes for each pair that the list has, 29 where bounds are more than neighbouring doubles.
//
//   (1) the same table and origin give the same bytes
//   (2) with only_rows the other rows are empty, and the file says so
// Throws UsageError where hottel was built without HDF5, OutputError where `out` is no regular file.
void write_factors_hdf5(const FactorTable& table, const FactorOrigin& origin, const OutputFile& out);

}  // namespace hottel
