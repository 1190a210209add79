// The variants of the method `vertices`.
#pragma once

#include <string>
#include <string_view>

namespace hottel {

// Pairs of vertices nearer than this are dropped, in halves of the diagonal of the bounding box.
inline constexpr double kNearestVertices = 0.005;

struct VertexVariant {
  bool is_literal = false;     // as the source writes it: the constant of the kernel is lost
  bool tests_centres = false;  // V = 1 iff the centres see each other, else iff S > 0

  // "", ":literal", ":centroid" or ":literal:centroid".
  std::string suffix() const {
    return std::string(is_literal ? ":literal" : "") + std::string(tests_centres ? ":centroid" : "");
  }
};

// The variant with that suffix. Throws UsageError where there is none.
VertexVariant vertex_variant(std::string_view suffix);

}  // namespace hottel
