#include "viewer/picture/space/smooth_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>

#include "geometry/space/prepared/element_table.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "viewer/picture/bounded_mean.h"

namespace hottel {
namespace {

using Part = ElementTable3::Part;

// What the parts of one flat surface have in common: whose it is, its material, and its plane with the side.
struct FlatSurface {
  bool is_of_group = false;
  std::uint32_t owner = 0, material = 0;
  std::array<Rational, 4> plane{};

  friend bool operator<(const FlatSurface& a, const FlatSurface& b) {
    return std::tie(a.is_of_group, a.owner, a.material, a.plane) <
           std::tie(b.is_of_group, b.owner, b.material, b.plane);
  }
};

std::array<Rational, 4> plane_of(const Polygon3& polygon, bool is_back) {
  Vector3 n = doubled_area(polygon);
  const Rational& first = n.x != 0 ? n.x : n.y != 0 ? n.y : n.z;
  const Rational scale = (is_back ? -1 : 1) / Rational(abs(first));
  n = {n.x * scale, n.y * scale, n.z * scale};
  return {n.x, n.y, n.z, dot(n, polygon.points[0] - Point3{})};
}

// The first material that acts like each.
std::vector<std::uint32_t> materials_alike(const SceneTable& scene) {
  std::vector<std::uint32_t> result;
  for (std::uint32_t m = 0; m < scene.materials.size(); ++m) {
    std::uint32_t first = 0;
    while (!(scene.materials[first] == scene.materials[m])) ++first;
    result.push_back(first);
  }
  return result;
}

struct LexicalLess {
  bool operator()(const Point3& a, const Point3& b) const { return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z); }
};

// The corners of one flat surface, to find those that lie within a side. They are looked at along the axis that the
// plane has most of, as that keeps what is on a line, and what is not.
class FlatCorners {
 public:
  FlatCorners(const std::vector<Point3>& corners, std::uint32_t begin, const std::array<Rational, 4>& plane)
      : corners_(corners), begin_(begin) {
    const std::array<double, 3> n{std::fabs(to_double(plane[0])), std::fabs(to_double(plane[1])),
                                  std::fabs(to_double(plane[2]))};
    const auto most = static_cast<std::size_t>(std::max_element(n.begin(), n.end()) - n.begin());
    constexpr std::array<Rational Point3::*, 3> kAxes{&Point3::x, &Point3::y, &Point3::z};
    across_ = kAxes[(most + 1) % 3];
    up_ = kAxes[(most + 2) % 3];
    for (std::uint32_t k = begin; k < corners.size(); ++k) {
      places_.push_back({rounded(corners[k], across_), rounded(corners[k], up_), k});
      extent_ = std::max({extent_, std::fabs(places_.back().x), std::fabs(places_.back().y)});
    }
    std::sort(places_.begin(), places_.end(), [](const Place& a, const Place& b) { return a.x < b.x; });
  }

  struct InSide {
    Rational share;  // of the way
    std::uint32_t corner;
  };
  // Those strictly between two corners, in order.
  std::vector<InSide> between(std::uint32_t from, std::uint32_t to) const {
    const Place a = place(from), b = place(to);
    const double slack = 1e-9 * extent_, low = std::min(a.x, b.x) - slack, high = std::max(a.x, b.x) + slack;
    const double bottom = std::min(a.y, b.y) - slack, top = std::max(a.y, b.y) + slack;
    std::vector<InSide> found;
    auto next = std::lower_bound(places_.begin(), places_.end(), low, [](const Place& p, double x) { return p.x < x; });
    for (; next != places_.end() && next->x <= high; ++next) {
      if (next->y < bottom || next->y > top || next->corner == from || next->corner == to) continue;
      const double off = (b.x - a.x) * (next->y - a.y) - (b.y - a.y) * (next->x - a.x);
      if (std::fabs(off) > slack * (std::fabs(b.x - a.x) + std::fabs(b.y - a.y))) continue;
      if (const auto part = part_of_way(corners_[from], corners_[to], corners_[next->corner]); part > 0 && part < 1)
        found.push_back({part, next->corner});
    }
    std::sort(found.begin(), found.end(), [](const InSide& p, const InSide& q) {
      return std::tie(p.share, p.corner) < std::tie(q.share, q.corner);
    });
    return found;
  }

 private:
  struct Place {
    double x, y;
    std::uint32_t corner;
  };

  double rounded(const Point3& p, Rational Point3::*axis) const { return to_double(p.*axis - corners_[begin_].*axis); }
  Place place(std::uint32_t corner) const {
    return {rounded(corners_[corner], across_), rounded(corners_[corner], up_), corner};
  }

  // How far along the way a point on its line is; -1 for others.
  Rational part_of_way(const Point3& from, const Point3& to, const Point3& p) const {
    const Rational dx = to.*across_ - from.*across_, dy = to.*up_ - from.*up_;
    const Rational x = p.*across_ - from.*across_, y = p.*up_ - from.*up_;
    if (dx * y != dy * x) return -1;
    return dx != 0 ? Rational(x / dx) : Rational(y / dy);
  }

  const std::vector<Point3>& corners_;
  std::uint32_t begin_;
  Rational Point3::*across_;
  Rational Point3::*up_;
  std::vector<Place> places_;
  double extent_ = 0;
};

// The parts of each flat surface.
std::map<FlatSurface, std::vector<std::uint32_t>> flat_surfaces(const PreparedScene3& prepared,
                                                                const ElementTable3& table) {
  const std::vector<std::size_t> members = group_sizes(prepared.scene);
  const std::vector<std::uint32_t> alike = materials_alike(prepared.scene);
  std::map<FlatSurface, std::vector<std::uint32_t>> result;
  for (std::uint32_t k = 0; k < table.parts().size(); ++k) {
    const Part& part = table.parts()[k];
    if (part.patch.is_sky() || !table.has_row(part.label)) continue;
    const Element& element = table.elements()[part.label];
    const std::uint32_t group = prepared.scene.surfaces[element.surface].group;
    const bool is_of_group = members[group] > 1;
    const Polygon3& polygon = prepared.arrangement().pieces()[part.patch.surface].polygon;
    result[{is_of_group, is_of_group ? group : element.surface, alike[*element.material],
            plane_of(polygon, part.is_back)}]
        .push_back(k);
  }
  return result;
}

}  // namespace

class SmoothMesh3::Builder {
 public:
  Builder(SmoothMesh3& mesh, const PreparedScene3& prepared, const ElementTable3& table)
      : mesh_(mesh), vertices_(prepared.occluders().vertices()), table_(table), rings_(table.parts().size()) {
    for (const auto& [surface, parts] : flat_surfaces(prepared, table)) {
      const std::uint32_t first = label(parts[0]);
      const auto is_other = [&](std::uint32_t k) { return label(k) != first; };
      if (std::any_of(parts.begin(), parts.end(), is_other)) add(surface, parts);
    }
    set_rings();
    set_meeting();
    set_hanging();
  }

 private:
  // A side in which a corner hangs.
  struct Side {
    std::uint32_t from, to;
    Rational share, length_squared;
  };

  std::uint32_t label(std::size_t part) const { return table_.parts()[part].label; }
  const Point3& point(std::uint32_t corner) const { return mesh_.corners_[corner]; }

  void add(const FlatSurface& surface, const std::vector<std::uint32_t>& parts) {
    const auto begin = static_cast<std::uint32_t>(mesh_.corners_.size());
    std::map<Point3, std::uint32_t, LexicalLess> known;
    std::vector<std::vector<std::uint32_t>> outlines;
    for (const std::uint32_t k : parts) {
      outlines.emplace_back();
      for (const Point3& p : corners_of(vertices_, table_.parts()[k].patch)) {
        const auto [place, is_new] = known.try_emplace(p, static_cast<std::uint32_t>(mesh_.corners_.size()));
        if (is_new) mesh_.corners_.push_back(p);
        outlines.back().push_back(place->second);
      }
    }
    const FlatCorners flat(mesh_.corners_, begin, surface.plane);
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const std::vector<std::uint32_t>& outline = outlines[i];
      for (std::size_t k = 0; k < outline.size(); ++k) {
        const std::uint32_t from = outline[k], to = outline[(k + 1) % outline.size()];
        rings_[parts[i]].push_back(from);
        for (const FlatCorners::InSide& corner : flat.between(from, to)) {
          rings_[parts[i]].push_back(corner.corner);
          add_side(corner, from, to);
        }
      }
    }
  }
  // Keeps the longest side of a corner, of equal ones the first.
  void add_side(const FlatCorners::InSide& corner, std::uint32_t from, std::uint32_t to) {
    const Vector3 way = point(to) - point(from);
    const Side side{from, to, corner.share, dot(way, way)};
    const auto [place, is_new] = sides_.try_emplace(corner.corner, side);
    if (!is_new && place->second.length_squared < side.length_squared) place->second = side;
  }

  void set_rings() {
    for (const std::vector<std::uint32_t>& ring : rings_) {
      mesh_.begin_.push_back(mesh_.ring_.size());
      mesh_.ring_.insert(mesh_.ring_.end(), ring.begin(), ring.end());
    }
    mesh_.begin_.push_back(mesh_.ring_.size());
  }
  // Each element once, however many of its parts meet in a corner.
  void set_meeting() {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> meeting;  // corner, element
    for (std::size_t part = 0; part < rings_.size(); ++part)
      for (const std::uint32_t corner : rings_[part]) meeting.emplace_back(corner, label(part));
    std::sort(meeting.begin(), meeting.end());
    meeting.erase(std::unique(meeting.begin(), meeting.end()), meeting.end());
    mesh_.first_.assign(mesh_.corners_.size() + 1, 0);
    for (const auto& [corner, element] : meeting) {
      ++mesh_.first_[corner + 1];
      mesh_.meeting_.push_back(element);
    }
    std::partial_sum(mesh_.first_.begin(), mesh_.first_.end(), mesh_.first_.begin());
    for (std::uint32_t element = 0; element < table_.count(); ++element)
      mesh_.area_.push_back(std::max(table_.extent(element).value, std::numeric_limits<double>::min()));
  }
  void set_hanging() {
    std::vector<HangingCorner3> hanging;
    for (const auto& [corner, side] : sides_) hanging.push_back({corner, side.from, side.to, to_double(side.share)});
    mesh_.hanging_ = in_order(hanging);
  }

  SmoothMesh3& mesh_;
  const Vertices3& vertices_;
  const ElementTable3& table_;
  std::vector<std::vector<std::uint32_t>> rings_;  // by part
  std::map<std::uint32_t, Side> sides_;            // by corner
};

SmoothMesh3::SmoothMesh3(const PreparedScene3& prepared, const ElementTable3& table) {
  Builder(*this, prepared, table);
}

std::vector<double> SmoothMesh3::at_corners(std::span<const double> by_element, std::size_t channels) const {
  std::vector<double> values;
  std::vector<BoundedMean> means;
  for (std::size_t corner = 0; corner < corners_.size(); ++corner) {
    means.assign(channels, {});
    for (std::size_t k = first_[corner]; k < first_[corner + 1]; ++k) {
      const std::span<const double> value = by_element.subspan(meeting_[k] * channels, channels);
      if (std::isnan(value[0])) continue;
      for (std::size_t c = 0; c < channels; ++c) means[c].add(value[c], area_[meeting_[k]]);
    }
    for (const BoundedMean& mean : means) values.push_back(mean.value());
  }
  hang(hanging_, channels, values);
  return values;
}

}  // namespace hottel
