#include "solver/radiosity/kept_inverses.h"

#include <atomic>

#include "solver/radiosity/certificate.h"

namespace hottel {

// What belongs to certain components.
struct KeptInverses::Plain {
  enum class Known : char { kNot, kNo, kYes };

  std::vector<char> is_wanted;
  PlainSystem system;
  MadeOnce<ApproximateInverse> lu{};
  std::atomic<Known> dies_out{Known::kNot};
};

const SymmetricRows& KeptInverses::rows() const {
  return rows_.get([this] { return std::make_unique<SymmetricRows>(system_); });
}

std::shared_ptr<const ApproximateInverse> KeptInverses::elimination(const std::vector<char>& is_wanted) const {
  const SymmetricRows& rows = this->rows();
  return elimination_.get([&] { return std::make_unique<Elimination>(rows, system_.components().size()); })
      .of(is_wanted);
}

std::shared_ptr<const ApproximateInverse> KeptInverses::conjugate_gradient(const std::vector<char>& is_wanted,
                                                                           CgLimits limits,
                                                                           std::vector<double>* history) const {
  return make_conjugate_gradient(rows(), is_wanted, limits, history);
}

std::shared_ptr<KeptInverses::Plain> KeptInverses::last(const std::vector<char>& is_wanted) const {
  const std::lock_guard lock(mutex_);
  if (!last_ || last_->is_wanted != is_wanted)
    last_ = std::shared_ptr<Plain>(new Plain{is_wanted, PlainSystem(system_, is_wanted)});
  return last_;
}

std::shared_ptr<const PlainSystem> KeptInverses::plain(const std::vector<char>& is_wanted) const {
  const std::shared_ptr<Plain> kept = last(is_wanted);
  return {kept, &kept->system};
}

std::shared_ptr<const ApproximateInverse> KeptInverses::lu(const std::vector<char>& is_wanted) const {
  const std::shared_ptr<Plain> kept = last(is_wanted);
  return {kept, &kept->lu.get([&] { return make_lu(kept->system, system_.components().size()); })};
}

std::shared_ptr<const ApproximateInverse> KeptInverses::bicgstab(const std::vector<char>& is_wanted, CgLimits limits,
                                                                 std::vector<double>* history) const {
  return make_bicgstab(plain(is_wanted), system_.components().size(), limits, history);
}

bool KeptInverses::light_dies_out(const std::vector<char>& is_wanted, const ApproximateInverse& inverse) const {
  const std::shared_ptr<Plain> kept = last(is_wanted);
  // Not under a lock: others help with the work, and may be asked the same meanwhile.
  if (kept->dies_out == Plain::Known::kNot)
    kept->dies_out = spectral_radius_is_below_one(system_, inverse, is_wanted) ? Plain::Known::kYes : Plain::Known::kNo;
  return kept->dies_out == Plain::Known::kYes;
}

}  // namespace hottel
