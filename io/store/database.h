// A database of SQLite that is a store of factors: opened, or refused by name.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

struct sqlite3;
struct sqlite3_stmt;

namespace hottel {

// One statement, with what is bound to it, and the row that it stands at. Numbers count from 1 where they are bound,
// from 0 where they are read.
class Statement {
 public:
  Statement(sqlite3* database, const std::string& file, const char* text);
  Statement(const Statement&) = delete;
  Statement& operator=(const Statement&) = delete;
  ~Statement();

  Statement& bind(int place, std::int64_t value);
  Statement& bind(int place, std::string_view bytes);  // copied
  // Goes to the next row; false where there is none. Throws as Database does.
  bool step();
  // Steps to the end, and makes it ready to be bound again.
  void run();

  std::int64_t number(int column) const;
  std::string_view bytes(int column) const;  // until the next step

 private:
  sqlite3* database_;
  std::string file_;
  sqlite3_stmt* statement_ = nullptr;
};

enum class MayCreate : bool { kNo, kYes };

// A store's database, open to be read and written.
//
//   (1) a file that is none is refused before SQLite looks at it: it stays as it is
//   (2) it is written ahead (WAL): readers do not wait, writers wait for each other a minute long. What was committed
//       before the process is killed is there, what was not is gone
// The constructor and all statements throw InputError naming the file where it is missing (and may not be made),
// foreign, of a later version or damaged; OutputError where it cannot be written, or is in use for too long.
class Database {
 public:
  Database(const std::filesystem::path& file, MayCreate may_create);
  Database(const Database&) = delete;
  Database& operator=(const Database&) = delete;
  ~Database();

  const std::string& name() const { return name_; }
  void run(const char* text);
  std::int64_t number(const char* text);  // of a statement that returns one
  Statement statement(const char* text) { return {database_, name_, text}; }

  // Bytes that its pages take, without free ones.
  std::uint64_t used_bytes();

 private:
  void open();
  void make_tables();
  void write_ahead();

  std::string name_;
  sqlite3* database_ = nullptr;
};

// What is done by then stays; what is not committed when it goes out of scope is undone.
class Transaction {
 public:
  explicit Transaction(Database& database, bool writes = true) : database_(database) {
    database_.run(writes ? "BEGIN IMMEDIATE" : "BEGIN");
  }
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;
  ~Transaction();
  void commit();

 private:
  Database& database_;
  bool is_open_ = true;
};

}  // namespace hottel
