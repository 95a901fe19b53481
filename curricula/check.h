// Reads a curriculum file and finds every problem in one pass.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "curricula/curriculum.h"

namespace curricula {

struct Problem {
  enum class Severity { error, warning };
  Severity severity = Severity::error;
  int line = 0;         // 1-based
  int column = 0;       // 1-based
  std::string message;  // what is wrong and what to do, one sentence
};

// What the checker knows of the world outside the file: the catalogue.
struct Catalogue {
  struct Anatomy {
    std::string id;
    double length = 0.0;
  };  // mm from the access
  struct InstrumentEntry {
    std::string id;
    double length = 0.0;
  };  // mm
  std::vector<Anatomy> anatomies;
  std::vector<InstrumentEntry> instruments;
};

struct CheckResult {
  std::optional<Curriculum> curriculum;  // present when there is no error
  std::vector<Problem> problems;         // in the order of their lines
  bool ok() const { return curriculum.has_value(); }
};

// `text` is the file's content (UTF-8, at most 1 MiB). Never throws.
CheckResult check(const std::string& text, const Catalogue& catalogue);

}  // namespace curricula
