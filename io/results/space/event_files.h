// The surfaces of lines along which what two faces see of each other changes, as csv and for ParaView.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "geometry/space/exchange/event_surfaces.h"

namespace hottel {

struct Scene3;

// `event,kind,edge,edge_of,vertex,edge_2,edge_3,crossing,t,x0,y0,z0,x1,y1,z1`: one line a ruling. event: from 0; kind:
// EV or EEE. Edges are both ends, "x y z;x y z", and a vertex "x y z", the nearest doubles; edge_of and crossing: names
// of surfaces with | between. The ruling is from (x0, y0, z0) on the plane of the first face to the one on the second.
// Throws RequestError where a coordinate is beyond the range of doubles.
void write_events_csv_3(const Scene3& scene, std::span<const EventSurface3> events,
                        const std::function<void(std::string_view)>& sink);

// VTK's format for polygons, as text: a strip of quads between the rulings of each surface, with `event` and `kind` (1:
// EV, 2: EEE) of each quad.
void write_events_vtp(std::span<const EventSurface3> events, const std::function<void(std::string_view)>& sink);

// How many surfaces of each kind there are, in a sentence.
std::string events_summary_3(std::span<const EventSurface3> events);

}  // namespace hottel
