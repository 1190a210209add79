#include "cli/streams.h"

#include <cstdio>
#include <memory>

#include "geometry/name.h"
#include "kernel/support/interrupt.h"

namespace hottel {
namespace {

constexpr std::size_t kMostHints = 3;

void print(const std::string& text) noexcept { std::fwrite(text.data(), 1, text.size(), stderr); }

}  // namespace

Streams::Streams(bool is_quiet) : is_quiet_(is_quiet) {}

void Streams::write(const std::string& option, std::string_view text) const {
  write_with(option, [text](OutputFile& file) { file.write(text); });
}

void Streams::write_with(const std::string& option, const std::function<void(OutputFile&)>& work) const {
  OutputFile file = output(option);
  try {
    work(file);
    file.commit();
  } catch (const ReaderGone&) {  // what else there is to be done is done
  }
}

void Streams::note(std::string_view text) const {
  if (is_quiet_ || text.empty()) return;
  Progress::make_room();
  print(std::string(text) + (text.back() == '\n' ? "" : "\n"));
}

std::function<void(double)> Streams::progress(const std::string& what) const {
  const auto bar = std::make_shared<Progress>(what, !is_quiet_ && Progress::is_terminal());
  return [bar](double fraction) {
    throw_if_interrupted();
    bar->update(fraction);
  };
}

StageProgress Streams::stages() const {
  struct Bar {
    std::string stage;
    std::unique_ptr<Progress> progress;
  };
  const auto bar = std::make_shared<Bar>();
  return [bar, is_shown = !is_quiet_ && Progress::is_terminal()](std::string_view stage, double fraction) {
    if (bar->stage != stage || !bar->progress) {
      bar->progress.reset();  // wipes its line first
      bar->stage = stage;
      bar->progress = std::make_unique<Progress>(bar->stage, is_shown);
    }
    bar->progress->update(fraction);
  };
}

std::string one_line(std::string_view text) {
  if (!has_control_character(text)) return std::string(text);
  const bool is_text = is_utf8(text);
  std::string result;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x20 && byte != 0x7F && (is_text || byte < 0x80)) {
      result += c;
    } else {
      constexpr char kDigits[] = "0123456789ABCDEF";
      result += {'\\', 'x', kDigits[byte >> 4], kDigits[byte & 15]};
    }
  }
  return result;
}

void print_error(const std::string& line, const std::vector<std::string>& hints) noexcept {
  try {
    std::string text = one_line(line) + "\n";
    for (std::size_t i = 0; i < hints.size() && i < kMostHints; ++i) text += "  " + one_line(hints[i]) + "\n";
    print(text);
  } catch (...) {
    print("hottel: memory ran out\n");
  }
}

}  // namespace hottel
