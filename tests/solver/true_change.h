// What dividing once more does change, to hold the estimate of it against.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "solver/compare/face_means.h"
#include "solver/dividing/cut_elements.h"
#include "solver/dividing/dividing_estimate.h"

namespace hottel::testing_dividing {

// An estimate over the truth: of the channel in which most changes.
struct Ratios {
  double pointwise = 0;
  std::optional<double> face_means{};
};

// For each element of a finer division the element that it lies in, by places along the edge or in the polygon.
template <class IsIn>
std::vector<std::uint32_t> elements_around_by(const ExchangeMatrix& fine, const ExchangeMatrix& coarse,
                                              const IsIn& is_in) {
  std::vector<std::uint32_t> result;
  for (const Element& part : fine.elements()) {
    std::uint32_t i = 0;
    while (i < coarse.size() && !is_in(part, coarse.elements()[i])) ++i;
    result.push_back(i);
  }
  return result;
}

// around: of each fine element the coarse one.
inline Ratios ratios(const DividingEstimate& estimate, const ExchangeMatrix& coarse, const RadiositySolution& before,
                     const ExchangeMatrix& fine, const RadiositySolution& after,
                     const std::vector<std::uint32_t>& around) {
  Ratios result;
  double most = 0, most_of_means = 0;
  const FaceMeans means = face_mean_radiosities(coarse, before), finer = face_mean_radiosities(fine, after);
  for (std::size_t c = 0; c < before.channels.size(); ++c) {
    double sum = 0, area = 0;
    for (std::uint32_t i = 0; i < fine.size(); ++i) {
      if (!fine.has_row(i)) continue;
      const double a = fine.elements()[i].area.value;
      const double change = after.channels[c].elements[i].radiosity - before.channels[c].elements[around[i]].radiosity;
      sum += a * change * change;
      area += a;
    }
    const double rms = std::sqrt(sum / area);
    if (rms > most) {
      most = rms;
      result.pointwise = *estimate.channels[c].pointwise / rms;
    }
    double change = 0;
    for (std::size_t face = 0; face < means[c].size(); ++face)
      if (means[c][face] && finer[c][face]) change = std::max(change, std::abs(*means[c][face] - *finer[c][face]));
    if (change > most_of_means && estimate.channels[c].face_means) {
      most_of_means = change;
      result.face_means = *estimate.channels[c].face_means / change;
    }
  }
  return result;
}

// In the plane, where parts are intervals.
inline Ratios ratios(const DividingEstimate& estimate, const ExchangeMatrix& coarse, const RadiositySolution& before,
                     const ExchangeMatrix& fine, const RadiositySolution& after) {
  const auto is_in = [](const Element& part, const Element& whole) {
    return part.surface == whole.surface && part.is_back == whole.is_back &&
           std::uint64_t{part.part} * whole.parts / part.parts == whole.part;
  };
  return ratios(estimate, coarse, before, fine, after, elements_around_by(fine, coarse, is_in));
}

// The same elements, areas and factors but for their last digits; names are not compared where a face is one element.
inline void expect_same_matrix(const ExchangeMatrix& a, const ExchangeMatrix& b, double error) {
  ASSERT_EQ(a.size(), b.size());
  for (std::uint32_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a.name(i), b.name(i));
    EXPECT_NEAR(a.elements()[i].area.value, b.elements()[i].area.value, error * b.elements()[i].area.value);
    for (std::uint32_t j = 0; j <= a.size(); ++j)
      EXPECT_NEAR(a.factor(i, j).value, b.factor(i, j).value, error) << a.name(i) << " to " << a.name(j);
  }
}

}  // namespace hottel::testing_dividing
