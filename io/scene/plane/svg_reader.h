// Drawings as scenes: the straight lines of an SVG file.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "geometry/plane/scene/scene.h"
#include "io/scene/passed_over.h"

namespace hottel {

// The material of everything that names none, and the reflectivity of all materials: a drawing says neither.
inline constexpr const char* kSvgMaterial = "white";
inline const Rational kSvgReflectivity{1, 2};

// Whether a file name ends as that of a drawing: .svg.
bool is_svg_2(const std::filesystem::path& file);

// Returns the scene of a drawing.
//
//   (1) a <line> is an edge; <polyline>, <polygon>, <rect> and each part of a <path> that M begins is a polyline; edges
//       first, then polylines, each in the order of the drawing
//   (2) coordinates are exact: user units of the outermost <svg> with y turned to point up, (x, y) -> (x, -y); its
//       width, height and viewBox scale nothing. Transforms are applied exactly
//   (3) the front is the right side as one draws, seen on the screen; a <rect> is a room seen from inside, mirrored or
//       not; data-front="left" turns an element round
//   (4) names are the ids ("ID.1", "ID.2", ... for a path of several parts); without an id edge[k] and polyline[k], k
//       counted over elements of that kind. Materials are data-material, or else the class, or else "white"; data-back
//       is the material of the back. data-on is the name of what an element is a patch on (NAME or NAME:back).
//       data-material, data-back, data-front, data-on and class hold for everything in a group
//   (5) a point that repeats the one before, or of a closed run the first, is passed over, and counted; so is a run
//       that has one point left, unless nothing else is drawn
//   (6) nothing else is dropped: what cannot be read exactly (curves, text, images, <use>, rounded corners, hidden or
//       clipped elements, rotations other than quarter turns, lengths with units), styles that hide, move or resize
//       (svg_style.h), data- keys other than those above, scripts, and references to entities are refused at their
//       line, the element named with its container. What SVG does not draw by itself (definitions, titles, metadata,
//       elements of other namespaces) is passed over
//
// Throws InputError with file and line.                                                              COST: linear.
ValidScene2 read_svg_2(const std::filesystem::path& file, PassedOver* passed_over = nullptr);

// The same for a text in memory.
ValidScene2 parse_svg_2(std::string_view text, const std::string& name_for_messages, PassedOver* passed_over = nullptr);

}  // namespace hottel
