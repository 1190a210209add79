#include "solver/methods/vertex_variant.h"

#include "kernel/support/failure.h"

namespace hottel {

VertexVariant vertex_variant(std::string_view suffix) {
  for (const bool is_literal : {false, true})
    for (const bool tests_centres : {false, true})
      if (const VertexVariant one{is_literal, tests_centres}; one.suffix() == suffix) return one;
  throw UsageError("the variants of vertices are centroid, literal and literal:centroid, not '" +
                   std::string(suffix.substr(1)) + "'");
}

}  // namespace hottel
