// The linear system of radiosity, with residuals that are proven.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "geometry/exchange_matrix.h"
#include "geometry/material.h"
#include "geometry/shared_work.h"
#include "solver/radiosity/radiosity_sources.h"
#include "solver/radiosity/scaled_ball.h"

namespace hottel {

class SharedRows;

// One number an unknown, with what is common to the unknowns of a component kept apart: x_i = constant + rest_i. Near
// reflectivity 1 the constant is huge and only differences of the rest matter; they are formed before rounding.
struct SplitVector {
  std::vector<DoubleDouble> constant;  // by component
  std::vector<DoubleDouble> rest;      // by unknown
};

// The sources of one channel. Components are independent of each other, so each has a unit of its own, 2^exponent: the
// largest emission in it or seen from it is near 1, or less where radiosities may be so much larger that they would
// leave the range of doubles. What shines elsewhere does not matter to it. Light that arrives directly and is reflected
// counts as emitted.
struct Sources {
  std::vector<ScaledBall> emission;  // by element, the sky last: E + rho D; 0 for black backs
  std::vector<int> exponent;         // of the unit, by component
  std::vector<double> largest;       // by component: the largest emission in it or seen from it, in its unit
  std::vector<char> is_lit;          // by component: some light reaches it
  std::vector<Enclosure> range;      // by component: all its radiosities lie within, in its unit

  // The emission of an element that is in the component or seen from it, in the unit of the component.
  DoubleDoubleBall emission_in(std::uint32_t component, std::uint32_t element) const {
    return emission[element].in_unit(exponent[component]);
  }
};

// Unknowns that exchange light with each other, directly or not.
struct SystemComponent {
  std::uint32_t first_element = 0;  // the first face of it, to name it
  std::uint32_t size = 0;
  bool loses = false;  // some face has reflectivity < 1 or sees the sky or a face that reflects nothing
};

// One unknown: its element, and the numbers of its equation, enclosed.
struct SystemRow {
  std::uint32_t element = 0, component = 0;
  DoubleDoubleBall reflectivity, loss;  // loss = 1 - reflectivity * (sum of the row's factors)
};

// What a residual is of: the factors as they are, or, with closed rows, any within their bounds.
enum class FactorsMeant { kAsGiven, kWithinBounds };

// What counts in the error bound of a residual. Terms may be left out, to show in tests that bounds need them.
struct ErrorTerms {
  bool factors = true;    // the factors are known to half an ulp only
  bool roundings = true;  // and the residual itself is rounded
  // kWithinBounds: what is enclosed of all factors within their bounds whose rows sum to 1. REQUIRES rows_are_closed().
  FactorsMeant meant = FactorsMeant::kAsGiven;
};

// What a residual is asked of: E - A x by rows. Without sources: -A x, with 0 for all that is known. Rows of components
// that `is_wanted` leaves out are 0.
struct ResidualQuestion {
  const Sources* sources;  // null: none
  const SplitVector& x;
  const std::vector<char>& is_wanted;
  ErrorTerms terms{};
};

// What of a system does not follow from some rows of its matrix alone.
struct SystemNumbers {
  bool rows_are_closed = false, has_negative_factors = false;
  std::vector<std::int32_t> unknown;  // by element, the sky last: as RadiositySystem::unknown()
  std::vector<SystemRow> rows;
  std::vector<SystemComponent> components;
};

// B_i = E_i + rho_i (sum_j F_ij B_j + D_i) for the channels of one reflectivity vector, in row-defect form:
//   (A x)_i = loss_i x_i + rho_i sum_j F_ij (x_i - x_j) = E_i + rho_i D_i,        loss_i = 1 - rho_i sum_j F_ij.
//
//   (1) the unknowns are the rows with rho > 0, in the order of the matrix; all else is known: black backs are 0, the
//       sky has its emission, and so have rows with rho = 0
//   (2) where rows_are_closed(), rows sum to 1 exactly, so loss_i = 1 - rho_i, from the exact reflectivity; else
//       loss_i comes from the row as it is
//   (3) components come from the pattern of F alone: F_ij > 0 or F_ji > 0
//   (4) Sources::range is that of (E_j + rho_j D_j) / (1 - rho_j), over the unknowns of a component, and of the
//       emissions of all that is known and that they see: no extremum can be elsewhere. REQUIRES a component that loses
//       light; [0, infinity] where an unknown with rho = 1 emits, and where rows are not closed
//   (5) F is the factors themselves: the double of an entry that is not exact; of one that is, the real number and its
//       double alike: what is proven holds for both. Bounds of factors enter where they are asked for
//       (ErrorTerms::meant)
// Throws RequestError where a factor is no number, ContractViolation where the matrix says that it is exact, or that
// its rows are closed, and a row cannot sum to 1. COST: about 20 ns an entry of the matrix for a residual, over all
// threads.
class RadiositySystem {
 public:
  // `reflectivity`: by material; or channel 0, 1 or 2 of the materials' spectra. REQUIRES that the matrix outlives
  // this, and that the materials of its rows index into these; throws ContractViolation otherwise.
  RadiositySystem(const ExchangeMatrix& matrix, const std::vector<Rational>& reflectivity);
  RadiositySystem(const ExchangeMatrix& matrix, const std::vector<Material>& materials, int channel)
      : RadiositySystem(matrix, in_channel(reflectivities_of(materials), channel)) {}
  // The system of these numbers, of which some rows are here and all others are empty: who has the others forms theirs.
  // Knows no absorptivity and no sources. REQUIRES that the matrix outlives this.
  RadiositySystem(const ExchangeMatrix& some_rows, SystemNumbers numbers);

  const ExchangeMatrix& matrix() const { return *matrix_; }
  // True if the matrix is exact; also if no entry is estimated and factors within their bounds may sum to
  // 1 in every row.
  bool rows_are_closed() const { return rows_are_closed_; }
  // Some factor is below 0, as only estimates may be: nothing is proven of the solution.
  bool has_negative_factors() const { return has_negative_factors_; }
  std::size_t size() const { return rows_.size(); }
  // By unknown, in the order of the matrix; components in the order of their first elements.
  const std::vector<SystemRow>& rows() const { return rows_; }
  const std::vector<SystemComponent>& components() const { return components_; }
  // Returns 1 - rho of an unknown.
  const Rational& absorptivity(const SystemRow& row) const {
    return absorptivity_[*matrix_->elements()[row.element].material];
  }
  // Returns the unknown of an element (or of the sky), -1 when it is known.
  std::int32_t unknown(std::uint32_t element) const { return unknown_[element]; }

  // The sources of one channel; those of materials and the sky are what sources_of() makes of them. REQUIRES the
  // channel of this system, or one of the same reflectivities, and as many emissions as there are elements; as many
  // direct irradiances, or none (else ContractViolation).
  Sources sources(const RadiositySources& sources, int channel) const;
  Sources sources(const std::vector<Material>& materials, const Spectrum& sky_emission, int channel) const {
    return sources(hottel::sources_of(*matrix_, materials, sky_emission), channel);
  }
  // The sources when one element (or the sky) emits 1 and nothing else does.
  Sources unit_source(std::uint32_t element) const;

  // Returns the residual by rows, enclosed; `others` form some of them (null: none do).
  std::vector<DoubleDoubleBall> residual(const ResidualQuestion& question, SharedRows* others = nullptr) const;
  // Sets it for some unknowns. REQUIRES a member of `result` for each unknown, 0 at first.
  void set_residual(const ResidualQuestion& question, const WorkRange& unknowns,
                    std::vector<DoubleDoubleBall>& result) const;

  // Returns x_i as one number.
  DoubleDoubleBall value(const SplitVector& x, std::size_t unknown) const;

  // Returns the irradiance H_i = sum_j F_ij B_j of every row, by element; `radiosity` >= 0 is by element, the sky last.
  // Its width is that of the radiosities and half an ulp or so of H_i, however much the radiosities differ; it is
  // exactly 0 where all of them are. With kWithinBounds that of all factors within their bounds whose rows sum to 1:
  // what is unknown of a factor counts times the difference of two radiosities.
  // `others` form some rows (null: none do).
  std::vector<ScaledBall> irradiance(const std::vector<ScaledBall>& radiosity,
                                     FactorsMeant meant = FactorsMeant::kAsGiven, SharedRows* others = nullptr) const;
  // Sets it for some elements. REQUIRES a member of `result` for each element, 0 at first.
  void set_irradiance(const std::vector<ScaledBall>& radiosity, FactorsMeant meant, const WorkRange& elements,
                      std::vector<ScaledBall>& result) const;

 private:
  void find_components();
  DoubleDoubleBall residual_of_row(const ResidualQuestion& question, std::size_t i, bool is_start) const;
  Sources in_units(const std::vector<const RationalEnclosure*>& emission) const;  // by element, the sky last; null: 0

  const ExchangeMatrix* matrix_;
  bool rows_are_closed_, has_negative_factors_ = false;
  std::vector<Rational> absorptivity_;  // by material
  std::vector<std::int32_t> unknown_;
  std::vector<SystemRow> rows_;
  std::vector<SystemComponent> components_;
};

inline bool is_positive(const Rounded& factor) { return factor.value > 0 || factor.side > 0; }  // it may underflow

// The same system in plain doubles: x = source + scatter x, each component in its unit. Rows of components that are not
// wanted scatter nothing. Made for iterations: nothing here is proven.
struct PlainSystem {
  std::vector<std::size_t> begin;  // by unknown, one more at the end
  std::vector<std::uint32_t> to;   // unknowns
  std::vector<double> scatter;     // rho_i F_ij
  std::vector<double> area;

  PlainSystem(const RadiositySystem& system, const std::vector<char>& is_wanted);
  // Returns the row of scatter times x.
  double gathered(std::size_t i, const std::vector<double>& x) const;
  // Sets scatter times x for some unknowns, over all threads.
  void multiply(const WorkRange& unknowns, const std::vector<double>& x, std::vector<double>& result) const;
  // Returns of - (I - scatter) x, for any source `of`; `others` form some rows (null: none do). COST: one pass over the
  // entries, over all threads.
  std::vector<double> residual(const std::vector<double>& of, const std::vector<double>& x,
                               SharedRows* others = nullptr) const;
};

// The right side of a plain system: the sources of one channel.
struct PlainSource {
  std::vector<double> value;        // by unknown: E_i + rho_i (D_i + sum of F_ij B_j over all that is known)
  std::vector<double> per_largest;  // by unknown: 1 / the largest source of the component; 1 where there is none

  PlainSource(const RadiositySystem& system, const Sources& sources);
  // Returns max |r_i|, each relative to the largest source of its component.
  double relative(const std::vector<double>& r) const;
};

}  // namespace hottel
