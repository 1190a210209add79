#include "tests/oracle/space/exchange_to_digits.h"

#include <optional>
#include <stdexcept>

#include "tests/oracle/space/border_integral.h"
#include "tests/oracle/space/digits_rules.h"

namespace hottel::oracle {
namespace {

using Digits = RealOf<50>;

using SeventyDigits = RealOf<70>;

constexpr double kLeastOfDoubles = 1e-9, kShortForDoubles = 1e-6, kShortForSeventy = 1e-20;
const char* const kLeastOfSeventy = "1e-45";
const char* const kLeastOfDigits = "1e-100";
const char* const kTolerance = "1e-32";  // of one part of an edge
constexpr double kParts[] = {0.4837, 0.3119, 0.7041};

template <class Real>
std::optional<std::vector<SeenBorder>> found_between(BorderFinder<Real>& finder, const Real& low, const Real& width) {
  for (const double part : kParts)
    if (auto found = finder.at(low + part * width)) return found;
  return std::nullopt;
}

// One edge, with all that is asked along it. Few places need many digits.
class EdgeBorders {
 public:
  EdgeBorders(const std::vector<PlanePolygon>& polygons, const SpaceSegment& f)
      : lines_(polygons, f),
        by_doubles_(polygons, f, lines_, kLeastOfDoubles),
        by_seventy_(polygons, f, lines_, SeventyDigits(kLeastOfSeventy)),
        by_digits_(polygons, f, lines_, DeepReal(kLeastOfDigits)) {}

  const PlaneLines& lines() const { return lines_; }

  std::vector<SeenBorder> between(const DeepReal& low, const DeepReal& high) {
    const DeepReal width = high - low;
    if (width > kShortForDoubles)
      if (auto found = found_between(by_doubles_, static_cast<double>(low), static_cast<double>(width))) return *found;
    if (width > kShortForSeventy)
      if (auto found = found_between(by_seventy_, SeventyDigits(low), SeventyDigits(width))) return *found;
    if (auto found = found_between(by_digits_, low, width)) return *found;
    throw std::runtime_error("what borders there are is in doubt");
  }

 private:
  PlaneLines lines_;
  BorderFinder<double> by_doubles_;
  BorderFinder<SeventyDigits> by_seventy_;
  BorderFinder<DeepReal> by_digits_;
};

// The borders between all events. Most events change nothing: where borders are the same at five places, all between
// are taken to be, unless all are asked for.
class BordersAlong {
 public:
  BordersAlong(EdgeBorders& edge, bool asks_all)
      : edge_(edge), events_(edge.lines().events()), borders_(events_.size() - 1), asks_all_(asks_all) {
    fill(0, borders_.size() - 1);
  }

  const std::vector<DeepReal>& events() const { return events_; }
  std::vector<SeenBorder>& operator[](std::size_t k) { return *borders_[k]; }

 private:
  static constexpr std::size_t kFew = 8;

  const std::vector<SeenBorder>& ask(std::size_t k) {
    if (!borders_[k]) borders_[k] = edge_.between(events_[k], events_[k + 1]);
    return *borders_[k];
  }
  void fill(std::size_t first, std::size_t last) {
    if (asks_all_ || last - first < kFew) {
      for (std::size_t k = first; k <= last; ++k) ask(k);
      return;
    }
    const std::size_t middle = (first + last) / 2;
    const std::vector<SeenBorder> at = ask(middle);
    const auto is_same = [&](std::size_t k) { return ask(k) == at; };
    if (is_same(first) && is_same(last) && is_same((first + middle) / 2) && is_same((middle + last) / 2)) {
      for (std::size_t k = first; k <= last; ++k) borders_[k] = at;
      return;
    }
    fill(first, middle);
    fill(middle, last);
  }

  EdgeBorders& edge_;
  std::vector<DeepReal> events_;
  std::vector<std::optional<std::vector<SeenBorder>>> borders_;
  bool asks_all_;
};

struct Piece {
  DeepReal low, high;
  std::vector<SeenBorder> borders;
};

std::vector<Piece> pieces_of(EdgeBorders& edge, bool asks_all) {
  BordersAlong along(edge, asks_all);
  const std::vector<DeepReal>& events = along.events();
  std::vector<Piece> pieces;
  for (std::size_t k = 1; k < events.size(); ++k) {
    if (!pieces.empty() && pieces.back().borders == along[k - 1])
      pieces.back().high = events[k];
    else
      pieces.push_back({events[k - 1], events[k], std::move(along[k - 1])});
  }
  std::erase_if(pieces, [](const Piece& piece) { return piece.borders.empty(); });
  return pieces;
}

template <class Real>
Real integral_of(const std::vector<PlanePolygon>& polygons, const SpaceSegment& f, const PlaneLines& lines,
                 const Piece& piece, DigitsIntegral<Real>& integral) {
  BorderIntegrand<Real> integrand(PlaneFrame(polygons[0].points), f, lines, piece.borders);
  return integral.of([&](const Real& t) { return integrand.at(t); }, Real(piece.low), Real(piece.high));
}

}  // namespace

DigitsResult exchange_to_digits(const std::vector<SpacePolygon>& polygons, bool asks_all) {
  std::vector<PlanePolygon> planes;
  for (const SpacePolygon& polygon : polygons) planes.emplace_back(polygon);
  DigitsIntegral<Digits> integral{Digits(kTolerance)};
  DigitsResult result;
  Digits sum = 0;
  for (const SpaceSegment& f : border_edges(planes)) {
    EdgeBorders edge(planes, f);
    for (const Piece& piece : pieces_of(edge, asks_all)) {
      sum += integral_of(planes, f, edge.lines(), piece, integral);
      ++result.pieces;
    }
  }
  const Digits measure = sum / (2 * acos(Digits(-1)));
  result.measure = measure.str(34, std::ios_base::fixed);
  result.error = integral.error();
  return result;
}

}  // namespace hottel::oracle
