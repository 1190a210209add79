#include "geometry/space/proven/piece_enclosure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>

#include "geometry/space/proven/node_balls.h"
#include "geometry/space/proven/node_lanes.h"
#include "kernel/legendre_rule.h"
#include "kernel/plain_functions.h"
#include "kernel/wide_real.h"

namespace hottel {
namespace {

using namespace ball_arithmetic_3;

// Eight nodes take as long as fewer.
constexpr std::array<int, 3> kNodes{8, 16, 20};
// An ellipse has no larger rho than the first; what it has of that of the nearest zero, less 1, is tried in that order,
// and parts are halved where that is near.
constexpr double kMostRho = 32, kOfNearest[] = {0.75, 0.6, 0.88}, kLeastRho = 1.7;
// So often a part is halved, and all parts of a piece together.
constexpr int kMostHalvings = 40, kAllHalvings = 128;

// From the focus along the ellipse, in half lengths.
double half_axis(double rho) { return (rho + 1 / rho) / 2; }

constexpr double kRootOfThree = 1.7320508075688774;

}  // namespace

double error_of_rule_3(double largest, double rho, int n) {
  constexpr double kRoundings = 1 + 0x1p-30;
  return largest * (64.0 / 15) * same_bits::pow(rho, -2 * n) / (1 - 1 / (rho * rho)) * kRoundings;
}

template <class Real>
PieceEncloser3<Real>::PieceEncloser3(const ProvenPiece3<Real>& piece, const ProvenMoment3<Real>& moment, double allowed,
                                     double most_seen, ProofCounts3& counts)
    : piece_(piece),
      moment_(moment),
      allowed_(allowed),
      most_seen_(most_seen),
      halvings_left_(kAllHalvings),
      counts_(counts) {
  const LocalVector3<Real>& m = moment.value;
  moment_in_doubles_ = {static_cast<double>(m.x), static_cast<double>(m.y), static_cast<double>(m.z)};
  moment_off_ = up(kRootOfThree * (moment.error + kRoundoff<double> * moment.size));
}

template <class Real>
Ball3<double> PieceEncloser3<Real>::enclose(double low, double high) {
  return enclose(low, high, 0);
}

template <class Real>
Ball3<double> PieceEncloser3<Real>::enclose(double low, double high, int halvings) {
  if (const auto result = enclose_by_rule(low, high)) return *result;
  const double middle = low + (high - low) / 2;
  if (halvings == kMostHalvings || --halvings_left_ < 0 || !(low < middle && middle < high)) {
    ++counts_.failures;
    steepest_ = kNothingKnown;
    return {0, up(up(high - low) * moment_.size * most_seen_)};
  }
  ++counts_.halvings;
  return enclose(low, middle, halvings + 1) + enclose(middle, high, halvings + 1);
}

// At the ends of a gap the formula tells what is seen; from there it changes by its slope, which is no more than the
// largest on an ellipse over the distance to its border.
template <class Real>
double PieceEncloser3<Real>::most_in_gaps(double gaps) const {
  return std::min(largest_, up(moment_.size * most_seen_ + gaps * steepest_));
}

// The ellipse that takes fewest nodes.
template <class Real>
std::optional<typename PieceEncloser3<Real>::Choice> PieceEncloser3<Real>::choose(ArcsOnEllipse3& arcs) const {
  const double reach = arcs.reach(), farthest = reach + std::sqrt(std::max(0.0, reach * reach - 1));
  Choice best;
  for (const double part : kOfNearest) {
    const Choice ellipse{std::min(kMostRho, 1 + part * (farthest - 1)), 0, 0};
    if (!(ellipse.rho > kLeastRho)) break;
    const double largest = arcs.largest(half_axis(ellipse.rho));
    for (const int nodes : kNodes) {
      if (best.nodes != 0 && nodes >= best.nodes) break;
      if (!(error_of_rule_3(largest, ellipse.rho, nodes) <= 2 * allowed_)) continue;
      best = {ellipse.rho, largest, nodes};
      break;
    }
    if (best.nodes == kNodes.front()) break;
  }
  if (best.nodes == 0) return {};
  return best;
}

template <class Real>
std::optional<Ball3<double>> PieceEncloser3<Real>::enclose_by_rule(double low, double high) {
  thread_local std::vector<PartVector3> planes, corners;
  thread_local ArcsOnEllipse3 arcs;
  thread_local std::vector<signed char> turns;
  const double half = (high - low) / 2;
  planes.clear();
  corners.clear();
  for (const ProvenVector3<Real>& plane : piece_.planes) planes.emplace_back(in_doubles_3(plane), low, half);
  for (const ProvenVector3<Real>& corner : piece_.corners) corners.emplace_back(in_doubles_3(corner), low, half);
  const PartArcs3 part{piece_.arcs, planes, corners, moment_in_doubles_, moment_off_, moment_.size};
  arcs.set(part);
  const std::optional<Choice> choice = choose(arcs);
  if (!choice) return {};
  const double axis = half_axis(choice->rho);
  arcs.find_turns(axis, turns);
  const LegendreRule<Real>& rule = legendre_rule<Real>(choice->nodes);
  std::optional<Ball3<Real>> mean;
  if constexpr (std::is_same_v<Real, double>)
    mean = mean_at_nodes_3(part, turns, rule);
  else
    mean = mean_at_nodes_3(piece_, moment_, turns, rule, low, high);
  if (!mean) return {};
  const Ball3<Real> integral = *mean * Ball3<Real>{Real(high) - Real(low), 2 * kRoundoff<Real> * (high - low)};
  const double value = static_cast<double>(integral.mid);
  if (!(std::isfinite(value) && std::isfinite(integral.rad))) return {};
  ++counts_.parts;
  largest_ = std::max(largest_, choice->largest);
  steepest_ = std::max(steepest_, up(choice->largest / (down(half) * down(axis - 1))));
  const double error = up(error_of_rule_3(choice->largest, choice->rho, choice->nodes) * half);
  return Ball3<double>{value, up(integral.rad + error + kRoundoff<double> * std::fabs(value))};
}

template class PieceEncloser3<double>;
template class PieceEncloser3<WideReal>;

}  // namespace hottel
