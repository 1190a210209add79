#include "viewer/window/space/nearest_rows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "kernel/support/failure.h"

namespace hottel {

void NearestRows3::look_from(const Direction3& eye) {
  const std::lock_guard lock(mutex_);
  eye_ = eye;
}

std::vector<std::uint32_t> NearestRows3::next(const ExchangeRows3& rows) {
  const ElementTable3& table = rows.table();
  std::vector<std::uint32_t> missing;
  std::uint32_t all = 0;
  for (std::uint32_t i = 0; i < table.count(); ++i) {
    if (rows.is_missing(i)) missing.push_back(i);
    all += table.has_row(i) ? 1 : 0;
  }
  const std::lock_guard lock(mutex_);
  const std::size_t part = std::min<std::size_t>(missing.size(), std::max(1u, (all + kParts - 1) / kParts));
  if (missing.size() == all) {  // it begins
    last_ = &rows;
    so_far_ = {std::vector<char>(table.count(), 0), 0, all, {}};
    middles_.clear();
    for (const auto& corners : rows.corners()) {
      Direction3 sum;
      for (const std::array<double, 3>& p : corners) sum = sum + Direction3{p[0], p[1], p[2]};
      middles_.push_back((1 / std::max(1.0, static_cast<double>(corners.size()))) * sum);
    }
  }
  if (last_ == &rows)
    std::ranges::stable_sort(missing, {}, [this](std::uint32_t i) { return length(middles_[i] - eye_); });
  missing.resize(part);
  return missing;
}

void NearestRows3::have_come(const ExchangeRows3& rows, std::span<const PairSum3> pairs) {
  auto plain = std::make_shared<std::vector<PlainPair3>>();
  for (const PairSum3& pair : pairs)
    plain->push_back({pair.i, pair.j, rows.factor(pair, pair.i), rows.factor(pair, pair.j)});
  {
    const std::lock_guard lock(mutex_);
    if (last_ != &rows) return;
    for (std::uint32_t i = 0; i < so_far_.has_come.size(); ++i)
      so_far_.has_come[i] = rows.table().has_row(i) && !rows.is_missing(i);
    so_far_.count = so_far_.all - rows.missing();
    so_far_.pairs.push_back(std::move(plain));
    has_more_ = true;
  }
  if (changed_) changed_();
}

std::shared_ptr<const RowsSoFar3> NearestRows3::take() {
  const std::lock_guard lock(mutex_);
  if (!std::exchange(has_more_, false)) return nullptr;
  return std::make_shared<const RowsSoFar3>(so_far_);
}

RowSweeps3::RowSweeps3(const Scene3& scene, const ElementTable3& table, const RowsSoFar3& rows,
                       std::span<const LightShares> lights, ElementPaint3 from)
    : sky_(table.sky()), light_(std::move(from)) {
  const std::size_t channels = light_.channels;
  HOTTEL_REQUIRE(rows.has_come.size() == table.count() && light_.values.size() == table.count() * channels);
  HOTTEL_REQUIRE(lights.size() == scene.lights.size());
  std::vector<std::size_t> begin(std::size_t{table.count()} + 1, 0);
  const auto for_each = [&](const auto& take) {
    for (const auto& some : rows.pairs)
      for (const PlainPair3& pair : *some) {
        if (rows.has_come[pair.i] != 0) take(pair.i, pair.j, pair.to_j);
        if (pair.j != sky_ && pair.j != pair.i && rows.has_come[pair.j] != 0) take(pair.j, pair.i, pair.to_i);
      }
  };
  for_each([&](std::uint32_t from_element, std::uint32_t, double) { ++begin[from_element + 1]; });
  for (std::size_t i = 1; i < begin.size(); ++i) begin[i] += begin[i - 1];
  entries_.resize(begin.back());
  std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
  for_each([&](std::uint32_t from_element, std::uint32_t to, double factor) {
    entries_[next[from_element]++] = {to, factor};
  });
  emission_.assign(table.count() * channels, 0);
  reflectivity_.assign(table.count() * channels, 0);
  std::vector<std::array<double, 3>> emission, reflectivity;  // by material
  for (const Material& material : scene.materials) {
    emission.push_back({});
    reflectivity.push_back({});
    for (std::size_t c = 0; c < 3; ++c) {
      emission.back()[c] = to_double(material.emission.value[c]);
      reflectivity.back()[c] = to_double(material.reflectivity.value[c]);
    }
  }
  for (std::uint32_t i = 0; i < table.count(); ++i) {
    if (rows.has_come[i] == 0) continue;
    rows_.push_back({i, begin[i], begin[i + 1]});
    const std::uint32_t material = *table.elements()[i].material;
    for (std::size_t c = 0; c < channels; ++c) {
      double direct = 0;
      for (std::size_t k = 0; k < lights.size(); ++k)
        direct += lights[k].of_element[i].upper * to_double(scene.lights[k].power.value[c]);
      // What a light sends is reflected once and is then sent out as if it were emitted.
      emission_[i * channels + c] =
          emission[material][c] + reflectivity[material][c] * direct / table.elements()[i].area.value;
      reflectivity_[i * channels + c] = reflectivity[material][c];
    }
  }
}

double RowSweeps3::sweep() {
  const std::size_t channels = light_.channels;
  double most = 0, change = 0;
  std::array<double, 3> received{};
  for (const Row& row : rows_) {
    received.fill(0);
    for (std::size_t k = row.begin; k < row.end; ++k) {
      const double* sent =
          entries_[k].to == sky_ ? light_.sky.data() : light_.values.data() + entries_[k].to * channels;
      for (std::size_t c = 0; c < channels; ++c) received[c] += entries_[k].factor * sent[c];
    }
    for (std::size_t c = 0; c < channels; ++c) {
      const std::size_t place = row.element * channels + c;
      const double now = emission_[place] + reflectivity_[place] * received[c];
      change = std::max(change, std::fabs(now - light_.values[place]));
      most = std::max(most, now);
      light_.values[place] = now;
    }
  }
  return most > 0 ? change / most : 0;
}

}  // namespace hottel
