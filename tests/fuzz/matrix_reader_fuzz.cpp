// Any bytes as a matrix of another program: refused with InputError, or read; what is read is as the header says.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "io/external/external_file.h"
#include "kernel/support/failure.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const hottel::ExternalMatrix matrix =
        hottel::parse_external_matrix("fuzz.matrix", std::string_view(reinterpret_cast<const char*>(data), size));
    const hottel::ExternalEntry* last = nullptr;
    for (const hottel::ExternalEntry& entry : matrix.entries) {
      if (entry.row >= matrix.rows || entry.column >= matrix.columns) std::abort();
      if (!std::isfinite(entry.value) || entry.value == 0) std::abort();
      if (last && (entry.row < last->row || (entry.row == last->row && entry.column <= last->column))) std::abort();
      last = &entry;
    }
  } catch (const hottel::InputError& error) {
    if (!std::string_view(error.what()).starts_with("fuzz.matrix")) std::abort();
  }
  return 0;
}
