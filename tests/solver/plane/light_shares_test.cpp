// What lights shine on first: closed forms, a slow oracle to sixty digits, and what bounds promise.
#include "solver/plane/light/light_shares.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <random>
#include <vector>

#include "geometry/plane/prepared/element_table.h"
#include "geometry/plane/prepared/prepared_scene.h"
#include "kernel/support/failure.h"
#include "solver/plane/light/beam.h"
#include "tests/solver/plane/lit_scenes.h"

namespace hottel::light_shares_test {
namespace {

using Wide = boost::multiprecision::cpp_bin_float_100;

Wide wide(const Rational& q) { return Wide(q.get_num().get_str()) / Wide(q.get_den().get_str()); }
const Wide& wide_pi() {
  static const Wide pi = boost::multiprecision::acos(Wide(-1));
  return pi;
}

Light point_light(const Rational& power = 1) {
  Light light;
  light.name = "bulb";
  light.power = Spectrum::scalar(power);
  return light;
}

Light spot(const Rational& focus, const Rational& falloff = 0) {
  Light light = point_light();
  light.type = LightType::kSpot;
  light.focus = focus;
  light.falloff = falloff;
  return light;
}

LightShares shares_in(Scene2 scene, const Light& light, const LightPlace2& place,
                      Granularity granularity = Granularity::kFace) {
  scene.add_light(light, place);
  validate(scene);
  const Divided2 divided = granularity == Granularity::kElement ? Divided2::kYes : Divided2::kNo;
  return light_shares(prepare(std::move(scene), divided), granularity).front();
}

void expect_holds(const Enclosure& share, double value, const std::string& what) {
  EXPECT_TRUE(share.lower <= value * (1 + 0x1p-50) && value * (1 - 0x1p-50) <= share.upper)
      << what << ": " << share.lower << " to " << share.upper << ", not " << value;
  EXPECT_LE(share.width(), 0x1p-48 * share.upper) << what;
}

// The sum of all shares holds 1, and is no wider than rounding makes it.
void expect_whole(const LightShares& shares, const std::string& what) {
  double lower = shares.sky.lower, upper = shares.sky.upper;
  for (const Enclosure& share : shares.of_element) {
    EXPECT_LE(0, share.lower) << what;
    lower += share.lower;
    upper += share.upper;
  }
  EXPECT_LE(lower, 1 + 1e-15) << what;
  EXPECT_GE(upper, 1 - 1e-15) << what;
  EXPECT_LE(upper - lower, 1e-13) << what;
}

const Rational kHalf(1, 2);

TEST(LightShares2, PointInTheMiddleOfASquareGivesEachWallAQuarter) {
  const LightShares shares = shares_in(square_room(), point_light(), {{kHalf, kHalf}});
  for (std::size_t wall = 0; wall < 4; ++wall) expect_holds(shares.of_element[2 * wall], 0.25, "wall");
  EXPECT_EQ(shares.sky, (Enclosure{0, 0}));
  expect_whole(shares, "square");
}

TEST(LightShares2, BeamInsideOneFaceGivesItAll) {
  for (const Rational& falloff : {Rational(0), Rational(1), Rational(2), Rational(5, 2), Rational(100)}) {
    const LightShares shares = shares_in(square_room(), spot(30, falloff), {{kHalf, kHalf}, {1, 0}});
    expect_holds(shares.of_element[4], 1, "right wall");
    for (const std::size_t other : {0, 2, 6}) EXPECT_EQ(shares.of_element[other], (Enclosure{0, 0}));
  }
}

// The corners of the square lie exactly at 45 degrees: the beam touches the other walls there, and gives them nothing.
TEST(LightShares2, BeamThatEndsInACornerGivesNothingBeyondIt) {
  for (const Rational& falloff : {Rational(0), Rational(1), Rational(2), Rational(5, 2)}) {
    const LightShares shares = shares_in(square_room(), spot(45, falloff), {{kHalf, kHalf}, {3, 0}});
    expect_holds(shares.of_element[4], 1, "right wall");
    for (const std::size_t other : {0, 2, 6}) EXPECT_EQ(shares.of_element[other], (Enclosure{0, 0})) << falloff;
  }
}

TEST(LightShares2, FalloffHasItsClosedForms) {
  // From 0 to 45 degrees of a half turn: the share of the upper half of the right wall, axis to the right.
  const double r = std::sqrt(0.5), pi = std::acos(-1.0);
  const auto upper_half = [&](const Rational& falloff, const Rational& focus) {
    Scene2 scene;
    add_polygon(scene, {{0, 0}, {0, 1}, {1, 1}, {1, kHalf}, {1, 0}});
    return shares_in(std::move(scene), spot(focus, falloff), {{kHalf, kHalf}, {1, 0}}).of_element[4];
  };
  expect_holds(upper_half(0, 180), 0.125, "n = 0, all around");
  expect_holds(upper_half(0, 90), 0.25, "n = 0");
  expect_holds(upper_half(1, 90), r / 2, "n = 1");
  expect_holds(upper_half(1, 180), r / 2, "n = 1, cut to 90 degrees");
  expect_holds(upper_half(2, 90), (0.25 + pi / 8) / (pi / 2), "n = 2");
  expect_holds(upper_half(3, 90), (r - r * r * r / 3) / (4.0 / 3), "n = 3");
  // The integral of cos^(1/2) to 45 and to 90 degrees, by quadrature to thirty digits.
  expect_holds(upper_half(Rational(1, 2), 90), 0.744303079760492874810 / 2.39628046947118441488, "n = 1/2");
}

TEST(LightShares2, LightInTheLineOfAFaceGivesItNothing) {
  Scene2 scene = square_room();
  add_edge(scene, {Rational(3, 4), kHalf}, {Rational(7, 8), kHalf}, true);
  const LightShares shares = shares_in(std::move(scene), point_light(), {{kHalf, kHalf}});
  EXPECT_EQ(shares.of_element[8], (Enclosure{0, 0}));
  EXPECT_EQ(shares.of_element[9], (Enclosure{0, 0}));
  expect_holds(shares.of_element[4], 0.25, "what is behind it");
}

TEST(LightShares2, LightAloneSendsAllToTheSky) {
  EXPECT_EQ(shares_in(Scene2(), spot(10), {{0, 0}, {1, 2}}).sky, (Enclosure{1, 1}));
}

TEST(LightShares2, LightOutsideSeesTheSkyAndABack) {
  const LightShares shares = shares_in(square_room(), point_light(), {{kHalf, 2}});
  const double top = 2 * std::atan(0.5) / (2 * std::acos(-1.0));
  expect_holds(shares.of_element[3], top, "back of the top");
  expect_holds(shares.sky, 1 - top, "sky");
}

TEST(LightShares2, LightInASolidGivesNothing) {
  Scene2 scene;  // counter-clockwise: fronts outside
  for (const auto& [a, b] :
       std::vector<std::pair<Point2, Point2>>{{{0, 0}, {1, 0}}, {{1, 0}, {1, 1}}, {{1, 1}, {0, 1}}, {{0, 1}, {0, 0}}})
    add_edge(scene, a, b);
  for (Surface& surface : scene.surfaces) surface.group = 0;
  scene.groups.resize(1, Group("box"));
  const LightShares shares = shares_in(std::move(scene), point_light(), {{kHalf, kHalf}});
  EXPECT_EQ(shares.solid, "edge0");
  for (const Enclosure& share : shares.of_element) EXPECT_EQ(share, (Enclosure{0, 0}));
  EXPECT_EQ(shares.sky, (Enclosure{0, 0}));
}

TEST(LightShares2, LightOnAnEdgeIsRefusedByName) {
  Scene2 scene = square_room();
  scene.add_light(point_light(), {{1, Rational(1, 3)}});
  try {
    validate(scene);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("light 'bulb' lies on the surface 'edge2'"), std::string::npos)
        << error.what();
  }
}

// Elements share what their face gets.
TEST(LightShares2, ElementsSumToTheirFace) {
  Scene2 scene = square_room();
  for (Surface& surface : scene.surfaces) surface.elements = 5;
  const LightPlace2 place{{Rational(1, 3), Rational(1, 5)}, {2, 1}};
  const LightShares faces = shares_in(square_room(), spot(50, 2), place);
  const LightShares parts = shares_in(scene, spot(50, 2), place, Granularity::kElement);
  std::size_t part = 0;
  for (std::size_t wall = 0; wall < 4; ++wall, ++part) {
    double sum = 0;
    for (int k = 0; k < 5; ++k) sum += parts.of_element[part++].upper;
    EXPECT_NEAR(sum, faces.of_element[2 * wall].upper, 1e-15);
  }
}

// The oracle: all directions in which anything may change, sorted; between two of them a ray finds what is nearest.
class Oracle {
 public:
  Oracle(const Scene2& scene, const LightPlace2& place, const Light& light) : light_(light) {
    for (const Edge2& edge : scene.edges)
      segments_.push_back({wide(edge.from.x - place.position.x), wide(edge.from.y - place.position.y),
                           wide(edge.to.x - place.position.x), wide(edge.to.y - place.position.y)});
    axis_ = atan2(wide(place.direction.y), wide(place.direction.x));
  }

  // By edge and side (front, back), then the sky.
  std::vector<Wide> shares() const {
    const Wide half = wide(light_.half_angle()) * wide_pi() / 180;
    std::vector<Wide> cuts{-half, half};
    const auto add = [&](const Wide& x, const Wide& y) {
      Wide angle = atan2(y, x) - axis_;
      while (angle <= -wide_pi()) angle += 2 * wide_pi();
      while (angle > wide_pi()) angle -= 2 * wide_pi();
      if (angle > -half && angle < half) cuts.push_back(angle);
    };
    for (const auto& s : segments_) {
      add(s[0], s[1]);
      add(s[2], s[3]);
      for (const auto& t : segments_) {
        const Wide dx = s[2] - s[0], dy = s[3] - s[1], ex = t[2] - t[0], ey = t[3] - t[1];
        const Wide turn = dx * ey - dy * ex;
        if (turn == 0) continue;
        const Wide at = ((t[0] - s[0]) * ey - (t[1] - s[1]) * ex) / turn;
        add(s[0] + at * dx, s[1] + at * dy);
      }
    }
    std::sort(cuts.begin(), cuts.end());
    std::vector<Wide> result(2 * segments_.size() + 1);
    const Wide whole = power(half) - power(-half);
    for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
      if (cuts[k + 1] - cuts[k] < Wide(1e-80)) continue;
      result[nearest(axis_ + (cuts[k] + cuts[k + 1]) / 2)] += (power(cuts[k + 1]) - power(cuts[k])) / whole;
    }
    return result;
  }

 private:
  // The integral of cos^n by its Fourier series.
  Wide power(const Wide& angle) const {
    const int n = static_cast<int>(light_.falloff.get_num().get_si());
    Wide sum = 0, binomial = 1;
    for (int k = 0; k <= n; ++k) {
      const int frequency = n - 2 * k;
      sum += binomial * (frequency == 0 ? angle : Wide(sin(frequency * angle) / frequency));
      binomial = binomial * (n - k) / (k + 1);
    }
    return sum / pow(Wide(2), n);
  }

  std::size_t nearest(const Wide& angle) const {
    const Wide x = cos(angle), y = sin(angle);
    std::size_t found = 2 * segments_.size();
    Wide least = -1;
    for (std::size_t s = 0; s < segments_.size(); ++s) {
      const auto& [ax, ay, bx, by] = segments_[s];
      const Wide dx = bx - ax, dy = by - ay, turn = x * dy - y * dx;
      if (abs(turn) < Wide(1e-90)) continue;
      const Wide way = (ax * dy - ay * dx) / turn, at = (ax * y - ay * x) / turn;
      if (way <= 0 || at < 0 || at > 1 || (least >= 0 && way > least)) continue;
      least = way;
      found = 2 * s + (ax * by - ay * bx < 0 ? 0 : 1);  // the light is right of a -> b iff the triangle turns right
    }
    return found;
  }

  const Light& light_;
  std::vector<std::array<Wide, 4>> segments_;
  Wide axis_;
};

TEST(LightShares2, BoundsHoldTheTruthToSixtyDigitsInRandomScenes) {
  std::mt19937 random(20);
  const auto draw = [&](int most) { return Rational(static_cast<int>(random() % static_cast<unsigned>(most))); };
  std::size_t lit = 0;
  for (int round = 0; round < 300; ++round) {
    Scene2 scene;
    const int edges = 2 + static_cast<int>(random() % 7);
    while (static_cast<int>(scene.edges.size()) < edges) {
      Point2 a{draw(1000), draw(1000)}, b{draw(1000), draw(1000)};
      if (!(a == b)) add_edge(scene, a, b, random() % 2 == 0);
    }
    const bool is_round = random() % 4 == 0;
    const Light light = is_round ? point_light() : spot(1 + draw(180), draw(5));
    const LightPlace2 place{{draw(1000) + Rational(1, 3), draw(1000) + Rational(2, 7)},
                            {draw(19) - 9, draw(19) - Rational(17, 2)}};
    const LightShares shares = shares_in(scene, light, place);
    const std::vector<Wide> truth = Oracle(scene, place, light).shares();
    expect_whole(shares, "round " + std::to_string(round));
    for (std::size_t k = 0; k < truth.size(); ++k) {
      const Enclosure& share = k + 1 < truth.size() ? shares.of_element[k] : shares.sky;
      EXPECT_LE(Wide(share.lower), truth[k] + Wide(1e-60)) << "round " << round << ", " << k;
      EXPECT_GE(Wide(share.upper), truth[k] - Wide(1e-60)) << "round " << round << ", " << k;
      lit += share.lower > 0;
    }
  }
  EXPECT_GT(lit, 500u);
}

// (1), (2) of the beam
TEST(Beam2, SharesOfStepsAroundSumToOneWhereverTheAxisIsTurned) {
  const std::vector<Point2> around{{1, 0},  {2, 1},  {1, 1},   {0, 1},  {-1, 1},
                                   {-3, 1}, {-1, 0}, {-1, -1}, {0, -2}, {1, -1}};
  for (const Rational& turned :
       {Rational(0), Rational(45), Rational(180), Rational(-135), Rational(1, 3), Rational(725)})
    for (const Rational& focus : {Rational(45), Rational(90), Rational(180), Rational(17), Rational(135)})
      for (const Rational& falloff : {Rational(0), Rational(2), Rational(5, 2)}) {
        const Beam2 beam(spot(focus, falloff), {.position = {0, 0}, .direction = {1, 0}, .turned = turned});
        double lower = 0, upper = 0;
        for (std::size_t k = 0; k < around.size(); ++k) {
          const Enclosure share = beam.share(around[k], around[(k + 1) % around.size()]);
          lower += share.lower;
          upper += share.upper;
        }
        EXPECT_NEAR(lower, 1, 1e-14) << turned << " " << focus << " " << falloff;
        EXPECT_NEAR(upper, 1, 1e-14) << turned << " " << focus << " " << falloff;
      }
}

TEST(Beam2, BordersAreToldExactly) {
  const Beam2 beam(spot(45), {{0, 0}, {1, 0}});
  EXPECT_TRUE(beam.contains({1, 1}));
  EXPECT_TRUE(beam.contains({1, -1}));
  const Rational tiny("1/1000000000000000000000000000000");
  EXPECT_FALSE(beam.contains({1, 1 + tiny}));
  EXPECT_TRUE(beam.contains({1, 1 - tiny}));
  EXPECT_EQ(beam.share({1, 1}, {0, 1}), (Enclosure{0, 0}));
  EXPECT_GT(beam.share({1, 1 - tiny}, {0, 1}).lower, 0);
  const Beam2 turned(spot(45), {.position = {0, 0}, .direction = {1, 0}, .turned = 90});
  EXPECT_TRUE(turned.contains({1, 1}));
  EXPECT_FALSE(turned.contains({1, 1 - tiny}));
}

// A direction at a border, next to it or far from it, of any size: something leaves in it iff the beam contains it.
TEST(Beam2, SendsLightWhereItReachesAndNowhereElse) {
  std::mt19937 random(11);
  std::size_t inside = 0, outside = 0;
  for (const int focus : {1, 17, 45, 60, 90, 135, 179, 180})
    for (const char* turned : {"0", "45", "-135", "1/3", "725"})
      for (const Point2& axis : {Point2{1, 0}, Point2{-2, 3}, Point2{1 / Rational(Integer(1) << 700), 0}}) {
        const Beam2 beam(spot(focus), {.position = {0, 0}, .direction = axis, .turned = Rational(turned)});
        for (int k = 0; k < 40; ++k) {
          const double degrees =
              (k % 2 ? 1 : -1) * focus + to_double(Rational(turned)) + (k % 5 - 2) * std::ldexp(1.0, -k);
          const double angle = degrees * std::numbers::pi / 180 + std::atan2(to_double(axis.y), to_double(axis.x));
          const Rational size = Rational(1 + random() % 1000) / Rational(k % 3 == 0 ? 7 : 1);
          const Point2 way{Rational(std::cos(angle)) * size, Rational(std::sin(angle)) * size};
          const double sent = beam.intensity(to_double(way.x), to_double(way.y), [&] { return way; });
          EXPECT_EQ(sent > 0, beam.contains(way)) << focus << " " << turned << " " << k;
          ++(sent > 0 ? inside : outside);
        }
      }
  EXPECT_GT(inside, 1000u);
  EXPECT_GT(outside, 1000u);
  const Beam2 half(spot(90), {{0, 0}, {1, 0}});
  const Rational large(Integer(1) << 2000);
  for (const Point2& way :
       {Point2{large, large}, Point2{1 / large, -1 / large}, Point2{0, 1 / large}, Point2{0, large}})
    EXPECT_GT(half.intensity(to_double(way.x), to_double(way.y), [&] { return way; }), 0);
  EXPECT_EQ(half.intensity(to_double(Rational(-1 / large)), 0, [&] { return Point2{-1 / large, 0}; }), 0);
}

}  // namespace
}  // namespace hottel::light_shares_test
