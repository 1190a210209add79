#include "solver/cached_report.h"

#include "solver/cached_pairs.h"

namespace hottel {

CachedRow report_to_keep(const ExchangeMatrix& matrix, const MethodReport& report) {
  CachedRow row{.row = matrix.sky(), .known = {}, .to = {}, .numbers = {}};
  NumberWriter out(row.numbers);
  out.number(report.row_defect);
  out.byte(report.standard_error ? 1 : 0);
  out.number(report.standard_error.value_or(0));
  out.number(static_cast<double>(report.counts.pairs));
  for (const std::string& note : report.notes) {
    out.word(static_cast<std::uint32_t>(note.size()));
    row.numbers += note;
  }
  return row;
}

std::optional<MethodReport> cached_report(const std::vector<CachedRows>& kept, const ExchangeMatrix& matrix) {
  for (const CachedRows& some : kept)
    for (const CachedRow& row : some.rows) {
      if (row.row + std::size_t{1} != some.place.size()) continue;
      MethodReport report;
      NumberReader in(row.numbers);
      report.row_defect = in.number();
      const bool has_error = in.byte() == 1;
      const double error = in.number();
      if (has_error) report.standard_error = error;
      report.counts.pairs = static_cast<std::uint64_t>(in.number());
      while (in.is_whole() && !in.is_at_end()) {
        const std::uint32_t size = in.word();
        std::string note;
        for (std::uint32_t k = 0; k < size && in.is_whole(); ++k) note += static_cast<char>(in.byte());
        report.notes.push_back(std::move(note));
      }
      if (!in.is_whole()) continue;
      report.counts.elements = matrix.size();
      return report;
    }
  return std::nullopt;
}

std::uint64_t pair_count(const ExchangeMatrix& matrix) {
  std::uint64_t count = 0;
  for (std::uint32_t i = 0; i < matrix.size(); ++i)
    for (const FactorEntry& entry : matrix.row(i)) {
      const bool is_told = entry.to < i && matrix.has_row(entry.to) && matrix.row(entry.to).place_of(i);
      count += is_told ? 0 : 1;
    }
  return count;
}

}  // namespace hottel
