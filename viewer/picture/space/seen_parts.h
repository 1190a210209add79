// What a camera sees, as polygons of its picture.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "geometry/space/prepared/element_table.h"
#include "geometry/space/scene/scene.h"
#include "viewer/picture/space/element_paint.h"
#include "viewer/picture/space/pixel_values.h"
#include "viewer/picture/space/projection.h"
#include "viewer/picture/space/smooth_mesh.h"

namespace hottel {

struct PreparedScene3;

// How values run over a flat triangle in a picture: those of its corners, blended in space.
class Shade3 {
 public:
  static constexpr std::size_t kMostChannels = 3;

  // Of the triangle of the ends of three ways from the eye, with a value each of as many channels, three at most.
  Shade3(const Projection3& projection, const std::array<Direction3, 3>& ways,
         const std::array<std::span<const double>, 3>& values);

  // Gives the corners other values: then it is, bit for bit, what a new one of them would be.
  void set(const std::array<std::span<const double>, 3>& values);

  // The value at a place, for which there is room; within those of the corners.
  void value(const Pixel& at, std::span<double> result) const;

  // The same, of so many channels, for those who ask often: made once, and off by some roundings.
  template <std::size_t Channels>
  class Quick {
   public:
    // REQUIRES a shade of as many channels.
    explicit Quick(const Shade3& shade) : under_(shade.under_) {
      std::copy_n(shade.over_.begin(), Channels, over_.begin());
      std::copy_n(shade.low_.begin(), Channels, low_.begin());
      std::copy_n(shade.high_.begin(), Channels, high_.begin());
    }
    std::array<double, Channels> at(const Pixel& place) const {
      const double per_under = 1 / under_.at(place);
      std::array<double, Channels> result;
      for (std::size_t c = 0; c < Channels; ++c) {
        const double blended = over_[c].at(place) * per_under;
        result[c] = blended > low_[c] ? (blended < high_[c] ? blended : high_[c]) : low_[c];
      }
      return result;
    }

   private:
    std::array<AffineValue3, Channels> over_;
    AffineValue3 under_;
    std::array<double, Channels> low_, high_;
  };

  // A number for each place that is >= 0 where the value of the channels, each times its weight, sums up to at least
  // `level`: a straight line parts the triangle.
  AffineValue3 above(std::span<const double> weights, double level) const;
  // The least and the largest of that sum.
  double low(std::span<const double> weights) const;
  double high(std::span<const double> weights) const;

 private:
  using Values = std::array<double, kMostChannels>;

  std::size_t channels_ = 0;
  std::array<AffineValue3, 3> share_;               // of each corner, over their sum
  std::array<AffineValue3, kMostChannels> over_{};  // by channel: the value times that sum
  AffineValue3 under_;                              // the sum; not negative in the triangle
  std::array<Values, 3> corners_{};
  Values low_{}, high_{};  // by channel, of the corners
};

// A polygon of the picture in which one element is seen, or black.
struct SeenPart3 {
  PixelPolygon outline;                  // convex
  std::optional<std::uint32_t> element;  // nothing: a side without a row
  const Shade3* shade = nullptr;         // how its value runs; null: it is that of the element all over
  // Of the mesh, where there is a shade: that runs between them and the middle of the part.
  std::array<std::uint32_t, 2> corners{};
};

// What is looked at.
struct SeenScene3 {
  const PreparedScene3& prepared;
  const ElementTable3& table;
  const ElementPaint3& paint;         // of the elements of the table
  const SmoothMesh3* mesh = nullptr;  // null: every element has one value
};

// Calls take(part) for all that a camera sees but the sky.
//
//   (1) no two parts share an area, and together with the sky they are the picture: what hides what is decided exactly
//       (VisibilityMap3), places are in doubles
//   (2) with a mesh, values are blended over triangles of parts, as it says
//
// Throws RequestError where the eye is in a solid, Interrupted when asked to stop. REQUIRES a camera without a problem.
void for_each_seen_part(const SeenScene3& scene, const Camera3& camera,
                        const std::function<void(const SeenPart3&)>& take);

}  // namespace hottel
