// How bad a finding is.
#pragma once

namespace hottel {

// kError:   light cannot be computed, or a promise of the scene is broken
// kWarning: probably not meant
// kNote:    legal, and worth knowing
// The worst comes first, and findings are sorted by it.
enum class Severity : unsigned char { kError, kWarning, kNote };

// The word that reports print.
constexpr const char* to_string(Severity severity) {
  switch (severity) {
    case Severity::kError:
      return "error";
    case Severity::kWarning:
      return "warning";
    case Severity::kNote:
      return "note";
  }
  return "";
}

}  // namespace hottel
