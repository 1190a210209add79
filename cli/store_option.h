// --store: factors that are kept from one run to the next.
#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "io/results/store_report.h"
#include "solver/store.h"

namespace hottel {

struct StoreOption {
  std::string file;

  // Adds the option to the command line of a command. REQUIRES that this outlives the command.
  void add_to(CLI::App& command);
  bool is_given() const { return !file.empty(); }
  // Opens the store, or returns null where none is asked for. Throws UsageError for "-" and for a method whose factors
  // come from elsewhere (file:, run:).
  std::shared_ptr<FactorStore> open(const std::string& method) const;
  // What a run took from it; nothing where there is none.
  std::optional<StoreReport> report(const std::shared_ptr<FactorStore>& store) const;
};

}  // namespace hottel
