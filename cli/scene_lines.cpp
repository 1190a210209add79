#include "cli/scene_lines.h"

#include <span>
#include <vector>

#include "geometry/plane/visibility/critical_lines.h"
#include "geometry/plane/visibility/visibility_graph.h"
#include "io/results/plane/edge_report.h"
#include "io/results/plane/graph_report.h"
#include "kernel/support/failure.h"
#include "kernel/support/with_file_context.h"

namespace hottel {

void require_sense(const SceneLines& lines, const std::string& what) {
  const bool is_file = !lines.out.empty() && lines.out != "-";
  if (lines.json && is_file) throw UsageError("--json is for standard output, -o FILE for a .csv");
  if (lines.json && lines.exact) throw UsageError("--exact is for a csv: --json holds p/q as it is");
  if (is_file && !lines.out.ends_with(".csv")) throw UsageError(what + " written as .csv, not '" + lines.out + "'");
}

void write_events(const SceneLines& lines, const PreparedScene2& prepared, const Streams& streams) {
  const std::vector<CriticalLine2> found = critical_lines(prepared, streams.progress("critical lines"));
  if (lines.json) {
    streams.write("", critical_lines_json(prepared, found));
    return;
  }
  std::string text;
  with_file_context(lines.scene, [&] {
    write_critical_lines_csv(prepared, found, lines.exact, [&](std::string_view part) { text += part; });
  });
  streams.write(lines.out, text);
}

void write_graph(const SceneLines& lines, const PreparedScene2& prepared, const Streams& streams) {
  const GraphFormat2 format = lines.json    ? GraphFormat2::kJson
                              : lines.exact ? GraphFormat2::kExactCsv
                                            : GraphFormat2::kCsv;
  streams.write_with(lines.out, [&](OutputFile& file) {
    with_file_context(lines.scene, [&] {
      GraphWriter2 writer(prepared, format, [&](std::string_view text) { file.write(text); });
      visibility_graph(
          prepared, [&](std::span<const VisiblePair2> pairs) { writer.add(pairs); },
          streams.progress("visibility graph"));
      writer.finish();
      streams.note(writer.summary());
    });
  });
}

}  // namespace hottel
