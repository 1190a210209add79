#include "parallel/channel.h"

#include <mpi.h>
#include <sched.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <thread>
#include <vector>

#include "io/files/pending_removal.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

// Counts of MPI are ints.
constexpr std::size_t kMostAtATime = std::size_t{1} << 30;

// Calls visit(begin, count) for the parts that a message is sent in.
template <class Visit>
void for_each_part(std::size_t size, const Visit& visit) {
  for (std::size_t begin = 0; begin < size; begin += kMostAtATime)
    visit(begin, static_cast<int>(std::min(kMostAtATime, size - begin)));
}

// How many ranks of one machine have the same cores as this one.
int ranks_on_the_cores_of_this_one(MPI_Comm machine) {
  int count = 1;
  MPI_Comm_size(machine, &count);
  cpu_set_t mine;
  CPU_ZERO(&mine);
  sched_getaffinity(0, sizeof mine, &mine);
  std::vector<cpu_set_t> all(static_cast<std::size_t>(count));
  MPI_Allgather(&mine, sizeof mine, MPI_BYTE, all.data(), sizeof mine, MPI_BYTE, machine);
  return static_cast<int>(std::ranges::count_if(all, [&](const cpu_set_t& set) { return CPU_EQUAL(&set, &mine); }));
}

// What MPI cannot do ends the job; it would leave temporary files behind.
void end_job(MPI_Comm* communicator, int* error, ...) {
  remove_pending();
  std::array<char, MPI_MAX_ERROR_STRING> text{};
  int length = 0;
  MPI_Error_string(*error, text.data(), &length);
  std::fprintf(stderr, "hottel-mpi: %.*s\n", length, text.data());
  MPI_Abort(*communicator, 1);
}

}  // namespace

Channel::Channel(int& argc, char**& argv) {
  int provided = 0;
  MPI_Init_thread(&argc, &argv, MPI_THREAD_SERIALIZED, &provided);
  HOTTEL_REQUIRE(provided >= MPI_THREAD_SERIALIZED);
  MPI_Errhandler handler = MPI_ERRHANDLER_NULL;
  MPI_Comm_create_errhandler(end_job, &handler);
  MPI_Comm_set_errhandler(MPI_COMM_WORLD, handler);
  MPI_Errhandler_free(&handler);
  MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks_);
  MPI_Comm here = MPI_COMM_NULL;
  MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &here);
  ranks_on_these_cores_ = ranks_on_the_cores_of_this_one(here);
  MPI_Comm_free(&here);
}

Channel::~Channel() { MPI_Finalize(); }

void Channel::send(int rank, Word word, const std::string& bytes) {
  const std::uint64_t size = bytes.size();
  const int tag = static_cast<int>(word);
  MPI_Send(&size, 1, MPI_UINT64_T, rank, tag, MPI_COMM_WORLD);
  for_each_part(bytes.size(), [&](std::size_t begin, int count) {
    MPI_Send(bytes.data() + begin, count, MPI_BYTE, rank, tag, MPI_COMM_WORLD);
  });
}

std::optional<Message> Channel::receive() {
  int is_there = 0;
  MPI_Status status;
  MPI_Iprobe(MPI_ANY_SOURCE, MPI_ANY_TAG, MPI_COMM_WORLD, &is_there, &status);
  if (is_there == 0) return std::nullopt;
  const int rank = status.MPI_SOURCE, tag = status.MPI_TAG;
  std::uint64_t size = 0;
  MPI_Recv(&size, 1, MPI_UINT64_T, rank, tag, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
  Message message{rank, static_cast<Word>(tag), std::string(size, '\0')};
  for_each_part(message.bytes.size(), [&](std::size_t begin, int count) {
    MPI_Recv(message.bytes.data() + begin, count, MPI_BYTE, rank, tag, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
  });
  return message;
}

Message Channel::wait() {
  Nap nap;
  for (;; nap.take())
    if (auto message = receive()) return std::move(*message);
}

void Nap::take() {
  std::this_thread::sleep_for(std::chrono::microseconds(microseconds_));
  microseconds_ = std::min(2 * microseconds_, kMost);
}

}  // namespace hottel
