// Reads the description of one instrument or one anatomy.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "curricula/catalogue.h"

namespace curricula {

template <typename Spec>
struct CatalogueEntry {
  std::optional<Spec> spec;       // present when there is no error
  std::vector<Problem> problems;  // in the order of their lines
};

// `text` is the file's content, YAML in the same safe subset as a curriculum. Never throws for
// what the file says.
CatalogueEntry<InstrumentSpec> read_instrument(const std::string& text);
CatalogueEntry<AnatomySpec> read_anatomy(const std::string& text);

}  // namespace curricula
