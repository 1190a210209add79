#include "io/scene/space/off_reader.h"

#include "geometry/name.h"
#include "geometry/planarity.h"
#include "geometry/space/scene/near_plane.h"
#include "io/scene/text_words.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

// The fewest bytes of a vertex, "0 0 0\n", and of a face, "3 0 0 0\n".
constexpr std::size_t kVertexBytes = 6, kFaceBytes = 8;

bool take(std::string_view& text, std::string_view prefix) {
  if (!text.starts_with(prefix)) return false;
  text.remove_prefix(prefix.size());
  return true;
}

class OffReader3 {
 public:
  OffReader3(std::string_view text, const std::string& file) : words_(text, file, true) { mesh_.file = file; }

  Mesh3 read() {
    read_header();
    if (const auto word = words_.next(); word == "BINARY")
      words_.refuse("OFF BINARY is not read by this version: write the file as text");
    else
      vertices_ = count(word, "vertices");
    const std::size_t faces = count(words_.next(), "faces");
    if (const std::string_view edges = words_.rest_of_line(); !edges.empty())
      words_.integer(edges, "the number of edges");
    require_room(vertices_, kVertexBytes, "vertices");
    for (std::size_t k = 0; k < vertices_; ++k) read_vertex(k);
    require_room(faces, kFaceBytes, "faces");
    for (std::size_t k = 0; k < faces; ++k) read_face(k, faces);
    if (const auto word = words_.next()) words_.refuse("after the last face there is " + quoted_name(*word));
    if (mesh_.faces.empty()) throw InputError({mesh_.file, 0}, "has no faces");
    mesh_.unit = finest_.unit();
    return std::move(mesh_);
  }

 private:
  void read_header() {
    const std::string_view keyword = words_.next().value_or("");
    std::string_view rest = keyword;
    const bool has_textures = take(rest, "ST"), has_colours = take(rest, "C"), has_normals = take(rest, "N");
    const bool has_weights = take(rest, "4"), has_dimension = take(rest, "n");
    if (rest != "OFF")
      words_.refuse("the file begins with " + quoted_name(keyword) + ", not with OFF (or COFF, NOFF, STOFF, ...)");
    if (has_weights || has_dimension)
      words_.refuse(quoted_name(keyword) + " is not read: its points do not have three coordinates");
    has_more_than_points_ = has_textures || has_colours || has_normals;
  }

  std::size_t count(const std::optional<std::string_view>& word, const std::string& what) {
    if (!word) words_.refuse("the file ends before the number of " + what);
    const std::int64_t count = words_.integer(*word, "the number of " + what);
    if (count < 0) words_.refuse("the number of " + what + " is negative: " + quoted_name(*word));
    return static_cast<std::size_t>(count);
  }

  // The last end of line may be missing.
  void require_room(std::size_t count, std::size_t bytes, const std::string& what) const {
    if (count > (words_.bytes_left() + 1) / bytes)
      words_.refuse("the file says that there are " + std::to_string(count) + " " + what + ", and ends before that");
  }

  void read_vertex(std::size_t k) {
    Point3 point;
    for (Rational* coordinate : {&point.x, &point.y, &point.z}) {
      const auto word = words_.next();
      if (!word) words_.refuse("the file ends within vertex " + std::to_string(k) + " of " + std::to_string(vertices_));
      *coordinate = words_.number(*word, "coordinate");
      finest_.take(*word);
    }
    if (has_more_than_points_) words_.rest_of_line();
    points_.push_back(std::move(point));
  }

  void read_face(std::size_t k, std::size_t faces) {
    const auto number = [&](const std::string& what) {
      const auto word = words_.next();
      if (!word) words_.refuse("the file ends within face " + std::to_string(k) + " of " + std::to_string(faces));
      return words_.integer(*word, what);
    };
    const std::int64_t corners = number("the number of vertices of face " + std::to_string(k));
    MeshFace3 face;
    face.line = words_.line();
    if (corners < 3)
      words_.refuse("face " + std::to_string(k) + " has fewer than three vertices: " + std::to_string(corners));
    for (std::int64_t c = 0; c < corners; ++c) {  // each is read before there is room for the next
      const std::int64_t vertex = number("a vertex of face " + std::to_string(k));
      if (vertex < 0 || static_cast<std::size_t>(vertex) >= vertices_)
        words_.refuse("the vertex " + std::to_string(vertex) + " of face " + std::to_string(k) + " is none of the " +
                      std::to_string(vertices_) + ", counted from 0");
      face.polygon.points.push_back(points_[static_cast<std::size_t>(vertex)]);
    }
    words_.rest_of_line();  // its colour
    mesh_.faces.push_back(std::move(face));
  }

  TextWords words_;
  Mesh3 mesh_;
  bool has_more_than_points_ = false;  // in the lines of vertices
  std::size_t vertices_ = 0;
  std::vector<Point3> points_;
  FinestDigit finest_;  // of these
};

}  // namespace

Mesh3 parse_off_3(std::string_view text, const std::string& file) { return OffReader3(text, file).read(); }

}  // namespace hottel
