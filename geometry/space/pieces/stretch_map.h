// What a point that moves along a stretch sees of both patches. Internal to geometry/space/exchange.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "geometry/space/between/joined_bodies.h"
#include "geometry/space/moving/moving_cone.h"
#include "geometry/space/moving/sight_corner.h"
#include "geometry/space/pieces/stretch_piece.h"
#include "geometry/space/pieces/sure_part.h"
#include "geometry/space/pieces/wide_piece.h"
#include "geometry/space/stretches/solid_cover.h"
#include "geometry/space/stretches/stretch.h"
#include "geometry/space/stretches/stretch_hull.h"

namespace hottel {

// Why lines of sight end at a stretch.
//   kSource:  it is an edge of a patch
//   kFoot:    a surface stands on a patch there, or pierces it
//   kOutline: it is an edge of surfaces between the patches
enum class StretchRole3 : unsigned char { kSource, kFoot, kOutline };

// A stretch with what is needed to look around from its points.
struct PairStretch3 {
  struct Face {
    std::uint32_t body;
    bool is_forward;        // as StretchFace3
    bool patch_is_forward;  // of sources: the patch lies where N . w > 0 with N the normal of the body
  };
  Stretch3 made;                    // where it is none of the scene's
  const Stretch3* known = nullptr;  // one of the scene's
  StretchRole3 role = StretchRole3::kSource;
  std::uint32_t own = 0;     // the patch that it is on; 0 for outlines
  std::vector<Face> faces;   // surfaces whose closure contains it
  double low = 0, high = 1;  // outside of this nothing is seen

  const Stretch3& line() const { return known ? *known : made; }
};

// Divides stretches into parts along which what is seen is bounded by the same arcs.
class StretchMapper3 {
 public:
  explicit StretchMapper3(const PairGeometry3& bodies);

  // Appends the parts of a stretch in which something is seen, without their arcs. False where it took too many steps.
  // Sets `parts`, where it is not null, as divide_surely() does, at once: that costs a third of it.
  bool divide(const PairStretch3& stretch, std::vector<StretchPiece3>& pieces, std::vector<SurePart3>* parts = nullptr);
  // Makes the arcs of one of these parts: at any time the same. REQUIRES that it has none.
  void make_arcs(const PairStretch3& stretch, StretchPiece3& piece);

  // What the corners of a part are of, in their order. REQUIRES that it is one of that stretch, and has its arcs.
  std::vector<SightCorner3> corners_of(const PairStretch3& stretch, const StretchPiece3& piece);

  // Where, on the stretch that was divided last, a part was too short to be looked at.
  const std::vector<double>& not_looked_at() const { return not_looked_at_; }

  // A part of a stretch with more digits. REQUIRES that it is one of that stretch, and has its arcs.
  template <class Real>
  WidePiece3<Real> widened(const PairStretch3& stretch, const StretchPiece3& piece);

  // Sets `parts` to parts of a stretch on which what is seen is proven, those too in which it is nothing. Outside of
  // `low` to `high` of the stretch nothing is seen. False where it took too many steps.
  //
  //   (1) of a stretch past which nothing can be seen, whatever t: sees_nothing(), and no parts
  bool divide_surely(const PairStretch3& stretch, std::vector<SurePart3>& parts);
  bool sees_nothing(const PairStretch3& stretch) { return !find_sides(stretch); }
  // REQUIRES that the part is one of that stretch.
  template <class Real>
  WholePiece3<Real> whole_piece(const PairStretch3& stretch, const StretchPiece3& piece);

  // Whether a surface was found to hide something, at any stretch so far.
  bool is_anything_hidden() const { return is_anything_hidden_; }
  std::uint32_t maps() const { return maps_; }
  const SignCounts& counts() const { return planes_.counts(); }
  std::uint32_t relied_polynomials() const { return planes_.relied_polynomials(); }

 private:
  // What hides something of a patch: a body, or, behind all of these, a solid; 0 for none.
  struct Hider {
    std::uint32_t number = 0, patch = 0;
  };
  void take(const PairStretch3& stretch);
  bool look(const PairStretch3& stretch, double low, double high, StretchPiece3& piece);
  bool walk(const PairStretch3& stretch, std::vector<StretchPiece3>& pieces, std::vector<SurePart3>* parts);
  void begin_sure_parts(std::vector<SurePart3>& parts);
  void add_sure_part(const StretchPiece3& piece, std::vector<SurePart3>& parts);
  static void end_sure_parts(std::vector<SurePart3>& parts);
  bool find_sides(const PairStretch3& stretch);
  void find_bodies(const PairStretch3& stretch);
  bool hides_as_one(const PairGeometry3::Solid& solid, const PairStretch3& stretch, std::uint32_t patch) const;
  void find_view(const PairStretch3& stretch);
  bool find_start(const PairStretch3& stretch);
  void see_on_both_sides(const PairStretch3& stretch);
  void see(const PairStretch3& stretch, MovingFragment3& start, int sign);
  void take_away(const PairStretch3& stretch, std::uint32_t hider, std::uint32_t patch, int sign);
  void take_away_body(const PairStretch3& stretch, std::uint32_t body, std::uint32_t patch, int sign);
  void take_away_solid(const PairStretch3& stretch, std::uint32_t number, std::uint32_t patch, int sign);
  bool take_away_group(const PairStretch3& stretch, const JoinedBodies3::Group& group, std::uint32_t patch, int sign);
  void join_bodies();
  void take_away_cone(const PairStretch3& stretch, std::uint32_t hider, std::uint32_t patch, int sign,
                      std::span<const PlaneSide3> beside);
  enum class Hides : unsigned char { kNever, kWhole, kWhereNearer };
  Hides hides(std::uint32_t body, int facing, std::uint32_t patch) const;
  void set_signature(StretchPiece3& piece);
  void set_arcs(StretchPiece3& piece);
  void list_arcs(const std::vector<ArcEnd3>& signature, std::vector<SeenArc3>& arcs);
  static void add_near_zero(const MovingVector3& vector, StretchPiece3& piece);
  MovingCorner3 corner_of(std::uint64_t label);

  const PairGeometry3& bodies_;
  MovingPlanes3 planes_;
  const PairStretch3* taken_ = nullptr;  // by planes_
  MovingCutter3 cutter_;
  std::vector<double> not_looked_at_;
  std::vector<std::pair<double, double>> waiting_;  // parts of a stretch that are to be looked at
  MovingFragment3 start_, copy_;
  MovingFragments3 pieces_, rest_;
  std::vector<std::pair<int, MovingFragment3>> seen_;
  std::size_t seen_count_ = 0;
  MovingCutter3::Cone cone_;
  std::vector<PlaneSide3> sides_;
  std::vector<signed char> facings_;
  std::vector<std::uint64_t> labels_;     // as the corners of the piece
  std::vector<PlaneId3> planes_of_arcs_;  // as its planes
  std::vector<ArcEnd3> begins_, ends_, all_ends_;
  std::vector<std::uint32_t> hints_;  // what told apart last: by body, direction and side
  StretchHull3 hull_;
  SolidCover3 cover_;
  JoinedBodies3 joined_;
  std::array<bool, 2> sides_seen_{};                   // right, left
  std::array<Hider, 2> hiders_;                        // what hid the rest last, by sign
  std::vector<std::uint32_t> solid_of_;                // of bodies
  std::array<std::vector<std::uint32_t>, 2> between_;  // what may hide something of a patch from the stretch
  // What of that hides as one; joined anew where it was found not to (is_joined_).
  std::array<std::vector<JoinedBodies3::Group>, 2> groups_;
  std::array<std::vector<std::uint32_t>, 2> group_of_;  // of bodies: a number in groups_, or none
  std::array<bool, 2> is_joined_{};
  std::array<std::vector<char>, 2> is_taken_;  // of groups
  std::vector<std::uint32_t> whole_;
  bool is_anything_hidden_ = false;
  std::uint32_t maps_ = 0;
};

}  // namespace hottel
