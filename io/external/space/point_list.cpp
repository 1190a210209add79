#include "io/external/space/point_list.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "io/external/csv_reader.h"
#include "kernel/support/failure.h"
#include "kernel/support/lower_case.h"

namespace hottel {
namespace {

constexpr CsvDialect kTriples{.trims = true};

bool names_axes(const std::vector<std::string_view>& fields) {
  constexpr std::array<const char*, 3> kAxes{"x", "y", "z"};
  return std::ranges::equal(fields, kAxes,
                            [](std::string_view field, const char* axis) { return lower_case(field) == axis; });
}

}  // namespace

bool are_points_3(std::string_view text) {
  const std::size_t begin = text.find_first_not_of("\xEF\xBB\xBF \t\r\n");
  if (begin == std::string_view::npos) return false;
  const std::string_view line = text.substr(begin, text.find_first_of("\r\n", begin) - begin);
  return line.find_first_of("{(") == std::string_view::npos && std::ranges::count(line, ',') == 2;
}

std::vector<Point3> read_points_3(std::string_view text, const std::string& name) {
  std::vector<Point3> points;
  CsvReader reader(name, text, kTriples);
  for (bool is_first = true; reader.next(); is_first = false) {
    const auto& fields = reader.fields();
    if (fields.size() == 1 && fields[0].empty()) continue;
    if (fields.size() != 3)
      throw InputError(reader.where(),
                       "a point in space has three coordinates x,y,z, not " + std::to_string(fields.size()));
    if (is_first && names_axes(fields)) continue;
    points.push_back({exact_number(fields[0], reader.where()), exact_number(fields[1], reader.where()),
                      exact_number(fields[2], reader.where())});
  }
  if (points.empty()) throw InputError({name, 0}, "there is no point in it");
  return points;
}

}  // namespace hottel
