#include "cli/sums_option.h"

#include "kernel/support/failure.h"
#include "solver/memory_estimate.h"

namespace hottel {

void SumsOption::add_to(CLI::App& command, const std::string& what) {
  CLI::Option* with_none_left = command.add_option("--out-of-core", out_of_core, "in the plane: " + what);
  with_none_left->type_name("DIR");
  command
      .add_option("--checkpoint", checkpoint,
                  "the same, and the files stay where the run is ended: the same command goes on from there")
      ->type_name("DIR")
      ->excludes(with_none_left);
}

void SumsOption::refuse_in_space() const {
  if (is_given()) throw UsageError("--out-of-core and --checkpoint are for scenes in the plane");
}

void SumsOption::tell(std::uint64_t bytes, const Streams& streams) const {
  streams.note(short_bytes(static_cast<double>(bytes)) + " of sums were in " + folder());
}

}  // namespace hottel
