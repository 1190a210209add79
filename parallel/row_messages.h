// Rows of radiosity systems, and what is formed of them, in messages.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/exchange_matrix.h"
#include "geometry/shared_work.h"
#include "parallel/message.h"
#include "solver/radiosity/row_crew.h"
#include "solver/radiosity/symmetric_rows.h"

namespace hottel {

// The unknowns among some elements.
WorkRange unknowns_among(const RadiositySystem& system, const WorkRange& elements);

// Cuts the elements of a system into as many ranges, one after the other, of about as many entries each.
std::vector<WorkRange> even_shares(const ExchangeMatrix& matrix, std::size_t parts);

// Returns all that others need to form the rows of some elements.
std::string rows_message(const RadiositySystem& system, const std::vector<char>& is_wanted, const WorkRange& elements);

// Questions to those who have rows.
std::string product_question(RowProduct product, const std::vector<double>& x);
std::string residual_question(const ResidualQuestion& question);
std::string irradiance_question(const std::vector<ScaledBall>& radiosity, FactorsMeant meant);

// Sets the members of a range that were answered: of unknowns, or of elements where irradiances were asked for. Throws
// ContractViolation where these are more or fewer.
template <class T>
void take_answer(std::string_view answer, const WorkRange& range, std::vector<T>& result) {
  const std::vector<T> values = MessageReader(answer).take_all<T>();
  HOTTEL_REQUIRE(values.size() == range.size() && range.end <= result.size());
  std::copy(values.begin(), values.end(), result.begin() + static_cast<std::ptrdiff_t>(range.begin));
}

// Rows that were read.
class ReceivedRows {
 public:
  explicit ReceivedRows(std::string_view bytes);
  ReceivedRows(const ReceivedRows&) = delete;
  ReceivedRows& operator=(const ReceivedRows&) = delete;

  // Answers a question for these rows, as the whole system does. Throws ContractViolation for any other bytes.
  std::string answer(std::string_view question);

 private:
  std::string product(MessageReader& reader);
  std::string residual(MessageReader& reader) const;
  std::string irradiance(MessageReader& reader) const;

  WorkRange elements_;
  ExchangeMatrix matrix_;
  std::vector<char> is_wanted_;
  std::optional<RadiositySystem> system_;
  WorkRange unknowns_;
  std::optional<SymmetricRows> symmetric_;  // made when they are asked for, as is the other
  std::optional<PlainSystem> plain_;
};

}  // namespace hottel
