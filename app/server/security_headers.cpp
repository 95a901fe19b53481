#include "app/server/security_headers.h"

#include <algorithm>

namespace app {
namespace {

void add_if_missing(Response& response, const char* name, const std::string& value) {
  const bool there = std::any_of(response.headers.begin(), response.headers.end(),
                                 [&](const auto& header) { return header.first == name; });
  if (!there) response.headers.emplace_back(name, value);
}

}  // namespace

std::string content_security_policy(const std::string& style_nonce) {
  const std::string nonce = style_nonce.empty() ? "" : " 'nonce-" + style_nonce + "'";
  return "default-src 'self'; script-src 'self'; style-src 'self'" + nonce +
         "; img-src 'self' data: blob:; connect-src 'self'; form-action 'self'; "
         "frame-ancestors 'none'; base-uri 'none'; object-src 'none'";
}

void add_security_headers(Response& response, bool secure) {
  add_if_missing(response, "Content-Security-Policy", content_security_policy(""));
  add_if_missing(response, "X-Content-Type-Options", "nosniff");
  add_if_missing(response, "X-Frame-Options", "DENY");
  add_if_missing(response, "Referrer-Policy", "no-referrer");
  add_if_missing(response, "Cross-Origin-Opener-Policy", "same-origin");
  add_if_missing(response, "Cross-Origin-Resource-Policy", "same-origin");
  add_if_missing(response, "Cache-Control", "no-store");
  if (secure) add_if_missing(response, "Strict-Transport-Security", "max-age=31536000");
}

}  // namespace app
