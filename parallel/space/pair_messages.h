// Sums of pairs in space, and what was found of them, in messages.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/space/exchange/pair_crew.h"
#include "parallel/space/element_messages.h"

namespace hottel {

// Returns all that others need to measure pairs of a job as PairHelper3 does.
std::string pair_job_message_3(const PairJob3& job);

// A job that was read, with all that its request points to.
struct ReceivedPairJob3 {
  std::shared_ptr<const PreparedScene3> prepared;
  std::shared_ptr<const ElementTable3> table;
  PairSumRequest3 request;  // its turn points to the lists below

  std::vector<char> is_now, was_before, with_sky;
  std::optional<PairRanges> known;
  std::optional<PairTurn3> turn;

  // Throws RequestError where this process makes other elements of the scene than the one that wrote it.
  ReceivedPairJob3(std::string_view bytes, KeptScene3& kept);
  ReceivedPairJob3(const ReceivedPairJob3&) = delete;
  ReceivedPairJob3& operator=(const ReceivedPairJob3&) = delete;
};

// What some tasks found, in bytes and back, bit for bit. REQUIRES a table of the same scene, as on both sides.
std::string done_message_3(const DoneTasks3& done, const ElementTable3& table);
DoneTasks3 read_done_3(std::string_view bytes, const ElementTable3& table);

}  // namespace hottel
