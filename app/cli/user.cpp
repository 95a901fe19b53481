// cathedra user add | list | disable | enable | reset: people, from the shell.
#include <iomanip>
#include <iostream>
#include <string>
#include <vector>

#include <termios.h>
#include <unistd.h>

#include "app/cli/command.h"
#include "app/server/passwords.h"
#include "app/server/setup_link.h"
#include "database/people.h"

namespace app::cli {
namespace {

using nlohmann::ordered_json;

struct Options {
  std::string database = "sqlite:cathedra.db";
  std::string name;
  std::string display_name;
  std::string role = "trainee";
  std::string level;
  std::vector<std::string> groups;
  bool password_stdin = false;
  std::string url = "http://127.0.0.1:8080";
};

ordered_json person_json(const database::Person& person) {
  return {{"person_id", person.id},
          {"name", person.name},
          {"display_name", person.display_name},
          {"role", database::word(person.role)},
          {"kind", database::word(person.kind)},
          {"level", person.level ? ordered_json(database::word(*person.level)) : nullptr},
          {"groups", person.groups},
          {"disabled", person.disabled}};
}

// Asks without showing what is typed, or takes the first line of a pipe.
std::string read_password(bool from_pipe) {
  std::string password;
  if (from_pipe || !isatty(STDIN_FILENO)) {
    std::getline(std::cin, password);
    return password;
  }
  std::cerr << "Password: " << std::flush;
  termios shown{};
  tcgetattr(STDIN_FILENO, &shown);
  termios hidden = shown;
  hidden.c_lflag &= ~static_cast<tcflag_t>(ECHO);
  tcsetattr(STDIN_FILENO, TCSAFLUSH, &hidden);
  std::getline(std::cin, password);
  tcsetattr(STDIN_FILENO, TCSAFLUSH, &shown);
  std::cerr << '\n';
  return password;
}

void add(const Options& options, Output& output) {
  database::NewPerson person;
  person.name = options.name;
  person.display_name = options.display_name.empty() ? options.name : options.display_name;
  person.groups = options.groups;
  database::parse(options.role, person.role);
  database::Level level;
  if (database::parse(options.level, level)) person.level = level;

  const std::string password = read_password(options.password_stdin);
  const base::Status acceptable = check_new_password(password, options.name);
  if (!acceptable) return output.fail(acceptable.error());
  const auto hash = hash_password(password);
  if (!hash) return output.fail(hash.error());
  person.password_phc = *hash;

  auto store = database::Store::open(options.database);
  if (!store) return output.fail(store.error());
  const auto added = database::add_person(**store, person, "shell");
  if (!added) return output.fail(added.error());
  if (output.json) return output.print(person_json(*added));
  std::cout << "Added " << added->name << " (" << database::word(added->role) << ").\n";
}

void list(const Options& options, Output& output) {
  const base::Status there = require_database(options.database);
  if (!there) return output.fail(there.error());
  auto store = database::Store::open(options.database);
  if (!store) return output.fail(store.error());
  const auto everyone = database::people(**store);
  if (!everyone) return output.fail(everyone.error());
  ordered_json rows = ordered_json::array();
  for (const database::Person& person : *everyone) rows.push_back(person_json(person));
  if (output.json) return output.print(rows);
  for (const database::Person& person : *everyone) {
    std::cout << std::left << std::setw(24) << person.name << std::setw(16)
              << database::word(person.role) << std::setw(12) << database::word(person.kind)
              << (person.disabled ? "disabled" : "") << '\n';
  }
}

void set_disabled(const Options& options, bool disabled, Output& output) {
  const base::Status there = require_database(options.database);
  if (!there) return output.fail(there.error());
  auto store = database::Store::open(options.database);
  if (!store) return output.fail(store.error());
  const auto person = database::person_by_name(**store, options.name);
  if (!person) return output.fail(person.error());
  const base::Status done = database::set_disabled(**store, person->id, disabled, "shell");
  if (!done) return output.fail(done.error());
  if (disabled) {
    const base::Status ended = database::end_web_sessions_of(**store, person->id);
    if (!ended) return output.fail(ended.error());
  }
  if (output.json) return output.print({{"name", options.name}, {"disabled", disabled}});
  std::cout << options.name << (disabled ? " can no longer sign in.\n" : " can sign in again.\n");
}

void reset(const Options& options, Output& output) {
  const base::Status there = require_database(options.database);
  if (!there) return output.fail(there.error());
  auto store = database::Store::open(options.database);
  if (!store) return output.fail(store.error());
  const auto token = make_setup_token(**store);
  if (!token) return output.fail(token.error());
  const std::string link = setup_url(options.url, *token);
  if (output.json) return output.print({{"setup_link", link}});
  std::cout << "Open this link once, within 24 hours, to set up an administrator:\n  " << link
            << '\n';
}

}  // namespace

void add_user(CLI::App& app, Output& output) {
  CLI::App* user = app.add_subcommand("user", "People: add, list, disable; a new set-up link");
  user->require_subcommand(1);
  user->footer("Example: cathedra user add resident14 --role trainee --level novice --group 2026");
  auto options = std::make_shared<Options>();  // shared: kept alive by the callbacks

  const auto command = [&](const char* name, const char* what, const char* example) {
    CLI::App* made = user->add_subcommand(name, what);
    made->footer(std::string("Example: ") + example);
    made->add_option("--database", options->database, "sqlite:PATH")->capture_default_str();
    add_json_flag(*made, output);
    return made;
  };
  CLI::App* add_command =
      command("add", "Add a person; the password is asked for, or read from a pipe",
              "cathedra user add ines --role instructor --group 2026");
  add_command->add_option("name", options->name, "What the person signs in with")->required();
  add_command->add_option("--display-name", options->display_name, "What others see");
  add_command->add_option("--role", options->role, "What the person may do")
      ->check(CLI::IsMember({"trainee", "instructor", "administrator", "researcher"}))
      ->capture_default_str();
  add_command->add_option("--level", options->level, "Experience, as of today")
      ->check(CLI::IsMember({"novice", "intermediate", "expert"}));
  add_command->add_option("--group", options->groups, "Group; may be given more than once");
  add_command->add_flag("--password-stdin", options->password_stdin,
                        "Read the password from standard input");
  add_command->callback([options, &output] { add(*options, output); });

  command("list", "Everyone", "cathedra user list --json")->callback([options, &output] {
    list(*options, output);
  });
  CLI::App* disable = command("disable", "End a person's access; nothing is deleted",
                              "cathedra user disable resident14");
  disable->add_option("name", options->name, "Who")->required();
  disable->callback([options, &output] { set_disabled(*options, true, output); });
  CLI::App* enable = command("enable", "Give access back", "cathedra user enable resident14");
  enable->add_option("name", options->name, "Who")->required();
  enable->callback([options, &output] { set_disabled(*options, false, output); });
  CLI::App* reset_command =
      command("reset", "A new one-time set-up link for a locked-out administrator",
              "cathedra user reset --database sqlite:data/site/cathedra.db");
  reset_command->add_option("--url", options->url, "Where the server answers")
      ->capture_default_str();
  reset_command->callback([options, &output] { reset(*options, output); });
}

}  // namespace app::cli
