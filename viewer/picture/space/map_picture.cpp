#include "viewer/picture/space/map_picture.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>

#include "geometry/space/scene/scene.h"
#include "geometry/space/visibility/convex_cut.h"
#include "geometry/space/visibility/visibility_map.h"
#include "kernel/plain_functions.h"
#include "kernel/support/failure.h"
#include "viewer/picture/cairo_canvas.h"
#include "viewer/picture/colour_map.h"
#include "viewer/picture/palette.h"

namespace hottel {
namespace {

constexpr double kHeight = 1024, kTitle = 76;  // units of the whole, and of the heading

// The part of a piece with dot(normal, direction) >= 0.
std::vector<Direction3> cut(const std::vector<Direction3>& piece, const Direction3& normal) {
  return cut_convex(
      piece, [&](const Direction3& d) { return dot(normal, d); },
      [](const Direction3& a, const Direction3& b, double t) { return unit((1 - t) * a + t * b); });
}

using Arc = std::pair<Direction3, Direction3>;

// The part of an arc, or of nothing; nothing where none is left.
std::optional<Arc> cut(const std::optional<Arc>& arc, const Direction3& normal) {
  if (!arc) return std::nullopt;
  const double at_a = dot(normal, arc->first), at_b = dot(normal, arc->second);
  if (at_a < 0 && at_b < 0) return std::nullopt;
  if ((at_a < 0) == (at_b < 0)) return arc;
  const double t = at_a / (at_a - at_b);
  const Direction3 between = unit((1 - t) * arc->first + t * arc->second);
  return at_a < 0 ? Arc{between, arc->second} : Arc{arc->first, between};
}

// A side of a piece: an arc from angle 0 on the great circle of a normal.
struct PieceSide {
  Direction3 from, normal;
  double angle;
};

double angle_between(const Direction3& a, const Direction3& b) {
  return same_bits::atan2(length(cross(a, b)), dot(a, b));
}

Direction3 along(const PieceSide& side, double angle) {
  const Direction3 across = cross(side.normal, side.from);
  return unit(same_bits::cos(angle) * side.from + same_bits::sin(angle) * across);
}

std::vector<PieceSide> sides_of(const MapPiece3& piece) {
  std::vector<PieceSide> sides;
  for (std::size_t k = 0; k < piece.corners.size(); ++k) {
    const Direction3 &a = piece.corners[k], &b = piece.corners[(k + 1) % piece.corners.size()];
    const Direction3 normal = cross(a, b);
    if (length(normal) > 1e-12) sides.push_back({a, unit(normal), angle_between(a, b)});
  }
  return sides;
}

// What is left of a side beside the pieces of the same face along its other bank.
void add_outline(const PieceSide& side, const std::vector<PieceSide>& others, std::vector<Arc>& arcs) {
  constexpr double kOneCircle = 1e-9, kLeast = 1e-9;
  std::vector<std::pair<double, double>> covered;
  for (const PieceSide& other : others) {
    if (length(side.normal + other.normal) > kOneCircle) continue;
    const Direction3 across = cross(side.normal, side.from);
    const double end = same_bits::atan2(dot(other.from, across), dot(other.from, side.from));  // it runs the other way
    for (const double turn : {0.0, 2 * std::numbers::pi}) covered.emplace_back(end + turn - other.angle, end + turn);
  }
  std::sort(covered.begin(), covered.end());
  double reached = 0;
  for (const auto& [from, to] : covered) {
    if (to <= reached) continue;
    if (from > reached + kLeast && reached < side.angle)
      arcs.emplace_back(along(side, reached), along(side, std::min(from, side.angle)));
    reached = std::max(reached, to);
  }
  if (reached < side.angle - kLeast) arcs.emplace_back(along(side, reached), along(side, side.angle));
}

std::vector<Arc> outlines(const std::vector<MapPiece3>& pieces) {
  std::map<std::uint32_t, std::vector<PieceSide>> by_face;
  for (const MapPiece3& piece : pieces)
    for (const PieceSide& side : sides_of(piece)) by_face[piece.face].push_back(side);
  std::vector<Arc> arcs;
  for (const auto& [face, sides] : by_face)
    for (const PieceSide& side : sides) add_outline(side, sides, arcs);
  return arcs;
}

// Points along the arc from a to b, a included and b not, so close that straight lines between them will do.
void add_arc(const Direction3& a, const Direction3& b, double step, std::vector<Direction3>& points) {
  const double angle = angle_between(a, b);
  const int count = std::max(1, static_cast<int>(std::ceil(angle / step)));
  for (int k = 0; k < count; ++k) {
    const double t = static_cast<double>(k) / count;
    const double left = angle > 1e-9 ? same_bits::sin((1 - t) * angle) / same_bits::sin(angle) : 1 - t;
    const double right = angle > 1e-9 ? same_bits::sin(t * angle) / same_bits::sin(angle) : t;
    points.push_back(unit(left * a + right * b));
  }
}

// With its border, so that no paper is seen between two pieces.
void fill_piece(PictureCanvas& canvas, const std::vector<Pixel>& polygon, const Colour& colour) {
  canvas.fill(Mark::kStripe, polygon, colour);
  for (std::size_t k = 0; k < polygon.size(); ++k)
    canvas.stroke(Mark::kStripe, polygon[k], polygon[(k + 1) % polygon.size()], colour, 0.7);
}

// A face in the colour of its material, lit from above and from one side so that faces are told apart; black backs are
// dark.
Colour colour_of(const Scene3& scene, const Face& face) {
  const std::optional<std::uint32_t> material = scene.surfaces[face.surface].material_of(face.is_back);
  if (!material) return palette::kUnlitSolid;
  const Spectrum& paint = scene.materials[*material].reflectivity;
  const bool emits = !scene.materials[*material].emission.is_zero();
  const Vector3 area = doubled_area(scene.polygons[face.surface]);
  Direction3 normal = unit({to_double(area.x), to_double(area.y), to_double(area.z)});
  if (face.is_back) normal = -normal;
  const double shade = emits ? 1 : 0.62 + 0.38 * dot(normal, unit({0.35, 0.5, 0.8}));
  const auto level = [&](std::size_t c) {
    const double value = emits ? 1 : 0.08 + 0.92 * to_double(paint.value[c]);
    return srgb_from_linear(std::clamp(shade * value, 0.0, 1.0));
  };
  return {level(0), level(1), emits ? 0.6 : level(2)};
}

}  // namespace

MapPainter3::MapPainter3(const MapDrawing3& drawing) : drawing_(drawing), width_(drawing.width) {
  if (width_ < kMinPictureWidth || width_ > kMaxPictureSide)
    throw UsageError("picture: the width must be between " + std::to_string(kMinPictureWidth) + " and " +
                     std::to_string(kMaxPictureSide) + " pixels");
  unit_ = width_ / 1600.0;
  height_ = static_cast<std::uint32_t>(std::ceil(kHeight * unit_));
  const Direction3 forward = unit(drawing.forward), right = unit(cross(forward, drawing.up)),
                   up = cross(right, forward);
  half_side_ = 130 * unit_;
  radius_ = 216 * unit_;
  const auto at = [&](double column, double row) {
    return Pixel{(40 + 130 * (2 * column + 1)) * unit_, (kTitle + 30 + 130 * (2 * row + 1)) * unit_};
  };
  sides_ = {{{right, up, forward}, at(1, 1)},  {{-right, up, -forward}, at(3, 1)}, {{forward, up, -right}, at(0, 1)},
            {{-forward, up, right}, at(2, 1)}, {{right, -forward, up}, at(1, 0)},  {{right, forward, -up}, at(1, 2)}};
  const double x = width_ - 40 * unit_ - radius_;
  discs_ = {{{right, up, forward}, {x, (kTitle + 14) * unit_ + radius_}},
            {{-right, up, -forward}, {x, (kTitle + 44) * unit_ + 3 * radius_}}};
  lines_ = outlines(drawing_.pieces);
}

Pixel MapPainter3::cube_pixel(const Side& side, const Direction3& direction) const {
  const double out = dot(direction, side.axes.out);
  return {side.middle.x + half_side_ * dot(direction, side.axes.right) / out,
          side.middle.y - half_side_ * dot(direction, side.axes.up) / out};
}

Pixel MapPainter3::disc_pixel(const Side& disc, const Direction3& direction) const {
  const double scale = radius_ / std::sqrt(1 + std::max(0.0, dot(direction, disc.axes.out)));
  return {disc.middle.x + scale * dot(direction, disc.axes.right),
          disc.middle.y - scale * dot(direction, disc.axes.up)};
}

Pixel MapPainter3::on_disc(const Direction3& direction) const {
  return disc_pixel(discs_[dot(direction, discs_[0].axes.out) >= 0 ? 0 : 1], direction);
}

Pixel MapPainter3::on_cube(const Direction3& direction) const {
  const auto most = std::max_element(sides_.begin(), sides_.end(), [&](const Side& a, const Side& b) {
    return dot(direction, a.axes.out) < dot(direction, b.axes.out);
  });
  return cube_pixel(*most, direction);
}

void MapPainter3::draw_cube_side(PictureCanvas& canvas, const Side& side) const {
  const auto& [right, up, out] = side.axes;
  const std::array<Direction3, 5> inside{out, out + right, out - right, out + up, out - up};
  const Pixel low{side.middle.x - half_side_, side.middle.y - half_side_};
  const Pixel high{side.middle.x + half_side_, side.middle.y + half_side_};
  canvas.fill_rectangle(Mark::kFloor, low, high, palette::kSky);
  for (const MapPiece3& piece : drawing_.pieces) {
    std::vector<Direction3> corners = piece.corners;
    for (const Direction3& normal : inside) corners = cut(corners, normal);
    if (corners.size() < 3) continue;
    std::vector<Pixel> polygon;
    for (const Direction3& corner : corners) polygon.push_back(cube_pixel(side, corner));
    fill_piece(canvas, polygon, drawing_.colours[piece.face]);
  }
  for (const Arc& line : lines_) {
    std::optional<Arc> part = line;
    for (const Direction3& normal : inside) part = cut(part, normal);
    if (part)
      canvas.stroke(Mark::kEdge, cube_pixel(side, part->first), cube_pixel(side, part->second), palette::kInk,
                    1.1 * unit_);
  }
  const Pixel frame[] = {low, {high.x, low.y}, high, {low.x, high.y}};
  for (std::size_t k = 0; k < 4; ++k)
    canvas.stroke(Mark::kAxis, frame[k], frame[(k + 1) % 4], palette::kSoftInk.with_alpha(0.6), unit_);
}

void MapPainter3::draw_disc(PictureCanvas& canvas, const Side& disc) const {
  const double step = std::sqrt(0.8 / radius_);  // a chord is a tenth of a pixel from its arc
  canvas.disc(Mark::kFloor, disc.middle, radius_, palette::kSky);
  for (const MapPiece3& piece : drawing_.pieces) {
    const std::vector<Direction3> corners = cut(piece.corners, disc.axes.out);
    if (corners.size() < 3) continue;
    std::vector<Direction3> border;
    for (std::size_t k = 0; k < corners.size(); ++k)
      add_arc(corners[k], corners[(k + 1) % corners.size()], step, border);
    std::vector<Pixel> polygon;
    for (const Direction3& at : border) polygon.push_back(disc_pixel(disc, at));
    fill_piece(canvas, polygon, drawing_.colours[piece.face]);
  }
  for (const Arc& line : lines_) {
    const std::optional<Arc> part = cut(std::optional(line), disc.axes.out);
    if (!part) continue;
    std::vector<Direction3> points;
    add_arc(part->first, part->second, step, points);
    points.push_back(part->second);
    for (std::size_t k = 1; k < points.size(); ++k)
      canvas.stroke(Mark::kEdge, disc_pixel(disc, points[k - 1]), disc_pixel(disc, points[k]), palette::kInk,
                    1.1 * unit_);
  }
  canvas.circle(Mark::kAxis, disc.middle, radius_, palette::kSoftInk, 1.5 * unit_);
}

void MapPainter3::draw(PictureCanvas& canvas) const {
  canvas.fill_rectangle(Mark::kPaper, {0, 0}, {canvas.width(), canvas.height()}, palette::kPaper);
  TextStyle title{.size = 32 * unit_, .colour = palette::kInk, .weight = TextWeight::kBold};
  const double room = width_ - 80 * unit_, wide = canvas.text_width(drawing_.title, title);
  if (wide > room) title.size *= room / wide;
  canvas.text(Mark::kTitle, {40 * unit_, 52 * unit_}, drawing_.title, title);
  for (const Side& side : sides_) draw_cube_side(canvas, side);
  for (const Side& disc : discs_) draw_disc(canvas, disc);
  const TextStyle small{.size = 17 * unit_, .colour = palette::kSoftInk, .anchor = TextAnchor::kCentre};
  const auto name = [&](const Side& place, double below, const char* text) {
    canvas.text(Mark::kLabel, {place.middle.x, place.middle.y + below + 20 * unit_}, text, small);
  };
  name(sides_[1], half_side_, "behind");
  name(sides_[2], half_side_, "left");
  name(sides_[3], half_side_, "right");
  name(sides_[5], half_side_, "in front, with what is above and below");
  name(discs_[0], radius_, "in front");
  name(discs_[1], radius_, "behind");
}

MapDrawing3 drawing_of(const Scene3& scene, const Look3& look, const VisibilityMap3& map) {
  MapDrawing3 drawing;
  if (look.normal) {
    drawing.forward = unit({to_double(look.normal->x), to_double(look.normal->y), to_double(look.normal->z)});
    if (std::abs(drawing.forward.z) > 0.99) drawing.up = {0, 1, 0};
  }
  const auto in_solids = static_cast<std::uint32_t>(2 * scene.surfaces.size());
  const auto add = [&](const VisibilityMap3::Fragment& fragment, std::uint32_t face) {
    MapPiece3 piece{{}, face};
    for (std::uint32_t c = fragment.begin; c < fragment.end; ++c) piece.corners.push_back(map.corners[c].direction);
    drawing.pieces.push_back(std::move(piece));
  };
  for (const VisibilityMap3::Fragment& fragment : map.solid_fragments) add(fragment, in_solids);
  for (const VisibilityMap3::Fragment& fragment : map.fragments) add(fragment, fragment.face.number());  // over these
  drawing.colours.resize(in_solids + 1);
  drawing.colours[in_solids] = palette::kSolid;
  for (const VisibilityMap3::Share& share : map.shares)
    drawing.colours[share.face.number()] = colour_of(scene, share.face);
  return drawing;
}

std::string map_picture_3(const MapDrawing3& drawing, PictureFormat format) {
  const MapPainter3 painter(drawing);
  CairoCanvas canvas(format, painter.width(), painter.height());
  painter.draw(canvas);
  return canvas.finish();
}

}  // namespace hottel
