#include "io/store/factor_store.h"

#include <algorithm>
#include <array>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <unordered_map>
#include <utility>

#include "io/files/output_file.h"
#include "io/store/database.h"
#include "io/store/stored_record.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

// A transaction has so many bytes of records at most: what was committed stays when the process is killed.
constexpr std::size_t kBytesOfATransaction = std::size_t{1} << 23;

// Elements that rows are numbered by: a key, and what is kept of whom.
struct List {
  std::int64_t id = 0;
  std::string key, elements, about;

  std::string sum() const { return digest_of(std::array<std::string_view, 4>{"list", key, elements, about}); }
};

std::string sum_of_row(const std::string& of_list, std::uint32_t row, std::uint32_t what, std::string_view body) {
  const std::string place = std::to_string(row) + " " + std::to_string(what);
  return digest_of(std::array<std::string_view, 4>{"row", of_list, place, body});
}

std::string key_of(const StoreTable& table) { return digest_of(std::array<std::string_view, 1>{table.key}); }

// The list of a statement that asks for id, key, elements, about, sum; nothing where it is damaged.
std::optional<List> list_of(const Statement& asked) {
  List list{asked.number(0), std::string(asked.bytes(1)), std::string(asked.bytes(2)), std::string(asked.bytes(3))};
  if (list.sum() != asked.bytes(4)) return std::nullopt;
  return list;
}

// A row as it stands in a statement that asks for row, what, body, sum from the given column on.
struct FoundRow {
  std::uint32_t what = 0;
  CachedRow row;
};
std::optional<FoundRow> row_of_statement(const Statement& asked, int first, const std::string& of_list,
                                         std::uint32_t elements) {
  const auto row = static_cast<std::uint32_t>(asked.number(first));
  const auto what = static_cast<std::uint32_t>(asked.number(first + 1));
  const std::string_view body = asked.bytes(first + 2);
  if (sum_of_row(of_list, row, what, body) != asked.bytes(first + 3) || row > elements) return std::nullopt;
  auto read = row_of(row, body, elements);
  if (!read) return std::nullopt;
  return FoundRow{what, std::move(*read)};
}

std::uint64_t limit_of(Database& database) {
  Statement asked = database.statement("SELECT value FROM settings WHERE name = 'limit'");
  return asked.step() && asked.number(0) > 0 ? static_cast<std::uint64_t>(asked.number(0)) : kUsualStoreLimit;
}

// Takes out the list that was used longest ago, but this one. False where there is none.
bool evict_one(Database& database, std::int64_t keeps) {
  Statement oldest = database.statement("SELECT id FROM lists WHERE id <> ?1 ORDER BY used, id LIMIT 1");
  if (!oldest.bind(1, keeps).step()) return false;
  const std::int64_t id = oldest.number(0);
  database.statement("DELETE FROM rows WHERE list = ?1").bind(1, id).run();
  database.statement("DELETE FROM lists WHERE id = ?1").bind(1, id).run();
  return true;
}

class SqliteStore final : public FactorStore {
 public:
  explicit SqliteStore(const std::filesystem::path& file) : database_(file, MayCreate::kYes) {}

  std::vector<CachedRows> read(const StoreTable& table, std::uint32_t what) override {
    const std::lock_guard lock(mutex_);
    std::unordered_map<std::string_view, std::uint32_t> place;
    for (std::uint32_t i = 0; i < table.elements.size(); ++i) place.emplace(table.elements[i], i);
    const auto sky = static_cast<std::uint32_t>(table.elements.size());
    std::vector<CachedRows> result;
    std::vector<std::int64_t> used;
    {
      Transaction transaction(database_, false);
      Statement lists =
          database_.statement("SELECT id, key, elements, about, sum FROM lists WHERE key = ?1 ORDER BY id");
      lists.bind(1, key_of(table));
      while (lists.step()) {
        const auto list = list_of(lists);
        const auto elements = list ? separated(list->elements) : std::nullopt;
        if (!elements) {
          use_.damaged += damaged_lists_.insert(lists.number(0)).second ? 1 : 0;
          continue;
        }
        CachedRows kept;
        bool is_any = false;
        for (const std::string& element : *elements) {
          const auto there = place.find(element);
          kept.place.push_back(there == place.end() ? CachedRows::kNoPlace : there->second);
          is_any = is_any || there != place.end();
        }
        kept.place.push_back(sky);
        if (!is_any) continue;
        read_rows(*list, what, kept);
        if (!kept.rows.empty()) used.push_back(list->id);
        result.push_back(std::move(kept));
      }
    }
    tell_used(used);
    return result;
  }

  void keep(const StoreTable& table, std::uint32_t what, std::span<const CachedRow> rows) override {
    const std::lock_guard lock(mutex_);
    std::size_t next = 0;
    const std::uint64_t limit = limit_of(database_);
    bool has_room = true;
    while (next < rows.size() && has_room) {
      Transaction transaction(database_);
      if (next == 0) remove_damaged();
      const List list = list_for(table);
      const std::string sum = list.sum();
      Statement insert = database_.statement("INSERT INTO rows(list, row, what, body, sum) VALUES(?1, ?2, ?3, ?4, ?5)");
      for (std::size_t bytes = 0; next < rows.size() && bytes < kBytesOfATransaction; ++next) {
        const CachedRow& row = rows[next];
        const std::string body = record_of(row);
        insert.bind(1, list.id).bind(2, std::int64_t{row.row}).bind(3, std::int64_t{what});
        insert.bind(4, body).bind(5, sum_of_row(sum, row.row, what, body)).run();
        bytes += body.size();
      }
      while (database_.used_bytes() > limit && evict_one(database_, list.id)) {
      }
      has_room = database_.used_bytes() <= limit;
      if (has_room) transaction.commit();
    }
    database_.run("PRAGMA incremental_vacuum");
  }

  void forget(const StoreTable& table) override {
    const std::lock_guard lock(mutex_);
    const std::string key = key_of(table);
    {
      Statement lists = database_.statement("SELECT id FROM lists WHERE key = ?1");
      if (!lists.bind(1, key).step()) return;  // as nearly always: nobody need wait for others who write
    }
    Transaction transaction(database_);
    database_.statement("DELETE FROM rows WHERE list IN (SELECT id FROM lists WHERE key = ?1)").bind(1, key).run();
    database_.statement("DELETE FROM lists WHERE key = ?1").bind(1, key).run();
    transaction.commit();
    database_.run("PRAGMA incremental_vacuum");
  }

  void add(std::uint64_t computed, std::uint64_t read) override {
    const std::lock_guard lock(mutex_);
    use_.computed += computed;
    use_.read += read;
  }
  StoreUse use() const override {
    const std::lock_guard lock(mutex_);
    return use_;
  }

 private:
  void read_rows(const List& list, std::uint32_t what, CachedRows& kept) {
    const std::string of_list = list.sum();
    const auto elements = static_cast<std::uint32_t>(kept.place.size() - 1);
    Statement rows = database_.statement("SELECT id, row, what, body, sum FROM rows WHERE list = ?1 ORDER BY id");
    rows.bind(1, list.id);
    while (rows.step()) {
      auto found = row_of_statement(rows, 1, of_list, elements);
      if (!found) {
        use_.damaged += damaged_rows_.insert(rows.number(0)).second ? 1 : 0;
        continue;
      }
      if ((found->what & what) == what && kept.place[found->row.row] != CachedRows::kNoPlace)
        kept.rows.push_back(std::move(found->row));
    }
  }

  // The list of a table, made where it is not there.
  List list_for(const StoreTable& table) {
    List wanted{0, key_of(table), joined(table.elements), table.about};
    Statement lists = database_.statement("SELECT id, key, elements, about, sum FROM lists WHERE key = ?1 ORDER BY id");
    lists.bind(1, wanted.key);
    while (lists.step())
      if (auto list = list_of(lists); list && list->elements == wanted.elements) return std::move(*list);
    Statement insert = database_.statement(
        "INSERT INTO lists(key, elements, about, sum, used) VALUES(?1, ?2, ?3, ?4, "
        "(SELECT coalesce(max(used), 0) + 1 FROM lists))");
    insert.bind(1, wanted.key).bind(2, wanted.elements).bind(3, wanted.about).bind(4, wanted.sum()).run();
    wanted.id = database_.number("SELECT last_insert_rowid()");
    return wanted;
  }

  void remove_damaged() {
    for (const std::int64_t row : damaged_rows_)
      database_.statement("DELETE FROM rows WHERE id = ?1").bind(1, row).run();
    for (const std::int64_t list : damaged_lists_) {
      database_.statement("DELETE FROM rows WHERE list = ?1").bind(1, list).run();
      database_.statement("DELETE FROM lists WHERE id = ?1").bind(1, list).run();
    }
    damaged_rows_.clear();
    damaged_lists_.clear();
  }

  // So that others give way first. Where somebody else writes just now nothing is told.
  void tell_used(const std::vector<std::int64_t>& lists) {
    if (lists.empty()) return;
    try {
      Transaction transaction(database_);
      Statement update = database_.statement(
          "UPDATE lists SET used = (SELECT coalesce(max(used), 0) + 1 FROM lists) WHERE id = ?1 AND used < (SELECT "
          "max(used) FROM lists)");
      for (const std::int64_t list : lists) update.bind(1, list).run();
      transaction.commit();
    } catch (const OutputError&) {
    }
  }

  mutable std::mutex mutex_;
  Database database_;
  StoreUse use_;
  std::set<std::int64_t> damaged_rows_, damaged_lists_;
};

}  // namespace

std::shared_ptr<FactorStore> open_factor_store(const std::filesystem::path& file) {
  return std::make_shared<SqliteStore>(file);
}

namespace {

// Sentences of what SQLite finds in its own pages.
void look_through(Database& database, std::vector<std::string>& damage) {
  Statement findings = database.statement("PRAGMA integrity_check(10)");
  while (findings.step())
    if (const std::string text(findings.bytes(0)); text != "ok") damage.push_back(text);
}

void read_lists(Database& database, bool checks, StoreContents& contents) {
  std::map<std::int64_t, std::pair<List, std::uint32_t>> known;
  Statement lists = database.statement("SELECT id, key, elements, about, sum FROM lists ORDER BY used DESC, id DESC");
  while (lists.step()) {
    auto list = list_of(lists);
    const auto elements = list ? separated(list->elements) : std::nullopt;
    if (!elements) {
      contents.damage.emplace_back("a list of elements is damaged");
      continue;
    }
    Statement count = database.statement("SELECT count(*), coalesce(sum(length(body)), 0) FROM rows WHERE list = ?1");
    count.bind(1, list->id).step();
    contents.lists.push_back({list->about, elements->size(), static_cast<std::uint64_t>(count.number(0)),
                              static_cast<std::uint64_t>(count.number(1))});
    const std::int64_t id = list->id;
    known.emplace(id, std::pair(std::move(*list), static_cast<std::uint32_t>(elements->size())));
  }
  contents.records = static_cast<std::uint64_t>(database.number("SELECT count(*) FROM rows"));
  if (!checks) return;
  std::uint64_t damaged = 0;
  Statement rows = database.statement("SELECT list, row, what, body, sum FROM rows");
  while (rows.step()) {
    const auto list = known.find(rows.number(0));
    if (list == known.end() || !row_of_statement(rows, 1, list->second.first.sum(), list->second.second)) ++damaged;
  }
  if (damaged > 0)
    contents.damage.push_back(damaged == 1 ? "a record is damaged" : std::to_string(damaged) + " records are damaged");
}

std::uint64_t file_bytes(const std::filesystem::path& file) {
  std::error_code none;
  const auto size = std::filesystem::file_size(file, none);
  return none ? 0 : size;
}

}  // namespace

StoreContents store_contents(const std::filesystem::path& file, bool checks) {
  Database database(file, MayCreate::kNo);
  StoreContents contents;
  contents.limit = limit_of(database);
  if (checks) look_through(database, contents.damage);
  read_lists(database, checks, contents);
  contents.bytes = file_bytes(file) + file_bytes(file.string() + "-wal");
  return contents;
}

void shrink_store(const std::filesystem::path& file, std::uint64_t bytes) {
  Database database(file, MayCreate::kNo);
  {
    Transaction transaction(database);
    while (database.used_bytes() > bytes && evict_one(database, -1)) {
    }
    transaction.commit();
  }
  database.run("VACUUM");
  database.run("PRAGMA wal_checkpoint(TRUNCATE)");
}

void limit_store(const std::filesystem::path& file, std::uint64_t bytes) {
  Database database(file, MayCreate::kNo);
  Statement set = database.statement("INSERT OR REPLACE INTO settings(name, value) VALUES('limit', ?1)");
  set.bind(1, static_cast<std::int64_t>(bytes)).run();
}

}  // namespace hottel
