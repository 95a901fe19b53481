#include "app/server/static_files.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <optional>
#include <span>
#include <string_view>
#include <system_error>

#include "app/server/problem.h"
#include "app/server/secrets.h"
#include "app/server/security_headers.h"
#include "app/session/recording.h"

namespace app {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kNoncePlace = "__CSP_NONCE__";

struct MimeType {
  std::string_view ending, type;
};
constexpr std::array kMimeTypes = std::to_array<MimeType>({
    {".html", "text/html; charset=utf-8"},
    {".js", "text/javascript; charset=utf-8"},
    {".mjs", "text/javascript; charset=utf-8"},
    {".css", "text/css; charset=utf-8"},
    {".json", "application/json"},
    {".webmanifest", "application/manifest+json"},
    {".svg", "image/svg+xml"},
    {".png", "image/png"},
    {".jpg", "image/jpeg"},
    {".webp", "image/webp"},
    {".ico", "image/x-icon"},
    {".woff2", "font/woff2"},
    {".glb", "model/gltf-binary"},
    {".wasm", "application/wasm"},
    {".txt", "text/plain; charset=utf-8"},
});

// A path made of plain names only: nothing that climbs, hides or means something to the system.
bool is_plain(std::string_view path) {
  if (path.find('\\') != std::string_view::npos) return false;
  while (!path.empty()) {
    const std::size_t slash = path.find('/');
    const std::string_view name = path.substr(0, slash);
    path = slash == std::string_view::npos ? std::string_view{} : path.substr(slash + 1);
    if (name.starts_with('.')) return false;
  }
  return true;
}

// The file a path names inside the folder, links followed; nothing when it is not in there.
std::optional<fs::path> file_inside(const fs::path& folder, const std::string& path) {
  std::error_code failed;
  const fs::path root = fs::canonical(folder, failed);
  if (failed) return std::nullopt;
  const fs::path file = fs::canonical(root / path.substr(1), failed);
  if (failed || !fs::is_regular_file(file, failed)) return std::nullopt;
  const auto end = std::mismatch(root.begin(), root.end(), file.begin(), file.end()).first;
  if (end != root.end()) return std::nullopt;
  return file;
}

std::optional<std::string> read(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) return std::nullopt;
  return std::string(std::istreambuf_iterator<char>(stream), {});
}

// The page itself is new each time: it carries the nonce its styles need.
Response page(const fs::path& web_root) {
  auto html = read(web_root / "index.html");
  if (!html) {
    return problem(503, "not_built", "The browser application is not built; run ./run build.");
  }
  const std::string nonce = new_token();
  for (std::size_t at = html->find(kNoncePlace); at != std::string::npos;
       at = html->find(kNoncePlace, at)) {
    html->replace(at, kNoncePlace.size(), nonce);
  }
  Response response;
  response.type = "text/html; charset=utf-8";
  response.body = *std::move(html);
  response.headers.emplace_back("Content-Security-Policy", content_security_policy(nonce));
  response.headers.emplace_back("Cache-Control", "no-store");
  return response;
}

Response file_response(const Request& request, const fs::path& file) {
  auto bytes = read(file);
  if (!bytes) return problem(404, "not_found", "This file cannot be read.");
  Response response;
  response.type = mime_type(file);
  const std::string tag = "\"" + sha256_hex(std::as_bytes(std::span(*bytes))).substr(0, 32) + "\"";
  response.headers.emplace_back("ETag", tag);
  // names under /assets/ change with their content
  response.headers.emplace_back("Cache-Control", request.path.starts_with("/assets/")
                                                     ? "public, max-age=31536000, immutable"
                                                     : "no-cache");
  if (request.header("if-none-match") == tag) {
    response.status = 304;
  } else {
    response.body = *std::move(bytes);
  }
  return response;
}

}  // namespace

std::string mime_type(const fs::path& file) {
  const std::string ending = file.extension().string();
  for (const MimeType& known : kMimeTypes) {
    if (known.ending == ending) return std::string(known.type);
  }
  return "application/octet-stream";
}

Response static_file(const Request& request, const fs::path& web_root) {
  if (request.method != Method::get) {
    Response response = problem(405, "wrong_method", "This address answers only to GET.");
    response.headers.emplace_back("Allow", "GET");
    return response;
  }
  if (!is_plain(request.path)) return problem(404, "not_found", "This address does not exist.");
  if (request.path != "/" && request.path != "/index.html") {
    if (const auto file = file_inside(web_root, request.path)) return file_response(request, *file);
    if (request.path.starts_with("/assets/")) {
      return problem(404, "not_found", "This file does not exist; reload the page.");
    }
  }
  return page(web_root);
}

}  // namespace app
