// How help texts look, for readers and for help2man.

#ifndef TRUELUX_CLI_HELP_FORMAT_H_
#define TRUELUX_CLI_HELP_FORMAT_H_

#include <memory>

namespace CLI {  // NOLINT(readability-identifier-naming): CLI11's name
class FormatterBase;
}

namespace truelux {

/// For CLI::App::formatter, before commands are added. A blank follows the
/// comma of "-o, --output", as manual pages are made to expect.
std::shared_ptr<CLI::FormatterBase> MakeHelpFormatter();

}  // namespace truelux

#endif  // TRUELUX_CLI_HELP_FORMAT_H_
