// hottel factors: the view factors of a scene.
#include <fmt/format.h>

#include <algorithm>

#include "cli/command.h"
#include "cli/factors_in_space.h"
#include "cli/factors_options.h"
#include "cli/memory/give_back.h"
#include "cli/methods.h"
#include "cli/script_f.h"
#include "cli/streamed_factors.h"
#include "cli/unit_notes.h"
#include "geometry/plane/exchange/closed_forms.h"
#include "geometry/plane/exchange/exchange.h"
#include "geometry/plane/prepared/element_pieces.h"
#include "io/external/plane/external_matrix.h"
#include "io/results/factors_report.h"
#include "io/results/short_digits.h"
#include "io/scene/space/vs3_reader.h"
#include "kernel/support/failure.h"
#include "kernel/support/with_file_context.h"
#include "solver/method_catalogue.h"
#include "solver/plane/simulation/simulation.h"
#include "viewer/picture/plane/factor_picture.h"

namespace hottel {
namespace {

// What is computed of a scene, and what is said of it.
struct Factors {
  std::shared_ptr<const PreparedScene2> prepared;
  std::shared_ptr<const ComputedFactors2> computed;  // view factors
  std::optional<GrayFactors> gray;                   // script-F instead
  FactorsReport report;

  const ExchangeMatrix& matrix() const { return computed->matrix; }
  const ExchangeMatrix& written() const { return gray ? gray->matrix : matrix(); }
};

// Sorts out what --exact-form took: its two names, or the scene, or both.
void take_exact_form(FactorsOptions& options) {
  options.wants_exact_form = options.exact_form_option->count() > 0;
  std::erase(options.exact_form, "");  // what the option holds when it is given without names
  if (options.scene.empty() && options.exact_form.size() % 2 == 1) {
    options.scene = options.exact_form.back();
    options.exact_form.pop_back();
  }
  if (options.exact_form.size() % 2 == 1) throw UsageError("--exact-form takes two names, or none for all pairs");
}

void require_sense_of_digits(const FactorsOptions& options) {
  if (!options.digits) return;
  if (options.wants_exact_form) throw UsageError("--digits rounds numbers, and --exact-form has none");
  if (options.format() != FactorFormat::kCsv)
    throw UsageError("--digits is for csv: '" + options.out + "' holds numbers as they are");
  if (options.json && options.out.empty())
    throw UsageError("with --json the factors need a file: --digits wants -o FILE");
}

void require_sense_of_rows(const FactorsOptions& options) {
  if (options.rows.empty()) return;
  if (options.wants_exact_form) throw UsageError("--rows is for view factors: --exact-form A B chooses pairs");
  if (!options.lists_pairs())
    throw UsageError("--rows says which rows are listed: --matrix, .npy, .txt and .bin hold all");
  if (options.json && options.out.empty())
    throw UsageError("with --json the factors need a file: --rows wants -o FILE");
}

void require_sense_of_folders(const FactorsOptions& options) {
  if (!options.sums.is_given() || needs_rows_alone(options)) return;
  throw UsageError(std::string(options.sums.name()) +
                   " is for lists of pairs (.csv, .mtx, .h5) by the method exact: without --store, --matrix, --pairs, "
                   "--picture, --script-f and --exact-form, and --json with -o FILE");
}

// What CLI11 does not see.
void require_sense(const FactorsOptions& options) {
  if (options.scene.empty()) throw UsageError("factors needs a scene");
  if (!options.is_exact() &&
      (options.script_f || options.wants_exact_form || options.matrix == "visibility" || options.pairs == "facing"))
    throw UsageError("--script-f, --exact-form, --matrix visibility and --pairs facing are for the method exact");
  if (options.tolerance) {
    const auto tolerance = parse_rational(*options.tolerance);
    if (!tolerance || *tolerance <= 0)
      throw UsageError("--tolerance must be a positive number, not '" + *options.tolerance + "'");
  }
  if (options.pairs_option->count() > 0) {
    if (!options.lists_pairs())
      throw UsageError("--pairs says which pairs are listed: --matrix, .npy, .txt and .bin hold all");
    if (!options.exact_form.empty()) throw UsageError("--pairs says which pairs are listed: --exact-form A B is one");
  }
  if (options.json && options.out.empty() &&
      (!options.matrix.empty() || options.wants_exact_form || options.pairs_option->count() > 0))
    throw UsageError("with --json the factors need a file: --matrix, --exact-form and --pairs want -o FILE");
  if (options.areas && (options.format() != FactorFormat::kCsv || !options.matrix.empty() || options.wants_exact_form))
    throw UsageError("--areas adds columns to the list of pairs: .mtx and .npy have the areas in the file beside them");
  if (options.areas && options.json && options.out.empty())
    throw UsageError("with --json the factors need a file: --areas wants -o FILE");
  if (options.json && options.out == "-") throw UsageError("--json and -o - both want standard output; give -o a file");
  if (options.script_f && options.matrix != "" && options.matrix != "factor")
    throw UsageError("--script-f is written as --matrix factor, not --matrix " + options.matrix);
  if (options.script_f && options.pairs != "visible")
    throw UsageError("--script-f lists all pairs that exchange heat: it goes with --pairs visible only");
  if (const std::string method = split_method_name(options.method).raw; method.starts_with("file:"))
    require_not_read("-o " + options.out, options.out, "--method", method.substr(5));
  require_sense_of_digits(options);
  require_sense_of_rows(options);
  require_sense_of_folders(options);
  if (options.picture.empty() != options.toward.empty()) throw UsageError("--picture and --toward go together");
  if (!options.picture.empty() && options.granularity != "face")
    throw UsageError("--picture colours whole faces: it is drawn --per face, not --per " + options.granularity);
}

// What cannot be kept to in the plane.
void require_use_of_limits(const FactorsOptions& options) {
  if (options.memory > 0 && !options.is_exact())
    throw UsageError("--memory is kept to by the method exact only, not by " + options.method);
  if (options.tolerance)
    throw UsageError(
        "--tolerance is for scenes in space: in the plane every factor is correctly rounded, and those of other "
        "methods are as good as the method");
  options.guarantee.refuse_in_plane();
  options.sky.refuse_in_plane();
}

void write_closed_forms(const FactorsOptions& options, const PreparedScene2& prepared, const FactorTable& table,
                        OutputFile& out) {
  std::optional<ElementPair> only;
  if (!options.exact_form.empty())
    only = {require_element(table.matrix, options.exact_form[0]), require_element(table.matrix, options.exact_form[1])};
  const std::vector<ElementPair> pairs = exact_form_pairs(table, only);
  write_exact_forms_csv(table, only, pairs, exact_exchange_measures(prepared, table.granularity, pairs),
                        exact_areas(prepared, table.granularity), [&out](std::string_view text) { out.write(text); });
}

SimulationRequest2 request_of(const FactorsOptions& options, const Scene2& scene) {
  return {.method = all_methods_2().make(options.method),
          .granularity = options.per(),
          .wants_visibility = options.is_exact() && (options.matrix.empty() || options.matrix == "visibility"),
          .wants_measures = options.matrix == "exchange",
          .rows = rows_to_compute(options, scene),
          .memory = options.memory,
          .store = options.store.open(options.method)};
}

Factors factors_of(const FactorsOptions& options, const Simulation2& simulation, const Streams& streams) {
  Factors factors;
  factors.computed = simulation.factors(streams.stages());
  factors.prepared = simulation.prepared();
  factors.report = {options.scene, options.method, simulation.granularity(), factors.computed->report};
  factors.report.store = options.store.report(simulation.request().store);
  if (options.script_f) {
    factors.gray = gray_factors(options, factors.matrix(), factors.prepared->scene.materials, streams);
    factors.report.gray = factors.gray->report;
  }
  return factors;
}

void factors_in_plane(FactorsOptions& options, ValidScene2 scene, Streams& streams) {
  SimulationRequest2 request = request_of(options, *scene);
  const auto picture = options.picture.empty() ? std::nullopt : picture_format(options.picture);
  require_use_of_limits(options);
  options.elements.apply_to(scene);
  require_room_for(options, [&](FactorFormat format) { return dense_size(*scene, options.per(), format); });
  const PictureTargets2 targets = picture ? picture_targets(*scene, options.toward) : PictureTargets2{};
  if (options.elements.is_given() && options.granularity != "element" && !request.method->works_by_elements())
    streams.note("the division into elements changes no number here: each row is a whole " + options.granularity +
                 "; --per element writes a row for each element");
  const FactorOrigin origin{2, options.method, options.keeps_scene() ? write_scene_2(*scene) : ""};
  Simulation2 simulation(std::move(scene), std::move(request));

  FactorsFiles files(options, streams);
  if (options.sums.is_given()) require_memory_of_rows(options, simulation.scene());
  simulation.require_closed(streams.stages());
  if (streams_rows(options, simulation, streams))
    return write_streamed_factors(options, simulation, origin, files, streams);
  if (takes_groups_of_many(options, simulation.factors(streams.stages())->matrix.entry_count(), streams))
    simulation = simulation.with_request(request_of(options, simulation.scene()));
  const Factors factors = factors_of(options, simulation, streams);
  const PreparedScene2& prepared = *factors.prepared;
  FactorTable table{prepared.scene, factors.written(), factors.report.granularity, {}, {}};
  if (factors.gray) table.gray_channel = factors.gray->channel;
  table.has_areas = options.areas;
  table.digits = options.digits;
  take_rows(options, streams, table);
  if (options.pairs == "facing" || options.matrix == "visibility")
    table.hidden = hidden_pairs(prepared, table.granularity, factors.matrix(), simulation.request().rows);
  if (picture)
    files.drawing->write(
        factor_picture_2(prepared, table.matrix, targets, factors.gray ? "script-F" : "view factor", *picture));
  if (files.out)
    with_file_context(options.scene, [&] {
      if (options.wants_exact_form) return write_closed_forms(options, prepared, table, *files.out);
      write_table(options, table, origin, files,
                  [&](const Sink& sink) { write_faces_csv(table, element_pieces(prepared, table.granularity), sink); });
    });
  files.finish();
  if (options.json) streams.write("", factors_json(factors.report));
  files.commit();
  note_matrix(options, table, streams);
  streams.note(factors_text(factors.report));
}

// What View3D combines is one row of its output.
bool combines(const Scene3& scene) {
  const std::vector<std::size_t> sizes = group_sizes(scene);
  return std::any_of(sizes.begin(), sizes.end(), [](std::size_t size) { return size > 1; });
}

// emit=1 of a deck is --script-f, unless view factors are asked for in a way that script-F has not.
void take_emit(FactorsOptions& options, const Streams& streams) {
  if (!options.deck.wants_script_f || options.script_f) return;
  const std::string instead = !options.is_exact()                                    ? "--method " + options.method
                              : options.pairs != "visible"                           ? "--pairs " + options.pairs
                              : options.matrix.empty() || options.matrix == "factor" ? ""
                                                                                     : "--matrix " + options.matrix;
  options.script_f = instead.empty();
  streams.note(instead.empty() ? "emit=1: gray-body exchange factors, script-F, are written"
                               : "emit=1 asks for script-F; view factors are written: " + instead + " is of these");
}

bool tells_areas(const FactorsOptions& options) {
  if (options.wants_exact_form) return false;
  if (!options.matrix.empty()) return options.matrix == "exchange";
  return options.areas || options.format() != FactorFormat::kCsv;
}

ExitCode factors(FactorsOptions options, Streams& streams) {
  if (options.memory > 0) give_memory_back_soon();
  take_exact_form(options);
  options.awaits_deck = is_vs3(options.scene);
  require_sense(options);
  options.format();
  if (!options.picture.empty() && !picture_format(options.picture))
    throw UsageError("a picture is written as .png, .svg or .pdf, not '" + options.picture + "'");
  ValidScene scene = read_scene_noting(options.scene, options.polygons, streams, &options.deck);
  options.awaits_deck = false;
  take_emit(options, streams);
  options.format();
  if (is_vs3(options.scene) && options.per_option->count() == 0 && combines(*std::get<ValidScene3>(scene)))
    options.granularity = "group";
  if (tells_areas(options)) note_unknown_unit(scene, streams);
  if (auto* const in_space = std::get_if<ValidScene3>(&scene))
    factors_in_space(options, std::move(*in_space), streams);
  else
    factors_in_plane(options, std::get<ValidScene2>(std::move(scene)), streams);
  return ExitCode::kDone;
}

// What is written of the pairs, and of which elements.
void add_quantity_options(CLI::App& command, FactorsOptions& options) {
  CLI::Option* matrix =
      command.add_option("--matrix", options.matrix, "a dense matrix of this quantity instead of a list");
  matrix->check(CLI::IsMember({"factor", "exchange", "visibility"}));
  options.elements.add_to(command);
  options.polygons.add_to(command);
  CLI::Option* script_f = command.add_flag(
      "--script-f", options.script_f,
      "gray-body exchange factors instead: q = A script-F sigma (T^4 - T^4), reflections counted, with proven bounds");
  command.add_option("--channel", options.channel, "r, g or b: whose reflectivities, where materials are not gray")
      ->check(CLI::IsMember({"r", "g", "b"}))
      ->needs(script_f);
  options.exact_form_option =
      command
          .add_option(
              "--exact-form", options.exact_form,
              "direct exchange areas in closed form, of A and B or of all pairs: sums of square roots; in space, of "
              "rectangles that nothing hides, with arc tangents and logarithms")
          ->expected(0, 3)  // the scene may follow
          ->excludes(matrix)
          ->excludes(script_f)
          ->type_name("[A B]");
}

}  // namespace

void add_factors(Commands& commands) {
  const auto options = std::make_shared<FactorsOptions>();
  CLI::App& command = commands.add(
      "factors", "View factors of all pairs of faces, each correctly rounded; in space, with proven bounds",
      {"hottel factors scenes/analytic/triangle_345.json",
       "hottel factors scenes/showcase/apartment.json -o /tmp/factors.mtx",
       "hottel factors scenes/analytic/triangle_345.json --exact-form",
       "hottel factors scenes/analytic/triangle_345.json --per element --elements 2 --matrix visibility",
       "hottel factors scenes/analytic/square_radiosity.json --script-f",
       "hottel factors scenes/analytic/strip_obstructed.json --method gauss:4 --elements 8",
       "hottel factors scenes/space/two_boxes.json",
       "hottel factors scenes/space/cube.json --per element --elements 3 --tolerance 1e-12 -o "
       "/tmp/cube.mtx",
       "hottel factors scenes/space/two_boxes.json --rows 'lamp*' --digits 4",
       "hottel factors scenes/showcase/apartment.json --quiet -o /tmp/factors.csv --picture "
       "/tmp/windows.png --toward 'window*'"},
      [options](Streams& streams) { return factors(*options, streams); });
  command.add_option("SCENE", options->scene, "the scene file");
  command
      .add_option("-o", options->out,
                  "the file to write: .csv .mtx .npy .h5 .txt .bin; without it, or with -, csv on standard output")
      ->type_name("FILE");
  command.add_option("--method", options->method, "how to compute, each also as METHOD:normalised" + methods_text())
      ->type_name("METHOD")
      ->capture_default_str();
  command
      .add_option("--tolerance", options->tolerance,
                  "in space: what A F may be off, relative to the smaller area (default 1e-9); refused in the plane, "
                  "where factors are exact")
      ->type_name("T");
  options->guarantee.add_to(command);
  options->sky.add_to(command);
  options->per_option = command
                            .add_option("--per", options->granularity,
                                        "one row per face, element or group (polyline, mesh); group is the default of "
                                        "a .vs3 deck that combines (cmb)")
                            ->check(CLI::IsMember({"face", "element", "group"}))
                            ->capture_default_str();
  options->pairs_option =
      command
          .add_option("--pairs", options->pairs, "visible: S > 0; facing: also pairs that something hides completely")
          ->check(CLI::IsMember({"visible", "facing"}))
          ->capture_default_str();
  command.add_flag("--areas", options->areas,
                   "the list of pairs has the area of each face too [m², in the plane m], in two columns at its end");
  command
      .add_option("--rows", options->rows,
                  "list these rows alone, and compute no others where that saves work: fronts (no backs), or a face, a "
                  "polyline, a group, or all that a pattern like 'win*' describes")
      ->type_name("fronts|NAME");
  command
      .add_option("--digits", options->digits,
                  "of csv: numbers rounded to N significant digits, lower bounds down and upper bounds up")
      ->type_name("N")
      ->transform(whole_number(1, kMostDigits));
  add_quantity_options(command, *options);
  options->store.add_to(command);
  command.add_option("--memory", options->memory, "bytes the factors may take; without it 80 % of what is free")
      ->type_name("BYTES")
      ->transform(whole_number(1));
  options->sums.add_to(command,
                       "the sums of pairs go to files in this folder while the run lasts, so that it keeps to --memory "
                       "however many pairs there are; the same result",
                       "in the plane: the same, and the files stay where the run is ended: the same command goes on "
                       "from there");
  command
      .add_option("--picture", options->picture,
                  "draw the scene (.png, .svg, .pdf), faces coloured by their factor to --toward")
      ->type_name("FILE");
  command
      .add_option("--toward", options->toward,
                  "a face, a polyline, all that a pattern like 'win*' or 'w[1-3]' describes, or sky")
      ->type_name("NAME");
  command.add_flag("--json", options->json, "a report on standard output as one JSON object (factors then need -o)");
}

}  // namespace hottel
