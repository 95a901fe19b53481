// What the commands share: how they end, how they print, where things lie.
//
// Exit codes: 0 worked, 1 the data or the run failed, 2 the call was wrong.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/session/scene.h"
#include "database/store.h"
#include "sim/base/result.h"

namespace app::cli {

inline constexpr int kWorked = 0;
inline constexpr int kFailed = 1;
inline constexpr int kWrongCall = 2;

// Where results go while the command runs.
struct Output {
  bool json = false;
  int exit_code = kWorked;

  // One JSON document on standard output.
  void print(const nlohmann::ordered_json& document) const;
  // One sentence on standard error (as {"error": ...} on standard output with --json).
  void fail(const std::string& sentence, int code = kFailed);
  void fail(const base::Error& error);  // the code follows from the kind of error
};

// Adds --json to a command.
void add_json_flag(CLI::App& command, Output& output);

// A bar on standard error, drawn only when that is a terminal.
class ProgressBar {
 public:
  explicit ProgressBar(std::string title);
  ~ProgressBar();  // clears the line
  void set(double fraction);

 private:
  std::string title_;
  int drawn_ = -1;
};

// The installation: catalogue and browser application, found beside the program or above it.
std::filesystem::path library_folder();
std::filesystem::path web_folder();
base::Result<curricula::Library> load_installed_library();

// Opens the database, brings it up to date and files the built-in curricula in it.
base::Result<std::unique_ptr<database::Store>> open_prepared(const std::string& url,
                                                             const curricula::Library& library);

// Fails with not_found when a sqlite: URL names no file: a typing error must not make an empty one.
base::Status require_database(const std::string& url);

// Writes a file whole or not at all: what was there before stays until the new one is complete.
// Fails with unavailable.
base::Status write_whole_file(const std::string& path, const std::string& text);

// Where the first administrator sets up a site, once.
std::string setup_url(const std::string& site_url, const std::string& token);

// Each adds one command with its sub-commands. `output` outlives the parsing.
void add_serve(CLI::App& app, Output& output);
void add_demo(CLI::App& app, Output& output);
void add_exercise(CLI::App& app, Output& output);
void add_trial(CLI::App& app, Output& output);
void add_report(CLI::App& app, Output& output);
void add_curriculum(CLI::App& app, Output& output);
void add_user(CLI::App& app, Output& output);
void add_instrument(CLI::App& app, Output& output);
void add_anatomy(CLI::App& app, Output& output);
void add_validate(CLI::App& app, Output& output);
void add_doctor(CLI::App& app, Output& output);

}  // namespace app::cli
