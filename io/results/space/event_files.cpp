#include "io/results/space/event_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "geometry/space/scene/scene.h"
#include "io/results/csv_field.h"
#include "kernel/written_double.h"

namespace hottel {
namespace {

std::string told(const std::array<double, 3>& p, const char* between) {
  std::string text;
  for (const double x : p) {
    require_double(x, "a coordinate of an event surface");
    text += (text.empty() ? "" : between) + shortest(x);
  }
  return text;
}

std::string told(const Point3& p) { return told(to_doubles(p), " "); }

std::string told(const std::array<Point3, 2>& edge) { return told(edge[0]) + ";" + told(edge[1]); }

std::string names(const Scene3& scene, const std::vector<std::uint32_t>& surfaces) {
  std::string text;
  for (const std::uint32_t s : surfaces) text += (text.empty() ? "" : "|") + scene.surfaces[s].name;
  return csv_field(text);
}

const char* kind_of(const EventSurface3& event) { return event.kind == EventSurface3::Kind::kEV ? "EV" : "EEE"; }

// An array of VTK by its attributes.
void write_array(const std::string& attributes, const std::string& numbers,
                 const std::function<void(std::string_view)>& sink) {
  sink("        <DataArray " + attributes + " format=\"ascii\">\n" + numbers + "        </DataArray>\n");
}

// What a .vtp has of strips of quads.
struct Strips {
  std::string points, connectivity, offsets, numbers, kinds;
  std::size_t count = 0, quads = 0;

  explicit Strips(std::span<const EventSurface3> events) {
    for (std::size_t e = 0; e < events.size(); ++e) add(events[e], e);
  }

 private:
  void add(const EventSurface3& event, std::size_t number) {
    for (std::size_t k = 0; k < event.rulings.size(); ++k) {
      points += told(event.rulings[k].on_from, " ") + "\n" + told(event.rulings[k].on_to, " ") + "\n";
      if (k > 0) add_quad(event, number);
      count += 2;
    }
  }
  void add_quad(const EventSurface3& event, std::size_t number) {
    connectivity += fmt::format("{} {} {} {}\n", count - 2, count - 1, count + 1, count);
    offsets += fmt::format("{}\n", 4 * ++quads);
    numbers += fmt::format("{}\n", number);
    kinds += event.kind == EventSurface3::Kind::kEV ? "1\n" : "2\n";
  }
};

}  // namespace

void write_events_csv_3(const Scene3& scene, std::span<const EventSurface3> events,
                        const std::function<void(std::string_view)>& sink) {
  sink("event,kind,edge,edge_of,vertex,edge_2,edge_3,crossing,t,x0,y0,z0,x1,y1,z1\n");
  for (std::size_t e = 0; e < events.size(); ++e) {
    const EventSurface3& event = events[e];
    const auto other = [&](std::size_t k) { return k < event.others.size() ? told(event.others[k]) : ""; };
    const std::string begin =
        fmt::format("{},{},{},{},{},{},{},{}", e, kind_of(event), told(event.edge), names(scene, event.surfaces),
                    event.vertex ? told(*event.vertex) : "", other(0), other(1), names(scene, event.crossing));
    for (const EventSurface3::Ruling& ruling : event.rulings)
      sink(begin + "," + shortest(ruling.t) + "," + told(ruling.on_from, ",") + "," + told(ruling.on_to, ",") + "\n");
  }
}

void write_events_vtp(std::span<const EventSurface3> events, const std::function<void(std::string_view)>& sink) {
  const Strips strips(events);
  sink(
      fmt::format("<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" "
                  "byte_order=\"LittleEndian\">\n  <PolyData>\n    <Piece NumberOfPoints=\"{}\" "
                  "NumberOfVerts=\"0\" NumberOfLines=\"0\" NumberOfStrips=\"0\" NumberOfPolys=\"{}\">\n",
                  strips.count, strips.quads));
  sink("      <Points>\n");
  write_array("type=\"Float64\" NumberOfComponents=\"3\"", strips.points, sink);
  sink("      </Points>\n      <Polys>\n");
  write_array("type=\"Int64\" Name=\"connectivity\"", strips.connectivity, sink);
  write_array("type=\"Int64\" Name=\"offsets\"", strips.offsets, sink);
  sink("      </Polys>\n      <CellData>\n");
  write_array("type=\"Int64\" Name=\"event\"", strips.numbers, sink);
  write_array("type=\"Int64\" Name=\"kind\"", strips.kinds, sink);
  sink("      </CellData>\n    </Piece>\n  </PolyData>\n</VTKFile>\n");
}

std::string events_summary_3(std::span<const EventSurface3> events) {
  const auto planes = std::ranges::count(events, EventSurface3::Kind::kEV, &EventSurface3::kind);
  const auto all = static_cast<std::ptrdiff_t>(events.size());
  return fmt::format("{} of lines through an edge and a vertex (EV), {} through three edges (EEE)\n", planes,
                     all - planes);
}

}  // namespace hottel
