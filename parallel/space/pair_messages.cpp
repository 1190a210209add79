#include "parallel/space/pair_messages.h"

#include <cstdint>
#include <utility>

#include "kernel/support/failure.h"

namespace hottel {
namespace {

using Part = ElementTable3::Part;

void put_list(const std::vector<char>& list, MessageWriter& writer) {
  writer.put_text(std::string_view(list.data(), list.size()));
}
std::vector<char> take_list(MessageReader& reader) {
  const std::string_view text = reader.take_text();
  return {text.begin(), text.end()};
}

void put_ranges(const PairRanges& known, MessageWriter& writer) {
  writer.put(known.elements());
  for (std::uint32_t i = 0; i < known.elements(); ++i) {
    writer.put(std::uint64_t{known.ranges(i).size()});
    for (const ColumnRange& range : known.ranges(i)) writer.put(range.begin, range.end);
  }
}
PairRanges take_ranges(MessageReader& reader) {
  PairRanges known(reader.take<std::uint32_t>());
  for (std::uint32_t i = 0; i < known.elements(); ++i)
    for (auto left = reader.take<std::uint64_t>(); left > 0; --left) {
      ColumnRange range;
      reader.take_into(range.begin, range.end);
      known.add(i, range);
    }
  return known;
}

// Which of its own patches a pair is of: of one label, all or what is free of it.
void put_part(const Part& part, const ElementTable3& table, MessageWriter& writer) {
  const std::span<const Part> all = table.parts(part.label), free = table.free_parts(part.label);
  const auto is_among = [&part](std::span<const Part> parts) {
    return !parts.empty() && &part >= &parts.front() && &part <= &parts.back();
  };
  const bool is_of_all = is_among(all);
  HOTTEL_REQUIRE(is_of_all || is_among(free));
  writer.put(part.label, is_of_all, std::uint64_t(&part - (is_of_all ? all : free).data()));
}
const Part* take_part(MessageReader& reader, const ElementTable3& table) {
  const auto label = reader.take<std::uint32_t>();
  HOTTEL_REQUIRE(label <= table.sky());
  const bool is_of_all = reader.take<bool>();
  const std::span<const Part> parts = is_of_all ? table.parts(label) : table.free_parts(label);
  const auto place = reader.take<std::uint64_t>();
  HOTTEL_REQUIRE(place < parts.size());
  return &parts[place];
}

void put_sum(const PairSum3& sum, MessageWriter& writer) {
  writer.put(sum.i, sum.j, sum.measure, sum.error, sum.bounds.lower, sum.bounds.upper, sum.alone, sum.is_whole);
}
PairSum3 take_sum(MessageReader& reader) {
  PairSum3 sum{};
  reader.take_into(sum.i, sum.j, sum.measure, sum.error, sum.bounds.lower, sum.bounds.upper, sum.alone, sum.is_whole);
  return sum;
}

// Calls visit(count) for all that sum_pairs() adds to.
template <class Report, class Visit>
void for_each_count(Report& counts, const Visit& visit) {
  for (auto* count : {&counts.hidden, &counts.clear, &counts.mixed, &counts.maps, &counts.pieces, &counts.nodes,
                      &counts.signs.by_tier[0], &counts.signs.by_tier[1], &counts.signs.by_tier[2], &counts.proof.parts,
                      &counts.proof.halvings, &counts.proof.redone, &counts.proof.failures})
    visit(*count);
}

}  // namespace

std::string pair_job_message_3(const PairJob3& job) {
  const PairSumRequest3& request = job.request;
  MessageWriter writer;
  put_elements_3(job.prepared, job.granularity, job.table, writer);
  writer.put(request.tolerance, request.proves, request.wants_visibility, request.turn != nullptr);
  if (request.turn == nullptr) return writer.bytes();
  const PairTurn3& turn = *request.turn;
  put_list(turn.is_now, writer);
  put_list(turn.was_before, writer);
  writer.put(turn.is_of_sky_alone, turn.with_sky != nullptr, turn.known != nullptr);
  if (turn.with_sky != nullptr) put_list(*turn.with_sky, writer);
  if (turn.known != nullptr) put_ranges(*turn.known, writer);
  return writer.bytes();
}

ReceivedPairJob3::ReceivedPairJob3(std::string_view bytes, KeptScene3& kept) {
  MessageReader reader(bytes);
  const ReceivedElements3 elements = take_elements_3(reader, kept);
  prepared = elements.prepared;
  table = elements.table;
  bool has_turn = false;
  reader.take_into(request.tolerance, request.proves, request.wants_visibility, has_turn);
  if (!has_turn) return;
  is_now = take_list(reader);
  was_before = take_list(reader);
  bool is_of_sky_alone = false, has_sky = false, has_known = false;
  reader.take_into(is_of_sky_alone, has_sky, has_known);
  if (has_sky) with_sky = take_list(reader);
  if (has_known) known = take_ranges(reader);
  turn.emplace(PairTurn3{.is_now = is_now,
                         .was_before = was_before,
                         .known = has_known ? &*known : nullptr,
                         .with_sky = has_sky ? &with_sky : nullptr,
                         .is_of_sky_alone = is_of_sky_alone});
  request.turn = &*turn;
}

std::string done_message_3(const DoneTasks3& done, const ElementTable3& table) {
  MessageWriter writer;
  writer.put(std::uint64_t{done.tasks.begin}, std::uint64_t{done.tasks.end});
  for_each_count(done.counts, [&](const std::uint64_t& count) { writer.put(count); });
  writer.put(std::uint64_t{done.found.size()});
  for (const auto& [task, found] : done.found) {
    writer.put(std::uint64_t{task}, std::uint64_t{found.pairs.size()}, std::uint64_t{found.open.size()});
    for (const PairSum3& sum : found.pairs) put_sum(sum, writer);
    for (const OpenPair3& open : found.open) {
      put_sum(open.sum, writer);
      put_part(*open.a, table, writer);
      put_part(*open.b, table, writer);
      writer.put(open.is_undecided);
      writer.put_text(open.problem);
    }
  }
  return writer.bytes();
}

DoneTasks3 read_done_3(std::string_view bytes, const ElementTable3& table) {
  MessageReader reader(bytes);
  DoneTasks3 done{.tasks = {}, .found = {}};
  reader.take_into(done.tasks.begin, done.tasks.end);
  for_each_count(done.counts, [&](std::uint64_t& count) { count = reader.take<std::uint64_t>(); });
  for (auto left = reader.take<std::uint64_t>(); left > 0; --left) {
    std::uint64_t task = 0, pairs = 0, open = 0;
    reader.take_into(task, pairs, open);
    FoundPairs3 found;
    for (; pairs > 0; --pairs) found.pairs.push_back(take_sum(reader));
    for (; open > 0; --open) {
      OpenPair3 one{take_sum(reader), nullptr, nullptr, false, ""};
      one.a = take_part(reader, table);
      one.b = take_part(reader, table);
      one.is_undecided = reader.take<bool>();
      one.problem = reader.take_text();
      found.open.push_back(std::move(one));
    }
    done.found.emplace_back(task, std::move(found));
  }
  HOTTEL_REQUIRE(reader.is_at_end());
  return done;
}

}  // namespace hottel
