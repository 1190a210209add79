// --out-of-core and --checkpoint: sums of pairs in files.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <string>

#include "cli/streams.h"
#include "io/sums/plane/sum_folder.h"

namespace hottel {

struct SumsOption {
  std::string out_of_core, checkpoint;  // folders, of which one is given at the most

  // Adds both to the command line of a command. what: what goes to files, and what comes of it; staying: the same of
  // files that stay. REQUIRES that this outlives the command.
  void add_to(CLI::App& command, const std::string& what, const std::string& staying);
  bool is_given() const { return !folder().empty(); }
  std::string folder() const { return out_of_core + checkpoint; }
  const char* name() const { return checkpoint.empty() ? "--out-of-core" : "--checkpoint"; }
  SumFolderRequest request() const { return {.folder = folder(), .stays = !checkpoint.empty()}; }
  // Throws UsageError where one is given.
  void refuse_in_space() const;
  // Tells how many bytes of sums there were.
  void tell(std::uint64_t bytes, const Streams& streams) const;
};

}  // namespace hottel
