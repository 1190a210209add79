// Lists of points in space that others write.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/space/point.h"
#include "io/external/csv_reader.h"

namespace hottel {

// Whether a text is a csv whose first line has three fields; if these are words, x,y,z.
bool are_points_3(std::string_view text);

// Reads the points of a csv of lines x,y,z, in its order, exactly as typed: a number is an integer, a decimal or p/q,
// blanks about it do not count, and a first line x,y,z is allowed. Some at a time: a rational takes ten times the
// memory of its text.
//
// Throws InputError with file and line for a line with another number of fields, and a number that is none.
class PointReader3 {
 public:
  // REQUIRES that `text` outlives this.
  PointReader3(std::string_view text, const std::string& name_for_messages);

  // Returns the next points, fewer than `most` only at the end.
  std::vector<Point3> next(std::size_t most);

 private:
  CsvReader reader_;
  bool is_first_ = true;
};

// Returns how many points there are. Throws InputError as PointReader3 does for any of them, and where there is none.
// COST: linear; no memory.
std::size_t count_points_3(std::string_view text, const std::string& name_for_messages);

}  // namespace hottel
