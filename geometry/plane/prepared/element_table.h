// Which element each side of each piece belongs to, and what is known of the elements before anything is seen.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/element.h"
#include "geometry/plane/arrangement/arrangement.h"
#include "geometry/plane/scene/scene.h"
#include "kernel/rounding.h"

namespace hottel {

// The elements of an arrangement in the order of the contract: surfaces in the order of the scene, front before
// back, parts ascending, and leaves of trees under them.
//
//   (1) every side of every piece belongs to one element, or is covered; the sky has a number too, sky()
//   (2) the length of an element is that of the pieces it owns: parts that other surfaces own or that look into a
//       solid do not count, and an element that owns nothing has length 0 and no row
//   (3) Granularity::kGroup: all fronts of a group are one element and all its backs another; elements of one surface
//       are never in two
//   (4) Element::area is the length in metres, correctly rounded, where the unit of the scene is known; else in that
//
// COST: linear in the sides of pieces.
class ElementTable2 {
 public:
  ElementTable2(const Scene2& scene, const Arrangement2& arrangement, const Division2& division,
                Granularity granularity);

  std::uint32_t count() const { return static_cast<std::uint32_t>(elements_.size()); }
  std::uint32_t sky() const { return count(); }
  // The label of sides that belong to no element: they look into a solid. It has no row.
  std::uint32_t covered() const { return count() + 1; }
  const std::vector<Element>& elements() const { return elements_; }

  // Returns the element of a side, covered(), or sky() for kSky. REQUIRES: not kNoPiece.
  std::uint32_t of(PieceSideId side) const { return of_side_[place_after_sky(side)]; }
  // True iff the element has a material and an area: only then are factors from it computed.
  bool has_row(std::uint32_t label) const { return labels_[label].has_row; }
  // Takes the rows of all elements but those chosen, one for each element: the others are columns from now on.
  void keep_rows(const std::vector<bool>& is_chosen);

  // The table of elements i and j alone, with the numbers 0 and 1 (0 alone where j is i), on an arrangement of some
  // pieces. Sides of all other elements are covered.
  // REQUIRES: `pieces` ascend, and `arrangement_of_pieces` is what Arrangement2::restricted_to makes of them.
  ElementTable2 restricted_to(std::uint32_t i, std::uint32_t j, const std::vector<std::uint32_t>& pieces,
                              const Arrangement2& arrangement_of_pieces) const;

  // The element's straight runs: its owned pieces, joined where they follow each other on one line, front on the
  // right. There are none where the element has no length.
  std::span<const Segment2> runs(std::uint32_t label) const {
    return {runs_.data() + runs_begin_[label], runs_.data() + runs_begin_[label + 1]};
  }
  // Which of two vertices are ends of the element, where it is one run: 1 for v, 2 for w, 3 for both; 0 else, and for
  // what is no element.
  unsigned ends_among(std::uint32_t label, VertexId v, VertexId w) const {
    const Label& l = labels_[label];
    const auto is_end = [&l](VertexId u) { return unsigned{l.from == u} | unsigned{l.to == u}; };
    return is_end(v) | is_end(w) << 1;
  }

  // Sum of the lengths of the owned pieces, in units of Vertices2::fixed_unit().
  const FixedSum& length(std::uint32_t label) const { return length_[label]; }
  // The same as a sum of square roots; 0 where the element owns nothing. REQUIRES: the vertices of the arrangement.
  RootSum exact_length(std::uint32_t label, const Vertices2& vertices) const;  // in integer form

 private:
  ElementTable2() = default;
  void measure(const Arrangement2& arrangement);
  void find_runs(const Arrangement2& arrangement);

  std::vector<Element> elements_;
  std::vector<std::uint32_t> of_side_;  // by place_after_sky
  bool are_straight_ = true;
  Rational metres_ = 1;  // of a scene unit
  std::vector<Segment2> runs_;
  std::vector<std::size_t> runs_begin_;
  // What a sweep asks at every term. Ends are none where the element is not one run.
  struct Label {
    VertexId from, to;
    bool has_row;
  };
  std::vector<Label> labels_;  // two more than elements: the sky and what is covered have neither rows nor ends
  std::vector<FixedSum> length_;
};

}  // namespace hottel
