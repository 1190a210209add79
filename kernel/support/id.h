// Numbers that name things, of a type of their own for each kind of thing.
#pragma once

#include <compare>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
#include <limits>

namespace hottel {

// The number of one of many things of a kind, which are numbered from 0. Each kind has its own Tag, so that the number
// of one kind cannot be taken for that of another, nor for a count or an index.
//
//   (1) it is made from an integer, and gives its integer, only where that is written: Id(number), index(), number()
//   (2) ordered by number; none() comes before all others
//   (3) as large and as fast as a std::int32_t, and like it without a value until it is given one
template <class Tag>
class Id {
 public:
  Id() = default;
  // REQUIRES that the number fits into 31 bits. One below 0 names none of the things that are numbered; a kind may give
  // it a meaning of its own.
  template <std::integral Number>
  explicit constexpr Id(Number number) : number_(static_cast<std::int32_t>(number)) {}

  // Where there is no such thing.
  static constexpr Id none() { return Id(std::numeric_limits<std::int32_t>::min()); }
  constexpr bool is_none() const { return *this == none(); }

  constexpr std::int32_t number() const { return number_; }
  // The place in a table of these things. REQUIRES number() >= 0.
  constexpr std::size_t index() const { return static_cast<std::size_t>(number_); }

  // Goes on to the thing with the next number.
  constexpr Id& operator++() {
    ++number_;
    return *this;
  }
  friend constexpr bool operator==(const Id&, const Id&) = default;
  friend constexpr auto operator<=>(const Id&, const Id&) = default;

 private:
  std::int32_t number_;
};

// The first `count` things of a kind, to loop over: for (const VertexId v : IdRange<VertexId>(n)).
//
//   (1) their numbers are 0 .. count - 1, in ascending order; of 0 things there are none
//   (2) an id is made on the way: the range holds no list
template <class Kind>
class IdRange {
 public:
  class Iterator {
   public:
    using iterator_category = std::forward_iterator_tag;
    using value_type = Kind;
    using difference_type = std::ptrdiff_t;
    using pointer = const Kind*;
    using reference = Kind;

    Iterator() = default;
    explicit constexpr Iterator(Kind id) : id_(id) {}
    constexpr Kind operator*() const { return id_; }
    constexpr Iterator& operator++() {
      ++id_;
      return *this;
    }
    constexpr Iterator operator++(int) {
      const Iterator before = *this;
      ++id_;
      return before;
    }
    friend constexpr bool operator==(const Iterator&, const Iterator&) = default;

   private:
    Kind id_;
  };

  explicit constexpr IdRange(std::size_t count) : end_(count) {}
  constexpr Iterator begin() const { return Iterator(Kind(0)); }
  constexpr Iterator end() const { return Iterator(end_); }

 private:
  Kind end_;
};

}  // namespace hottel

template <class Tag>
struct std::hash<hottel::Id<Tag>> {
  std::size_t operator()(hottel::Id<Tag> id) const noexcept { return std::hash<std::int32_t>()(id.number()); }
};
