// The program: parses the command line, runs one command, and turns errors into one line and an exit code.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "sim/command.h"
#include "sim/input_error.h"
#include "sim/scene/suggest.h"

namespace {

// "help" and "help COMMAND" are other words for --help; anything else that is no command is told what it is near to.
void check_command(const CLI::App& app, std::vector<std::string>& arguments) {
  if (arguments.empty() || arguments[0].starts_with("-")) return;
  if (arguments[0] == "help") {
    arguments.erase(arguments.begin());
    arguments.push_back("--help");
  }
  std::vector<std::string_view> names;
  for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
  const bool option = arguments[0].starts_with("-");
  if (option || std::find(names.begin(), names.end(), arguments[0]) != names.end()) return;
  throw wrinkle::InputError(wrinkle::Place{"command line"}, "the command \"" + arguments[0] + "\"",
                            wrinkle::list_of(names) + wrinkle::did_you_mean(arguments[0], names));
}

int run(int argc, char** argv) {
  CLI::App app{"Wrinkle: hardware for bump mapping, its bit-exact model, and the bench that compares them."};
  app.name("wrinkle");
  app.require_subcommand(1);
  app.set_version_flag("--version", "wrinkle " WRINKLE_VERSION);
  app.footer(
      "exit code: 0 done and equal, 1 compared and different, 2 bad input\nAlso: ./wrinkle test [--long] builds and "
      "runs all tests, ./wrinkle fuzz [TARGET] the readers under a fuzzer.");
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
  wrinkle::add_config(app, command);
  wrinkle::add_completion(app, command);
  wrinkle::add_generate(app, command);
  std::vector<std::string> arguments(argv + std::min(argc, 1), argv + argc);
  check_command(app, arguments);
  std::reverse(arguments.begin(), arguments.end());  // as CLI11 takes them
  try {
    app.parse(std::move(arguments));
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
  } catch (const std::filesystem::filesystem_error& error) {
    fmt::print(stderr,
               "wrinkle: {}: {}; what is built is kept in the build folder, or in the one that WRINKLE_CACHE names\n",
               error.path1().string(), error.code().message());
  } catch (const std::exception& error) {
    fmt::print(stderr, "wrinkle: {}\n", error.what());
  }
  return wrinkle::kExitBadInput;
}
