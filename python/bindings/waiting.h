// Long work: without the lock of the interpreter, ended by Ctrl-C, told to who asked for it.
#pragma once

#include <pybind11/pybind11.h>

#include <chrono>
#include <functional>
#include <optional>
#include <string_view>

#include "kernel/support/stage.h"
#include "kernel/support/thread_share.h"

namespace hottel::python {

namespace py = pybind11;

// How the stages of a simulation are waited for.
struct Waiting {
  std::optional<int> threads;       // at most so many for each piece of work
  py::object progress{py::none()};  // progress(stage, fraction), or None
};

// Asks Python, every twentieth of a second, for signals, and tells it of progress. REQUIRES a thread that does not hold
// the lock of the interpreter.
class Watch {
 public:
  explicit Watch(const Waiting& waiting) : waiting_(waiting) {}
  // Throws error_already_set where Ctrl-C was pressed, or where the callable throws.
  void operator()(std::string_view stage, double fraction);

 private:
  const Waiting& waiting_;
  std::chrono::steady_clock::time_point next_{};
};

// Returns work(progress), which runs without the lock of the interpreter. REQUIRES the lock, and that the work touches
// no object of Python.
template <class Work>
auto without_lock(const Waiting& waiting, const Work& work) {
  Watch watch(waiting);
  const py::gil_scoped_release released;
  const ThreadShare share(waiting.threads.value_or(0));
  return work(StageProgress(std::ref(watch)));
}

}  // namespace hottel::python
