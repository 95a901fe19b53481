// cathedra: one program, one file per command beside this one.
#include <algorithm>
#include <cstdio>
#include <exception>
#include <string>

#include <sodium.h>

#include "app/cli/command.h"
#include "app/session/build_info.h"

namespace {

int run(int argc, char** argv) {
  using namespace app::cli;
  CLI::App app{
      "Cathedra: learn to steer a catheter.\n"
      "Start with:  cathedra demo   (then open http://127.0.0.1:8080)",
      "cathedra"};
  app.require_subcommand(1);
  app.set_version_flag("--version", std::string("cathedra ") + ::app::kVersion);
  app.failure_message(CLI::FailureMessage::simple);

  Output output;
  add_serve(app, output);
  add_demo(app, output);
  add_exercise(app, output);
  add_trial(app, output);
  add_report(app, output);
  add_curriculum(app, output);
  add_user(app, output);
  add_instrument(app, output);
  add_anatomy(app, output);
  add_validate(app, output);
  add_doctor(app, output);

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    const bool json = std::find(argv, argv + argc, std::string("--json")) != argv + argc;
    if (error.get_exit_code() != 0 && json) {
      output.json = true;
      output.fail(error.what(), kWrongCall);
      return kWrongCall;
    }
    const int code = app.exit(error);
    return code == 0 ? kWorked : kWrongCall;
  }
  return output.exit_code;
}

}  // namespace

int main(int argc, char** argv) {
  if (sodium_init() < 0) {
    std::fputs("cathedra: the cryptography library could not start\n", stderr);
    return app::cli::kFailed;
  }
  try {
    return run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "cathedra: stopped by an unexpected failure: %s\n", error.what());
    return app::cli::kFailed;
  }
}
