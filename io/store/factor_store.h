// Factors in a file, from one run to the next.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "solver/store.h"

namespace hottel {

// The bytes that a store may take unless its file says otherwise; then those kept longest without use give way.
inline constexpr std::uint64_t kUsualStoreLimit = std::uint64_t{1} << 30;

// Opens a store, and makes one where there is no file.
//
//   (1) every record has a checksum over itself and over what it is of: a byte that was changed anywhere is found, and
//       the record is as good as not there; or it had no meaning
//   (2) any number of processes may read and write one file
//   (3) an empty file is an empty store, and so is a database without a table; any other that is none is refused and
//       left alone
//
// Throws InputError or OutputError as Database does (database.h).
std::shared_ptr<FactorStore> open_factor_store(const std::filesystem::path& file);

// What a store holds of one scene by one method and one list of elements.
struct StoredList {
  std::string about;  // scene and method
  std::uint64_t elements = 0, records = 0, bytes = 0;
};

// What a store holds. Of what was found damaged: nothing else is told of it.
struct StoreContents {
  std::uint64_t bytes = 0, limit = 0;  // of the file
  std::vector<StoredList> lists;       // the one used last comes first
  std::uint64_t records = 0;
  std::vector<std::string> damage;  // sentences
};

// Looks into a store that is there. checks: every record is held against its checksum, and the file is looked through.
StoreContents store_contents(const std::filesystem::path& file, bool checks);

// Takes out what was used longest ago until the file takes at most so many bytes, or is empty, and makes it as small as
// it can be.
void shrink_store(const std::filesystem::path& file, std::uint64_t bytes);
// Sets the bytes that the store may take from now on.
void limit_store(const std::filesystem::path& file, std::uint64_t bytes);

}  // namespace hottel
