// Enclosures of pairs that something stands between, and what they are made of.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "geometry/space/arrangement/surface_boxes.h"
#include "geometry/space/between/pair_occluders.h"
#include "geometry/space/exchange/exchange.h"
#include "geometry/space/generate/generators.h"
#include "geometry/space/integrals/edge_integral.h"
#include "geometry/space/moving/kept_sign.h"
#include "geometry/space/pairs/pair_stretches.h"
#include "geometry/space/prepared/element_table.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "geometry/space/proven/edge_enclosure.h"
#include "geometry/space/stretches/surface_stretches.h"
#include "io/scene/scene_json.h"
#include "kernel/wide_real.h"
#include "tests/comparison/space/pair_scene.h"
#include "tests/comparison/space/pierced_pairs.h"
#include "tests/oracle/space/random_polygons.h"
#include "tests/sanitizers.h"

namespace hottel::proven_test {
namespace {

// Polynomials of whole numbers, with a root a little within an interval, or a little beyond it.
TEST(KeptSign, IsToldNextToRoots) {
  const auto keeps = [](const std::array<long, 3>& c, double left, double right) {
    const std::array<double, 3> doubles{static_cast<double>(c[0]), static_cast<double>(c[1]),
                                        static_cast<double>(c[2])};
    const int sign = c[0] > 0 ? 1 : -1;
    const bool by_integers = keeps_sign_3({Integer(c[0]), Integer(c[1]), Integer(c[2])}, sign, left, right);
    EXPECT_TRUE(by_integers || !keeps_sign_3(doubles, {0, 0, 0}, sign, left, right));
    return by_integers;
  };
  EXPECT_TRUE(keeps({-1, 3, 0}, 1, 1.0 / 3 - 1e-12));
  EXPECT_FALSE(keeps({-1, 3, 0}, 1, 1.0 / 3 + 1e-12));
  EXPECT_TRUE(keeps({1, 3, 0}, 1.0 / 3 - 1e-12, 1));
  EXPECT_FALSE(keeps({1, 3, 0}, 1.0 / 3 + 1e-12, 1));
  EXPECT_TRUE(keeps({1, -4, 4}, 1, 1));      // a double root at 1 / 2
  EXPECT_FALSE(keeps({12, -49, 49}, 1, 1));  // roots at 3 / 7 and 4 / 7: both signs are the same at the ends
  EXPECT_TRUE(keeps({13, -49, 49}, 1, 1));   // none
  EXPECT_TRUE(keeps({12, -49, 49}, 1, 0.4));
  EXPECT_FALSE(keeps({-12, 49, -49}, 1, 0.5));
}

// The pairs of a scene that something stands between.
class ProvenPairs : public testing::Test {
 protected:
  explicit ProvenPairs(const char* kind = "triangle-soup", std::uint32_t n = 10)
      : prepared_(prepare(generate_3({.kind = kind, .n = n, .seed = 1}))) {}

  template <class Visit>
  void for_each_mixed(std::size_t most, const Visit& visit) const {
    std::size_t count = 0;
    for (std::uint32_t i = 0; i < table_.count(); ++i)
      for (std::uint32_t j = i + 1; j < table_.count(); ++j) {
        if (table_.parts(i).empty() || table_.parts(j).empty()) continue;
        const Patch3 &a = table_.parts(i).front().patch, &b = table_.parts(j).front().patch;
        const PairOccluders3 setting(occluders_, boxes_, a, b);
        if (setting.sight != PairVisibility3::kMixed || count++ == most) continue;
        visit(setting, pair_stretches(setting, stretches_, a, b));
        if (count == most) return;
      }
  }

  const PreparedScene3 prepared_;
  const Occluders3& occluders_ = prepared_.occluders();
  const ElementTable3 table_{prepared_.scene, prepared_.arrangement(), occluders_, Granularity::kFace};
  const SurfaceBoxes3 boxes_{occluders_};
  const SurfaceStretches3 stretches_{occluders_, boxes_};
};

class ProvenRoom : public ProvenPairs {
 protected:
  ProvenRoom() : ProvenPairs("room-touching", 3) {}
};

// Lambda at t, as the arcs of a piece tell it.
Direction3 lambda(StretchMapper3& mapper, const PairStretch3& stretch, const StretchPiece3& piece, double t) {
  const auto exact = mapper.whole_piece<WideReal>(stretch, piece);
  const WidePiece3<WideReal> wide{.low = piece.low,
                                  .high = piece.high,
                                  .planes = exact.planes,
                                  .corners = exact.corners,
                                  .arcs = exact.arcs,
                                  .near_zeros = {}};
  const LocalVector3<WideReal> found = wide.lambda(t, WideReal(0));
  return {static_cast<double>(found.x), static_cast<double>(found.y), static_cast<double>(found.z)};
}

// Close to the ends of parts, as close as can be looked, exact signs tell the same. Of a short stretch fewer surfaces
// may matter: then other arcs bound the same.
void expect_sure_to_the_ends(const PairOccluders3& setting, const std::vector<PairStretch3>& stretches,
                             std::size_t& looked) {
  StretchMapper3 mapper(setting.bodies);
  std::vector<SurePart3> parts, there;
  for (const PairStretch3& stretch : stretches) {
    ASSERT_TRUE(mapper.divide_surely(stretch, parts));
    double before = -1;
    for (const SurePart3& part : parts) {
      const double low = part.piece.low, high = part.piece.high;
      EXPECT_LT(before, low + 0x1p-60);
      before = high;
      if (high - low < 0x1p-40) continue;
      for (const double from : {low, high - 0x1p-50}) {
        PairStretch3 end = stretch;
        end.low = from;
        end.high = from + 0x1p-50;
        StretchMapper3 anew(setting.bodies);
        ASSERT_TRUE(anew.divide_surely(end, there));
        for (const SurePart3& one : there) {
          ++looked;
          if (one.piece.signature == part.piece.signature) continue;
          const Direction3 apart =
              lambda(anew, end, one.piece, one.piece.base) - lambda(mapper, stretch, part.piece, one.piece.base);
          EXPECT_LE(length(apart), 1e-14) << "at " << from;
        }
      }
    }
  }
}

TEST_F(ProvenPairs, PartsAreWhatTheyAreToTheirEnds) {
  std::size_t looked = 0;
  for_each_mixed(25, [&](const PairOccluders3& setting, const std::vector<PairStretch3>& stretches) {
    expect_sure_to_the_ends(setting, stretches, looked);
  });
  EXPECT_GT(looked, 1000u);
}

TEST_F(ProvenRoom, PartsAreWhatTheyAreToTheirEnds) {
  std::size_t looked = 0;
  for_each_mixed(25, [&](const PairOccluders3& setting, const std::vector<PairStretch3>& stretches) {
    expect_sure_to_the_ends(setting, stretches, looked);
  });
  EXPECT_GT(looked, 300u);
}

// Relies on the sides of one body that points are on, and on those that the point sees of others.
void rely_on_some(const PairGeometry3& bodies, std::uint32_t body, MovingPlanes3& planes) {
  for (std::uint32_t k = 2; k < bodies.count(); ++k) planes.facing(k);
  for (std::uint32_t side = 0; side < bodies.bodies[body].corners.size(); ++side)
    planes.rely(bodies.bodies[(body + 1) % bodies.count()].corners, planes.cone_side(body, side, 1, false));
}

// Roots that are told wrongly, a part in 10^12 too far, lie in no proven interval: neither those of planes of bodies
// nor those of points beside planes.
TEST_F(ProvenPairs, NoRootLiesWithinWhatIsProven) {
  constexpr double kWrong = 1e-12, kAt = 0.4837;
  std::size_t to_roots = 0;
  for_each_mixed(40, [&](const PairOccluders3& setting, const std::vector<PairStretch3>& stretches) {
    MovingPlanes3 planes(setting.bodies);
    planes.keep_signs();
    for (const PairStretch3& stretch : stretches) {
      planes.take(stretch.line());
      for (std::uint32_t body = 0; body < setting.bodies.count(); ++body) {
        planes.move_to(kAt, kAt, 1 - kAt);
        rely_on_some(setting.bodies, body, planes);
        if (planes.is_unlucky() || planes.left() < 1e-6 || planes.right() < 1e-6) continue;
        const double left = planes.left(), right = planes.right();
        const double far_left = std::min(kAt, left + kWrong), far_right = std::min(1 - kAt, right + kWrong);
        const auto proven = planes.prove_signs(far_left, far_right);
        ASSERT_TRUE(proven.has_value());
        EXPECT_GE(proven->low, kAt - left - 1e-14);
        EXPECT_LE(proven->high, kAt + right + 1e-14);
        EXPECT_LE(proven->low, kAt - left + 1e-13);
        EXPECT_GE(proven->high, kAt + right - 1e-13);
        to_roots += left < kAt ? 1 : 0;
      }
    }
  });
  EXPECT_GT(to_roots, 500u);
}

// Nearly all of a stretch is proven: ends are told to 2^-49 of parts.
TEST_F(ProvenPairs, PartsLeaveLittleBetween) {
  for_each_mixed(25, [&](const PairOccluders3& setting, const std::vector<PairStretch3>& stretches) {
    StretchMapper3 mapper(setting.bodies);
    std::vector<SurePart3> parts;
    for (const PairStretch3& stretch : stretches) {
      if (mapper.sees_nothing(stretch)) continue;
      ASSERT_TRUE(mapper.divide_surely(stretch, parts));
      double rest = stretch.high - stretch.low;
      for (const SurePart3& part : parts) rest -= part.piece.high - part.piece.low - part.gaps;
      EXPECT_LE(rest, 5e-14);
    }
  });
}

// The integral over a part by another formula, with the normal as a unit vector and angles by atan2, in numbers of 320
// bits, halved until two rules agree to 25 digits.
double reference(const WholePiece3<WideReal>& piece, double low, double high, const Direction3& moment) {
  WidePiece3<WideReal> wide{
      .low = low, .high = high, .planes = piece.planes, .corners = piece.corners, .arcs = piece.arcs, .near_zeros = {}};
  EdgeIntegral3<WideReal> integral([](std::uint32_t, WidePiece3<WideReal>&) {}, std::size_t{1} << 40);
  const std::uint32_t stretch =
      integral.add_stretch({0, 0, 0}, {WideReal(moment.x), WideReal(moment.y), WideReal(moment.z)});
  integral.add(std::move(wide), stretch);
  const EdgeValues3 values = integral.refine(1e-25, 1);
  EXPECT_LE(values.error, 1e-22);
  return values.value;
}

// The last digit of the reference as a double.
void expect_within(const Ball3<double>& ball, double value) {
  EXPECT_LE(std::fabs(ball.mid - value), ball.rad + 0x1p-53 * std::fabs(value));
}

// Calls it for parts in which something is seen.
template <class Visit>
void for_each_part(const PairOccluders3& setting, const std::vector<PairStretch3>& stretches, const Visit& visit) {
  StretchMapper3 mapper(setting.bodies);
  std::vector<SurePart3> parts;
  for (const PairStretch3& stretch : stretches) {
    ASSERT_TRUE(mapper.divide_surely(stretch, parts));
    for (const SurePart3& part : parts)
      if (!part.piece.signature.empty()) visit(mapper, stretch, part.piece);
  }
}

TEST_F(ProvenPairs, PiecesHoldTheirIntegrals) {
  const ProvenMoment3<double> moment{{1, -2, 3}, 0, 3.75};
  const ProvenMoment3<WideReal> wide_moment{{1, -2, 3}, 0, 3.75};
  std::size_t number = 0, compared = 0;
  double widest = 0;
  ProofCounts3 counts;
  for_each_mixed(40, [&](const PairOccluders3& setting, const std::vector<PairStretch3>& stretches) {
    for_each_part(setting, stretches, [&](StretchMapper3& mapper, const PairStretch3& stretch, const auto& part) {
      if (++number % 19 != 0) return;
      ++compared;
      const double width = part.high - part.low;
      const auto exact = mapper.whole_piece<WideReal>(stretch, part);
      const double value = reference(exact, part.low, part.high, {1, -2, 3});
      const ProvenPiece3<double> piece(mapper.whole_piece<double>(stretch, part));
      for (const double allowed : {1e-3, 1e-8, 1e-14}) {
        const Ball3<double> found =
            PieceEncloser3<double>(piece, moment, allowed, 3.2, counts).enclose(part.low, part.high);
        expect_within(found, value);
        EXPECT_LE(found.rad, (allowed + 1e-12) * width + 1e-15);
        if (allowed == 1e-14) widest = std::max(widest, found.rad / width);
      }
      const ProvenPiece3<WideReal> wide(exact);
      const Ball3<double> fine =
          PieceEncloser3<WideReal>(wide, wide_moment, 1e-20, 3.2, counts).enclose(part.low, part.high);
      expect_within(fine, value);
      EXPECT_LE(fine.rad, 1e-15 * std::max(width, std::fabs(value)));
    });
  });
  EXPECT_GT(compared, 100u);
  EXPECT_EQ(counts.failures, 0u);
  EXPECT_LE(widest, 1e-12);
}

PairRequest3 proving(double tolerance) {
  PairRequest3 request;
  request.tolerance = tolerance;
  request.proves = true;
  return request;
}

// Pairs of made-up scenes: enclosures from i to j and from j to i about different origins have numbers in common, hold
// the sum along edges to the digits that it is told in, and are as narrow as was asked.
std::size_t expect_enclosed(const std::vector<oracle::SpacePolygon>& polygons, std::size_t most) {
  const oracle::PairScene3 scene(polygons);
  std::size_t compared = 0;
  for (std::size_t a = 0; a < polygons.size(); ++a)
    for (std::size_t b = a + 1; b < polygons.size() && compared < most; ++b)
      for (const bool is_back : {false, true}) {
        const Patch3 i = scene.patch(a, is_back), j = scene.patch(b, is_back);
        if (scene.measurer().count_between(i, j) == 0) continue;
        const double area = std::min(scene.area(i), scene.area(j));
        const PairResult3 found = scene.measure(i, j, proving(1e-9));
        if (found.bounds.upper == 0 || found.is_whole) continue;
        PairRequest3 other = proving(1e-11), fine;
        other.is_reversed = true;
        for (PairRequest3* request : {&other, &fine}) {
          request->origin_shift[0] = 0.75;
          request->origin_shift[1] = -2;
        }
        fine.tolerance = 1e-13;
        const PairResult3 reversed = scene.measure(i, j, other), measured = scene.measure(i, j, fine);
        ++compared;
        EXPECT_LE(found.bounds.width(), 1e-9 * area);
        EXPECT_LE(reversed.bounds.width(), 1e-11 * area);
        EXPECT_LE(found.bounds.lower, reversed.bounds.upper * (1 + 1e-15));
        EXPECT_LE(reversed.bounds.lower, found.bounds.upper * (1 + 1e-15));
        if (!measured.problem.empty()) continue;
        const double slack = 1e-13 * area;
        EXPECT_LE(reversed.bounds.lower - slack, measured.measure);
        EXPECT_GE(reversed.bounds.upper + slack, measured.measure);
      }
  return compared;
}

TEST(ProvenStorm, EnclosuresAgree) {
  std::size_t compared = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    compared += expect_enclosed(oracle::lattice_room(seed, 3, 2, 1, 1), 30);
    compared += expect_enclosed(oracle::piercing_triangles(seed, 8, 100, 40), 30);
  }
  EXPECT_GT(compared, 200u);
}

// (On the lattice, as many as one likes: hottel_storm --dimension 3 --law stated. Of these, report_proven_sums.)
TEST(ProvenStorm, TenThousandSumsAreWithinBounds) {
  const std::size_t most = kHasAddressSanitizer ? 300 : 10'000;
  std::size_t count = 0;
  for (std::uint64_t seed = 1; count < most; ++seed)
    for (const oracle::PiercedPair3& pair : oracle::pierced_pairs_3(seed)) {
      ++count;
      EXPECT_TRUE(pair.is_within_bounds()) << seed << ": " << pair.sum.problem << " " << pair.sum.measure << " in ["
                                           << pair.proven.bounds.lower << ", " << pair.proven.bounds.upper << "]";
      EXPECT_LE(pair.width(), 1e-9) << seed;
    }
}

// Where an edge is looked at, its exact middle, is 2^-60 from where what is seen changes: no double is between.
TEST(ProvenStorm, PlacesNextToRootsArePartsOfTheirOwn) {
  const mpq_class nearly("54043195528445951/18014398509481984");  // 3 - 2^-54
  const oracle::PairScene3 scene({{{0, 0, 4}, {0, 4, 4}, {1, 0, 3}},
                                  {{4, 0, 0}, {4, 2, 0}, {0, 3, 0}},
                                  {{4, 1, 3}, {0, 2, nearly}, {0, 0, 0}},
                                  {{3, 2, 0}, {2, 3, 0}, {1, 3, 1}}});
  const PairResult3 found = scene.measure(scene.patch(0), scene.patch(1), proving(1e-9));
  EXPECT_LE(found.bounds.width(), 1e-9 * scene.area(scene.patch(0)));
  EXPECT_LE(found.bounds.lower, 0.0118404369362029440);
  EXPECT_GE(found.bounds.upper, 0.0118404369362029439);
}

// Numbers are those without proofs; rows of a closed room hold 1, and bounds are the same for any number of threads.
TEST_F(ProvenRoom, FactorsAreEnclosed) {
  const ExchangeMatrix plain = exact_exchange(prepared_), proven = exact_exchange(prepared_, {.proves = true});
  EXPECT_THROW(require_enclosed_3(plain, 1e-9), std::exception);
  require_enclosed_3(proven, 1e-9);
  for (std::uint32_t i = 0; i < proven.size(); ++i) {
    double lower = 0, upper = 0;
    for (std::size_t k = 0; k < proven.row(i).size(); ++k) {
      const Enclosure bounds = proven.bounds(i, k);
      EXPECT_EQ(proven.row(i)[k].factor, plain.row(i)[k].factor);
      EXPECT_TRUE(bounds.contains(proven.row(i)[k].factor.value));
      lower += bounds.lower;
      upper += bounds.upper;
    }
    if (proven.row(i).empty()) continue;
    EXPECT_LE(lower, 1 + 1e-15);
    EXPECT_GE(upper, 1 - 1e-15);
    EXPECT_LE(upper - lower, 1e-7);
  }
}

// Walls typed to six digits stand 1e-7 off the edges of the floor: what is singular is as near to these edges.
TEST(ProvenSlits, AreAsNarrowAsAnythingElse) {
  const Scene3 room = read_scene_3(HOTTEL_SOURCE_DIR "/scenes/space/room_six_digits.json");
  const ExchangeMatrix proven = exact_exchange(prepare(room), {.wants_visibility = false, .proves = true});
  EXPECT_NO_THROW(require_enclosed_3(proven, 1e-9));
  EXPECT_EQ(proven.guarantee(), Guarantee::kEnclosed);
}

}  // namespace
}  // namespace hottel::proven_test
