#include "python/bindings/waiting.h"

namespace hottel::python {

void Watch::operator()(std::string_view stage, double fraction) {
  constexpr std::chrono::milliseconds kBetween{50};
  const auto now = std::chrono::steady_clock::now();
  if (now < next_) return;
  next_ = now + kBetween;
  const py::gil_scoped_acquire acquired;
  if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  if (!waiting_.progress.is_none()) waiting_.progress(py::str(stage.data(), stage.size()), fraction);
}

}  // namespace hottel::python
