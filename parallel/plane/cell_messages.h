// Light of grids in the plane, in messages.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "parallel/plane/element_messages.h"
#include "solver/plane/light/cell_crew.h"

namespace hottel {

// Returns all that others need to light bands of a job as LightOfElements2 does.
std::string cell_job_message_2(const CellJob2& job);

// A job that was read.
struct ReceivedCellJob2 {
  ReceivedElements2 elements;
  RadiositySolution solution;  // radiosities alone
  std::optional<LightOfElements2> light;

  // Throws RequestError where this process makes other elements of the scene than the one that wrote it.
  ReceivedCellJob2(std::string_view bytes, KeptScene2& kept);
  ReceivedCellJob2(const ReceivedCellJob2&) = delete;
  ReceivedCellJob2& operator=(const ReceivedCellJob2&) = delete;
};

}  // namespace hottel
