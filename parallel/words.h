// What helpers and their leader say to each other.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include "geometry/shared_work.h"
#include "parallel/message.h"

namespace hottel {

// How a helper asks for more.
enum class Want : unsigned char {
  kWork,    // it has nothing in hand
  kDone,    // the pieces are done: what was found follows
  kUndone,  // the pieces could not be done
  kCannot,  // it cannot take part in the job: why follows
};

struct WantHead {
  std::uint64_t job = 0;  // the number of the one that it has, 0 where it has none
  Want want = Want::kWork;
  WorkRange pieces{};
};

// Of Word::kWant.
inline std::string want_message(const WantHead& head, std::string_view rest = {}) {
  MessageWriter writer;
  writer.put(head.job, head.want, std::uint64_t{head.pieces.begin}, std::uint64_t{head.pieces.end});
  return writer.bytes() + std::string(rest);
}
inline WantHead read_want(MessageReader& reader) {
  WantHead head;
  reader.take_into(head.job, head.want, head.pieces.begin, head.pieces.end);
  return head;
}

// Of Word::kPieces: what is told of them follows.
inline std::string pieces_message(const WorkRange& pieces, std::string_view told) {
  MessageWriter writer;
  writer.put(std::uint64_t{pieces.begin}, std::uint64_t{pieces.end});
  return writer.bytes() + std::string(told);
}
inline WorkRange read_pieces(MessageReader& reader) {
  WorkRange pieces;
  reader.take_into(pieces.begin, pieces.end);
  return pieces;
}

}  // namespace hottel
