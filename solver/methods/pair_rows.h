// Matrices of methods that look at two elements at a time.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "geometry/exchange_matrix.h"
#include "solver/compare/method_report.h"

namespace hottel {

// The factors between two elements, both ways.
struct PairFactors {
  double forth = 0, back = 0;
};

// What is asked of a method, by several threads at once.
struct PairsOfElements {
  // Appends every element j > i whose factors with i may not be 0; others too, and in any order.
  std::function<void(std::uint32_t i, std::vector<std::uint32_t>& partners)> append_partners;
  // The factors of elements i < j of which one at least has a row.
  std::function<PairFactors(std::uint32_t i, std::uint32_t j)> factors;
};

// Returns F(from, to) of two different elements by these pairs, whose geometry is kept alive.
template <class Geometry>
std::function<double(std::uint32_t, std::uint32_t)> one_way(const PairsOfElements& pairs,
                                                            std::shared_ptr<const Geometry> geometry) {
  return [factors = pairs.factors, geometry = std::move(geometry)](std::uint32_t from, std::uint32_t to) {
    return from < to ? factors(from, to).forth : factors(to, from).back;
  };
}

// Partners by source->append_partners(i, partners).
template <class Source>
auto partners_of(std::shared_ptr<const Source> source) {
  return [source](std::uint32_t i, std::vector<std::uint32_t>& partners) { source->append_partners(i, partners); };
}

// Which elements there are, and which of them have a row, and border the open space.
struct PairRows {
  const std::vector<Element>& elements;
  std::function<bool(std::uint32_t)> has_row;
  std::vector<char> is_open;
};

// Returns the estimated matrix of a method that looks at pairs; fills MethodReport::row_defect.
//
//   (1) each pair is asked for once, both factors together; an entry for each that is above 0
//   (2) what a row lacks of 1 goes to the sky where its element borders open space; other rows, and those above 1, stay
//   (3) the matrix is the same bit for bit for any number of threads
// COST: parallel over elements. Stops when it is interrupted. progress: as matrix_by_rows() takes it.
ExchangeMatrix matrix_of_pairs(const PairRows& rows, const PairsOfElements& pairs,
                               const std::function<void(double)>& progress, MethodReport& report);

}  // namespace hottel
