// cathedra doctor: is everything there that serving needs?
#include <fstream>
#include <iostream>
#include <string>
#include <thread>
#include <vector>

#include <sys/statvfs.h>
#include <unistd.h>

#include "app/cli/command.h"
#include "app/session/build_info.h"
#include "database/audit.h"

namespace app::cli {
namespace {

using nlohmann::ordered_json;

struct Finding {
  std::string what;
  bool good = false;
  std::string says;
};

Finding check_library() {
  const auto library = load_installed_library();
  if (!library) return {"catalogue", false, library.error().message};
  return {"catalogue", true,
          std::to_string(library->instruments.size()) + " instruments, " +
              std::to_string(library->anatomies.size()) + " anatomies, " +
              std::to_string(library->curricula.size()) + " curricula"};
}

Finding check_web() {
  const auto page = web_folder() / "index.html";
  if (std::filesystem::exists(page))
    return {"browser application", true, page.parent_path().string()};
  return {"browser application", false, "not built; run ./run build"};
}

Finding check_cores() {
  const unsigned cores = std::thread::hardware_concurrency();
  return {
      "processor", cores >= 2,
      std::to_string(cores) + " cores" + (cores >= 2 ? "" : "; two or more keep trials smooth")};
}

Finding check_disk(const std::string& folder) {
  struct statvfs disk {};
  if (statvfs(folder.c_str(), &disk) != 0) return {"disk", false, "cannot look at " + folder};
  const double free_gb =
      static_cast<double>(disk.f_bavail) * static_cast<double>(disk.f_frsize) / 1e9;
  char text[80];
  std::snprintf(text, sizeof text, "%.1f GB free%s", free_gb,
                free_gb > 1.0 ? "" : "; a trial needs about 0.5 MB a minute");
  return {"disk", free_gb > 1.0, text};
}

Finding check_database(const std::string& url) {
  const std::string path = url.substr(std::min<std::size_t>(7, url.size()));
  if (!std::filesystem::exists(path)) return {"database", true, "none yet at " + path};
  auto store = database::Store::open(url);
  if (!store) return {"database", false, store.error().message};
  const base::Status whole = (*store)->check_integrity();
  if (!whole) return {"database", false, whole.error().message};
  const base::Status audit = database::verify_audit(**store);
  if (!audit) return {"database", false, audit.error().message};
  return {"database", true,
          path + ", schema " + std::to_string((*store)->schema_version()) + ", audit log whole"};
}

}  // namespace

void add_doctor(CLI::App& app, Output& output) {
  auto url =
      std::make_shared<std::string>("sqlite:data/demo/cathedra.db");  // shared: with the callback
  CLI::App* command = app.add_subcommand("doctor", "Check this installation and a database");
  command->footer("Example: cathedra doctor --database sqlite:data/site/cathedra.db");
  command->add_option("--database", *url, "sqlite:PATH")->capture_default_str();
  add_json_flag(*command, output);
  command->callback([url, &output] {
    const std::vector<Finding> findings = {check_library(), check_web(), check_cores(),
                                           check_disk("."), check_database(*url)};
    ordered_json rows = ordered_json::array();
    for (const Finding& finding : findings) {
      rows.push_back({{"what", finding.what}, {"good", finding.good}, {"says", finding.says}});
      if (!finding.good) output.exit_code = kFailed;
    }
    if (output.json) return output.print({{"build", build_id()}, {"findings", rows}});
    std::cout << "Cathedra " << build_id() << '\n';
    for (const Finding& finding : findings) {
      std::cout << (finding.good ? "  good  " : "  BAD   ") << finding.what << ": " << finding.says
                << '\n';
    }
  });
}

}  // namespace app::cli
