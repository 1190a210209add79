#include "geometry/space/generate/generator_canvas.h"

#include <numeric>
#include <utility>

#include "geometry/name.h"

namespace hottel {
namespace {

// The command that makes the scene again.
std::string command_of(const GeneratorRequest3& request) {
  std::string text = numbered(("hottel generate " + request.kind + " --n ").c_str(), request.n);
  text += numbered(" --seed ", request.seed);
  if (!request.has_bottoms) text += " --no-bottoms";
  return text;
}

// The corners of the faces: bit 0 goes along u, bit 1 along v, bit 2 along w.
constexpr std::array<std::array<std::size_t, 4>, 6> kFaces = {
    {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}}};

Dot3 corner_of(const Block3& block, std::size_t k) {
  Dot3 corner = block.corner;
  if (k & 1) corner = corner + block.u;
  if (k & 2) corner = corner + block.v;
  if (k & 4) corner = corner + block.w;
  return corner;
}

}  // namespace

Block3 upright_block(const Dot3& low, const Dot3& high) {
  return {low, {high.x - low.x, 0, 0}, {0, high.y - low.y, 0}, {0, 0, high.z - low.z}};
}

Faces3 faces_of(const Block3& block) {
  Faces3 faces;
  for (std::size_t f = 0; f < faces.size(); ++f)
    for (std::size_t k = 0; k < 4; ++k) faces[f][k] = corner_of(block, kFaces[f][k]);
  return faces;
}

std::array<std::int64_t, 4> plane_of(const Dot3& a, const Dot3& b, const Dot3& c) {
  Dot3 normal = cross(b - a, c - a);
  std::int64_t divisor = std::gcd(std::gcd(normal.x, normal.y), normal.z);
  if (normal.x < 0 || (normal.x == 0 && (normal.y < 0 || (normal.y == 0 && normal.z < 0)))) divisor = -divisor;
  normal = {normal.x / divisor, normal.y / divisor, normal.z / divisor};
  return {normal.x, normal.y, normal.z, dot(normal, a)};
}

GeneratorCanvas3::GeneratorCanvas3(const GeneratorRequest3& request, int decimals)
    : has_bottoms_(request.has_bottoms), denominator_(1) {
  for (; decimals > 0; --decimals) denominator_ *= 10;
  scene_.file = scene_.about = command_of(request);
  scene_.materials = paints();
}

Point3 GeneratorCanvas3::point(const Dot3& dot) const {
  const auto coordinate = [this](std::int64_t units) {
    Rational value(Integer(static_cast<long>(units)), denominator_);
    value.canonicalize();
    return value;
  };
  return {coordinate(dot.x), coordinate(dot.y), coordinate(dot.z)};
}

void GeneratorCanvas3::begin(std::string name) {
  scene_.groups.emplace_back(std::move(name));
  count_in_group_ = 0;
}

void GeneratorCanvas3::add_polygon(Polygon3 polygon, Paint paint) {
  Surface surface;
  surface.name = piece_name(scene_.groups.back().name, count_in_group_++);
  surface.material = paint;
  surface.elements = elements_;
  surface.group = static_cast<std::uint32_t>(scene_.groups.size() - 1);
  scene_.add(std::move(surface), std::move(polygon));
}

void GeneratorCanvas3::add_quad(const std::array<Point3, 4>& corners, Paint paint) {
  const auto& [a, b, c, d] = corners;
  if (!draws_triangles_) return add_polygon({{a, b, c, d}}, paint);
  add_polygon({{a, b, c}}, paint);
  add_polygon({{a, c, d}}, paint);
}

void GeneratorCanvas3::add(const std::vector<Dot3>& points, Paint paint) {
  Polygon3 polygon;
  for (const Dot3& dot : points) polygon.points.push_back(point(dot));
  add_polygon(std::move(polygon), paint);
}

void GeneratorCanvas3::add_faces(const Block3& block, Paint paint, std::size_t first) {
  std::array<Point3, 8> corners;
  for (std::size_t k = 0; k < corners.size(); ++k) corners[k] = point(corner_of(block, k));
  for (std::size_t f = first; f < kFaces.size(); ++f) {
    const auto& [a, b, c, d] = kFaces[f];
    add_quad({corners[a], corners[b], corners[c], corners[d]}, paint);
  }
}

void GeneratorCanvas3::add_block(std::string name, const Block3& block, Paint paint) {
  begin(std::move(name));
  add_faces(block, paint, 0);
}

void GeneratorCanvas3::add_standing(std::string name, const Block3& block, Paint paint) {
  begin(std::move(name));
  add_faces(block, paint, has_bottoms_ ? 0 : 1);
}

void GeneratorCanvas3::add_inward(std::string name, const Block3& block, const std::array<Paint, 6>& paints) {
  begin(std::move(name));
  const Faces3 faces = faces_of(block);
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const auto& [a, b, c, d] = faces[f];
    add_quad({point(a), point(d), point(c), point(b)}, paints[f]);
  }
}

void GeneratorCanvas3::add_room(const Dot3& size) {
  add_inward("room", upright_block({0, 0, 0}, size), {kWhite, kLamp, kRed, kBlue, kWhite, kWhite});
}

void GeneratorCanvas3::look(const Dot3& eye, const Dot3& target) {
  Camera3 camera;
  camera.eye = point(eye);
  camera.target = point(target);
  camera.field_of_view = 60;
  scene_.camera = std::move(camera);
}

Scene3 GeneratorCanvas3::finish(bool closed) {
  drop_unused_materials(scene_);
  scene_.closed = closed;
  return std::move(scene_);
}

Scene3 GeneratorCanvas3::finish_under_sky(const Spectrum& emission) {
  scene_.sky_emission = emission;
  return finish(false);
}

}  // namespace hottel
