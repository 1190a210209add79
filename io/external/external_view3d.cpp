// View3D's output: areas, factors by rows, emittances of the surfaces that radiate (SaveF0 and SaveF1 of its savevf.c).
#include <cmath>
#include <cstring>
#include <limits>

#include "io/external/external_file.h"
#include "io/external/external_number.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

// `View3D VERSION FORMAT ENCLOSURE EMITTANCES COUNT`
struct View3dHead {
  bool is_binary = false, is_normalised = false;
  std::uint32_t count = 0;
  std::string_view body;
};

View3dHead read_view3d_head(const std::string& file, std::string_view text) {
  const auto refuse = [&](const std::string& what) { throw InputError({file, 1}, what); };
  const std::size_t end = text.find('\n');
  if (end == std::string_view::npos) refuse("breaks off in View3D's first line");
  View3dHead head;
  head.body = text.substr(end + 1);
  ExternalWords words(text.substr(0, end));
  words.next();  // View3D
  if (!words.next()) refuse("View3D's first line has no version");
  const ExternalNumbers numbers(file);
  const auto flag = [&](const char* what, std::uint64_t most) {
    if (!words.next()) refuse("View3D's first line breaks off: six words are expected");
    return numbers.read_count(words.word(), 0, most, what, 1);
  };
  head.is_binary = flag("View3D's format (0 text, 1 binary)", 1) == 1;
  head.is_normalised = flag("View3D's mark of an enclosure", 1) == 1;
  if (flag("View3D's mark of emittances", 1) == 1)
    throw InputError({file, 1}, "holds Hottel's script-F, not view factors",
                     {"View3D counted the emittances in (emit = 1); run it with emit = 0"});
  head.count = flag("View3D's number of surfaces", std::numeric_limits<std::int32_t>::max());
  if (head.count == 0) refuse("View3D's file has no surfaces");
  return head;
}

// What numbers there are, in the order of the file: COUNT areas, COUNT rows, COUNT emittances.
template <class Next>
void take_numbers(ExternalMatrix& matrix, const Next& next) {
  const std::uint32_t n = matrix.rows;
  for (std::uint32_t i = 0; i < n; ++i) matrix.areas.push_back(next(0).value);
  for (std::uint32_t i = 0; i < n; ++i)
    for (std::uint32_t j = 0; j < n; ++j) {
      ExternalEntry entry = next(1);
      entry.row = i;
      entry.column = j;
      if (entry.value != 0) matrix.entries.push_back(entry);
    }
  for (std::uint32_t i = 0; i < n; ++i) next(2);
}

void read_text(const View3dHead& head, ExternalMatrix& matrix) {
  ExternalNumbers factors(matrix.file), others(matrix.file);
  ExternalWords words(head.body, 2);
  take_numbers(matrix, [&](int part) {
    if (!words.next())
      throw InputError({matrix.file, words.line()},
                       "breaks off: View3D's text of " + std::to_string(head.count) + " surfaces has more numbers");
    return ExternalEntry{0, 0, words.line(), (part == 1 ? factors : others).read(words.word(), words.line())};
  });
  if (words.next())
    throw InputError({matrix.file, words.line()},
                     "goes on after the emittances of " + std::to_string(head.count) + " surfaces");
  matrix.digits = factors.digits();
}

void read_binary(const View3dHead& head, ExternalMatrix& matrix) {
  const std::uint64_t n = head.count;
  const std::uint64_t expected = (n * n + 2 * n) * sizeof(float);  // n < 2^31: no overflow
  if (head.body.size() != expected)
    throw InputError({matrix.file, 0}, "has " + std::to_string(head.body.size()) + " bytes after the first line; " +
                                           std::to_string(n) + " surfaces need " + std::to_string(expected));
  std::size_t at = 0;
  take_numbers(matrix, [&](int part) {
    float value = 0;
    std::memcpy(&value, head.body.data() + at, sizeof value);
    at += sizeof value;
    if (!std::isfinite(value)) {
      const std::uint64_t place = at / sizeof value - 1 - n;
      throw InputError({matrix.file, 0}, part == 1
                                             ? "the factor in row " + std::to_string(place / n + 1) + ", column " +
                                                   std::to_string(place % n + 1) + " is not a finite number"
                                             : std::string("an area or emittance is not a finite number"));
    }
    return ExternalEntry{0, 0, 0, value};
  });
  matrix.digits.relative = std::ldexp(1.0, -24);
}

}  // namespace

ExternalMatrix read_view3d(const std::string& file, std::string_view text) {
  const View3dHead head = read_view3d_head(file, text);
  ExternalMatrix matrix;
  matrix.file = file;
  matrix.rows = matrix.columns = head.count;
  if (head.is_normalised)
    matrix.notes.push_back("View3D has rescaled the rows to sum to 1 (encl = 1): row sums say nothing of accuracy");
  if (head.is_binary)
    read_binary(head, matrix);
  else
    read_text(head, matrix);
  return matrix;
}

}  // namespace hottel
