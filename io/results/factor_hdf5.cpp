#include "io/results/factor_hdf5.h"

#include <algorithm>
#include <cstdint>
#include <vector>

#include "geometry/unit_of_length.h"
#include "io/files/hdf5.h"
#include "io/results/listed_factors.h"
#include "kernel/version.h"
#include "kernel/written_double.h"

namespace hottel {
namespace {

constexpr std::uint32_t kLayout = 1;

// What is guaranteed of an entry, as one number: of exact ones on which side of the double the real number lies.
constexpr std::int8_t kEnclosedCode = 2, kEstimatedCode = 3;

std::int8_t code_of(const FactorEntry& entry, Guarantee guarantee) {
  if (guarantee == Guarantee::kExact) return entry.factor.side;
  return guarantee == Guarantee::kEnclosed ? kEnclosedCode : kEstimatedCode;
}

// Where rows begin, the sky last and empty, and whether bounds say more than the codes do.
struct RowOutline {
  std::vector<std::uint64_t> begin;
  bool has_bounds = false;
};

RowOutline outline_of(const FactorTable& table) {
  RowOutline outline;
  outline.begin.assign(1, 0);
  for (const std::uint64_t count : listed_counts(table)) outline.begin.push_back(outline.begin.back() + count);
  outline.begin.push_back(outline.begin.back());
  if (table.matrix.guarantee() == Guarantee::kExact) return outline;
  for_each_listed(table, [&](std::uint32_t, const FactorEntry&, const Enclosure& bounds, Guarantee guarantee) {
    outline.has_bounds = outline.has_bounds || (guarantee != Guarantee::kExact && bounds != Enclosure{0, 1});
  });
  return outline;
}

void say_origin(const FactorTable& table, const FactorOrigin& origin, Hdf5Writer& file) {
  file.say("format", "hottel view factors");
  file.say("layout", kLayout);
  file.say("hottel", kVersion);
  file.say("quantity", table.gray_channel ? "script-F" : "view factor");
  file.say("method", origin.method);
  file.say("dimension", static_cast<std::uint32_t>(origin.dimension));
  file.say("per", table.granularity == Granularity::kElement ? "element"
                  : table.granularity == Granularity::kGroup ? "group"
                                                             : "face");
  file.say("rows", table.only_rows.empty() ? "all" : "chosen");
  file.say("area_unit", (has_known_unit(table.scene) ? "m" : table.scene.unit) + (origin.dimension == 3 ? "²" : ""));
}

// Some entries, each of their numbers in an array of its own.
struct EntryBlock {
  std::vector<std::uint32_t> columns;
  std::vector<double> factors, lower, upper;
  std::vector<std::int8_t> codes;

  void push_back(const FactorEntry& entry, const Enclosure& bounds, Guarantee guarantee) {
    columns.push_back(entry.to);
    factors.push_back(entry.factor.value);
    codes.push_back(code_of(entry, guarantee));
    lower.push_back(bounds.lower);
    upper.push_back(bounds.upper);
  }
  void hand_on(bool has_bounds, Hdf5Writer& file) {
    const auto append = [&file](const char* name, auto& values) {
      file.append(name, values.data(), values.size());
      values.clear();
    };
    append("column", columns);
    append("factor", factors);
    append("guarantee", codes);
    if (has_bounds) {
      append("lower", lower);
      append("upper", upper);
    }
    lower.clear();
    upper.clear();
  }
};

void write_entries(const FactorTable& table, bool has_bounds, Hdf5Writer& file) {
  constexpr std::size_t kAtOnce = 1 << 14;
  EntryBlock block;
  for_each_listed(table, [&](std::uint32_t, const FactorEntry& entry, const Enclosure& bounds, Guarantee guarantee) {
    block.push_back(entry, bounds, guarantee);
    if (block.columns.size() == kAtOnce) block.hand_on(has_bounds, file);
  });
  block.hand_on(has_bounds, file);
}

void write_faces(const FactorTable& table, Hdf5Writer& file) {
  const std::uint32_t count = table.matrix.size() + 1;
  std::vector<std::string> names;
  std::vector<double> areas;
  for (std::uint32_t i = 0; i < count; ++i) {
    names.push_back(table.matrix.name(i));
    areas.push_back(i == table.matrix.sky() ? 0 : written_double(table.matrix.elements()[i].area));
  }
  file.write_texts("names", names);
  file.begin("area", Hdf5Number::kFloat64, count);
  file.append("area", areas.data(), areas.size());
}

}  // namespace

void write_factors_hdf5(const FactorTable& table, const FactorOrigin& origin, const OutputFile& out) {
  require_hdf5(out.name());
  const RowOutline outline = outline_of(table);
  const std::uint64_t count = outline.begin.back();
  Hdf5Writer file(out.place(), out.name());
  say_origin(table, origin, file);
  file.begin("begin", Hdf5Number::kUint64, outline.begin.size());
  file.append("begin", outline.begin.data(), outline.begin.size());
  file.begin("column", Hdf5Number::kUint32, count);
  file.begin("factor", Hdf5Number::kFloat64, count);
  file.begin("guarantee", Hdf5Number::kInt8, count);
  file.say_of("guarantee", "meaning",
              "-1, 0, 1: exact, the real number below, at, above the double and before the next one; 2: enclosed by "
              "lower and upper; 3: estimated, within lower and upper, or 0 and 1 where there are none");
  if (outline.has_bounds)
    for (const char* bound : {"lower", "upper"}) file.begin(bound, Hdf5Number::kFloat64, count);
  write_entries(table, outline.has_bounds, file);
  write_faces(table, file);
  file.write_text("scene", origin.scene);
  file.finish();
}

}  // namespace hottel
