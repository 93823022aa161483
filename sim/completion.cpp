// completion: what a shell needs to complete our commands, from the tables that --help is made from.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <memory>

#include "sim/command.h"
#include "sim/config_file.h"
#include "sim/input_error.h"

namespace wrinkle {
namespace {

// The options of a command, each in all its spellings.
std::vector<std::string> options_of(const CLI::App& command) {
  std::vector<std::string> words;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) words.push_back("--" + name);
    for (const std::string& name : option->get_snames()) words.push_back("-" + name);
  }
  std::sort(words.begin(), words.end());
  return words;
}

std::vector<std::string> commands_of(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
  names.push_back("help");
  return names;
}

std::string names() { return fmt::format("{} {}", fmt::join(named_scenes(), " "), fmt::join(named_configs(), " ")); }

// Words by the command that stands first; names of files wherever none fits.
std::string bash(const CLI::App& app) {
  std::string text = "_wrinkle() {\n  local word=${COMP_WORDS[COMP_CWORD]} words\n  case ${COMP_WORDS[1]} in\n";
  for (const CLI::App* command : app.get_subcommands({}))
    text +=
        fmt::format("    {}) words=\"{} {}\" ;;\n", command->get_name(), fmt::join(options_of(*command), " "), names());
  text += fmt::format("    *) words=\"{}\" ;;\n  esac\n", fmt::join(commands_of(app), " "));
  text += fmt::format("  [[ $COMP_CWORD == 1 ]] && words=\"{}\"\n", fmt::join(commands_of(app), " "));
  return text +
         "  mapfile -t COMPREPLY < <(compgen -W \"$words\" -- \"$word\")\n}\n"
         "complete -o bashdefault -o default -F _wrinkle wrinkle ./wrinkle\n";
}

std::string zsh(const CLI::App& app) {
  return "#compdef wrinkle\nautoload -U +X bashcompinit && bashcompinit\n" + bash(app);
}

// What stands in single quotes of fish.
std::string quoted(std::string text) {
  std::string result = "'";
  for (const char c : text.substr(0, text.find('\n'))) {
    if (c == '\'' || c == '\\') result += '\\';
    result += c;
  }
  return result + "'";
}

std::string fish(const CLI::App& app) {
  std::string text;
  for (const CLI::App* command : app.get_subcommands({})) {
    const std::string name = command->get_name();
    text += fmt::format("complete -c wrinkle -n __fish_use_subcommand -a {} -d {}\n", name,
                        quoted(command->get_description()));
    for (const CLI::Option* option : command->get_options()) {
      for (const std::string& word : option->get_lnames())
        text += fmt::format("complete -c wrinkle -n '__fish_seen_subcommand_from {}' -l {} -d {}\n", name, word,
                            quoted(option->get_description()));
    }
    text += fmt::format("complete -c wrinkle -n '__fish_seen_subcommand_from {}' -a '{}'\n", name, names());
  }
  return text;
}

int print(const CLI::App& app, const std::string& shell) {
  if (shell == "bash") {
    fmt::print("{}", bash(app));
  } else if (shell == "zsh") {
    fmt::print("{}", zsh(app));
  } else if (shell == "fish") {
    fmt::print("{}", fish(app));
  } else {
    throw InputError(Place{"completion"}, "\"" + shell + "\"", "\"bash\", \"zsh\" or \"fish\"");
  }
  return kExitEqual;
}

}  // namespace

void add_completion(CLI::App& app, Action& run) {
  auto shell = std::make_shared<std::string>();
  CLI::App* command =
      app.add_subcommand("completion", "Completion of commands for a shell: source <(wrinkle completion bash)");
  command->add_option("SHELL", *shell, "bash, zsh or fish")->required();
  command->callback([shell, &app, &run] { run = [shell, &app] { return print(app, *shell); }; });
}

}  // namespace wrinkle
