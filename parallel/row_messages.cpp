#include "parallel/row_messages.h"

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>

#include "kernel/support/failure.h"

namespace hottel {
namespace {

enum class Asked : unsigned char { kProduct, kResidual, kIrradiance };

// Elements of which areas are known, and which of them have rows.
void put_elements(const ExchangeMatrix& matrix, MessageWriter& writer) {
  writer.put(std::uint64_t{matrix.size()});
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    const Rounded& area = matrix.elements()[i].area;
    writer.put(area.value, area.side, matrix.has_row(i));
  }
}

std::vector<Element> take_elements(MessageReader& reader) {
  std::vector<Element> elements(reader.take<std::uint64_t>());
  for (Element& element : elements) {
    bool has_row = false;
    reader.take_into(element.area.value, element.area.side, has_row);
    if (has_row) element.material = 0;
  }
  return elements;
}

// Entries of some rows. Bounds are sent where the leader may ask for residuals of all factors within them.
void put_entries(const RadiositySystem& system, const WorkRange& elements, MessageWriter& writer) {
  const ExchangeMatrix& matrix = system.matrix();
  const std::size_t begin = matrix.begins()[elements.begin], end = matrix.begins()[elements.end];
  writer.put_all(matrix.begins().subspan(elements.begin, elements.size() + 1));
  writer.put_all(matrix.columns().subspan(begin, end - begin));
  writer.put_all(matrix.factors().subspan(begin, end - begin));
  std::vector<signed char> sides;
  sides.reserve(end - begin);
  for (std::size_t i = elements.begin; i < elements.end; ++i)
    for (const FactorEntry& entry : matrix.row(static_cast<std::uint32_t>(i))) sides.push_back(entry.factor.side);
  writer.put_all(sides);
  const bool has_bounds = matrix.guarantee() != Guarantee::kExact && system.rows_are_closed();
  writer.put(matrix.guarantee() == Guarantee::kExact, has_bounds);
  if (!has_bounds) return;
  std::vector<Enclosure> bounds;
  std::vector<Guarantee> guarantees;
  for (auto i = static_cast<std::uint32_t>(elements.begin); i < elements.end; ++i)
    for (std::size_t k = 0; k < matrix.row(i).size(); ++k) {
      bounds.push_back(matrix.bounds(i, k));
      guarantees.push_back(matrix.guarantee(i, k));
    }
  writer.put_all(bounds);
  writer.put_all(guarantees);
}

ExchangeMatrix take_entries(std::vector<Element> elements, const WorkRange& range, MessageReader& reader) {
  const std::size_t size = elements.size();
  const auto begins = reader.take_all<std::size_t>();
  const auto columns = reader.take_all<std::uint32_t>();
  const auto factors = reader.take_all<double>();
  const auto sides = reader.take_all<signed char>();
  HOTTEL_REQUIRE(range.end <= size && begins.size() == range.size() + 1);
  HOTTEL_REQUIRE(columns.size() == factors.size() && columns.size() == sides.size());
  std::vector<std::size_t> begin(size + 1, 0);
  for (std::size_t i = 0; i <= size; ++i)
    begin[i] = begins[std::clamp(i, range.begin, range.end) - range.begin] - begins.front();
  FactorEntries entries(columns.size());
  for (std::size_t k = 0; k < columns.size(); ++k) entries.set(k, {columns[k], {factors[k], sides[k]}, 1});
  const bool is_exact = reader.take<bool>(), has_bounds = reader.take<bool>();
  std::vector<Enclosure> bounds;
  std::vector<Guarantee> guarantees;
  if (has_bounds) {
    bounds = reader.take_all<Enclosure>();
    guarantees = reader.take_all<Guarantee>();
  }
  ExchangeMatrix matrix(std::move(elements), is_exact ? Guarantee::kExact : Guarantee::kEstimated);
  matrix.assign(std::move(begin), std::move(entries), {}, std::move(bounds), std::move(guarantees));
  return matrix;
}

void put_numbers(const RadiositySystem& system, MessageWriter& writer) {
  writer.put(system.rows_are_closed(), system.has_negative_factors());
  writer.put(std::uint64_t{system.matrix().size()} + 1);
  for (std::uint32_t e = 0; e <= system.matrix().size(); ++e) writer.put(system.unknown(e));
  writer.put_all(system.rows());
  writer.put_all(system.components());
}

SystemNumbers take_numbers(MessageReader& reader) {
  SystemNumbers numbers;
  reader.take_into(numbers.rows_are_closed, numbers.has_negative_factors);
  numbers.unknown = reader.take_all<std::int32_t>();
  numbers.rows = reader.take_all<SystemRow>();
  numbers.components = reader.take_all<SystemComponent>();
  return numbers;
}

template <class T>
std::string part_of(const std::vector<T>& values, const WorkRange& range) {
  MessageWriter writer;
  writer.put_all(std::span(values).subspan(range.begin, range.size()));
  return writer.bytes();
}

}  // namespace

WorkRange unknowns_among(const RadiositySystem& system, const WorkRange& elements) {
  const auto first_from = [&](std::size_t element) {
    const auto place = std::ranges::lower_bound(system.rows(), element, {}, &SystemRow::element);
    return static_cast<std::size_t>(place - system.rows().begin());
  };
  return {first_from(elements.begin), first_from(elements.end)};
}

std::vector<WorkRange> even_shares(const ExchangeMatrix& matrix, std::size_t parts) {
  std::vector<WorkRange> shares;
  std::size_t begin = 0;
  for (std::size_t k = 1; k <= parts; ++k) {
    const auto from_here = matrix.begins().begin() + static_cast<std::ptrdiff_t>(begin);
    const auto last = matrix.begins().end() - 1;
    const std::size_t entries = matrix.entry_count() / parts * k;
    const auto end = k == parts ? last : std::lower_bound(from_here, last, entries);
    shares.push_back({begin, static_cast<std::size_t>(end - matrix.begins().begin())});
    begin = shares.back().end;
  }
  return shares;
}

std::string rows_message(const RadiositySystem& system, const std::vector<char>& is_wanted, const WorkRange& elements) {
  MessageWriter writer;
  writer.put(std::uint64_t{elements.begin}, std::uint64_t{elements.end});
  writer.put_all(is_wanted);
  put_elements(system.matrix(), writer);
  put_entries(system, elements, writer);
  put_numbers(system, writer);
  return writer.bytes();
}

std::string product_question(RowProduct product, const std::vector<double>& x) {
  MessageWriter writer;
  writer.put(Asked::kProduct, product);
  writer.put_all(x);
  return writer.bytes();
}

std::string residual_question(const ResidualQuestion& question) {
  MessageWriter writer;
  writer.put(Asked::kResidual, question.terms.factors, question.terms.roundings, question.terms.meant);
  writer.put_all(question.x.constant);
  writer.put_all(question.x.rest);
  writer.put_all(question.is_wanted);
  writer.put(question.sources != nullptr);
  if (question.sources == nullptr) return writer.bytes();
  writer.put_all(question.sources->emission);
  writer.put_all(question.sources->exponent);
  return writer.bytes();
}

std::string irradiance_question(const std::vector<ScaledBall>& radiosity, FactorsMeant meant) {
  MessageWriter writer;
  writer.put(Asked::kIrradiance, meant);
  writer.put_all(radiosity);
  return writer.bytes();
}

ReceivedRows::ReceivedRows(std::string_view bytes) {
  MessageReader reader(bytes);
  reader.take_into(elements_.begin, elements_.end);
  is_wanted_ = reader.take_all<char>();
  std::vector<Element> elements = take_elements(reader);
  matrix_ = take_entries(std::move(elements), elements_, reader);
  system_.emplace(matrix_, take_numbers(reader));
  unknowns_ = unknowns_among(*system_, elements_);
}

std::string ReceivedRows::answer(std::string_view question) {
  MessageReader reader(question);
  switch (reader.take<Asked>()) {
    case Asked::kProduct:
      return product(reader);
    case Asked::kResidual:
      return residual(reader);
    case Asked::kIrradiance:
      return irradiance(reader);
  }
  throw ContractViolation("not a question");
}

std::string ReceivedRows::product(MessageReader& reader) {
  const auto product = reader.take<RowProduct>();
  const auto x = reader.take_all<double>();
  HOTTEL_REQUIRE(x.size() == system_->size());
  std::vector<double> result(x.size());
  if (product == RowProduct::kSymmetric) {
    if (!symmetric_) symmetric_.emplace(*system_);
    symmetric_->multiply(unknowns_, x, result);
  } else {
    if (!plain_) plain_.emplace(*system_, is_wanted_);
    plain_->multiply(unknowns_, x, result);
  }
  return part_of(result, unknowns_);
}

std::string ReceivedRows::residual(MessageReader& reader) const {
  ErrorTerms terms;
  reader.take_into(terms.factors, terms.roundings, terms.meant);
  SplitVector x;
  x.constant = reader.take_all<DoubleDouble>();
  x.rest = reader.take_all<DoubleDouble>();
  const auto is_wanted = reader.take_all<char>();
  std::optional<Sources> sources;
  if (reader.take<bool>()) {
    sources.emplace();
    sources->emission = reader.take_all<ScaledBall>();
    sources->exponent = reader.take_all<int>();
  }
  HOTTEL_REQUIRE(x.rest.size() == system_->size());
  std::vector<DoubleDoubleBall> result(system_->size());
  system_->set_residual({sources ? &*sources : nullptr, x, is_wanted, terms}, unknowns_, result);
  return part_of(result, unknowns_);
}

std::string ReceivedRows::irradiance(MessageReader& reader) const {
  const auto meant = reader.take<FactorsMeant>();
  const auto radiosity = reader.take_all<ScaledBall>();
  HOTTEL_REQUIRE(radiosity.size() == matrix_.size() + std::size_t{1});
  std::vector<ScaledBall> result(matrix_.size());
  system_->set_irradiance(radiosity, meant, elements_, result);
  return part_of(result, elements_);
}

}  // namespace hottel
