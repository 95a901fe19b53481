// major.minor.patch, as a curriculum carries it.
#pragma once

#include <compare>
#include <optional>
#include <string>
#include <string_view>

namespace curricula {

struct SemanticVersion {
  int major = 0, minor = 0, patch = 0;
  friend auto operator<=>(const SemanticVersion&, const SemanticVersion&) = default;
};

// "1.0.0"; nothing for anything else, leading zeros and numbers above 999999 included.
std::optional<SemanticVersion> parse_version(std::string_view text);
std::string version_text(const SemanticVersion& version);

}  // namespace curricula
