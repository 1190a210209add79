#include "io/store/database.h"

#include <sqlite3.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <thread>
#include <utility>

#include "io/files/output_file.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

constexpr std::uint32_t kApplication = 0x686f7474;  // "hott", at byte 68 of the file
constexpr int kFormat = 1;
constexpr int kWaitMilliseconds = 60'000;
constexpr std::size_t kHeaderBytes = 100;
constexpr std::string_view kMagic("SQLite format 3\0", 16);

constexpr const char* kTables = R"(
CREATE TABLE settings(name TEXT PRIMARY KEY, value INTEGER) WITHOUT ROWID;
CREATE TABLE lists(id INTEGER PRIMARY KEY, key BLOB, elements BLOB, about BLOB, sum BLOB, used INTEGER);
CREATE TABLE rows(id INTEGER PRIMARY KEY, list INTEGER, row INTEGER, what INTEGER, body BLOB, sum BLOB);
CREATE INDEX lists_by_key ON lists(key);
CREATE INDEX rows_by_list ON rows(list, row);
)";

[[noreturn]] void fail(sqlite3* database, const std::string& file, int code) {
  const int kind = code & 0xff;
  const std::string text = database != nullptr ? sqlite3_errmsg(database) : sqlite3_errstr(code);
  const int error = database != nullptr ? sqlite3_system_errno(database) : 0;
  switch (kind) {
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
      throw OutputError(file, "cannot be written: another process has it");
    case SQLITE_FULL:
    case SQLITE_IOERR:
    case SQLITE_CANTOPEN:
    case SQLITE_READONLY:
    case SQLITE_PERM:
      throw OutputError(file, "cannot be written: " + (error != 0 ? std::string(std::strerror(error)) : text));
    case SQLITE_NOMEM:
      throw std::bad_alloc();
    default:
      throw InputError({file, 0}, "is a damaged store of factors (" + text + ")",
                       {"remove it: what it held is computed again"});
  }
}

// Throws unless the file is a store, empty, or not there. Returns whether there is anything in it.
bool require_store(const std::string& file, MayCreate may_create) {
  const auto refuse = [&](const std::string& text) { throw InputError({file, 0}, text); };
  if (file.empty()) throw OutputError("''", "is no name of a file");
  struct stat status {};
  if (::stat(file.c_str(), &status) != 0) {
    if (errno != ENOENT) throw OutputError(file, "cannot be written: " + std::string(std::strerror(errno)));
    if (may_create == MayCreate::kNo) refuse("there is no such file");
    const std::filesystem::path folder = std::filesystem::path(file).parent_path();
    if (::access(folder.empty() ? "." : folder.c_str(), W_OK) != 0)
      throw OutputError(file, unwritten_text(folder, errno));
    return false;
  }
  if (S_ISDIR(status.st_mode)) refuse("is a directory, not a store of factors");
  if (!S_ISREG(status.st_mode)) refuse("is no store of factors");
  if (::access(file.c_str(), R_OK | W_OK) != 0)
    throw OutputError(file, "cannot be written: " + std::string(std::strerror(errno)));
  if (status.st_size == 0) return false;
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> stream(std::fopen(file.c_str(), "rb"), &std::fclose);
  if (!stream) refuse("cannot be opened: " + std::string(std::strerror(errno)));
  std::array<unsigned char, kHeaderBytes> header{};
  const bool is_whole = std::fread(header.data(), 1, header.size(), stream.get()) == header.size();
  const auto word = [&header](std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t k = at; k < at + 4; ++k) value = value << 8 | header[k];
    return value;
  };
  const std::uint32_t application = word(68);
  // A database without a table is what is left of one whose making was ended.
  const std::uint32_t page = word(16) >> 16;  // of a database a power of two, 1 for the largest
  const bool has_no_table = page != 0 && application == 0 && word(28) <= 1 && word(40) == 0 && word(60) == 0;
  if (is_whole && std::memcmp(header.data(), kMagic.data(), kMagic.size()) == 0 && has_no_table) return false;
  if (!is_whole || std::memcmp(header.data(), kMagic.data(), kMagic.size()) != 0 || application != kApplication)
    refuse("is no store of factors");
  return true;
}

}  // namespace

Statement::Statement(sqlite3* database, const std::string& file, const char* text) : database_(database), file_(file) {
  if (const int code = sqlite3_prepare_v2(database, text, -1, &statement_, nullptr); code != SQLITE_OK)
    fail(database, file, code);
}

Statement::~Statement() { sqlite3_finalize(statement_); }

Statement& Statement::bind(int place, std::int64_t value) {
  if (const int code = sqlite3_bind_int64(statement_, place, value); code != SQLITE_OK) fail(database_, file_, code);
  return *this;
}

Statement& Statement::bind(int place, std::string_view bytes) {
  const int code =
      sqlite3_bind_blob64(statement_, place, bytes.empty() ? "" : bytes.data(), bytes.size(), SQLITE_TRANSIENT);
  if (code != SQLITE_OK) fail(database_, file_, code);
  return *this;
}

bool Statement::step() {
  const int code = sqlite3_step(statement_);
  if (code == SQLITE_ROW) return true;
  if (code != SQLITE_DONE) fail(database_, file_, code);
  return false;
}

void Statement::run() {
  while (step()) {
  }
  sqlite3_reset(statement_);
}

std::int64_t Statement::number(int column) const { return sqlite3_column_int64(statement_, column); }

std::string_view Statement::bytes(int column) const {
  const void* const data = sqlite3_column_blob(statement_, column);
  const int size = sqlite3_column_bytes(statement_, column);
  return data == nullptr ? std::string_view() : std::string_view(static_cast<const char*>(data), std::size_t(size));
}

Database::Database(const std::filesystem::path& file, MayCreate may_create) : name_(file.string()) {
  require_store(name_, may_create);
  try {
    open();
    if (number("SELECT count(*) FROM sqlite_schema") == 0) make_tables();
    if (number("PRAGMA application_id") != kApplication) throw InputError({name_, 0}, "is no store of factors");
    if (const std::int64_t format = number("PRAGMA user_version"); format != kFormat)
      throw InputError({name_, 0}, "is a store of factors in format " + std::to_string(format) +
                                       "; this version reads format " + std::to_string(kFormat));
    write_ahead();
    run("PRAGMA synchronous = NORMAL");
    number("SELECT count(*) FROM settings");
  } catch (...) {
    sqlite3_close_v2(database_);
    throw;
  }
}

void Database::open() {
  const int code = sqlite3_open_v2(name_.c_str(), &database_,
                                   SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE | SQLITE_OPEN_FULLMUTEX, nullptr);
  if (code != SQLITE_OK) fail(database_, name_, code);
  sqlite3_extended_result_codes(database_, 1);
  sqlite3_busy_timeout(database_, kWaitMilliseconds);
  // What a damaged file says is not run, and tables are as they are written down or damaged.
  sqlite3_db_config(database_, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
  sqlite3_db_config(database_, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
  run("PRAGMA cell_size_check = ON");
}

void Database::make_tables() {
  run("PRAGMA auto_vacuum = INCREMENTAL");
  Transaction transaction(*this);
  if (number("SELECT count(*) FROM sqlite_schema") == 0) {  // nobody else was faster
    run(("PRAGMA application_id = " + std::to_string(kApplication)).c_str());
    run(("PRAGMA user_version = " + std::to_string(kFormat)).c_str());
    run(kTables);
  }
  transaction.commit();
}

// Where another process makes the same change, or holds what it needs, SQLite does not wait by itself.
void Database::write_ahead() {
  const auto give_up = std::chrono::steady_clock::now() + std::chrono::milliseconds(kWaitMilliseconds);
  for (;;) {
    const int code = sqlite3_exec(database_, "PRAGMA journal_mode = WAL", nullptr, nullptr, nullptr);
    if (code == SQLITE_OK) return;
    if ((code & 0xff) != SQLITE_BUSY || std::chrono::steady_clock::now() > give_up) fail(database_, name_, code);
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
}

Database::~Database() { sqlite3_close_v2(database_); }

void Database::run(const char* text) {
  if (const int code = sqlite3_exec(database_, text, nullptr, nullptr, nullptr); code != SQLITE_OK)
    fail(database_, name_, code);
}

std::int64_t Database::number(const char* text) {
  Statement asked = statement(text);
  return asked.step() ? asked.number(0) : 0;
}

std::uint64_t Database::used_bytes() {
  return static_cast<std::uint64_t>((number("PRAGMA page_count") - number("PRAGMA freelist_count")) *
                                    number("PRAGMA page_size"));
}

Transaction::~Transaction() {
  if (!is_open_) return;
  try {
    database_.run("ROLLBACK");
  } catch (const std::exception&) {  // it was undone already
  }
}

void Transaction::commit() {
  database_.run("COMMIT");
  is_open_ = false;
}

}  // namespace hottel
