// View factors as they arrive: those of what is near first, and light that goes around among them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "geometry/space/exchange/exchange_rows.h"
#include "geometry/space/scene/scene.h"
#include "geometry/space/visibility/direction.h"
#include "solver/radiosity/direct_light.h"
#include "viewer/picture/space/element_paint.h"

namespace hottel {

// Two elements with their factors to each other; one that has no row sends no light.
struct PlainPair3 {
  std::uint32_t i = 0, j = 0;
  double to_j = 0, to_i = 0;  // F(i, j), F(j, i)
};

// Rows so far.
struct RowsSoFar3 {
  std::vector<char> has_come;  // by element
  std::uint32_t count = 0, all = 0;
  std::vector<std::shared_ptr<const std::vector<PlainPair3>>> pairs;  // with the sky as the last number
};

// Lets rows come in parts, those of elements nearest to the eye first, wherever the eye is when a part begins.
//
//   (1) each part has a kParts-th of all rows, one at least
//   (2) it tells of the measurement that began last: one that has not stopped yet is not mixed with it
// Any thread may call its functions.
class NearestRows3 : public RowWatch3 {
 public:
  static constexpr std::uint32_t kParts = 24;

  // changed: called on other threads when something has come; must be quick.
  explicit NearestRows3(std::function<void()> changed) : changed_(std::move(changed)) {}

  void look_from(const Direction3& eye);
  std::vector<std::uint32_t> next(const ExchangeRows3& rows) override;
  void have_come(const ExchangeRows3& rows, std::span<const PairSum3> pairs) override;

  // What has come since it was asked for last, with all before; null where nothing has.
  std::shared_ptr<const RowsSoFar3> take();

 private:
  const std::function<void()> changed_;
  std::mutex mutex_;
  Direction3 eye_;
  const ExchangeRows3* last_ = nullptr;  // that began last; it may have ended
  RowsSoFar3 so_far_;
  bool has_more_ = false;
  std::vector<Direction3> middles_;  // by element
};

// Sweeps of Gauss and Seidel over the rows that have come, in the order of the elements: each element takes what it
// receives from all it sees, as they shine now. Elements whose rows are missing stay as they are.
//
//   (1) without missing rows it tends to the light of the scene
class RowSweeps3 {
 public:
  // lights: the shares of each light of the scene. from: the light to begin with (light_before_factors_3). REQUIRES as
  // many elements in the table, the rows, the shares and this light, and a share of each light.
  RowSweeps3(const Scene3& scene, const ElementTable3& table, const RowsSoFar3& rows,
             std::span<const LightShares> lights, ElementPaint3 from);

  // One more sweep. Returns the largest change of a radiosity, in fractions of the largest radiosity.
  double sweep();
  const ElementPaint3& light() const { return light_; }

 private:
  struct Row {
    std::uint32_t element;
    std::size_t begin, end;  // in entries_
  };
  struct Entry {
    std::uint32_t to;
    double factor;
  };

  std::vector<Row> rows_;
  std::vector<Entry> entries_;
  std::vector<double> emission_, reflectivity_;  // by element and channel
  std::uint32_t sky_;
  ElementPaint3 light_;
};

}  // namespace hottel
