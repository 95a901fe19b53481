// cathedra curriculum check | publish | list | show | copy | diff.
#include <fstream>
#include <iomanip>
#include <iostream>
#include <iterator>
#include <string>

#include "app/cli/command.h"
#include "app/session/publish_library.h"
#include "curricula/check.h"
#include "curricula/copy.h"
#include "curricula/diff.h"
#include "database/curricula.h"

namespace app::cli {
namespace {

using curricula::Problem;
using nlohmann::ordered_json;

struct Options {
  std::string file, other;
  std::string id, version, new_id;
  std::string database = "sqlite:cathedra.db";
  std::string out;
};

base::Result<std::string> read_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) {
    return base::Error{base::ErrorCode::not_found, "cannot read " + path + "; is the name right?"};
  }
  return std::string{std::istreambuf_iterator<char>(file), {}};
}

ordered_json problems_json(const std::string& file, const std::vector<Problem>& problems) {
  ordered_json rows = ordered_json::array();
  for (const Problem& problem : problems) {
    rows.push_back(
        {{"file", file},
         {"line", problem.line},
         {"column", problem.column},
         {"severity", problem.severity == Problem::Severity::error ? "error" : "warning"},
         {"message", problem.message}});
  }
  return rows;
}

void print_problems(const std::string& file, const std::vector<Problem>& problems) {
  for (const Problem& problem : problems) {
    std::cout << file << ':' << problem.line << ':' << problem.column << ": "
              << (problem.severity == Problem::Severity::error ? "error" : "warning") << ": "
              << problem.message << '\n';
  }
}

// Reads and checks a file; prints what is wrong. Empty when it cannot be used.
std::optional<curricula::CheckResult> load(const std::string& file, Output& output) {
  const auto library = load_installed_library();
  if (!library) {
    output.fail(library.error());
    return std::nullopt;
  }
  const auto text = read_file(file);
  if (!text) {
    output.fail(text.error().message);
    return std::nullopt;
  }
  return curricula::check(*text, library->catalogue());
}

void check(const Options& options, Output& output) {
  const auto result = load(options.file, output);
  if (!result) return;
  output.exit_code = result->ok() ? kWorked : kFailed;
  if (output.json) {
    return output.print({{"file", options.file},
                         {"ok", result->ok()},
                         {"problems", problems_json(options.file, result->problems)}});
  }
  print_problems(options.file, result->problems);
  if (result->ok()) {
    std::cout << options.file << ": " << result->curriculum->id << ' '
              << result->curriculum->version << " is in order, "
              << result->curriculum->exercises.size() << " exercises.\n";
  } else {
    std::cout << result->problems.size() << " problems.\n";
  }
}

void publish_file(const Options& options, Output& output) {
  const auto result = load(options.file, output);
  if (!result) return;
  if (!result->ok()) {
    if (!output.json) print_problems(options.file, result->problems);
    return output.fail(options.file +
                       " has problems and was not published; see: cathedra curriculum check " +
                       options.file);
  }
  const curricula::Curriculum& curriculum = *result->curriculum;
  auto store = database::Store::open(options.database);
  if (!store) return output.fail(store.error());
  const auto library = load_installed_library();
  if (!library) return output.fail(library.error());

  // a new version must say how much it changes
  const auto before = database::current_curriculum(**store, curriculum.id);
  if (before && before->sha256 != curriculum.sha256) {
    const auto old = curricula::check(before->yaml, library->catalogue());
    if (old.ok()) {
      const std::vector<Problem> problems =
          curricula::compare_versions(*old.curriculum, curriculum);
      if (!output.json) print_problems(options.file, problems);
      for (const Problem& problem : problems) {
        if (problem.severity == Problem::Severity::error) return output.fail(problem.message);
      }
    }
  }
  const base::Status published = publish(**store, curriculum, "shell");
  if (!published) return output.fail(published.error());
  if (output.json) {
    return output.print({{"curriculum", curriculum.id},
                         {"version", curriculum.version},
                         {"sha256", curriculum.sha256}});
  }
  std::cout << "Published " << curriculum.id << ' ' << curriculum.version << ".\n";
}

void list(const Options& options, Output& output) {
  const auto library = load_installed_library();
  if (!library) return output.fail(library.error());
  ordered_json rows = ordered_json::array();
  for (const curricula::Curriculum& curriculum : library->curricula) {
    rows.push_back({{"curriculum", curriculum.id},
                    {"version", curriculum.version},
                    {"where", "built in"},
                    {"sha256", curriculum.sha256}});
  }
  const std::string path =
      options.database.substr(std::min<std::size_t>(7, options.database.size()));
  if (std::filesystem::exists(path)) {
    auto store = database::Store::open(options.database);
    if (!store) return output.fail(store.error());
    const auto versions = database::curriculum_versions(**store);
    if (!versions) return output.fail(versions.error());
    for (const database::CurriculumVersion& version : *versions) {
      rows.push_back({{"curriculum", version.curriculum_id},
                      {"version", version.version},
                      {"where", version.status},
                      {"sha256", version.sha256}});
    }
  }
  if (output.json) return output.print(rows);
  for (const auto& row : rows) {
    std::cout << std::left << std::setw(24) << row["curriculum"].get<std::string>() << std::setw(10)
              << row["version"].get<std::string>() << std::setw(12)
              << row["where"].get<std::string>() << row["sha256"].get<std::string>().substr(0, 12)
              << '\n';
  }
}

// The text of a curriculum: ID, or ID@VERSION from the database.
base::Result<std::string> text_of(const std::string& id, const std::string& database_url) {
  const std::string name = id.substr(0, id.find('@'));
  const std::string version = id.size() > name.size() ? id.substr(name.size() + 1) : "";
  const auto library = load_installed_library();
  if (!library) return library.error();
  for (const curricula::Curriculum& curriculum : library->curricula) {
    if (curriculum.id == name && (version.empty() || version == curriculum.version)) {
      return curriculum.yaml;
    }
  }
  if (std::filesystem::exists(database_url.substr(std::min<std::size_t>(7, database_url.size())))) {
    auto store = database::Store::open(database_url);
    if (!store) return store.error();
    const auto versions = database::curriculum_versions(**store);
    if (!versions) return versions.error();
    for (const database::CurriculumVersion& stored : *versions) {
      if (stored.curriculum_id == name && (version.empty() || version == stored.version)) {
        return stored.yaml;
      }
    }
  }
  return base::Error{base::ErrorCode::not_found,
                     "there is no curriculum \"" + id + "\"; see: cathedra curriculum list"};
}

void show(const Options& options, Output& output) {
  const auto text = text_of(options.id, options.database);
  if (!text) return output.fail(text.error());
  if (output.json) return output.print({{"curriculum", options.id}, {"yaml", *text}});
  std::cout << *text;
}

void copy(const Options& options, Output& output) {
  const auto text = text_of(options.id, options.database);
  if (!text) return output.fail(text.error());
  const auto library = load_installed_library();
  if (!library) return output.fail(library.error());
  const curricula::CheckResult source = curricula::check(*text, library->catalogue());
  if (!source.ok()) return output.fail(options.id + " cannot be read by this version");
  const auto draft = curricula::copy_as_draft(*source.curriculum, options.new_id);
  if (!draft) return output.fail(draft.error());
  if (options.out.empty()) {
    if (output.json) return output.print({{"curriculum", options.new_id}, {"yaml", *draft}});
    std::cout << *draft;
    return;
  }
  if (std::filesystem::exists(options.out)) {
    return output.fail(options.out + " is already there; choose another name");
  }
  const base::Status written = write_whole_file(options.out, *draft);
  if (!written) return output.fail(written.error());
  if (output.json) return output.print({{"file", options.out}, {"curriculum", options.new_id}});
  std::cout << "Draft " << options.new_id << " written to " << options.out << ".\n";
}

void diff(const Options& options, Output& output) {
  const auto before = load(options.file, output);
  if (!before) return;
  const auto after = load(options.other, output);
  if (!after) return;
  for (const auto& [file, result] : {std::pair{options.file, &*before}, {options.other, &*after}}) {
    if (result->ok()) continue;
    if (!output.json) print_problems(file, result->problems);
    return output.fail(file + " has problems; mend them first");
  }
  const std::vector<curricula::Change> changes =
      curricula::diff(*before->curriculum, *after->curriculum);
  ordered_json rows = ordered_json::array();
  for (const curricula::Change& change : changes) {
    rows.push_back({{"weight", curricula::word(change.weight)}, {"change", change.sentence}});
    if (!output.json) {
      std::cout << curricula::word(change.weight) << ": " << change.sentence << '\n';
    }
  }
  if (output.json) return output.print({{"changes", rows}});
  if (changes.empty()) std::cout << "No difference that matters.\n";
}

}  // namespace

void add_curriculum(CLI::App& app, Output& output) {
  CLI::App* curriculum =
      app.add_subcommand("curriculum", "Curricula: check, publish, list, show, copy, diff");
  curriculum->require_subcommand(1);
  curriculum->footer("Example: cathedra curriculum check my-curriculum.yaml");
  auto options = std::make_shared<Options>();  // shared: kept alive by the callbacks

  const auto add = [&](const char* name, const char* what, const char* example,
                       void (*action)(const Options&, Output&)) {
    CLI::App* command = curriculum->add_subcommand(name, what);
    command->footer(std::string("Example: ") + example);
    add_json_flag(*command, output);
    command->callback([options, action, &output] { action(*options, output); });
    return command;
  };
  const auto add_database = [&](CLI::App* command) {
    command->add_option("--database", options->database, "sqlite:PATH")->capture_default_str();
  };
  add("check", "Find every problem of a file in one pass; exit code 1 when there is one",
      "cathedra curriculum check my-curriculum.yaml", check)
      ->add_option("file", options->file, "YAML file")
      ->required();
  CLI::App* publish_command =
      add("publish", "Check a file and make it a version for trainees",
          "cathedra curriculum publish my-curriculum.yaml --database sqlite:data/site/cathedra.db",
          publish_file);
  publish_command->add_option("file", options->file, "YAML file")->required();
  add_database(publish_command);
  add_database(add("list", "Built-in and published versions", "cathedra curriculum list", list));
  CLI::App* show_command = add("show", "The text of one version",
                               "cathedra curriculum show vascular-basics@1.0.0", show);
  show_command->add_option("id", options->id, "ID or ID@VERSION")->required();
  add_database(show_command);
  CLI::App* copy_command =
      add("copy", "An editable draft of a version under a new id",
          "cathedra curriculum copy vascular-basics --as our-basics -o our-basics.yaml", copy);
  copy_command->add_option("id", options->id, "ID or ID@VERSION")->required();
  copy_command->add_option("--as", options->new_id, "Id of the copy")->required();
  copy_command->add_option("-o,--output", options->out,
                           "File to write; without it the draft is printed");
  add_database(copy_command);
  CLI::App* diff_command = add("diff", "What changed between two files, in words",
                               "cathedra curriculum diff old.yaml new.yaml", diff);
  diff_command->add_option("before", options->file, "YAML file")->required();
  diff_command->add_option("after", options->other, "YAML file")->required();
}

}  // namespace app::cli
