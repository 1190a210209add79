#include "io/external/external_radiosity.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <unordered_map>

#include "geometry/name.h"
#include "geometry/near_names.h"
#include "io/external/csv_reader.h"
#include "io/external/external_file.h"
#include "io/external/external_number.h"
#include "io/files/text_file.h"
#include "solver/compare/radiosity_verdict.h"

namespace hottel {
namespace {

// Where each column of the csv is.
class Columns {
 public:
  explicit Columns(const CsvReader& csv) : head_(csv.fields().begin(), csv.fields().end()) {}

  std::size_t count() const { return head_.size(); }
  std::optional<std::size_t> find(const std::string& name) const {
    const auto found = std::find(head_.begin(), head_.end(), name);
    return found == head_.end() ? std::nullopt : std::optional<std::size_t>(found - head_.begin());
  }

 private:
  std::vector<std::string> head_;
};

// The name of an element as `face` and `element` spell it: a face that is not divided goes by its own name.
std::optional<std::uint32_t> element_named(const std::unordered_map<std::string, std::uint32_t>& index,
                                           const std::string& face, const std::string& part) {
  for (const std::string& name : {face, face + "#" + part})
    if (const auto found = index.find(name); found != index.end()) return found->second;
  return std::nullopt;
}

[[noreturn]] void refuse_name(const FileLine& where, const std::string& name, const ExchangeMatrix& matrix) {
  std::vector<std::string> known;
  for (std::uint32_t i = 0; i < matrix.size(); ++i)
    if (matrix.has_row(i)) known.push_back(matrix.elements()[i].name);
  throw InputError(where, "the scene has no face with a material called " + quoted_name(name),
                   near_name_hints(name, known));
}

// Throws InputError naming the channels of which nothing is given, else the elements that lack some.
void require_all(const std::string& file, const ExchangeMatrix& matrix, const std::vector<std::string>& channels,
                 const std::vector<std::vector<char>>& is_given) {
  std::vector<std::string> none, missing;
  for (std::size_t c = 0; c < channels.size(); ++c)
    if (std::ranges::find_if(is_given[c], [](char given) { return given != 0; }) == is_given[c].end())
      none.push_back(channels[c]);
  if (!none.empty() && none.size() < channels.size())
    throw InputError({file, 0}, (none.size() == 1 ? "lacks the channel " : "lacks the channels ") + listed_names(none) +
                                    ": the scene has " + fmt::format("{}", fmt::join(channels, ", ")));
  for (std::uint32_t i = 0; i < matrix.size(); ++i)
    if (matrix.has_row(i) &&
        std::any_of(is_given.begin(), is_given.end(), [i](const auto& channel) { return channel[i] == 0; }))
      missing.push_back(matrix.elements()[i].name);
  if (!missing.empty()) throw InputError({file, 0}, "has no radiosity of " + listed_names(missing));
}

}  // namespace

bool holds_radiosities(const std::filesystem::path& file) {
  return external_kind(file, read_text_file(file)) == ExternalKind::kRadiosity;
}

ExternalRadiosities read_external_radiosities(const std::filesystem::path& file, const ExchangeMatrix& matrix,
                                              const std::vector<std::string>& channels) {
  const std::string name = file.string(), text = read_text_file(file);
  CsvReader csv(name, text, csv_dialect_of(text));
  const bool has_head = csv.next();
  const Columns columns(csv);
  const auto face = columns.find("face"), part = columns.find("element"), channel = columns.find("channel"),
             radiosity = columns.find("radiosity");
  if (!has_head || !face || !radiosity) throw InputError({name, 1}, "needs the columns 'face' and 'radiosity'");
  if (!channel && channels.size() > 1)
    throw InputError({name, 1}, fmt::format("needs a column 'channel': the scene has {}", fmt::join(channels, ", ")));

  std::unordered_map<std::string, std::uint32_t> index;
  for (std::uint32_t i = 0; i < matrix.size(); ++i)
    if (matrix.has_row(i)) index.emplace(matrix.elements()[i].name, i);
  ExternalRadiosities result;
  result.by_channel.assign(channels.size(), std::vector<double>(matrix.size(), 0));
  std::vector<std::vector<char>> is_given(channels.size(), std::vector<char>(matrix.size(), 0));
  ExternalNumbers numbers(name);
  while (csv.next()) {
    const auto& fields = csv.fields();
    if (fields.size() != columns.count())
      throw InputError(csv.where(), std::to_string(fields.size()) + " fields where " + std::to_string(columns.count()) +
                                        " are expected");
    const std::string of(fields[*face]);
    const auto element = element_named(index, of, part ? std::string(fields[*part]) : "");
    if (!element) refuse_name(csv.where(), of, matrix);
    std::size_t c = 0;
    if (channels.size() > 1)
      c = static_cast<std::size_t>(std::find(channels.begin(), channels.end(), fields[*channel]) - channels.begin());
    if (c == channels.size())
      throw InputError(csv.where(), fmt::format("the scene has no channel {}, but {}", quoted_name(fields[*channel]),
                                                fmt::join(channels, ", ")));
    if (is_given[c][*element]++)
      throw InputError(csv.where(),
                       "the radiosity of " + quoted_name(matrix.elements()[*element].name) + " is given twice");
    result.by_channel[c][*element] = numbers.read(fields[*radiosity], csv.where().line);
  }
  require_all(name, matrix, channels, is_given);
  result.digits = numbers.digits();
  return result;
}

MethodResult judge_radiosity_file(const std::string& file, const ExchangeMatrix& factors,
                                  const RadiositySolution& exact, double beyond) {
  const ExternalRadiosities external = read_external_radiosities(file, factors, exact.channel_names);
  const RadiosityVerdict verdict = judge_radiosities(factors, exact, external.by_channel, external.digits, beyond);
  constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  MethodResult result;
  result.info = {"file:" + file, "file", 0, Guarantee::kEstimated, file};
  result.timing = {kUnknown, kUnknown, kUnknown, 0};
  result.errors = {kUnknown, kUnknown, kUnknown, 0};
  result.max_radiosity_error = verdict.max_error;
  result.notes = verdict_sentences(verdict, factors, exact);
  result.solution = exact;
  for (std::size_t c = 0; c < exact.channels.size(); ++c)
    for (std::size_t i = 0; i < factors.size(); ++i)
      result.solution->channels[c].elements[i].radiosity = external.by_channel[c][i];
  return result;
}

}  // namespace hottel
