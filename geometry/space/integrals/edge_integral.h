// The integrals of Lambda along the pieces of stretches. Internal to geometry/space/exchange.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <type_traits>
#include <utility>
#include <vector>

#include "geometry/space/pieces/arc_sum.h"
#include "geometry/space/pieces/stretch_piece.h"
#include "geometry/space/pieces/wide_piece.h"

namespace hottel {

// What integrals sum up to, as doubles: the sum of moments times integrals of Lambda, and that of ways x integrals of
// Lambda, each with what it may be off, as an estimate.
struct EdgeValues3 {
  double value = 0, error = 0;
  Direction3 residual;
  double residual_error = 0;
};

// So much the arcs of one sum may take, in bytes, and those with more digits as much again.
inline constexpr std::size_t kMostBytesOfArcs3 = 4'000'000;

// The sum over pieces, each by two rules of Gauss-Legendre that are held against each other. Real is double, long
// double, LongerReal or WideReal: what cancels between edges, of needles and of what is small, needs more digits than
// it has itself.
//
//   (1) where the arcs of all pieces would take more than `most_bytes`, those that were made first are given up, and
//       made again where a part is halved. No number depends on it
template <class Real>
class EdgeIntegral3 {
 public:
  using Vector = ArcVector3<Real>;
  using Piece = std::conditional_t<std::is_same_v<Real, double>, StretchPiece3, WidePiece3<Real>>;

  // Makes the arcs of the piece of a number again: the same as they were.
  using MakeArcs = std::function<void(std::uint32_t number, Piece& piece)>;
  EdgeIntegral3(MakeArcs make_arcs, std::size_t most_bytes)
      : make_arcs_(std::move(make_arcs)), most_bytes_(most_bytes) {}

  // The way of a stretch from its beginning to its end, and its moment. Returns its number.
  std::uint32_t add_stretch(const Vector& way, const Vector& moment);
  // A piece of a stretch, divided until the rules see all that happens. It has the number of those before it.
  void add(Piece piece, std::uint32_t stretch);

  // What else the value may be off.
  void add_error(double of_value) { fixed_error_ += of_value; }

  // The residual has some length along a direction: what is left without it is told.
  void expect_residual(const Vector& direction) { expected_ = direction; }

  // Halves the worst parts until the error is within the tolerance and that of the residual within its own, or as small
  // as rounding lets them be. Starts where the last call ended.
  EdgeValues3 refine(double tolerance, double residual_tolerance);

  // Without their arcs, as it may be.
  const std::vector<Piece>& pieces() const { return pieces_; }
  // One with its arcs; until the next call.
  const Piece& with_arcs(std::uint32_t piece);
  // What each piece adds to the value.
  std::vector<double> of_pieces() const;
  std::uint32_t nodes() const { return nodes_; }

 private:
  // An interval of t within a piece, and what it adds.
  struct Part {
    std::uint32_t piece, stretch;
    double low, high;
    Vector value;
    double error, residual_error;  // what two quadratures differ by
    double rounding, residual_rounding;
  };
  struct Stretch {
    Vector way, moment;
    double way_size, moment_size;
  };

  void add_parts(std::uint32_t piece, std::uint32_t stretch, double low, double high);
  Part make_part(std::uint32_t piece, std::uint32_t stretch, double low, double high);
  void sum_up();
  void keep_arcs(std::uint32_t piece);

  MakeArcs make_arcs_;
  std::vector<Piece> pieces_;
  std::vector<char> has_arcs_;
  std::deque<std::uint32_t> with_arcs_;  // those that have arcs, as they were made
  std::size_t most_bytes_, bytes_of_arcs_ = 0;
  std::vector<Stretch> stretches_;
  std::vector<Part> parts_;
  Real value_ = 0;
  Vector residual_, expected_;
  double error_ = 0, rounding_ = 0, residual_error_ = 0, residual_rounding_ = 0;
  double fixed_error_ = 0;
  std::uint32_t nodes_ = 0;
};

}  // namespace hottel
