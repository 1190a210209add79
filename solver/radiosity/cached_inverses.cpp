#include "solver/radiosity/cached_inverses.h"

#include <atomic>
#include <utility>

#include "solver/radiosity/certificate.h"
#include "solver/radiosity/single_precision_lu.h"

namespace hottel {

// What belongs to certain components.
struct CachedInverses::Plain {
  enum class Known : char { kNot, kNo, kYes };

  Plain(const std::vector<char>& wanted, PlainSystem of) : is_wanted(wanted), system(std::move(of)) {}

  std::vector<char> is_wanted;
  PlainSystem system;
  Lazy<ApproximateInverse> lu{};
  std::mutex mutex{};
  bool has_tried_single = false;                             // under the mutex, as is what follows
  std::unique_ptr<const ApproximateInverse> single_lu = {};  // null: not yet, or rows lose too little
  std::atomic<Known> dies_out{Known::kNot};
};

const SymmetricRows& CachedInverses::rows() const {
  return rows_.get([this] { return std::make_unique<SymmetricRows>(system_); });
}

std::shared_ptr<const ApproximateInverse> CachedInverses::elimination(const std::vector<char>& is_wanted) const {
  const SymmetricRows& rows = this->rows();
  return elimination_.get([&] { return std::make_unique<Elimination>(rows, system_.components().size()); })
      .of(is_wanted);
}

std::shared_ptr<const ApproximateInverse> CachedInverses::conjugate_gradient(const std::vector<char>& is_wanted,
                                                                             CgLimits limits,
                                                                             std::vector<double>* history,
                                                                             SharedRows* others) const {
  return make_conjugate_gradient(rows(), is_wanted, limits, history, others);
}

std::shared_ptr<CachedInverses::Plain> CachedInverses::last(const std::vector<char>& is_wanted) const {
  const std::lock_guard lock(mutex_);
  if (!last_ || last_->is_wanted != is_wanted)
    last_ = std::make_shared<Plain>(is_wanted, PlainSystem(system_, is_wanted));
  return last_;
}

std::shared_ptr<const PlainSystem> CachedInverses::plain(const std::vector<char>& is_wanted) const {
  const std::shared_ptr<Plain> kept = last(is_wanted);
  return {kept, &kept->system};
}

std::shared_ptr<const ApproximateInverse> CachedInverses::lu(const std::vector<char>& is_wanted) const {
  const std::shared_ptr<Plain> kept = last(is_wanted);
  return {kept, &kept->lu.get([&] { return make_lu(kept->system, system_.components().size()); })};
}

std::shared_ptr<const ApproximateInverse> CachedInverses::single_precision_lu(
    const std::vector<char>& is_wanted) const {
  const std::shared_ptr<Plain> kept = last(is_wanted);
  const auto single = [&] { return std::shared_ptr<const ApproximateInverse>(kept, kept->single_lu.get()); };
  {
    const std::lock_guard lock(kept->mutex);
    if (kept->has_tried_single) return kept->single_lu ? single() : nullptr;
  }
  // Not under the lock: as below. Who makes it second has made the same.
  std::unique_ptr<const ApproximateInverse> made = make_single_precision_lu(kept->system, system_.components().size());
  const std::lock_guard lock(kept->mutex);
  if (!std::exchange(kept->has_tried_single, true)) kept->single_lu = std::move(made);
  return kept->single_lu ? single() : nullptr;
}

std::shared_ptr<const ApproximateInverse> CachedInverses::bicgstab(const std::vector<char>& is_wanted, CgLimits limits,
                                                                   std::vector<double>* history,
                                                                   SharedRows* others) const {
  return make_bicgstab(plain(is_wanted), system_.components().size(), limits, history, others);
}

bool CachedInverses::light_dies_out(const std::vector<char>& is_wanted, const ApproximateInverse& inverse,
                                    SharedRows* others) const {
  const std::shared_ptr<Plain> kept = last(is_wanted);
  // Not under a lock: others help with the work, and may be asked the same meanwhile.
  if (kept->dies_out == Plain::Known::kNot)
    kept->dies_out =
        spectral_radius_is_below_one(system_, inverse, is_wanted, others) ? Plain::Known::kYes : Plain::Known::kNo;
  return kept->dies_out == Plain::Known::kYes;
}

}  // namespace hottel
