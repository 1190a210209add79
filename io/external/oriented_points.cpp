#include "io/external/oriented_points.h"

#include <algorithm>
#include <cstddef>

#include "io/external/csv_reader.h"
#include "kernel/support/failure.h"
#include "kernel/support/lower_case.h"

namespace hottel {
namespace {

constexpr CsvDialect kPointsDialect{.trims = true};

std::string joined(const std::vector<std::string_view>& fields) {
  std::string line;
  for (const std::string_view field : fields) line += (line.empty() ? "" : ",") + lower_case(field);
  return line;
}

OrientedPoint point_in(const CsvReader& reader, std::size_t dimension) {
  const auto& fields = reader.fields();
  if (fields.size() != 2 * dimension)
    throw InputError(reader.where(), "a point and its normal are " + std::to_string(2 * dimension) + " numbers, not " +
                                         std::to_string(fields.size()));
  OrientedPoint result;
  for (std::size_t k = 0; k < dimension; ++k) {
    result.point[k] = exact_number(fields[k], reader.where());
    result.normal[k] = exact_number(fields[dimension + k], reader.where());
  }
  if (std::ranges::all_of(result.normal, [](const Rational& number) { return number == 0; }))
    throw InputError(reader.where(), "the normal of a point is zero: it looks no way");
  return result;
}

}  // namespace

bool names_normals(std::string_view text) {
  const std::size_t begin = text.find_first_not_of("\xEF\xBB\xBF \t\r\n");
  if (begin == std::string_view::npos) return false;
  const std::string_view line = text.substr(begin, text.find_first_of("\r\n", begin) - begin);
  if (line.empty() || line.front() == '{' || line.find('(') != std::string_view::npos) return false;
  return lower_case(line).find("nx") != std::string::npos;
}

std::vector<OrientedPoint> read_oriented_points(std::string_view text, const std::string& name, int dimension) {
  const std::string expected = dimension == 2 ? "x,y,nx,ny" : "x,y,z,nx,ny,nz";
  CsvReader reader(name, text, kPointsDialect);
  if (!reader.next() || joined(reader.fields()) != expected)
    throw InputError(reader.where(), "the first line of points with normals is " + expected + " in " +
                                         (dimension == 2 ? "the plane" : "space") + ", not " + joined(reader.fields()));
  std::vector<OrientedPoint> points;
  while (reader.next()) points.push_back(point_in(reader, static_cast<std::size_t>(dimension)));
  if (points.empty()) throw InputError({name, 0}, "there is no point in it");
  return points;
}

}  // namespace hottel
