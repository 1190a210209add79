#include "io/results/space/element_files.h"

#include <fmt/format.h>

#include <array>
#include <string>
#include <vector>

#include "geometry/scene_names.h"
#include "io/results/csv_field.h"
#include "kernel/rational.h"
#include "kernel/support/failure.h"
#include "kernel/written_double.h"

namespace hottel {
namespace {

std::string number(double value, const char* what, const Element& element) {
  require_double(value, fmt::format("{} of '{}'", what, element.name));
  return shortest(value);
}

std::string points_text(const WrittenLoop3& corners, const Element& element) {
  std::string text;
  for (const std::array<double, 3>& corner : corners) {
    if (!text.empty()) text += ';';
    for (std::size_t a = 0; a < 3; ++a) text += (a > 0 ? " " : "") + number(corner[a], "a coordinate", element);
  }
  return text;
}

std::string points_text(const WrittenOutline3& outline, const Element& element) {
  std::string text;
  for (const std::vector<WrittenLoop3>& part : outline) {
    if (!text.empty()) text += "||";
    for (const WrittenLoop3& loop : part) text += (&loop == part.data() ? "" : "|") + points_text(loop, element);
  }
  return text;
}

}  // namespace

void write_faces_csv_3(const FactorTable& table, std::span<const WrittenOutline3> outlines, const Sink& sink) {
  const ExchangeMatrix& matrix = table.matrix;
  HOTTEL_REQUIRE(outlines.size() == matrix.size());
  std::string text = "index,face,element,area,material,points\n";
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    const Element& element = matrix.elements()[i];
    const std::string face = table.granularity == Granularity::kGroup
                                 ? element.name
                                 : face_name(table.scene, {element.surface, element.is_back});
    text += fmt::format("{},{},{},{},{},{}\n", i + 1, csv_field(face), element.node().text(),
                        number(written_double(element.area), "the area", element),
                        element.material ? csv_field(table.scene.materials[*element.material].name) : "",
                        points_text(outlines[i], element));
  }
  sink(text + fmt::format("{},sky,0,,,\n", matrix.size() + 1));
}

}  // namespace hottel
