#include "tests/oracle/space/pair_quadrature.h"

#include <algorithm>
#include <array>
#include <queue>

#include "tests/oracle/gauss_rule.h"
#include "tests/oracle/space/point_factor.h"

namespace hottel::oracle {
namespace {

constexpr double kSliver = 1e-11;  // cells, and pieces of lines, that are not worth cutting

// A point of the plane of i.
struct Place {
  double x, y;
};
Place between(const Place& p, const Place& q, double t) { return {p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)}; }
double doubled_area(const Place& p, const Place& q, const Place& r) {
  return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
}

using Cell = std::vector<Place>;
double area(const Cell& cell) {
  double sum = 0;
  for (std::size_t k = 2; k < cell.size(); ++k) sum += doubled_area(cell[0], cell[k - 1], cell[k]) / 2;
  return sum;
}

// A piece of a line at which the factor is not smooth, from one end to the other.
struct Event {
  Place from, to;

  // > 0 left of the line, by the distance from it.
  double side(const Place& p) const { return doubled_area(from, to, p) / std::hypot(to.x - from.x, to.y - from.y); }
};

// The plane of i in two coordinates.
class Frame {
 public:
  explicit Frame(const FlatPolygon& i) : origin_(i[0]), plane_(i) {
    east_ = i[1] - i[0];
    east_ = (1 / length(east_)) * east_;
    north_ = cross(plane_.normal, east_);
    for (const Vector& p : i) {
      outline_.push_back(place(p));
      reach_ = std::max(reach_, length(p - origin_));
    }
  }

  const Cell& outline() const { return outline_; }
  const FlatPlane& plane() const { return plane_; }
  double reach() const { return reach_; }  // all of i is within it of the origin
  Place place(const Vector& p) const { return {dot(east_, p - origin_), dot(north_, p - origin_)}; }
  Vector point(const Place& p) const { return origin_ + p.x * east_ + p.y * north_; }

 private:
  Vector origin_;
  FlatPlane plane_;
  Vector east_, north_;
  Cell outline_;
  double reach_ = 0;
};

// The lines on i at which what is seen of some polygons changes its shape.
class Events {
 public:
  Events(const Frame& frame, const PointFactor& factor) : frame_(frame) {
    std::vector<FlatPolygon> all = factor.between();
    all.push_back(factor.target());
    for (const FlatPolygon& a : all) {
      add_plane(a);
      for (const FlatPolygon& b : all)
        if (&a != &b)
          for (const Vector& corner : a)
            for (std::size_t k = 0; k < b.size(); ++k) add(corner, b[k], b[(k + 1) % b.size()]);
    }
  }

  const std::vector<Event>& all() const { return events_; }

 private:
  static constexpr double kFar = 1e3;  // times the reach: the ends of pieces without end

  void add_plane(const FlatPolygon& polygon) {
    const FlatPlane plane(polygon);
    const Vector along = cross(frame_.plane().normal, plane.normal);
    const double size = length(along);
    if (size < kSliver) return;
    // The point of the line that is nearest to the origin of the frame.
    const Vector origin = frame_.point({0, 0}), across = cross(along, frame_.plane().normal);
    const Vector p = origin - (plane.height(origin) / (size * size)) * across;
    add_piece(p - (kFar * frame_.reach() / size) * along, p + (kFar * frame_.reach() / size) * along);
  }

  // From where the corner is seen on the side from a to b.
  void add(const Vector& corner, const Vector& a, const Vector& b) {
    const double top = frame_.plane().height(corner);
    const double over_a = frame_.plane().height(a) - top, over_b = frame_.plane().height(b) - top;
    if (top < kSliver) return;  // from the plane of i it is not seen at all
    if (over_a * over_b >= 0) {
      add_ray_ends(corner, a, b, top, over_a, over_b);
    } else {  // a part of the side is above the corner, another one below
      const Vector level = (over_b / (over_b - over_a)) * a + (over_a / (over_a - over_b)) * b;
      add_ray_ends(corner, a, level, top, over_a, 0);
      add_ray_ends(corner, level, b, top, 0, over_b);
    }
  }

  void add_ray_ends(const Vector& corner, const Vector& a, const Vector& b, double top, double over_a, double over_b) {
    const double least = top / kFar;
    const double sign = over_a + over_b < 0 ? -1 : 1;
    const auto end = [&](const Vector& p, double over) {
      const double h = std::fabs(over) < least ? sign * least : over;
      return corner - (top / h) * (p - corner);
    };
    if (std::fabs(over_a) < least && std::fabs(over_b) < least) return;
    add_piece(end(a, over_a), end(b, over_b));
  }

  void add_piece(const Vector& p, const Vector& q) {
    const Event event{frame_.place(p), frame_.place(q)};
    if (std::hypot(event.to.x - event.from.x, event.to.y - event.from.y) > kSliver) events_.push_back(event);
  }

  const Frame& frame_;
  std::vector<Event> events_;
};

// Does the piece run through the inside of the cell?
bool crosses(const Event& event, const Cell& cell) {
  double least = 0, most = 0, from = 0, to = 1;
  for (const Place& p : cell) {
    const double side = event.side(p);
    least = std::min(least, side);
    most = std::max(most, side);
  }
  if (least > -kSliver || most < kSliver) return false;
  for (std::size_t k = 0; k < cell.size(); ++k) {
    const Place &p = cell[k], &q = cell[(k + 1) % cell.size()];
    const double a = doubled_area(p, q, event.from), b = doubled_area(p, q, event.to);
    if (a <= 0 && b <= 0) return false;
    if (a < 0) from = std::max(from, a / (a - b));
    if (b < 0) to = std::min(to, a / (a - b));
  }
  return from < to;
}

std::pair<Cell, Cell> cut(const Cell& cell, const Event& event) {
  std::pair<Cell, Cell> parts;
  for (std::size_t k = 0; k < cell.size(); ++k) {
    const Place &p = cell[k], &q = cell[(k + 1) % cell.size()];
    const double a = event.side(p), b = event.side(q);
    if (a >= 0) parts.first.push_back(p);
    if (a <= 0) parts.second.push_back(p);
    if (a * b < 0) {
      parts.first.push_back(between(p, q, a / (a - b)));
      parts.second.push_back(parts.first.back());
    }
  }
  return parts;
}

// The cells into which the events cut a polygon.
std::vector<Cell> cells_of(const Cell& outline, const std::vector<Event>& events) {
  struct Work {
    Cell cell;
    std::vector<std::size_t> events;
  };
  std::vector<std::size_t> numbers(events.size());
  for (std::size_t k = 0; k < numbers.size(); ++k) numbers[k] = k;
  std::vector<Work> work{{outline, numbers}};
  std::vector<Cell> cells;
  while (!work.empty()) {
    Work now = std::move(work.back());
    work.pop_back();
    std::erase_if(now.events, [&](std::size_t k) { return !crosses(events[k], now.cell); });
    if (now.events.empty() || area(now.cell) < kSliver) {
      cells.push_back(std::move(now.cell));
      continue;
    }
    const auto middle = now.events.begin() + static_cast<std::ptrdiff_t>(now.events.size() / 2);
    auto [left, right] = cut(now.cell, events[*middle]);
    now.events.erase(middle);
    work.push_back({std::move(left), now.events});
    work.push_back({std::move(right), std::move(now.events)});
  }
  return cells;
}

struct Triangle {
  std::array<Place, 3> corner;
  double measure = 0, error = 0;
  friend bool operator<(const Triangle& a, const Triangle& b) { return a.error < b.error; }
};

class Quadrature {
 public:
  Quadrature(const Frame& frame, const PointFactor& factor) : frame_(frame), factor_(factor) {}

  void add(const std::array<Place, 3>& corner) {
    Triangle triangle{corner};
    const double coarse = integral(corner, kCoarse);
    triangle.measure = integral(corner, kFine);
    triangle.error = std::fabs(triangle.measure - coarse);
    error_ += triangle.error;
    heap_.push(triangle);
  }

  // Halves triangles until their errors sum up to no more than this.
  void refine(double error, std::uint64_t max_points) {
    while (error_ > error && points_ < max_points && !heap_.empty()) {
      const Triangle worst = heap_.top();
      heap_.pop();
      error_ -= worst.error;
      // Across its longest side.
      std::size_t longest = 0;
      std::array<double, 3> size{};
      for (std::size_t k = 0; k < 3; ++k) {
        const Place &p = worst.corner[k], &q = worst.corner[(k + 1) % 3];
        size[k] = std::hypot(q.x - p.x, q.y - p.y);
        if (size[k] > size[longest]) longest = k;
      }
      const Place &p = worst.corner[longest], &q = worst.corner[(longest + 1) % 3],
                  &r = worst.corner[(longest + 2) % 3];
      const Place middle = between(p, q, 0.5);
      add({p, middle, r});
      add({middle, q, r});
    }
  }

  QuadratureResult result() {
    QuadratureResult result{0, 0, points_};
    for (; !heap_.empty(); heap_.pop()) {
      result.measure += heap_.top().measure;
      result.error += heap_.top().error;
    }
    return result;
  }

 private:
  inline static const GaussRule kCoarse{4}, kFine{6};

  double integral(const std::array<Place, 3>& corner, const GaussRule& rule) {
    const double doubled = doubled_area(corner[0], corner[1], corner[2]);
    if (!(doubled > 0)) return 0;
    double sum = 0;
    for (std::size_t a = 0; a < rule.node.size(); ++a)
      for (std::size_t b = 0; b < rule.node.size(); ++b) {
        const auto u = static_cast<double>(rule.node[a]), v = static_cast<double>(rule.node[b]);
        const Place p = between(corner[0], between(corner[1], corner[2], v), u);
        sum += static_cast<double>(rule.weight[a] * rule.weight[b]) * u * factor_(frame_.point(p));
      }
    points_ += rule.node.size() * rule.node.size();
    return doubled * sum;
  }

  const Frame& frame_;
  const PointFactor& factor_;
  std::priority_queue<Triangle> heap_;
  double error_ = 0;
  std::uint64_t points_ = 0;
};

}  // namespace

QuadratureResult exchange_by_quadrature(const FlatPair& pair, double tolerance, std::uint64_t max_points) {
  const PointFactor factor(pair);
  const FlatPolygon source = part_above(pair.i, FlatPlane(pair.j));
  if (factor.target().empty() || source.empty()) return {};
  const Frame frame(source);
  Quadrature quadrature(frame, factor);
  for (const Cell& cell : cells_of(frame.outline(), Events(frame, factor).all()))
    for (std::size_t k = 2; k < cell.size(); ++k) quadrature.add({cell[0], cell[k - 1], cell[k]});
  quadrature.refine(tolerance * area(pair.i), max_points);
  return quadrature.result();
}

}  // namespace hottel::oracle
