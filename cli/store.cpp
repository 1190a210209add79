// hottel store: what a store of factors holds, whether it is whole, and a smaller one.
#include <optional>

#include "cli/command.h"
#include "io/results/store_report.h"
#include "io/store/factor_store.h"
#include "kernel/support/counted.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

struct StoreOptions {
  std::string file;
  bool check = false, json = false;
  std::optional<std::uint64_t> shrink, limit;
};

ExitCode store(const StoreOptions& options, Streams& streams) {
  if (options.limit) limit_store(options.file, *options.limit);
  if (options.shrink) shrink_store(options.file, *options.shrink);
  const StoreContents contents = store_contents(options.file, options.check);
  streams.write("", options.json ? contents_json(options.file, contents, options.check)
                                 : contents_text(options.file, contents, options.check));
  if (options.shrink && contents.bytes > *options.shrink)
    streams.note(options.file + ": without rows it takes " + counted(contents.bytes, "byte") + ", and never less");
  if (!contents.damage.empty())
    throw InputError({options.file, 0}, "is damaged: " + contents.damage.front(),
                     {"what is damaged is computed again where it is asked for; it is never taken"});
  return ExitCode::kDone;
}

}  // namespace

void add_store(Commands& commands) {
  const auto options = std::make_shared<StoreOptions>();
  CLI::App& command =
      commands.add("store", "What a store of view factors (--store) holds, whether it is whole; a smaller one",
                   {"hottel factors scenes/space/cube.json --quiet -o /tmp/cube.csv --store /tmp/factors.store\n"
                    "  hottel store /tmp/factors.store --check",
                    "hottel factors scenes/space/cube.json --quiet -o /tmp/cube.csv --store /tmp/factors.store\n"
                    "  hottel store /tmp/factors.store --shrink 50000 --json"},
                   [options](Streams& streams) { return store(*options, streams); });
  command.add_option("FILE", options->file, "the store")->required();
  command.add_flag("--check", options->check, "hold every record against its checksum, and look through the file");
  command
      .add_option("--shrink", options->shrink,
                  "take out what was used longest ago until the file has at most so many bytes")
      ->type_name("BYTES")
      ->transform(whole_number());
  command
      .add_option("--limit", options->limit,
                  "the bytes that the store may take from now on; what was used longest ago then gives way (at first "
                  "1073741824)")
      ->type_name("BYTES")
      ->transform(whole_number(1, std::uint64_t{1} << 62));
  command.add_flag("--json", options->json, "as one JSON object");
}

}  // namespace hottel
