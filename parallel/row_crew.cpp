#include "parallel/row_crew.h"

#include <atomic>
#include <string>
#include <utility>
#include <vector>

namespace hottel {
namespace {

// The first range is that of this process, range k that of helper k.
class LedRows : public SharedRows {
 public:
  LedRows(std::unique_ptr<LedShares> shares, std::vector<WorkRange> elements, std::vector<WorkRange> unknowns)
      : shares_(std::move(shares)), elements_(std::move(elements)), unknowns_(std::move(unknowns)) {}

  void multiply(RowProduct product, const std::vector<double>& x, const Here& here,
                std::vector<double>& result) override {
    form([&] { return product_question(product, x); }, unknowns_, here, result);
  }
  void residual(const ResidualQuestion& question, const Here& here, std::vector<DoubleDoubleBall>& result) override {
    form([&] { return residual_question(question); }, unknowns_, here, result);
  }
  void irradiance(const std::vector<ScaledBall>& radiosity, FactorsMeant meant, const Here& here,
                  std::vector<ScaledBall>& result) override {
    form([&] { return irradiance_question(radiosity, meant); }, elements_, here, result);
  }

 private:
  template <class Question, class T>
  void form(const Question& question, const std::vector<WorkRange>& ranges, const Here& here, std::vector<T>& result) {
    // No lock: who waits for threads of its own may be asked to do work of others, and come here again.
    if (is_asking_.test_and_set()) return here({0, result.size()});
    const struct Asking {
      std::atomic_flag& flag;
      ~Asking() { flag.clear(); }
    } asking{is_asking_};
    std::vector<char> is_left(ranges.size(), 1);
    is_left[0] = 0;
    shares_->ask(
        question(), [&] { here(ranges[0]); },
        [&](std::size_t k, std::string_view answer) {
          take_answer(answer, ranges[k], result);
          is_left[k] = 0;
        });
    for (std::size_t k = 0; k < ranges.size(); ++k)
      if (is_left[k] != 0) here(ranges[k]);
  }

  const std::unique_ptr<LedShares> shares_;
  const std::vector<WorkRange> elements_, unknowns_;
  std::atomic_flag is_asking_;
};

class HelperRows : public HelperJob {
 public:
  explicit HelperRows(std::string_view bytes) : rows_(bytes) {}
  std::string work(const WorkRange&, std::string_view told) override { return rows_.answer(told); }

 private:
  ReceivedRows rows_;
};

}  // namespace

std::unique_ptr<SharedRows> LedRowCrew::begin(const RadiositySystem& system, const std::vector<char>& is_wanted) {
  const ExchangeMatrix& matrix = system.matrix();
  if (matrix.entry_count() < least_ || matrix.memory() != nullptr) return nullptr;
  std::vector<WorkRange> elements;
  auto shares = leader_.begin_shares([&](std::size_t k, std::size_t helpers) {
    if (elements.empty()) elements = even_shares(matrix, helpers + 1);
    return mark_ + rows_message(system, is_wanted, elements[k]);
  });
  if (shares == nullptr) return nullptr;
  std::vector<WorkRange> unknowns;
  for (const WorkRange& range : elements) unknowns.push_back(unknowns_among(system, range));
  return std::make_unique<LedRows>(std::move(shares), std::move(elements), std::move(unknowns));
}

std::unique_ptr<HelperJob> RowJobs::make(std::string_view bytes) { return std::make_unique<HelperRows>(bytes); }

}  // namespace hottel
