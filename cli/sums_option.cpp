#include "cli/sums_option.h"

#include "geometry/memory_text.h"
#include "kernel/support/failure.h"

namespace hottel {

void SumsOption::add_to(CLI::App& command, const std::string& what, const std::string& staying) {
  CLI::Option* with_none_left = command.add_option("--out-of-core", out_of_core, what);
  with_none_left->type_name("DIR");
  command.add_option("--checkpoint", checkpoint, staying)->type_name("DIR")->excludes(with_none_left);
}

void SumsOption::refuse_in_space() const {
  if (is_given()) throw UsageError("--out-of-core and --checkpoint of solve are for scenes in the plane");
}

void SumsOption::tell(std::uint64_t bytes, const Streams& streams) const {
  streams.note(short_bytes(static_cast<double>(bytes)) + " of sums were in " + folder());
}

}  // namespace hottel
