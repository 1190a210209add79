// What is told of a store of factors, and of what a run took from it.
#pragma once

#include <string>

#include "io/store/factor_store.h"
#include "solver/store.h"

namespace hottel {

// A store, and what one run took from it and gave to it.
struct StoreReport {
  std::string file;
  StoreUse use;
};

// "store FILE: 92 pairs read, none computed", and what was damaged.
std::string store_text(const StoreReport& report);
// The same as one line of JSON: an object.
std::string store_json(const StoreReport& report);

// What a store holds: a line a list, and the sum; and as one JSON object with a final newline. checked: whether records
// were held against their checksums.
std::string contents_text(const std::string& file, const StoreContents& contents, bool checked);
std::string contents_json(const std::string& file, const StoreContents& contents, bool checked);

}  // namespace hottel
