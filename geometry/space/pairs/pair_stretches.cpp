#include "geometry/space/pairs/pair_stretches.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <unordered_map>

#include "geometry/space/stretches/stretch_parts.h"

namespace hottel {
namespace {

// Rounding of doubles is far below this part of a length.
constexpr double kSlack = 1e-9;

Rational quotient(const Integer& numerator, const Integer& denominator) {
  Rational result(numerator, denominator);
  result.canonicalize();
  return result;
}

class StretchFinder {
 public:
  StretchFinder(const PairOccluders3& setting, const SurfaceStretches3& stretches)
      : bodies_(setting.bodies), setting_(setting), stretches_(stretches) {
    for (std::uint32_t body = 2; body < bodies_.end_of_between(); ++body) numbers_[bodies_.bodies[body].surface] = body;
  }

  void add_patch(const Patch3& patch, std::uint32_t own, const Patch3& other) {
    own_ = own;
    other_surface_ = other.surface;
    std::span<const AtomicStretch3> grounds;
    if (!patch.is_sky() && !numbers_.empty()) grounds = grounds_of(patch, own);
    relevant_.clear();
    for (const AtomicStretch3& ground : grounds)
      if (is_of_bodies(ground)) relevant_.push_back(&ground);
    const std::size_t count = patch.corners.size();
    for (std::size_t k = 0; k < count; ++k)
      add_source(stretch_between({patch.corners[k], patch.weight}, {patch.corners[(k + 1) % count], patch.weight}));
    for (const AtomicStretch3* ground : relevant_) add_foot(*ground, patch);
  }

  void add_outlines() {
    std::vector<std::uint32_t> found;
    for (std::uint32_t body = 2; body < bodies_.end_of_between(); ++body)
      for (const std::uint32_t number : stretches_.outlines_of(bodies_.bodies[body].surface)) found.push_back(number);
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    for (const std::uint32_t number : found) add_outline(number);
  }

  std::vector<PairStretch3> take() { return std::move(result_); }

 private:
  std::span<const AtomicStretch3> grounds_of(const Patch3& patch, std::uint32_t own) const {
    const bool is_back = !is_front(patch, own);
    return stretches_.grounds(patch.surface, is_back);
  }
  bool is_front(const Patch3& patch, std::uint32_t own) const {
    return sgn(dot(bodies_.bodies[own].exact_normal(), stretches_.normal(patch.surface))) > 0;
  }

  // True iff some of the surfaces there are among the bodies.
  bool is_of_bodies(const AtomicStretch3& ground) const {
    return std::any_of(ground.faces.begin(), ground.faces.end(),
                       [this](const StretchFace3& face) { return numbers_.contains(face.surface); });
  }

  // True iff all are, but for what is left out: past others nothing is seen. One is, of grounds and outlines asked
  // about.
  bool are_of_bodies(const AtomicStretch3& stretch) const {
    return std::all_of(stretch.faces.begin(), stretch.faces.end(), [this](const StretchFace3& face) {
      return numbers_.contains(face.surface) || std::ranges::binary_search(setting_.left_out, face.surface);
    });
  }

  bool is_on_line(const Stretch3& line, const IntegerVector& point, const Integer& weight) const {
    const IntegerVector offset = difference(multiple(line.weight, point), multiple(weight, line.from));
    return is_zero(cross(line.way, offset));
  }

  // Adds an edge of a patch, divided where surfaces at it begin and end.
  void add_source(Stretch3 edge) {
    struct Part {
      Rational low, high;
      const AtomicStretch3* ground;
    };
    std::vector<Part> parts;
    std::vector<Rational> ends;
    for (const AtomicStretch3* ground : relevant_) {
      const Stretch3& g = ground->stretch;
      if (!is_on_line(edge, g.from, g.weight)) continue;
      const WeightedPoint3 end = end_of(g);
      if (!is_on_line(edge, end.numerator, end.weight)) continue;
      const Integer square = dot(edge.way, edge.way);
      const auto place = [&](const IntegerVector& p) {
        const IntegerVector offset = difference(multiple(edge.weight, p), multiple(g.weight, edge.from));
        return quotient(dot(edge.way, offset), g.weight * square);
      };
      Rational low = place(g.from), high = place(end.numerator);
      if (low > high) std::swap(low, high);
      low = std::max(low, Rational(0));
      high = std::min(high, Rational(1));
      if (low >= high) continue;
      ends.push_back(low);
      ends.push_back(high);
      parts.push_back({std::move(low), std::move(high), ground});
    }
    if (parts.empty()) {
      result_.push_back({std::move(edge), nullptr, StretchRole3::kSource, own_, {}, 0, 1});
      return;
    }
    ends.insert(ends.end(), {0, 1});
    std::sort(ends.begin(), ends.end());
    ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
    for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
      PairStretch3 stretch{part_of(edge, ends[k], ends[k + 1]), nullptr, StretchRole3::kSource, own_, {}, 0, 1};
      for (const Part& part : parts) {
        if (part.low > ends[k] || part.high < ends[k + 1]) continue;
        for (const StretchFace3& face : part.ground->faces) add_face(face, stretch);
      }
      result_.push_back(std::move(stretch));
    }
  }

  void add_face(const StretchFace3& face, PairStretch3& stretch) const {
    const auto number = numbers_.find(face.surface);
    if (number == numbers_.end()) return;
    stretch.faces.push_back({number->second, face.is_forward, bodies_.of_patch[number->second][own_].has_front});
  }

  // Adds what is inside the patch of a stretch on which surfaces stand.
  void add_foot(const AtomicStretch3& ground, const Patch3& patch) {
    const bool is_target_there =
        std::any_of(ground.faces.begin(), ground.faces.end(),
                    [this](const StretchFace3& face) { return face.surface == other_surface_; });
    if (is_target_there || !are_of_bodies(ground)) return;
    std::vector<WeightedPoint3> corners;
    for (const IntegerVector& corner : patch.corners) corners.push_back({corner, patch.weight});
    const auto part = part_inside(ground.stretch, corners, bodies_.bodies[own_].exact_normal());
    if (!part) return;
    PairStretch3 stretch{part_of(ground.stretch, (*part)[0], (*part)[1]), nullptr, StretchRole3::kFoot, own_, {}, 0, 1};
    for (const StretchFace3& face : ground.faces) add_face(face, stretch);
    result_.push_back(std::move(stretch));
  }

  void add_outline(std::uint32_t place) {
    const AtomicStretch3& outline = stretches_.outline(place);
    if (!are_of_bodies(outline)) return;
    double low = 0, high = 1;
    if (!cut_short(stretches_.outline_ends(place), low, high)) return;
    PairStretch3& stretch = result_.emplace_back();
    stretch.known = &outline.stretch;
    stretch.role = StretchRole3::kOutline;
    stretch.low = low;
    stretch.high = high;
    for (const StretchFace3& face : outline.faces)
      if (const auto number = numbers_.find(face.surface); number != numbers_.end())
        stretch.faces.push_back({number->second, face.is_forward, false});
  }

  bool cut_short(const std::array<Direction3, 2>& ends, double& low, double& high) const {
    const Direction3 &a = ends[0], &b = ends[1];
    const double slack = kSlack * (length(a) + length(b));
    for (const HullHalfSpace3& plane : setting_.half_spaces) {
      const double at_a = plane.height(a) + slack, at_b = plane.height(b) + slack;
      if (at_a < 0 && at_b < 0) return false;
      if (at_a >= 0 && at_b >= 0) continue;
      const double zero = at_a / (at_a - at_b);
      if (at_a < 0)
        low = std::max(low, zero);
      else
        high = std::min(high, zero);
    }
    return low < high;
  }

  const PairGeometry3& bodies_;
  const PairOccluders3& setting_;
  const SurfaceStretches3& stretches_;
  std::unordered_map<std::uint32_t, std::uint32_t> numbers_;  // of surfaces among the bodies
  std::uint32_t own_ = 0, other_surface_ = 0;
  std::vector<const AtomicStretch3*> relevant_;
  std::vector<PairStretch3> result_;
};

}  // namespace

std::vector<PairStretch3> pair_stretches(const PairOccluders3& setting, const SurfaceStretches3& stretches,
                                         const Patch3& i, const Patch3& j) {
  StretchFinder finder(setting, stretches);
  finder.add_patch(i, 0, j);
  if (!j.is_far()) finder.add_patch(j, 1, i);  // directions do not move, whatever does
  finder.add_outlines();
  return finder.take();
}

}  // namespace hottel
