#include "viewer/picture/space/gathered_source.h"

#include "viewer/picture/space/smooth_mesh.h"
#include "viewer/picture/space/smooth_runs.h"

namespace hottel {
namespace {

std::vector<PartRun3> runs_of(const PreparedScene3& prepared, const ElementTable3& table,
                              const RadiositySolution& solution) {
  std::vector<double> radiosities;
  for (std::size_t i = 0; i < table.count(); ++i)
    for (const ChannelSolution& channel : solution.channels) radiosities.push_back(channel.elements[i].radiosity);
  return smooth_runs_3(prepared, table, SmoothMesh3(prepared, table), radiosities, solution.channels.size());
}

}  // namespace

GatheredSource3::GatheredSource3(const PreparedScene3& prepared, Granularity granularity,
                                 const RadiositySolution& solution, const Shown& shown)
    : prepared_(prepared),
      table_(prepared.elements(granularity)),
      responses_(responses_3(shown, solution)),
      runs_(runs_of(prepared, *table_, solution)),
      light_(prepared, granularity, solution, runs_) {}

}  // namespace hottel
