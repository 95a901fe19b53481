// cathedra demo: a site of its own with example people and data, served at once.
#include <atomic>
#include <iostream>
#include <string>
#include <thread>
#include <vector>

#include "app/cli/serving.h"
#include "app/server/passwords.h"
#include "app/session/published_data.h"
#include "app/session/simulated_trial.h"
#include "database/people.h"
#include "database/trials.h"

namespace app::cli {
namespace {

struct Options {
  ServerOptions server;
  std::string folder = "data/demo";
  std::string web_root;
  int example_trials = 4;
  bool load_only = false;
};

constexpr const char* kGroup = "Demo group";

struct Account {
  const char* name;
  const char* password;
  const char* display_name;
  database::Role role;
};
constexpr Account kAccounts[] = {
    {"trainee", "demo-trainee-1", "Demo trainee", database::Role::trainee},
    {"instructor", "demo-instructor-1", "Demo instructor", database::Role::instructor},
    {"admin", "demo-admin-1", "Demo administrator", database::Role::administrator}};

// The example group: simulated operators under names that say so.
struct Example {
  const char* name;
  const char* display_name;
  const char* skill;
};
constexpr Example kExamples[] = {{"simulated:expert-a", "Sim expert A", "expert"},
                                 {"simulated:novice-a", "Sim novice A", "novice"},
                                 {"simulated:expert-b", "Sim expert B", "expert"},
                                 {"simulated:novice-b", "Sim novice B", "novice"},
                                 {"simulated:expert-c", "Sim expert C", "expert"},
                                 {"simulated:novice-c", "Sim novice C", "novice"}};

base::Status add_accounts(database::Store& store) {
  for (const Account& account : kAccounts) {
    if (database::person_by_name(store, account.name)) continue;
    const auto hash = hash_password(account.password);
    if (!hash) return hash.error();
    database::NewPerson person;
    person.name = account.name;
    person.display_name = account.display_name;
    person.role = account.role;
    person.password_phc = *hash;
    person.groups = {kGroup};
    if (account.role == database::Role::trainee) person.level = database::Level::novice;
    const auto added = database::add_person(store, person, "system");
    if (!added) return added.error();
  }
  return base::Done{};
}

base::Result<std::string> example_person(database::Store& store, const Example& example) {
  const auto id = simulated_person(store, example.name, example.display_name, example.skill);
  if (!id) return id;
  const base::Status joined = database::join_group(store, *id, kGroup, "system");
  if (!joined) return joined.error();
  return id;
}

base::Result<std::unique_ptr<database::Store>> load_demo(const std::string& url,
                                                         const curricula::Library& library) {
  auto store = open_prepared(url, library);
  if (!store) return store.error();
  const auto published = load_published_data(
      **store, (library_folder().parent_path() / "app" / "demo" / "published_trials.csv").string());
  if (!published) return published.error();
  const base::Status accounts = add_accounts(**store);
  if (!accounts) return accounts.error();
  for (const Example& example : kExamples) {
    const auto person = example_person(**store, example);
    if (!person) return person.error();
  }
  return store;
}

// Lets the example group practise, in the background, trial by trial: everyone's first, then
// everyone's second, so that the pages fill evenly. Goes on where an earlier start was stopped.
base::Status fill_examples(const std::string& url, const curricula::Library& library, int trials,
                           const std::atomic<bool>& stop) {
  auto store = database::Store::open(url);
  if (!store) return store.error();
  SceneStore scenes(library);
  for (int practice = 1; practice <= trials; ++practice) {
    for (const curricula::Curriculum& curriculum : library.curricula) {
      for (const curricula::Exercise& exercise : curriculum.exercises) {
        const auto scene = scenes.scene(exercise.scene);
        if (!scene) return scene.error();
        for (std::size_t k = 0; k < std::size(kExamples); ++k) {
          const auto person = example_person(**store, kExamples[k]);
          if (!person) return person.error();
          database::TrialFilter filter;
          filter.person_id = *person;
          filter.exercise_id = exercise.id;
          const auto done = database::trials(**store, filter);
          if (!done) return done.error();
          if (static_cast<int>(done->size()) >= practice) continue;
          if (stop) return base::Done{};
          const auto seed = static_cast<std::uint64_t>(1000 * practice) + k;
          const auto result = run_simulated(
              **store, {&curriculum, &exercise, kExamples[k].skill, seed, practice, *person},
              *scene, [&](double) { return !stop; });
          if (!result) return result.error();
        }
      }
    }
  }
  return base::Done{};
}

void demo(Options& options, Output& output) {
  auto library = load_installed_library();
  if (!library) return output.fail(library.error());
  const auto url = database_in(options.folder);
  if (!url) return output.fail(url.error());
  const auto lock = FolderLock::take(options.folder);
  if (!lock) return output.fail(lock.error());
  auto store = load_demo(*url, *library);
  if (!store) return output.fail(store.error());

  std::atomic<bool> stop{false};
  if (options.load_only) {
    const base::Status filled = fill_examples(*url, *library, options.example_trials, stop);
    if (!filled) return output.fail(filled.error());
    std::cout << "The demo is loaded in " << options.folder << ".\n";
    return;
  }
  options.server.demo = true;
  options.server.database_url = *url;
  options.server.web_root =
      options.web_root.empty() ? web_folder() : std::filesystem::path(options.web_root);
  for (const Account& account : kAccounts) {
    options.server.demo_accounts.push_back({account.name, account.password, account.role});
  }
  const curricula::Library for_examples = *library;
  std::thread examples;
  output.exit_code =
      serve_until_stopped(options.server, *std::move(library), output, [&](const std::string&) {
        nlohmann::ordered_json accounts = nlohmann::ordered_json::array();
        if (!output.json) std::cout << "Sign in as:\n";
        for (const Account& account : kAccounts) {
          accounts.push_back({{"role", database::word(account.role)},
                              {"name", account.name},
                              {"password", account.password}});
          if (output.json) continue;
          std::cout << "  " << database::word(account.role) << ": " << account.name << " / "
                    << account.password << '\n';
        }
        std::cout << std::flush;
        examples = std::thread([&] {
          const base::Status filled =
              fill_examples(*url, for_examples, options.example_trials, stop);
          if (!filled) std::cerr << "cathedra: " << filled.error().message << '\n';
        });
        return nlohmann::ordered_json{{"accounts", accounts}};
      });
  stop = true;
  if (examples.joinable()) examples.join();
}

}  // namespace

void add_demo(CLI::App& app, Output& output) {
  auto options = std::make_shared<Options>();  // shared: kept alive by the callback
  CLI::App* command = app.add_subcommand(
      "demo", "Serve a demo with example people, published data and simulated operators");
  command->footer("Example: cathedra demo --data data/demo");
  add_server_options(*command, options->server, options->folder, options->web_root);
  add_json_flag(*command, output);
  command
      ->add_option("--example-trials", options->example_trials,
                   "Trials per simulated person and exercise, made in the background; 0: none")
      ->check(CLI::Range(0, 100))
      ->capture_default_str();
  command->add_flag("--load-only", options->load_only, "Load everything, then end without serving");
  command->callback([options, &output] { demo(*options, output); });
}

}  // namespace app::cli
