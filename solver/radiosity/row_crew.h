// Other processes that go through rows of a radiosity system together with this one.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

#include "geometry/shared_work.h"
#include "solver/radiosity/double_double_ball.h"
#include "solver/radiosity/scaled_ball.h"

namespace hottel {

class RadiositySystem;
struct ResidualQuestion;
enum class FactorsMeant;

// Systems of fewer entries than this are not worth sharing: rows are formed sooner than messages come and go.
inline constexpr std::size_t kLeastSharedEntries = 200'000;

// What rows are multiplied with x: those of K (symmetric_rows.h), or those of scatter (PlainSystem).
enum class RowProduct : unsigned char { kSymmetric, kPlain };

// Rows of one system, some of which others have while it lives. Vectors, and all that is summed over them, stay here:
// a row is a sum of its own, in the order of its columns, so it does not matter who forms it.
//
//   (1) each row is formed once: within a range that `here` is called with, or elsewhere, in `result` then. `here` sets
//       the members of `result` of its range
//   (2) what others could not do is done here; so is everything where another thread asks at the same time
// From any thread. Throws what `here` throws, and Interrupted where it is asked to stop.
class SharedRows {
 public:
  using Here = std::function<void(const WorkRange&)>;
  virtual ~SharedRows() = default;

  // Ranges of unknowns. `result` has a member for each of them.
  virtual void multiply(RowProduct product, const std::vector<double>& x, const Here& here,
                        std::vector<double>& result) = 0;
  virtual void residual(const ResidualQuestion& question, const Here& here, std::vector<DoubleDoubleBall>& result) = 0;
  // Ranges of elements, as the members of `result`.
  virtual void irradiance(const std::vector<ScaledBall>& radiosity, FactorsMeant meant, const Here& here,
                          std::vector<ScaledBall>& result) = 0;
};

// Who takes part in systems. What others find must be what is found here, bit for bit.
class RowCrew {
 public:
  virtual ~RowCrew() = default;
  // Begins to share the rows of a system, whose products are asked for components that are wanted; null where it is
  // solved here alone. From any thread. REQUIRES that both outlive what is returned.
  virtual std::unique_ptr<SharedRows> begin(const RadiositySystem& system, const std::vector<char>& is_wanted) = 0;
};

}  // namespace hottel
