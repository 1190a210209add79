#include "tests/storm/space/room_numbers.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "geometry/space/scene/near_plane.h"
#include "io/scene/space/mesh_pieces.h"

namespace hottel::storm {

namespace {

using Kind = SolidBody3::Kind;

const Rational kUnit(1, 1'000'000);  // of typed numbers
const Rational kThinnest(1, 1'000);  // of bodies whose corners are rounded

Rational rounded(const Rational& x, const Rational& unit) {
  const Rational scaled = x / unit + Rational(1, 2);
  Integer whole;
  mpz_fdiv_q(whole.get_mpz_t(), scaled.get_num_mpz_t(), scaled.get_den_mpz_t());
  return Rational(whole) * unit;
}

Rational to_float(const Rational& x) { return Rational(static_cast<double>(static_cast<float>(x.get_d()))); }

class NumberWriter {
 public:
  NumberWriter(FurnishedRoom3& room, std::mt19937_64& random) : room_(&room), random_(random) {}

  void write_numbers() {
    if (room_->numbers == RoomNumbers3::kExact) return;
    const auto any_turn = [this] {
      Rational tangent = between(-9, 9);
      tangent /= between(10, 99);
      return RoomTurn(tangent);
    };
    const bool is_tilted = room_->numbers == RoomNumbers3::kTilted;
    const RoomTurn about_z = any_turn(), about_y = is_tilted ? any_turn() : RoomTurn(),
                   about_x = is_tilted ? any_turn() : RoomTurn();
    Rational shift;
    if (between(0, 1) == 0) shift = Rational(between(-200, 200)) / 20;
    for (SolidBody3& body : room_->bodies)
      for (SolidBody3::Face& face : body.faces)
        for (Point3& p : face.polygon.points) {
          about_z(p.x, p.y);
          about_y(p.x, p.z);
          about_x(p.y, p.z);
          p.x += shift;
          if (room_->numbers == RoomNumbers3::kTurned) continue;
          for (const auto axis : {&Point3::x, &Point3::y, &Point3::z})
            p.*axis = room_->numbers == RoomNumbers3::kFloats ? to_float(p.*axis) : rounded(p.*axis, kUnit);
        }
    if (room_->numbers != RoomNumbers3::kTurned) take_up_rounding();
  }

 private:
  long between(long low, long high) {
    return low + static_cast<long>(random_() % static_cast<std::uint64_t>(high - low + 1));
  }

  // Faces become nearly plane, or triangles; what has no thickness any more is left out.
  void take_up_rounding() {
    for (SolidBody3& body : room_->bodies) {
      std::vector<SolidBody3::Face> faces;
      bool is_flat = false;
      for (SolidBody3::Face& face : body.faces) {
        if (room_->numbers == RoomNumbers3::kFloats) {
          for (Polygon3& triangle : triangles(face.polygon)) {
            is_flat = is_flat || !polygon_problem(triangle).text.empty();
            faces.push_back({std::move(triangle), face.material, face.back});
          }
        } else {
          accept_nearly_plane(face.polygon, kUnit);
          is_flat = is_flat || !polygon_problem(face.polygon).text.empty();
          faces.push_back(std::move(face));
        }
      }
      body.faces = std::move(faces);
      if (is_flat || (body.kind == Kind::kSolid && is_thin(body))) body.faces.clear();
    }
    std::erase_if(room_->bodies, [](const SolidBody3& body) { return body.faces.empty(); });
  }

  // The same for a turned polygon, whose corners are off their plane by rounding. One that rounding has made flat
  // stays.
  std::vector<Polygon3> triangles(const Polygon3& polygon) {
    Polygon3 bent = polygon;
    const bool has_triangles = accept_nearly_plane(bent, Rational(1, 1000));
    if (has_triangles) return facets_of(bent);
    return polygon_problem(polygon).text.empty() ? mesh_triangles(polygon) : std::vector<Polygon3>{polygon};
  }

  // Two of its corners are nearer to each other than rounding may turn it inside out.
  static bool is_thin(const SolidBody3& body) {
    for (const SolidBody3::Face& face : body.faces)
      for (const Side3& side : sides_of(face.polygon)) {
        const Vector3 way = side.to - side.from;
        if (dot(way, way) < kThinnest * kThinnest) return true;
      }
    return false;
  }

  FurnishedRoom3* room_;
  std::mt19937_64& random_;
};

}  // namespace

const char* to_string(RoomNumbers3 numbers) {
  switch (numbers) {
    case RoomNumbers3::kExact:
      return "exact";
    case RoomNumbers3::kTurned:
      return "turned";
    case RoomNumbers3::kTyped:
      return "typed to six digits";
    case RoomNumbers3::kTilted:
      return "tilted, six digits";
    case RoomNumbers3::kFloats:
      return "triangles of floats";
  }
  return "";
}

void write_numbers(FurnishedRoom3& room, std::mt19937_64& random) { NumberWriter(room, random).write_numbers(); }

}  // namespace hottel::storm
