// What must hold of a scene, whatever touches what.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "geometry/exchange/exchange_2.h"
#include "tests/oracle/split_2.h"

namespace hottel::storm {

using Edges = std::vector<oracle::InputSegment>;

// Everything printed of a scene, down to the last bit. Labels: 2 k the front of edge k, 2 k + 1 its back; last the sky.
using Numbers = std::map<std::pair<std::uint32_t, std::uint32_t>, std::tuple<double, int, double>>;

// A scene under test, with what is computed of it once.
class Subject {
 public:
  // `chance` is what laws draw from: a permutation, a place to cut.
  Subject(const Edges& edges, std::uint64_t chance);

  const Edges& edges() const { return edges_; }
  std::uint64_t chance() const { return chance_; }
  const ExchangeMatrix& matrix() const { return matrix_; }
  const ExchangeReport& report() const { return report_; }
  const Numbers& numbers() const { return numbers_; }

 private:
  Edges edges_;
  std::uint64_t chance_;
  ExchangeReport report_;
  ExchangeMatrix matrix_;
  Numbers numbers_;
};

// A law, with how to tell where it is broken.
struct Law {
  const char* name;
  std::string (*broken)(const Subject& subject);  // what is wrong, or nothing
  unsigned every;                                 // tried in one of so many scenes
};

// The laws, in order.
//
//   closure       sum over j of 2 S(i, j) = 2 A_i as an identity of integers, in every row
//   range         S(i, j) = S(j, i) bit for bit, 0 < F, 0 < Vis <= 1, rows of doubles sum to 1 within rounding
//   translation   all doubles are the same for x + 2^53 + 1, y - 2^60 + 7
//   scaling       all doubles are the same for 2^20 x
//   rotation      by 90 degrees
//   reflection    about the y axis, edges listed from the other end
//   reversal      each edge with two materials listed from the other end: fronts and backs change places
//   permutation   in another order: between faces that overlap no other edge nothing changes
//   splitting     an edge cut in its middle: S of its parts adds up to S, as exact sums
//   radiosity     the true radiosities, to 100 digits, lie within their bounds
//   brute force   every pair is the same exact sum, every double the nearest one, as the oracle has it
const std::vector<Law>& laws();

}  // namespace hottel::storm
