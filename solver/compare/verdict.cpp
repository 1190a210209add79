#include "solver/compare/verdict.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <tuple>

#include "geometry/name.h"
#include "kernel/support/counted.h"
#include "kernel/support/interrupt.h"
#include "solver/compare/composed_readings.h"
#include "solver/compare/composed_scatter.h"
#include "solver/compare/hypotheses.h"
#include "solver/compare/scene_hypotheses.h"

namespace hottel {
namespace {

// The pairs with the largest errors among those that are marked.
std::vector<JudgedPair> worst_of(const JudgedPairs& judged, const std::vector<char>& marked) {
  std::vector<JudgedPair> worst;
  for (const JudgedPair& pair : judged.pairs())
    if (marked[judged.index_of(pair)]) worst.push_back(pair);
  const auto count = static_cast<std::ptrdiff_t>(std::min(kPairsNamed, worst.size()));
  const auto is_worse = [](const JudgedPair& a, const JudgedPair& b) {
    return a.error() != b.error() ? a.error() > b.error() : std::tie(a.from, a.to) < std::tie(b.from, b.to);
  };
  std::partial_sort(worst.begin(), worst.begin() + count, worst.end(), is_worse);
  worst.resize(static_cast<std::size_t>(count));
  return worst;
}

// The laws that hold for the factors of any scene.
void judge_laws(const JudgedPairs& judged, Verdict& verdict) {
  const ExchangeMatrix& exact = judged.exact();
  for (std::uint32_t i = 0; i < exact.size(); ++i) {
    if (!exact.has_row(i)) continue;
    double sum = 0, exact_sum = 0, slack = verdict.options.beyond;
    for (const JudgedPair& pair : judged.row(i)) {
      sum += pair.value;
      exact_sum += pair.exact;
      slack += verdict.options.written.digits.rounding(pair.value);
      verdict.negative += pair.value < -judged.tolerance(pair.value);
      verdict.above_one += pair.value > 1 + judged.tolerance(pair.value);
      verdict.least = std::min(verdict.least, pair.value);
      verdict.most = std::max(verdict.most, pair.value);
    }
    const double defect = std::abs(sum - exact_sum);
    verdict.row_defect = std::max(verdict.row_defect, defect);
    verdict.rows_off += defect > slack;
  }
}

void judge_reciprocity(const JudgedPairs& judged, Verdict& verdict) {
  const ExchangeMatrix& exact = judged.exact();
  for (const JudgedPair& pair : judged.pairs()) {
    if (pair.to == exact.sky() || !exact.has_row(pair.to) || !judged.has_place(pair.to, pair.from)) continue;
    const double reverse = judged.matrix().factor(pair.to, pair.from).value;
    if (pair.to < pair.from && reverse != 0) continue;  // each pair once
    const double a = exact.elements()[pair.from].area.value, b = exact.elements()[pair.to].area.value;
    const double defect = std::abs(a * pair.value - b * reverse);
    verdict.reciprocity_defect = std::max(verdict.reciprocity_defect, defect / std::min(a, b));
    verdict.unsymmetric += defect > a * judged.tolerance(pair.value) + b * judged.tolerance(reverse);
  }
}

// Whether some reading explains nearly all. Scatter, and a ratio for each row, agree with much: what applies one rule
// to all pairs is asked for beside them.
bool is_explained(const std::vector<Hypothesis>& hypotheses, const JudgedPairs& judged, bool by_orders = true) {
  return std::any_of(hypotheses.begin(), hypotheses.end(), [&](const Hypothesis& each) {
    const bool is_order = each.fault == Fault::kPermuted || each.fault == Fault::kRowsPermuted ||
                          each.fault == Fault::kColumnsPermuted || each.fault == Fault::kShifted;
    return each.fault != Fault::kRowFactor && (by_orders || !is_order) &&
           static_cast<double>(each.count()) >= (1 - kLeastShare) * static_cast<double>(judged.off());
  });
}

// Adds the reading that applies several faults to every pair, where there is one: it goes before all others.
void compose(const JudgedScene& scene, const JudgedPairs& judged, const std::vector<double>& unobstructed,
             Orders orders, std::vector<Hypothesis>& hypotheses) {
  if (auto composed = suppose_composed(scene, judged, unobstructed, orders))
    hypotheses.insert(hypotheses.begin(), std::move(*composed));
}

// All readings that are worth their time: those that take runs of methods only where no other explains nearly all.
std::vector<Hypothesis> hypotheses_of(const JudgedScene& scene, const JudgedPairs& judged,
                                      const std::function<void(double)>& progress) {
  // What the readings take, roughly: those of the numbers alone, several faults at once, scatter, and so on.
  constexpr std::array kDone = {0.05, 0.3, 0.45, 0.75, 0.9};
  const auto tell = [&](std::size_t readings) {
    throw_if_interrupted();
    if (progress) progress(kDone[readings]);
  };
  const std::vector<double> unobstructed = unobstructed_factors(scene, judged);
  tell(0);
  std::vector<Hypothesis> hypotheses;
  hypotheses.push_back(suppose_transposed(judged));
  hypotheses.push_back(suppose_constant_factor(judged));
  hypotheses.push_back(suppose_row_factor(judged));
  hypotheses.push_back(suppose_permuted(judged));
  hypotheses.push_back(suppose_shifted(judged));
  hypotheses.push_back(suppose_rows_permuted(judged));
  hypotheses.push_back(suppose_columns_permuted(judged));
  hypotheses.push_back(suppose_no_occlusion(scene, judged, unobstructed));
  hypotheses.push_back(suppose_all_or_nothing(judged, unobstructed));
  hypotheses.push_back(suppose_sky_missing(judged));
  hypotheses.push_back(suppose_sky_is_rest(judged));
  hypotheses.push_back(suppose_missing(judged));
  hypotheses.push_back(suppose_behind(judged, unobstructed));
  tell(1);
  if (!is_explained(hypotheses, judged)) compose(scene, judged, unobstructed, Orders::kRight, hypotheses);
  tell(2);
  if (!is_explained(hypotheses, judged)) hypotheses.push_back(suppose_scatter(scene, judged, {}, false));
  tell(3);
  // A face that is turned around may look as if it had changed places with its back.
  if (!is_explained(hypotheses, judged, false)) hypotheses.push_back(suppose_reversed(scene, judged));
  if (!is_explained(hypotheses, judged)) hypotheses.push_back(suppose_method(scene, judged));
  tell(4);
  if (!is_explained(hypotheses, judged)) compose(scene, judged, unobstructed, Orders::kAny, hypotheses);
  // Of readings that explain equally many pairs the one that stands first in Fault is taken, and before these what was
  // done to all.
  const auto rank = [](const Hypothesis& each) {
    return std::pair(each.parts.empty() || each.fault == Fault::kSamplingNoise, each.fault);
  };
  std::stable_sort(hypotheses.begin(), hypotheses.end(),
                   [&](const Hypothesis& a, const Hypothesis& b) { return rank(a) < rank(b); });
  return hypotheses;
}

// Readings with numbers that were fitted to few pairs are taken for chance.
void drop_coincidences(const JudgedPairs& judged, std::vector<Hypothesis>& hypotheses, Verdict& verdict) {
  for (Hypothesis& each : hypotheses) {
    const bool is_fitted = each.fault == Fault::kConstantFactor || each.fault == Fault::kRowFactor;
    const std::uint64_t count = each.count();
    if (!is_fitted || static_cast<double>(count) >= kLeastShareOfFitted * static_cast<double>(judged.off())) continue;
    verdict.has_unnamed = verdict.has_unnamed || count > 0;
    each = explains_nothing(each.fault, judged);
  }
}

// Takes the reading that explains most of what is left, again and again, while it explains its share. What is left may
// scatter as rays do where all pairs together did not, or once shares of rows and columns are taken off.
void choose_findings(const JudgedScene& scene, std::vector<Hypothesis> hypotheses, const JudgedPairs& judged,
                     Verdict& verdict) {
  drop_coincidences(judged, hypotheses, verdict);
  std::vector<char> is_open(judged.pairs().size(), 0);
  for (const JudgedPair& pair : judged.pairs()) is_open[judged.index_of(pair)] = pair.is_off;
  bool is_scatter_asked = false;
  while (!hypotheses.empty()) {
    for (Hypothesis& hypothesis : hypotheses)
      for (std::size_t k = 0; k < is_open.size(); ++k) hypothesis.explains[k] = hypothesis.explains[k] && is_open[k];
    const auto best = std::max_element(hypotheses.begin(), hypotheses.end(),
                                       [](const Hypothesis& a, const Hypothesis& b) { return a.count() < b.count(); });
    if (static_cast<double>(best->count()) < std::max(1.0, kLeastShare * static_cast<double>(judged.off()))) {
      verdict.has_unnamed = verdict.has_unnamed || best->count() > 0;
      if (is_scatter_asked) break;
      is_scatter_asked = true;
      std::vector<char> is_settled(is_open.size(), 0);
      for (const JudgedPair& pair : judged.pairs())
        is_settled[judged.index_of(pair)] = pair.is_off && !is_open[judged.index_of(pair)];
      hypotheses = {suppose_scatter(scene, judged, is_settled, true)};
      continue;
    }
    for (std::size_t k = 0; k < is_open.size(); ++k) is_open[k] = is_open[k] && !best->explains[k];
    verdict.findings.push_back({best->fault, best->parts.empty() ? std::vector{best->fault} : best->parts, best->words,
                                best->count(), worst_of(judged, best->explains)});
    hypotheses.erase(best);
  }
  verdict.unexplained = static_cast<std::uint64_t>(std::count(is_open.begin(), is_open.end(), 1));
  verdict.worst_unexplained = worst_of(judged, is_open);
}

std::string pair_text(const JudgedPair& pair, const ExchangeMatrix& exact) {
  const auto name = [&](std::uint32_t i) { return quoted_name(exact.name(i)); };
  return fmt::format("{} to {}: {} instead of {:.6g}", name(pair.from), name(pair.to),
                     fmt::format("{:.6g}", pair.value), pair.exact);
}

std::string pairs_text(const std::vector<JudgedPair>& pairs, const ExchangeMatrix& exact, std::size_t most) {
  std::string text;
  for (std::size_t k = 0; k < std::min(most, pairs.size()); ++k)
    text += (k == 0 ? "" : "; ") + pair_text(pairs[k], exact);
  return text;
}

std::string laws_sentence(const Verdict& verdict) {
  std::string text =
      verdict.unsymmetric == 0
          ? fmt::format("reciprocity A_i F_ij = A_j F_ji holds (within {:.2g})", verdict.reciprocity_defect)
          : fmt::format("reciprocity A_i F_ij = A_j F_ji is broken by {} (by up to {:.3g} of the smaller area)",
                        counted(verdict.unsymmetric, "pair"), verdict.reciprocity_defect);
  text += verdict.rows_off == 0
              ? fmt::format("; rows sum to what they should (within {:.2g})", verdict.row_defect)
              : fmt::format("; {} not sum to what {} should (by up to {:.3g})",
                            verdict.rows_off == 1 ? "1 row does" : counted(verdict.rows_off, "row") + " do",
                            verdict.rows_off == 1 ? "it" : "they", verdict.row_defect);
  if (verdict.negative > 0)
    text += fmt::format("; {} negative, to {:.3g}",
                        verdict.negative == 1 ? "1 factor is" : counted(verdict.negative, "factor") + " are",
                        verdict.least);
  if (verdict.above_one > 0)
    text += fmt::format("; {} 1, to {:.6g}",
                        verdict.above_one == 1 ? "1 factor exceeds" : counted(verdict.above_one, "factor") + " exceed",
                        verdict.most);
  return text;
}

}  // namespace

Verdict judge(const JudgedScene& scene, const ExchangeMatrix& exact, const ExchangeMatrix& matrix,
              const VerdictOptions& options, const VerdictWatch& watch) {
  const JudgedPairs judged(exact, matrix, options.beyond, options.written);
  Verdict verdict;
  verdict.options = options;
  verdict.pairs = judged.pairs().size();
  verdict.off = judged.off();
  for (const JudgedPair& pair : judged.pairs()) verdict.max_error = std::max(verdict.max_error, pair.error());
  judge_laws(judged, verdict);
  judge_reciprocity(judged, verdict);
  if (watch.on_laws) watch.on_laws(verdict);
  if (verdict.off > 0) choose_findings(scene, hypotheses_of(scene, judged, watch.progress), judged, verdict);
  return verdict;
}

std::vector<std::string> verdict_sentences(const Verdict& verdict, const ExchangeMatrix& exact) {
  std::vector<std::string> text = law_sentences(verdict);
  std::ranges::move(finding_sentences(verdict, exact), std::back_inserter(text));
  return text;
}

std::vector<std::string> law_sentences(const Verdict& verdict) {
  std::vector<std::string> text;
  if (verdict.off == 0) {
    text.push_back(
        fmt::format("all {} pairs agree with the exact factors within {:.2g} and the digits written "
                    "(largest difference {:.2g})",
                    verdict.pairs, verdict.options.beyond, verdict.max_error));
  } else {
    text.push_back(
        fmt::format("{} of {} pairs are off by more than {:.2g}, whatever digits were left out; the worst "
                    "by {:.6g}",
                    verdict.off, verdict.pairs, verdict.options.beyond, verdict.max_error));
  }
  text.push_back(laws_sentence(verdict));
  return text;
}

std::vector<std::string> finding_sentences(const Verdict& verdict, const ExchangeMatrix& exact) {
  std::vector<std::string> text;
  for (const FoundFault& finding : verdict.findings)
    text.push_back(fmt::format("{}: this explains {} of the {} pairs ({})", finding.words, finding.explained,
                               verdict.off, pairs_text(finding.worst, exact, finding.explained <= 2 ? 2 : 1)));
  if (verdict.unexplained > 0) {
    std::string sentence =
        fmt::format("{}{} {} wrong by no pattern that is known: {}", verdict.findings.empty() ? "" : "the other ",
                    verdict.unexplained, verdict.unexplained == 1 ? "is" : "are",
                    pairs_text(verdict.worst_unexplained, exact, kPairsNamed));
    if (verdict.unexplained == 1 && verdict.worst_unexplained[0].to != exact.sky() &&
        !verdict.worst_unexplained[0].is_reverse_off)
      sentence += " (the factor the other way is right)";
    if (verdict.has_unnamed)
      sentence += fmt::format("; readings of fewer than {:g} % of the pairs are not named", 100 * kLeastShare);
    text.push_back(sentence);
  }
  return text;
}

}  // namespace hottel
