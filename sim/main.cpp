// The program: parses the command line, runs one command, and turns errors into one line and an exit code.
#include <fmt/format.h>

#include "sim/command.h"
#include "sim/input_error.h"

namespace {

int run(int argc, char** argv) {
  CLI::App app{"Wrinkle: hardware for bump mapping, its bit-exact model, and the bench that compares them."};
  app.name("wrinkle");
  app.require_subcommand(1);
  app.footer(
      "exit code: 0 done and equal, 1 compared and different, 2 bad input\nAlso: ./wrinkle test [--long] builds and "
      "runs all tests.");
  wrinkle::Action command;
  wrinkle::add_demo(app, command);
  wrinkle::add_render(app, command);
  wrinkle::add_verify(app, command);
  wrinkle::add_stress(app, command);
  wrinkle::add_bench(app, command);
  wrinkle::add_area(app, command);
  wrinkle::add_error(app, command);
  wrinkle::add_speed(app, command);
  wrinkle::add_figures(app, command);
  wrinkle::add_report(app, command);
  wrinkle::add_generate(app, command);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? wrinkle::kExitEqual : wrinkle::kExitBadInput;
  }
  return command();
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const wrinkle::InputError& error) {
    fmt::print(stderr, "wrinkle: {}\n", error.what());
  } catch (const wrinkle::ModelBuildError& error) {
    fmt::print(stderr, "wrinkle: the model could not be built\n{}\n", error.what());
  } catch (const std::exception& error) {
    fmt::print(stderr, "wrinkle: {}\n", error.what());
  }
  return wrinkle::kExitBadInput;
}
