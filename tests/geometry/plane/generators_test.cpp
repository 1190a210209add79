#include "geometry/plane/generate/generators.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace hottel::generators_test {
namespace {

int turn(const Point2& a, const Point2& b, const Point2& c) {
  const Rational area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  return sgn(area);
}

bool within_box(const Point2& p, const Edge2& s) {
  return std::min(s.from.x, s.to.x) <= p.x && p.x <= std::max(s.from.x, s.to.x) && std::min(s.from.y, s.to.y) <= p.y &&
         p.y <= std::max(s.from.y, s.to.y);
}

bool contains(const Edge2& s, const Point2& p) { return turn(s.from, s.to, p) == 0 && within_box(p, s); }

enum class Contact { kNone, kEndPoint, kTee, kCrossing, kOverlap };

bool boxes_meet(const Edge2& s, const Edge2& t) {
  return std::max(s.from.x, s.to.x) >= std::min(t.from.x, t.to.x) &&
         std::max(t.from.x, t.to.x) >= std::min(s.from.x, s.to.x) &&
         std::max(s.from.y, s.to.y) >= std::min(t.from.y, t.to.y) &&
         std::max(t.from.y, t.to.y) >= std::min(s.from.y, s.to.y);
}

Contact contact(const Edge2& s, const Edge2& t) {
  if (!boxes_meet(s, t)) return Contact::kNone;
  const int a = turn(s.from, s.to, t.from), b = turn(s.from, s.to, t.to);
  const int c = turn(t.from, t.to, s.from), d = turn(t.from, t.to, s.to);
  if (a * b < 0 && c * d < 0) return Contact::kCrossing;
  std::set<std::pair<std::string, std::string>> common;  // end points of one that lie on the other
  bool end_to_end = true;
  const auto note = [&](const Point2& p, const Edge2& on) {
    if (!contains(on, p)) return;
    common.insert({p.x.get_str(), p.y.get_str()});
    if (p != on.from && p != on.to) end_to_end = false;
  };
  note(t.from, s);
  note(t.to, s);
  note(s.from, t);
  note(s.to, t);
  if (common.empty()) return Contact::kNone;
  if (common.size() > 1) return Contact::kOverlap;
  return end_to_end ? Contact::kEndPoint : Contact::kTee;
}

GeneratorRequest2 request(const std::string& kind, std::uint64_t n, std::uint64_t seed, int digits = 0) {
  GeneratorRequest2 r;
  r.kind = kind;
  r.n = n;
  r.seed = seed;
  r.digits = digits;
  return r;
}

std::vector<std::string> kinds() {
  std::vector<std::string> names;
  for (const GeneratorKind2& kind : generator_kinds_2()) names.push_back(kind.name);
  return names;
}

std::string text_of(const Scene2& scene) {
  std::string text;
  for (std::size_t k = 0; k < scene.surfaces.size(); ++k) {
    const Surface& s = scene.surfaces[k];
    const auto& [from, to] = scene.edges[k];
    text += s.name + " " + from.x.get_str() + " " + from.y.get_str() + " " + to.x.get_str() + " " + to.y.get_str() +
            " " + std::to_string(s.material) + (s.back ? " " + std::to_string(*s.back) : "") + "\n";
  }
  return text;
}

// FNV-1a.
std::uint64_t fingerprint(const std::string& text) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  return hash;
}

// Number of significant digits of a value whose denominator divides a power of ten.
std::size_t significant_digits(Rational value) {
  while (value.get_den() != 1) value *= 10;
  std::string digits = value.get_num().get_str();
  return digits.size();
}

TEST(Generators2, SameRequestGivesTheSameScene) {
  for (const std::string& kind : kinds()) {
    for (const int digits : {0, 17}) {
      const auto r = request(kind, 200, 7, digits);
      EXPECT_EQ(text_of(generate_2(r)), text_of(generate_2(r))) << kind;
      EXPECT_NE(text_of(generate_2(r)), text_of(generate_2(request(kind, 200, 8, digits)))) << kind;
    }
  }
}

TEST(Generators2, ScenesAreTheSameOnEveryPlatform) {
  EXPECT_EQ(fingerprint(text_of(generate_2(request("room", 100, 1)))), 4197583260603562081u);
  EXPECT_EQ(fingerprint(text_of(generate_2(request("clutter", 100, 1)))), 7617687295319948866u);
  EXPECT_EQ(fingerprint(text_of(generate_2(request("clutter", 100, 1, 17)))), 4615541249254142854u);
  EXPECT_EQ(fingerprint(text_of(generate_2(request("lattice", 100, 1)))), 4394993350171586320u);
}

TEST(Generators2, EdgesTouchInSharedEndPointsOnly) {
  for (const std::string& kind : kinds()) {
    if (kind == "lattice") continue;
    for (const int digits : {0, 12, 17})
      for (std::uint64_t seed = 0; seed < 3; ++seed)
        for (const std::uint64_t n : {16u, 61u, 230u}) {
          const Scene2 scene = generate_2(request(kind, n, seed, digits));
          for (std::size_t i = 0; i < scene.surfaces.size(); ++i)
            for (std::size_t j = 0; j < i; ++j) {
              const Contact c = contact(scene.edges[i], scene.edges[j]);
              ASSERT_TRUE(c == Contact::kNone || c == Contact::kEndPoint)
                  << scene.about << ": " << scene.surfaces[i].name << " and " << scene.surfaces[j].name;
              if (kind == "clutter" && i >= 4) {
                ASSERT_EQ(c, Contact::kNone) << scene.about;
              }
            }
        }
  }
}

TEST(Generators2, NumberOfEdgesIsAsPromised) {
  for (const std::uint64_t n : {16u, 17u, 99u, 100u, 1000u, 12345u}) {
    const auto count = [n](const char* kind) {
      return static_cast<std::uint64_t>(generate_2(request(kind, n, 3)).surfaces.size());
    };
    EXPECT_EQ(count("clutter"), n);
    EXPECT_EQ(count("lattice"), n);
    EXPECT_EQ(count("star"), n);
    EXPECT_EQ(count("plates"), n);
    EXPECT_EQ(count("room"), n / 4 * 4);
    EXPECT_EQ(count("comb"), n / 4 * 4);
    EXPECT_EQ(count("pillars"), 4 + (n - 4) / 12 * 12);
    const std::uint64_t maze = count("maze");
    EXPECT_LE(maze, n);
    EXPECT_LT((n - maze) * (n - maze), n);
  }
}

TEST(Generators2, TheSmallestScenesOfEveryKindExist) {
  for (const GeneratorKind2& kind : generator_kinds_2()) {
    const Scene2 scene = generate_2(request(kind.name, kind.min_edges, 1));
    EXPECT_LE(scene.surfaces.size(), kind.min_edges);
    EXPECT_GE(scene.surfaces.size() + 4, kind.min_edges);
    EXPECT_THROW(generate_2(request(kind.name, kind.min_edges - 1, 1)), UsageError);
  }
}

TEST(Generators2, CoordinatesHaveTheDigitsAskedFor) {
  for (const std::string& kind : kinds()) {
    for (const int digits : {12, 17}) {
      const Scene2 scene = generate_2(request(kind, 100, 5, digits));
      for (const Edge2& s : scene.edges)
        for (const Rational& c : {s.from.x, s.from.y, s.to.x, s.to.y}) {
          if (kind == "lattice") {
            EXPECT_LE(significant_digits(c), static_cast<std::size_t>(digits)) << c;
          } else {
            EXPECT_EQ(significant_digits(c), static_cast<std::size_t>(digits)) << kind << " " << c;
          }
        }
    }
    const Scene2 plain = generate_2(request(kind, 100, 5));
    for (const Edge2& s : plain.edges) EXPECT_LE(significant_digits(s.from.x), 6u) << kind;
  }
}

// How often each contact occurs among all pairs.
std::vector<int> contacts(const Scene2& scene) {
  std::vector<int> count(5, 0);
  for (std::size_t i = 0; i < scene.surfaces.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) ++count[static_cast<std::size_t>(contact(scene.edges[i], scene.edges[j]))];
  return count;
}

TEST(Generators2, LatticeHasEveryContactAndOneMaterial) {
  for (const std::uint64_t n : {40u, 200u}) {
    const Scene2 scene = generate_2(request("lattice", n, 2));
    for (const int count : contacts(scene)) EXPECT_GT(count, 0);
    for (const Surface& s : scene.surfaces) {
      EXPECT_EQ(s.material, scene.surfaces.front().material);
      if (s.back) {
        EXPECT_EQ(*s.back, s.material);
      }
    }
  }
}

TEST(Generators2, DigitsKeepEveryCoincidenceOfALattice) {
  // The similarity draws from the same source of chance, so only the kinds of contact are compared, not their numbers.
  const Scene2 scene = generate_2(request("lattice", 60, 2, 17));
  for (const int count : contacts(scene)) EXPECT_GT(count, 0);
}

TEST(Generators2, NoFrontOnTheRimOfAClosedSceneLooksOut) {
  for (const std::string& kind : kinds()) {
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
      const Scene2 scene = generate_2(request(kind, 150, seed));
      EXPECT_EQ(scene.closed, kind != "plates");
      if (!scene.closed) continue;
      for (std::size_t k = 0; k < scene.surfaces.size(); ++k) {
        const Surface& s = scene.surfaces[k];
        const auto& [from, to] = scene.edges[k];
        bool something_left = false, something_right = false;
        for (const Edge2& t : scene.edges) {
          something_left |= turn(from, to, t.from) > 0;
          something_right |= turn(from, to, t.from) < 0;
        }
        EXPECT_TRUE(something_right) << scene.about << " " << s.name;
        EXPECT_TRUE(something_left || !s.back) << scene.about << " " << s.name;
      }
    }
  }
}

TEST(Generators2, SomethingEmitsAndEveryReferenceIsValid) {
  for (const std::string& kind : kinds()) {
    const Scene2 scene = generate_2(request(kind, 50, 4));
    bool emits = false;
    std::set<std::string> names;
    for (const Surface& s : scene.surfaces) {
      ASSERT_LT(s.material, scene.materials.size());
      ASSERT_LT(s.group, scene.groups.size());
      emits |= !scene.materials[s.material].emission.is_zero();
      EXPECT_TRUE(names.insert(s.name).second) << s.name;
    }
    EXPECT_TRUE(emits) << kind;
  }
}

TEST(Generators2, HalfOfTheClutterHasABackAndLengthIsObeyed) {
  auto r = request("clutter", 1004, 9);
  for (const Rational& length : {kShortView, kLongView}) {
    r.length = length;
    const Scene2 scene = generate_2(r);
    int backs = 0, full = 0;
    for (std::size_t i = 4; i < scene.surfaces.size(); ++i) {
      const Surface& s = scene.surfaces[i];
      const auto& [from, to] = scene.edges[i];
      const Rational dx = to.x - from.x, dy = to.y - from.y;
      const Rational squared = dx * dx + dy * dy;
      EXPECT_LE(squared, length * length);
      full += squared >= length * length * Rational(16, 25);
      backs += s.back.has_value();
    }
    EXPECT_EQ(backs, 500);
    EXPECT_GE(full, 990);
  }
}

TEST(Generators2, RefusesWhatItCannotMake) {
  EXPECT_THROW(generate_2(request("castle", 100, 1)), UsageError);
  EXPECT_THROW(generate_2(request("room", kMaxGeneratedEdges + 1, 1)), UsageError);
  EXPECT_THROW(generate_2(request("room", 100, 1, 3)), UsageError);
  EXPECT_THROW(generate_2(request("room", 100, 1, kMaxGeneratedDigits + 1)), UsageError);
  EXPECT_THROW(generate_2(request("lattice", 100, 1, 2)), UsageError);
  auto r = request("clutter", 100, 1);
  r.length = 5;
  EXPECT_THROW(generate_2(r), UsageError);
}

}  // namespace
}  // namespace hottel::generators_test
