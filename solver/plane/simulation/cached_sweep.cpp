#include "solver/plane/simulation/cached_sweep.h"

#include <utility>

#include "kernel/int128.h"
#include "solver/store_key.h"

namespace hottel {
namespace {

// Another one wherever sums of the same scene are others, or are kept otherwise, than before.
constexpr const char* kSweepKind = "plane sweep 1";

// Numbers by 7 bits a byte.
void put(std::string& out, UInt128 value) {
  for (; value >= 128; value >>= 7) out += static_cast<char>(static_cast<unsigned>(value % 128) + 128);
  out += static_cast<char>(static_cast<unsigned>(value));
}

class Numbers {
 public:
  explicit Numbers(std::string_view text) : text_(text) {}
  UInt128 take() {
    UInt128 value = 0;
    for (int shift = 0; shift < 128 && !text_.empty(); shift += 7) {
      const auto byte = static_cast<unsigned char>(text_.front());
      text_.remove_prefix(1);
      value |= static_cast<UInt128>(byte % 128U) << shift;
      if (byte < 128) return value;
    }
    is_whole_ = false;
    return 0;
  }
  std::uint64_t count() { return static_cast<std::uint64_t>(take()); }
  bool is_whole() const { return is_whole_; }
  bool is_at_end() const { return text_.empty(); }

 private:
  std::string_view text_;
  bool is_whole_ = true;
};

// Small numbers of either sign become small ones without.
UInt128 folded(Int128 value) { return (static_cast<UInt128>(value) << 1) ^ (value < 0 ? ~UInt128{0} : UInt128{0}); }
Int128 unfolded(UInt128 value) {
  return static_cast<Int128>((value >> 1) ^ ((value & 1) != 0 ? ~UInt128{0} : UInt128{0}));
}

// SEE: FNV-1a, 64 bits.
std::uint64_t number_of_order(std::span<const VertexId> order) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const VertexId v : order)
    for (int shift = 0; shift < 32; shift += 8) hash = (hash ^ (v.index() >> shift & 0xff)) * 0x100000001b3;
  return hash;
}

}  // namespace

std::string bytes_of(const SweptPart2& part, std::uint64_t order) {
  std::string out;
  for (const std::uint64_t number : {order, std::uint64_t{part.begin}, std::uint64_t{part.end}, part.counts.gaps,
                                     part.counts.updates, std::uint64_t{part.sums.size()}})
    put(out, number);
  std::uint64_t last = 0;
  for (const PairSum2& sum : part.sums) {
    put(out, sum.key - last);
    put(out, UInt128{sum.inexact} << 1 | sum.is_obstructed);
    put(out, folded(sum.value));
    last = sum.key;
  }
  return out;
}

std::optional<SweptPart2> swept_part_2(std::string_view bytes, std::uint64_t order) {
  Numbers in(bytes);
  if (in.count() != order) return std::nullopt;
  SweptPart2 part;
  part.begin = in.count();
  part.end = in.count();
  part.counts.gaps = in.count();
  part.counts.updates = in.count();
  const std::uint64_t size = in.count();
  if (!in.is_whole() || size > bytes.size()) return std::nullopt;
  part.sums.resize(size);
  std::uint64_t last = 0;
  for (PairSum2& sum : part.sums) {
    last += in.count();
    const UInt128 lengths = in.take();
    sum.key = last;
    sum.inexact = static_cast<std::uint64_t>(lengths >> 1) & (~std::uint64_t{0} >> 1);
    sum.is_obstructed = static_cast<unsigned>(lengths & 1);
    sum.value = unfolded(in.take());
  }
  if (!in.is_whole() || !in.is_at_end()) return std::nullopt;
  return part;
}

CachedSweep2::CachedSweep2(FactorStore& store, const PreparedScene2& prepared, const StoreTable& factors)
    : store_(store), prepared_(prepared), table_{{}, factors.about + ", begun", factors.elements} {
  StoreKey key(kSweepKind);
  key.add(factors.key);
  key.add_division(prepared.scene);
  key.add_elements(factors.elements);
  table_.key = key.text();
}

SweepParts2 CachedSweep2::parts() const {
  const std::uint64_t order = number_of_order(prepared_.arrangement.triangulation().sweep_order());
  const auto all = static_cast<std::uint32_t>(table_.elements.size());
  SweepParts2 parts;
  for (const CachedRows& kept : store_.read(table_, 0))
    for (const CachedRow& row : kept.rows)
      if (auto part = row.row == all ? swept_part_2(row.numbers, order) : std::nullopt)
        parts.before.push_back(std::move(*part));
  parts.sink = [this, order, all](SweptPart2&& part) {
    const CachedRow row{.row = all, .known = {}, .to = {}, .numbers = bytes_of(part, order)};
    store_.keep(table_, 0, std::span(&row, 1));
  };
  return parts;
}

void CachedSweep2::forget() const { store_.forget(table_); }

}  // namespace hottel
