#include "app/cli/command.h"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <utility>

#include <unistd.h>

#include "app/session/publish_library.h"

namespace app::cli {
namespace {

namespace fs = std::filesystem;

// The first folder at or above the program's own that holds `wanted`, e.g. build/release -> the
// source tree; or share/cathedra beside bin of an installation.
fs::path find_beside_program(const fs::path& wanted) {
  std::error_code ignored;
  fs::path folder = fs::read_symlink("/proc/self/exe", ignored).parent_path();
  while (!folder.empty()) {
    for (const fs::path& base : {folder, folder / "share" / "cathedra"}) {
      if (fs::exists(base / wanted, ignored)) return base;
    }
    if (folder == folder.root_path()) break;
    folder = folder.parent_path();
  }
  return fs::current_path(ignored);
}

}  // namespace

void Output::print(const nlohmann::ordered_json& document) const {
  std::cout << document.dump(2) << '\n';
}

void Output::fail(const std::string& sentence, int code) {
  exit_code = code;
  if (json) {
    print({{"error", sentence}});
  } else {
    std::cerr << "cathedra: " << sentence << '\n';
  }
}

void Output::fail(const base::Error& error) {
  const bool call = error.code == base::ErrorCode::invalid_input;
  fail(error.message, call ? kWrongCall : kFailed);
}

void add_json_flag(CLI::App& command, Output& output) {
  command.add_flag("--json", output.json, "Print one JSON document (schemas: docs/json)");
}

ProgressBar::ProgressBar(std::string title) : title_(std::move(title)) {}

ProgressBar::~ProgressBar() {
  if (drawn_ >= 0) std::fprintf(stderr, "\r\033[K");
}

void ProgressBar::set(double fraction) {
  constexpr int kWidth = 40;
  if (!isatty(STDERR_FILENO)) return;
  const int percent = static_cast<int>(100.0 * std::clamp(fraction, 0.0, 1.0));
  if (percent == drawn_) return;
  drawn_ = percent;
  const int filled = percent * kWidth / 100;
  std::fprintf(stderr, "\r%s [%s%s] %3d %%", title_.c_str(),
               std::string(static_cast<std::size_t>(filled), '#').c_str(),
               std::string(static_cast<std::size_t>(kWidth - filled), ' ').c_str(), percent);
  std::fflush(stderr);
}

fs::path library_folder() { return find_beside_program("curricula/library") / "curricula"; }

fs::path web_folder() { return find_beside_program("app/web/dist") / "app" / "web" / "dist"; }

base::Result<curricula::Library> load_installed_library() {
  return curricula::load_library(library_folder().string());
}

base::Result<std::unique_ptr<database::Store>> open_prepared(const std::string& url,
                                                             const curricula::Library& library) {
  auto store = database::Store::open(url);
  if (!store) return store.error();
  const base::Status published = publish_library(**store, library);
  if (!published) return published.error();
  return store;
}

base::Status require_database(const std::string& url) {
  const std::string prefix = "sqlite:";
  std::error_code ignored;
  if (url.rfind(prefix, 0) != 0 || fs::exists(url.substr(prefix.size()), ignored)) {
    return base::Done{};
  }
  return base::Error{base::ErrorCode::not_found,
                     "there is no database \"" + url.substr(prefix.size()) + "\""};
}

base::Status write_whole_file(const std::string& path, const std::string& text) {
  std::error_code problem;
  // a device or a pipe is written to as it is; a file is replaced once its successor is complete
  const bool in_place = fs::exists(path, problem) && !fs::is_regular_file(path, problem);
  const std::string written = in_place ? path : path + ".part";
  std::ofstream file(written, std::ios::binary | std::ios::trunc);
  file << text;
  file.close();
  if (file && !in_place) fs::rename(written, path, problem);
  if (file && !problem) return base::Done{};
  if (!in_place) fs::remove(written, problem);
  return base::Error{base::ErrorCode::unavailable,
                     "could not write " + path + "; is the folder there and writable?"};
}

std::string setup_url(const std::string& site_url, const std::string& token) {
  return site_url + "/setup?token=" + token;
}

}  // namespace app::cli
