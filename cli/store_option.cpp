#include "cli/store_option.h"

#include "io/external/external_method.h"
#include "io/store/factor_store.h"
#include "kernel/support/failure.h"

namespace hottel {

void StoreOption::add_to(CLI::App& command) {
  command
      .add_option("--store", file,
                  "keep view factors in this file, made where it is not there, and take from it what is there of this "
                  "scene: the same numbers, bit for bit")
      ->type_name("FILE");
}

std::shared_ptr<FactorStore> StoreOption::open(const std::string& method) const {
  if (!is_given()) return nullptr;
  if (file == "-") throw UsageError("--store takes a file, not -");
  if (is_external(method)) throw UsageError("--store keeps what hottel computes, not the factors of " + method);
  return open_factor_store(file);
}

std::optional<StoreReport> StoreOption::report(const std::shared_ptr<FactorStore>& store) const {
  if (!store) return std::nullopt;
  return StoreReport{file, store->use()};
}

}  // namespace hottel
