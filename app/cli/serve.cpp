// cathedra serve: a real site.
#include <iostream>
#include <string>

#include "app/cli/serving.h"
#include "app/server/setup_link.h"

namespace app::cli {
namespace {

struct Options {
  ServerOptions server;
  std::string folder = "data/site";
  std::string web_root;
};

void serve(Options& options, Output& output) {
  auto library = load_installed_library();
  if (!library) return output.fail(library.error());
  const auto url = database_in(options.folder);
  if (!url) return output.fail(url.error());
  const auto lock = FolderLock::take(options.folder);
  if (!lock) return output.fail(lock.error());
  options.server.database_url = *url;
  options.server.web_root =
      options.web_root.empty() ? web_folder() : std::filesystem::path(options.web_root);

  auto opened = open_prepared(*url, *library);
  if (!opened) return output.fail(opened.error());
  std::unique_ptr<database::Store> store = *std::move(opened);
  output.exit_code = serve_until_stopped(
      options.server, *std::move(library), output, [&](const std::string& site_url) {
        const auto needed = needs_setup(*store);
        nlohmann::ordered_json document = {{"setup_link", nullptr}};
        if (!needed || !*needed) return document;
        const auto token = make_setup_token(*store);
        if (!token) {
          std::cerr << "cathedra: " << token.error().message << '\n';
          return document;
        }
        const std::string link = setup_url(site_url, *token);
        document["setup_link"] = link;
        if (!output.json) {
          std::cout << "This site has no administrator yet. Open this link once, within 24 "
                       "hours:\n  "
                    << link << std::endl;
        }
        return document;
      });
}

}  // namespace

void add_serve(CLI::App& app, Output& output) {
  auto options = std::make_shared<Options>();  // shared: kept alive by the callback
  CLI::App* command = app.add_subcommand("serve", "Serve a real site in the browser");
  command->footer("Example: cathedra serve --data /srv/cathedra --port 8080");
  add_server_options(*command, options->server, options->folder, options->web_root);
  add_json_flag(*command, output);
  command->callback([options, &output] { serve(*options, output); });
}

}  // namespace app::cli
