#include "app/server/same_origin.h"

#include <algorithm>
#include <cctype>
#include <string_view>

#include <arpa/inet.h>

namespace app {
namespace {

bool equal_ignoring_case(std::string_view left, std::string_view right) {
  return std::equal(
      left.begin(), left.end(), right.begin(), right.end(),
      [](unsigned char a, unsigned char b) { return std::tolower(a) == std::tolower(b); });
}

// "[::1]:8080" -> "[::1]", "localhost:8080" -> "localhost"
std::string_view without_port(std::string_view host) {
  const std::size_t bracket = host.rfind(']');
  const std::size_t colon = host.rfind(':');
  if (colon == std::string_view::npos) return host;
  if (bracket != std::string_view::npos && colon < bracket) return host;
  return host.substr(0, colon);
}

}  // namespace

bool is_same_origin(const Request& request, const ServerOptions& options, bool origin_needed) {
  const std::string& site = request.header("sec-fetch-site");
  if (!site.empty() && site != "same-origin" && site != "none") return false;

  std::string_view origin = request.header("origin");
  if (origin.empty()) return !origin_needed;
  const std::size_t scheme = origin.find("://");
  if (scheme == std::string_view::npos) return false;  // "null": a sandboxed page or a file
  if (options.tls() && origin.substr(0, scheme) != "https") return false;
  return equal_ignoring_case(origin.substr(scheme + 3), request.header("host"));
}

bool is_own_host(const std::string& host, const ServerOptions& options) {
  if (host.empty()) return false;
  if (options.tls() || options.behind_proxy) return true;
  const std::string_view name = without_port(host);
  return equal_ignoring_case(name, "localhost") || is_loopback(std::string(name));
}

bool is_loopback(const std::string& address) {
  // a name such as 127.example.com only looks like an address
  in_addr four{};
  return address == "localhost" || address == "::1" || address == "[::1]" ||
         (inet_pton(AF_INET, address.c_str(), &four) == 1 && address.starts_with("127."));
}

}  // namespace app
