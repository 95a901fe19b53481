#include "curricula/semantic_version.h"

#include <array>
#include <charconv>

namespace curricula {

std::optional<SemanticVersion> parse_version(std::string_view text) {
  constexpr std::size_t kMostDigits = 6;
  std::array<int, 3> parts{};
  const char* at = text.data();
  const char* const end = text.data() + text.size();
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (i > 0) {
      if (at == end || *at != '.') return {};
      ++at;
    }
    if (at == end || *at < '0' || *at > '9') return {};  // no sign either
    const auto [stop, error] = std::from_chars(at, end, parts[i]);
    const auto digits = static_cast<std::size_t>(stop - at);
    if (error != std::errc{} || digits > kMostDigits || (digits > 1 && *at == '0')) return {};
    at = stop;
  }
  if (at != end) return {};
  return SemanticVersion{parts[0], parts[1], parts[2]};
}

std::string version_text(const SemanticVersion& version) {
  return std::to_string(version.major) + "." + std::to_string(version.minor) + "." +
         std::to_string(version.patch);
}

}  // namespace curricula
