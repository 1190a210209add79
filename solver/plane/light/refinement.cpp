#include "solver/plane/light/refinement.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "geometry/face.h"
#include "geometry/plane/scene/division.h"
#include "geometry/plane/scene/moving_lights.h"
#include "geometry/plane/visibility/point_location.h"
#include "geometry/plane/visibility/solid_around.h"
#include "geometry/plane/visibility/sun_view.h"
#include "kernel/support/parallel.h"
#include "solver/plane/light/beam.h"

namespace hottel {
namespace {

// The parts of the way along each edge that belong to its faces, by face number, ascending.
std::vector<std::vector<EdgeSpan2>> owned_spans(const PreparedScene2& prepared) {
  const Arrangement2& arrangement = prepared.arrangement;
  std::vector<std::vector<EdgeSpan2>> spans(2 * prepared.scene.surfaces.size());
  for (const PieceSideId side : arrangement.sides()) {
    if (arrangement.is_covered(side)) continue;
    const FacePart2& owner = arrangement.owner(side);
    const Edge2& edge = prepared.scene.edges[owner.surface];
    const Point2 along = minus(edge.to, edge.from);
    const auto at = [&](VertexId v) {
      const Point2 p = minus(arrangement.vertices().to_scene(arrangement.vertices().exact(v)), edge.from);
      return Rational(along.x != 0 ? p.x / along.x : p.y / along.y);
    };
    const Segment2& piece = arrangement.piece(side);
    Rational from = at(piece.a), to = at(piece.b);
    if (to < from) std::swap(from, to);
    spans[owner.number()].push_back({std::move(from), std::move(to)});
  }
  for (auto& of_face : spans) std::ranges::sort(of_face, {}, &EdgeSpan2::from);
  return spans;
}

// What a light reaches of edges.
class LitEdges2 {
 public:
  LitEdges2(const PreparedScene2& prepared, const PointLocation2& location, const Light& light,
            const LightPlace2& place)
      : prepared_(prepared), eye_(place.position), windows_(2 * prepared.scene.surfaces.size()) {
    if (light.is_sun())
      look_from_sun(place);
    else
      look_from_lamp(location, light, place);
    for (auto& of_face : windows_)
      std::ranges::sort(of_face, [](const Window& a, const Window& b) { return a.span.from < b.span.from; });
  }

  // Adds what is reached of a part of a face that belongs to it.
  void add(const Face& face, const EdgeSpan2& span, ReachSum& sum) const {
    const std::vector<Window>& windows = windows_[face.number()];
    auto window = std::ranges::partition_point(windows, [&](const Window& w) { return w.span.to <= span.from; });
    Rational done = span.from;
    for (; window != windows.end() && window->span.from < span.to && !sum.is_part(); ++window) {
      if (window->span.from > done) sum.add(Reach::kNothing);
      const EdgeSpan2 common{std::max(window->span.from, done), std::min(window->span.to, span.to)};
      sum.add(lit(face, *window, common));
      done = common.to;
    }
    if (done < span.to) sum.add(Reach::kNothing);
  }

 private:
  // A part of a face that is seen from the light.
  struct Window {
    EdgeSpan2 span;
    Beam2::Meets meets = Beam2::Meets::kNothing;
    bool is_reversed = false;  // counter-clockwise is against the edge
  };

  void look_from_sun(const LightPlace2& place) {
    const Vertices2& vertices = prepared_.arrangement.vertices();
    const SunView2 view(prepared_.arrangement, turned_direction(place));
    for (const SunView2::Strip& strip : view.strips()) {
      const Face face = prepared_.arrangement.owner(strip.side);
      const Edge2& edge = prepared_.scene.edges[face.surface];
      const Rational begin = view.across(vertices.from_scene(edge.from)),
                     all = view.across(vertices.from_scene(edge.to)) - begin;
      Window window{.span = {(view.across(strip.from) - begin) / all, (view.across(strip.to) - begin) / all},
                    .meets = Beam2::Meets::kAll};
      if (window.span.to < window.span.from) std::swap(window.span.from, window.span.to);
      windows_[face.number()].push_back(std::move(window));
    }
  }

  void look_from_lamp(const PointLocation2& location, const Light& light, const LightPlace2& place) {
    const PreparedScene2& prepared = prepared_;
    beam_.emplace(light, place);
    const Vertices2& vertices = prepared.arrangement.vertices();
    const Eye2 eye(vertices, vertices.from_scene(place.position));
    View2 view;
    location.look_around(eye, view);
    if (solid_around(prepared.arrangement, view) != Solids2::kNone) return;
    for (std::size_t k = 0; k < view.seen.size(); ++k) {
      const PieceSideId side = view.seen[k].behind;
      if (side == kSky) continue;
      const Face face = prepared.arrangement.owner(side);
      const auto toward = [&](const View2::Seen& seen) {
        return minus(vertices.to_scene(vertices.exact(seen.vertex)), eye_);
      };
      const Point2 from = toward(view.seen[k]), to = toward(view.seen[k + 1 == view.seen.size() ? 0 : k + 1]);
      Window window{.span = {along(face, from), along(face, to)}, .meets = beam_->meets(from, to)};
      window.is_reversed = window.span.to < window.span.from;
      if (window.is_reversed) std::swap(window.span.from, window.span.to);
      windows_[face.number()].push_back(std::move(window));
    }
  }

  // Where the ray in a direction meets the line of a face.
  Rational along(const Face& face, const Point2& direction) const {
    const Edge2& edge = prepared_.scene.edges[face.surface];
    return cross(minus(eye_, edge.from), direction) / cross(minus(edge.to, edge.from), direction);
  }

  Reach lit(const Face& face, const Window& window, const EdgeSpan2& span) const {
    Beam2::Meets meets = window.meets;
    if (meets == Beam2::Meets::kPart && span != window.span) {
      const Edge2& edge = prepared_.scene.edges[face.surface];
      Point2 from = minus(point_at(edge, span.from), eye_), to = minus(point_at(edge, span.to), eye_);
      if (window.is_reversed) std::swap(from, to);
      meets = beam_->meets(from, to);
    }
    return meets == Beam2::Meets::kAll ? Reach::kAll : meets == Beam2::Meets::kPart ? Reach::kPart : Reach::kNothing;
  }

  const PreparedScene2& prepared_;
  std::optional<Beam2> beam_;  // of a lamp
  Point2 eye_;
  std::vector<std::vector<Window>> windows_;  // by face number, ascending
};

// The leaves under the parts of one face.
class FaceTree {
 public:
  FaceTree(const Face& face, std::uint32_t parts, const std::vector<EdgeSpan2>& owned,
           const std::vector<LitEdges2>& lights, const RefinementLevels& levels)
      : face_(face), parts_(parts), owned_(owned), lights_(lights), levels_(levels) {
    for (std::uint32_t part = 0; part < parts; ++part) append({part, {}});
  }

  std::vector<TreeNode> leaves;

 private:
  void append(const TreeNode& node) {
    const int depth = node.path.depth();
    const bool is_divided =
        depth < levels_.everywhere || (depth < levels_.at_borders && is_crossed(EdgeSpan2::of(parts_, node)));
    if (!is_divided) {
      leaves.push_back(node);
      return;
    }
    for (const int digit : {0, 1}) append({node.part, node.path.child(digit)});
  }

  bool is_crossed(const EdgeSpan2& span) const {
    return std::ranges::any_of(lights_, [&](const LitEdges2& light) {
      ReachSum sum;
      for (const EdgeSpan2& owned : owned_) {
        const EdgeSpan2 common{std::max(owned.from, span.from), std::min(owned.to, span.to)};
        if (common.from < common.to) light.add(face_, common, sum);
        if (sum.is_part()) return true;
      }
      return false;
    });
  }

  Face face_;
  std::uint32_t parts_;
  const std::vector<EdgeSpan2>& owned_;
  const std::vector<LitEdges2>& lights_;
  RefinementLevels levels_;
};

}  // namespace

std::vector<SurfaceTrees> refined_trees(const PreparedScene2& prepared, const RefinementLevels& levels) {
  const DefaultFloatingPoint arithmetic;
  const Scene2& scene = prepared.scene;
  std::vector<SurfaceTrees> trees(scene.surfaces.size());
  if (!levels.is_any()) return trees;
  std::vector<LitEdges2> lights;
  std::vector<std::vector<EdgeSpan2>> owned(2 * scene.surfaces.size());
  if (levels.at_borders > levels.everywhere && !scene.lights.empty()) {
    const PointLocation2 location(prepared.arrangement.vertices(), prepared.arrangement.triangulation());
    for (std::size_t k = 0; k < scene.lights.size(); ++k)
      lights.emplace_back(prepared, location, scene.lights[k], scene.light_places[k]);
    owned = owned_spans(prepared);
  }
  parallel_for(scene.surfaces.size(), [&](std::size_t s) {
    const Surface& surface = scene.surfaces[s];
    for (const bool is_back : {false, true}) {
      if (!surface.material_of(is_back)) continue;
      const Face face{static_cast<std::uint32_t>(s), is_back};
      FaceTree tree(face, surface.elements, owned[face.number()], lights, levels);
      if (tree.leaves.size() > surface.elements) (is_back ? trees[s].back : trees[s].front) = std::move(tree.leaves);
    }
  });
  return trees;
}

}  // namespace hottel
