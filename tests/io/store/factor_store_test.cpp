#include "io/store/factor_store.h"

#include <gtest/gtest.h>
#include <sqlite3.h>

#include <atomic>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <random>
#include <thread>

#include "io/files/output_file.h"
#include "io/store/stored_record.h"
#include "kernel/support/failure.h"
#include "solver/memory_store.h"
#include "tests/temporary_folder.h"

namespace hottel::factor_store_test {
namespace {

namespace fs = std::filesystem;

StoreTable table_of(const std::string& key, const std::vector<std::string>& elements) {
  return {key, "scene by method", elements};
}

CachedRow some_row(std::uint32_t row, std::uint32_t elements, std::mt19937_64& random) {
  CachedRow kept{.row = row, .known = {{row, elements + 1}}, .to = {}, .numbers = {}};
  for (std::uint32_t j = row; j <= elements; ++j)
    if (random() % 2 == 0) {
      kept.to.push_back(j);
      for (int k = 0; k < 9; ++k) kept.numbers += static_cast<char>(random() % 256);
    }
  return kept;
}

std::vector<CachedRow> some_rows(std::uint32_t elements, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<CachedRow> rows;
  for (std::uint32_t i = 0; i < elements; ++i) rows.push_back(some_row(i, elements, random));
  return rows;
}

std::string bytes_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

const std::vector<std::string> kElements = {"a", "b", "c", "d#1 of 2", "d#2 of 2"};

TEST(StoredRecord, IsTheRow) {
  std::mt19937_64 random(2);
  for (int k = 0; k < 1000; ++k) {
    const auto n = static_cast<std::uint32_t>(1 + random() % 1000);
    const CachedRow row = some_row(static_cast<std::uint32_t>(random() % n), n, random);
    EXPECT_EQ(row_of(row.row, record_of(row), n), row);
  }
}

TEST(StoredRecord, OfAnyBytesIsARowOfTheElementsOrNone) {
  std::mt19937_64 random(3);
  for (int k = 0; k < 20000; ++k) {
    std::string bytes;
    for (auto size = random() % 30; size > 0; --size) bytes += static_cast<char>(random() % (k % 2 == 0 ? 256 : 8));
    const auto row = row_of(0, bytes, 5);
    if (!row) continue;
    for (const ColumnRange& range : row->known) EXPECT_TRUE(range.begin < range.end && range.end <= 6);
    for (const std::uint32_t to : row->to) EXPECT_LE(to, 5U);
  }
}

TEST(FactorStore, ReturnsWhatWasKept) {
  const TemporaryFolder folder;
  const std::vector<CachedRow> rows = some_rows(5, 1);
  open_factor_store(folder / "s")->keep(table_of("key", kElements), 1, rows);
  const auto store = open_factor_store(folder / "s");
  const auto kept = store->read(table_of("key", kElements), 1);
  ASSERT_EQ(kept.size(), 1U);
  EXPECT_EQ(kept[0].rows, rows);
  EXPECT_EQ(kept[0].place, (std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(store->read(table_of("key", kElements), 0)[0].rows, rows) << "with less than was kept";
  EXPECT_TRUE(store->read(table_of("key", kElements), 3)[0].rows.empty()) << "more was not kept";
  EXPECT_TRUE(store->read(table_of("another key", kElements), 0).empty());
  EXPECT_EQ(store->use().damaged, 0U);
}

TEST(FactorStore, PlacesElementsOfOtherRuns) {
  const TemporaryFolder folder;
  const auto store = open_factor_store(folder / "s");
  store->keep(table_of("key", kElements), 0, some_rows(5, 1));
  const auto kept = store->read(table_of("key", {"b", "d#1 of 3", "d#2 of 2"}), 0);
  ASSERT_EQ(kept.size(), 1U);
  const std::uint32_t none = CachedRows::kNoPlace;
  EXPECT_EQ(kept[0].place, (std::vector<std::uint32_t>{none, 0, none, none, 2, 3}));
  EXPECT_EQ(kept[0].rows.size(), 2U);
  EXPECT_TRUE(store->read(table_of("key", {"e"}), 0).empty());
}

TEST(FactorStore, ForgetsAllOfAKeyAndNothingElse) {
  const TemporaryFolder folder;
  const fs::path file = folder / "s";
  const std::vector<CachedRow> rows = some_rows(static_cast<std::uint32_t>(kElements.size()), 1);
  for (const auto& store : {open_factor_store(file), make_memory_store()}) {
    store->forget(table_of("key", kElements));
    store->keep(table_of("key", kElements), 0, rows);
    store->keep(table_of("key", {"a"}), 0, std::span(rows).first(0));
    store->keep(table_of("other", kElements), 0, rows);
    store->forget(table_of("key", kElements));
    EXPECT_TRUE(store->read(table_of("key", kElements), 0).empty());
    ASSERT_EQ(store->read(table_of("other", kElements), 0).size(), 1U);
    EXPECT_EQ(store->read(table_of("other", kElements), 0)[0].rows, rows);
  }
  const StoreContents contents = store_contents(file, true);
  EXPECT_EQ(contents.lists.size(), 1U);
  EXPECT_EQ(contents.records, rows.size());
  EXPECT_TRUE(contents.damage.empty());
}

TEST(FactorStore, GivesWayToWhatIsUsed) {
  const TemporaryFolder folder;
  const auto store = open_factor_store(folder / "s");
  std::vector<std::string> many;
  for (int k = 0; k < 300; ++k) many.push_back("e" + std::to_string(k));
  store->keep(table_of("old", many), 0, some_rows(300, 1));
  store->keep(table_of("used", many), 0, some_rows(300, 2));
  const std::uint64_t two = store_contents(folder / "s", true).bytes;
  EXPECT_FALSE(store->read(table_of("old", many), 0).empty());
  EXPECT_FALSE(store->read(table_of("used", many), 0).empty());
  limit_store(folder / "s", two + 50'000);
  store->keep(table_of("new", many), 0, some_rows(300, 3));
  EXPECT_TRUE(store->read(table_of("old", many), 0).empty());
  EXPECT_FALSE(store->read(table_of("used", many), 0).empty());
  EXPECT_FALSE(store->read(table_of("new", many), 0).empty());
  limit_store(folder / "s", 30'000);
  store->keep(table_of("too large", many), 0, some_rows(300, 4));
  EXPECT_TRUE(store->read(table_of("too large", many), 0).empty());
  shrink_store(folder / "s", two / 2 + 50'000);
  EXPECT_EQ(store_contents(folder / "s", true).lists.size(), 1U);
  shrink_store(folder / "s", 0);
  const StoreContents contents = store_contents(folder / "s", true);
  EXPECT_TRUE(contents.lists.empty() && contents.records == 0 && contents.damage.empty());
  EXPECT_LT(fs::file_size(folder / "s"), 100'000U);
}

TEST(FactorStore, FindsChangedBytesOrTheyHaveNoEffect) {
  const TemporaryFolder folder;
  std::vector<std::string> names;
  for (int k = 0; k < 100; ++k) names.push_back("element " + std::to_string(k));
  const StoreTable table = table_of("key", names);
  const std::vector<CachedRow> rows = some_rows(100, 5);
  open_factor_store(folder / "s")->keep(table, 1, rows);
  const std::string whole = bytes_of(folder / "s");
  std::mt19937_64 random(4);
  int found = 0, refused = 0, without_effect = 0;
  for (int k = 0; k < 1000; ++k) {
    std::string bytes = whole;
    bytes[k < 100 ? static_cast<std::size_t>(k) : random() % bytes.size()] ^= static_cast<char>(1 + random() % 255);
    for (const char* rest : {"t-wal", "t-shm", "t-journal"}) fs::remove(folder / rest);
    std::ofstream(folder / "t", std::ios::binary) << bytes;
    try {
      const auto store = open_factor_store(folder / "t");
      std::size_t read = 0;
      for (const CachedRows& kept : store->read(table, 1))
        for (const CachedRow& row : kept.rows) {
          ASSERT_LT(row.row, rows.size());
          EXPECT_EQ(row, rows[row.row]);
          ++read;
        }
      EXPECT_LE(read, rows.size());
      ++(read < rows.size() ? found : without_effect);
      if (read < rows.size()) {
        store->keep(table, 1, rows);
        const auto again = store->read(table, 1);
        std::size_t back = 0;
        for (const CachedRows& kept : again) back += kept.rows.size();
        EXPECT_GE(back, rows.size());
      }
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find((folder / "t").string()), std::string::npos) << error.what();
      ++refused;
    }
  }
  std::printf("of 1000 changed bytes %d cost a row, %d the file, %d were without effect\n", found, refused,
              without_effect);
  EXPECT_GT(found, 300);
}

TEST(FactorStore, RefusesFilesThatAreNone) {
  const TemporaryFolder folder;
  const auto why = [&](const std::string& name) -> std::string {
    try {
      open_factor_store(folder / name);
    } catch (const InputError& error) {
      return error.what();
    } catch (const OutputError& error) {
      return error.what();
    }
    return "";
  };
  std::ofstream(folder / "text")
      << "a text that is long enough for a header, and is no store of factors at all: refuse "
         "it, and leave it as it is.\n";
  const std::string text = bytes_of(folder / "text");
  EXPECT_NE(why("text").find("text: is no store of factors"), std::string::npos) << why("text");
  EXPECT_EQ(bytes_of(folder / "text"), text);
  std::ofstream(folder / "short") << "x";
  EXPECT_NE(why("short").find("is no store of factors"), std::string::npos);
  std::string foreign = "SQLite format 3";
  foreign.resize(8192, '\0');
  std::ofstream(folder / "foreign", std::ios::binary) << foreign;
  EXPECT_NE(why("foreign").find("is no store of factors"), std::string::npos);
  EXPECT_EQ(bytes_of(folder / "foreign"), foreign);
  fs::create_directory(folder / "folder");
  EXPECT_NE(why("folder").find("is a directory"), std::string::npos);
  EXPECT_NE(why("no/such/folder").find("cannot be written"), std::string::npos) << why("no/such/folder");
  EXPECT_THROW(store_contents(folder / "missing", false), InputError);
  EXPECT_FALSE(fs::exists(folder / "missing"));
  std::ofstream(folder / "empty").flush();
  EXPECT_EQ(why("empty"), "");
  std::ofstream(folder / "cut", std::ios::binary) << bytes_of(folder / "empty").substr(0, 5000);
  EXPECT_NE(why("cut").find("cut: is a damaged store of factors"), std::string::npos) << why("cut");
}

// Two processes that make a store at once: one of them is still at it when the other comes.
TEST(FactorStore, WaitsForWhomMakesIt) {
  const TemporaryFolder folder;
  const fs::path file = folder / "s";
  open_factor_store(file);
  sqlite3* other = nullptr;
  ASSERT_EQ(sqlite3_open(file.c_str(), &other), SQLITE_OK);
  ASSERT_EQ(sqlite3_exec(other, "PRAGMA journal_mode = DELETE; BEGIN IMMEDIATE", nullptr, nullptr, nullptr), SQLITE_OK);
  std::atomic<bool> is_made = false;
  std::thread maker([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    is_made = true;
    // Where the other one looks at the file just now, it is refused, and asks again.
    while (sqlite3_exec(other, "COMMIT", nullptr, nullptr, nullptr) == SQLITE_BUSY) std::this_thread::yield();
  });
  EXPECT_NO_THROW(open_factor_store(file));
  EXPECT_TRUE(is_made);
  maker.join();
  sqlite3_close(other);
}

TEST(FactorStore, HasManyReadersAndWritersAtOnce) {
  const TemporaryFolder folder;
  const std::vector<CachedRow> rows = some_rows(5, 9);
  std::vector<std::thread> threads;
  std::atomic<int> wrong{0};
  for (int t = 0; t < 6; ++t)
    threads.emplace_back([&, t] {
      try {
        for (int k = 0; k < 10; ++k) {
          const auto store = open_factor_store(folder / "s");
          store->keep(table_of("key " + std::to_string(t % 3), kElements), 0, rows);
          for (const CachedRows& kept : store->read(table_of("key " + std::to_string((t + 1) % 3), kElements), 0))
            for (const CachedRow& row : kept.rows)
              if (row != rows[row.row]) ++wrong;
        }
      } catch (const std::exception& error) {
        std::printf("%s\n", error.what());
        ++wrong;
      }
    });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(wrong, 0);
  const StoreContents contents = store_contents(folder / "s", true);
  EXPECT_EQ(contents.damage.size(), 0U);
  EXPECT_EQ(contents.lists.size(), 3U);
}

}  // namespace
}  // namespace hottel::factor_store_test
