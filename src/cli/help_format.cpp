#include "cli/help_format.h"

#include <CLI/CLI.hpp>
#include <string>

namespace truelux {
namespace {

class HelpFormatter final : public CLI::Formatter {
 public:
  std::string make_option_name(const CLI::Option* option,
                               bool is_positional) const override {
    std::string name = CLI::Formatter::make_option_name(option, is_positional);
    const std::size_t comma = name.find(",-");
    if (comma != std::string::npos) name.insert(comma + 1, " ");
    return name;
  }
};

}  // namespace

std::shared_ptr<CLI::FormatterBase> MakeHelpFormatter() {
  auto formatter = std::make_shared<HelpFormatter>();
  formatter->label("Positionals", "Arguments");
  formatter->label("REQUIRED", "");
  formatter->label("SUBCOMMAND", "COMMAND");
  return formatter;
}

}  // namespace truelux
