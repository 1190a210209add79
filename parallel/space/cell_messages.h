// Light of grids in space, in messages.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "parallel/space/element_messages.h"
#include "solver/space/light/cell_crew.h"

namespace hottel {

// Returns all that others need to light cells of a job as LightOfElements3 does.
std::string cell_job_message_3(const CellJob3& job);

// A job that was read.
struct ReceivedCellJob3 {
  ReceivedElements3 elements;
  RadiositySolution solution;  // radiosities alone
  std::optional<LightOfElements3> light;

  // Throws RequestError where this process makes other elements of the scene than the one that wrote it.
  ReceivedCellJob3(std::string_view bytes, KeptScene3& kept);
  ReceivedCellJob3(const ReceivedCellJob3&) = delete;
  ReceivedCellJob3& operator=(const ReceivedCellJob3&) = delete;
};

}  // namespace hottel
