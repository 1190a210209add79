#include "io/external/space/point_list.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <utility>

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
  if (line.find_first_of("{(") != std::string_view::npos || std::ranges::count(line, ',') != 2) return false;
  CsvReader reader("", line, kTriples);
  return std::isalpha(static_cast<unsigned char>(line.front())) == 0 || (reader.next() && names_axes(reader.fields()));
}

PointReader3::PointReader3(std::string_view text, const std::string& name) : reader_(name, text, kTriples) {}

std::vector<Point3> PointReader3::next(std::size_t most) {
  std::vector<Point3> points;
  while (points.size() < most && reader_.next()) {
    const bool may_be_head = std::exchange(is_first_, false);
    const auto& fields = reader_.fields();
    if (fields.size() == 1 && fields[0].empty()) continue;
    if (fields.size() != 3)
      throw InputError(reader_.where(),
                       "a point in space has three coordinates x,y,z, not " + std::to_string(fields.size()));
    if (may_be_head && names_axes(fields)) continue;
    points.push_back({exact_number(fields[0], reader_.where()), exact_number(fields[1], reader_.where()),
                      exact_number(fields[2], reader_.where())});
  }
  return points;
}

std::size_t count_points_3(std::string_view text, const std::string& name) {
  constexpr std::size_t kSome = 1024;
  PointReader3 reader(text, name);
  std::size_t count = 0;
  for (std::size_t read = kSome; read == kSome; count += read) read = reader.next(kSome).size();
  if (count == 0) throw InputError({name, 0}, "there is no point in it");
  return count;
}

}  // namespace hottel
