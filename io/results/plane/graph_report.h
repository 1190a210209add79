// The visibility graph of a scene as csv and as JSON.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "geometry/plane/visibility/visibility_graph.h"

namespace hottel {

enum class GraphFormat2 { kCsv, kExactCsv, kJson };

// Writes visible pairs through a sink as they come.
//
//   (1) csv: `vertex0,vertex1,x0,y0,x1,y1,length,along,surface0,surface1`, one line a pair. along: the first listed
//       surface on the segment between the vertices, else empty; surface0, surface1: what each vertex is of
//       (graph_vertices). Coordinates are the nearest doubles, or p/q in kExactCsv; the length is the nearest double
//   (2) JSON: one object with `vertices`, all of them by number, and `pairs`
//
// Throws RequestError where a coordinate or a length is beyond the range of doubles (a coordinate unless kExactCsv).
class GraphWriter2 {
 public:
  // REQUIRES that the scene outlives it.
  GraphWriter2(const PreparedScene2& prepared, GraphFormat2 format, std::function<void(std::string_view)> sink);
  ~GraphWriter2();

  void add(std::span<const VisiblePair2> pairs);
  void finish();

  // What was written, in a sentence: how many vertices and pairs, how many of these along edges, and which vertices are
  // crossings.
  std::string summary() const;

 private:
  struct Labels;
  std::string point(const GraphVertex2& vertex) const;
  std::string pair_as_csv(const VisiblePair2& pair) const;
  std::string pair_as_json(const VisiblePair2& pair) const;
  std::string along(const VisiblePair2& pair) const;
  void write_vertices();

  const PreparedScene2& prepared_;
  const GraphFormat2 format_;
  const std::function<void(std::string_view)> sink_;
  const std::unique_ptr<const Labels> labels_;
  std::size_t pairs_ = 0, along_ = 0;
};

}  // namespace hottel
