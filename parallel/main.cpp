// The program `hottel-mpi`: the same as `hottel`, whose view factors, radiosities and grids several processes compute.
#include <algorithm>
#include <memory>

#include "cli/command.h"
#include "kernel/support/parallel.h"
#include "parallel/channel.h"
#include "parallel/helper.h"
#include "parallel/leader.h"
#include "parallel/plane/cell_crew.h"
#include "parallel/plane/sweep_crew.h"
#include "parallel/row_crew.h"
#include "parallel/space/cell_crew.h"
#include "parallel/space/pair_crew.h"

namespace hottel {
namespace {

constexpr char kPlane = '2', kSpace = '3', kRows = 'r', kCells2 = 'd', kCells3 = 'c';

// Jobs of all kinds.
class AllJobs : public HelperJobs {
 public:
  std::unique_ptr<HelperJob> make(std::string_view bytes) override {
    HelperJobs* jobs = &rows_;
    if (bytes.front() == kPlane) jobs = &plane_;
    if (bytes.front() == kSpace) jobs = &space_;
    if (bytes.front() == kCells2) jobs = &cells_2_;
    if (bytes.front() == kCells3) jobs = &cells_3_;
    return jobs->make(bytes.substr(1));
  }

 private:
  KeptScene2 kept_2_;
  KeptScene3 kept_3_;
  SweepJobs2 plane_{kept_2_};
  PairJobs3 space_{kept_3_};
  CellJobs2 cells_2_{kept_2_};
  CellJobs3 cells_3_{kept_3_};
  RowJobs rows_;
};

int lead(Channel& channel, int argc, const char* const* argv) {
  Leader leader(channel);
  LedSweepCrew2 plane(leader, kPlane);
  LedPairCrew3 space(leader, kSpace);
  LedCellCrew2 cells_2(leader, kCells2);
  LedCellCrew3 cells_3(leader, kCells3);
  LedRowCrew rows(leader, kRows);
  int code = 0;
  {
    const CrewScope<SweepCrew2> in_the_plane(plane);
    const CrewScope<PairCrew3> in_space(space);
    const CrewScope<CellCrew2> of_grids_in_the_plane(cells_2);
    const CrewScope<CellCrew3> of_grids_in_space(cells_3);
    const CrewScope<RowCrew> of_systems(rows);
    Commands commands;
    add_all_commands(commands);
    commands.end_at_first_signal();  // mpirun kills ranks some milliseconds after it has asked them to end
    commands.set_threads(std::max(1, threads_allowed() / channel.ranks_on_these_cores()));
    code = commands.run(argc, argv);
  }
  leader.end(code);
  return code;
}

}  // namespace
}  // namespace hottel

int main(int argc, char** argv) {
  hottel::Channel channel(argc, argv);
  if (channel.rank() == 0) return hottel::lead(channel, argc, argv);
  hottel::AllJobs jobs;
  return hottel::help(channel, jobs);
}
