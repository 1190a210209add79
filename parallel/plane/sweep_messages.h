// Sweeps in the plane, and what they added up to, in messages.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/plane/exchange/sweep_crew.h"
#include "parallel/plane/element_messages.h"

namespace hottel {

// Returns all that others need to sweep vertices of a job as swept_part() does.
std::string sweep_job_message_2(const SweepJob2& job);

// A job that was read.
struct ReceivedSweepJob2 {
  std::shared_ptr<const PreparedScene2> prepared;
  std::shared_ptr<const ElementTable2> table;  // with the rows of the job

  // Throws RequestError where this process makes other elements of the scene than the one that wrote it.
  ReceivedSweepJob2(std::string_view bytes, KeptScene2& kept);
};

// Vertices in bytes and back.
std::string vertices_message_2(std::span<const VertexId> vertices);
std::vector<VertexId> read_vertices_2(std::string_view bytes);

// What some vertices added up to, in bytes and back, bit for bit.
std::string part_message_2(const SweptPart2& part);
SweptPart2 read_part_2(std::string_view bytes);

}  // namespace hottel
