// The options that say how an oracle answers, for all commands that ask one.

#ifndef TRUELUX_CLI_ORACLE_ARGUMENTS_H_
#define TRUELUX_CLI_ORACLE_ARGUMENTS_H_

#include <string>
#include <string_view>
#include <vector>

#include "truelux/irradiance.h"

namespace CLI {  // NOLINT(readability-identifier-naming): CLI11's name
class App;
class Option;
}  // namespace CLI

namespace truelux {

/// An option whose default is the value that `word` has now.
CLI::Option& AddWord(CLI::App& command, const char* name, std::string& word,
                     const std::string& help);

/// The same for an option that takes one of some words; the parser refuses all
/// others.
CLI::Option& AddChoice(CLI::App& command, const char* name, std::string& word,
                       const std::vector<std::string_view>& choices,
                       const std::string& help);

/// Each adds an option and sets `word` to its default; the parser then puts
/// the user's word there.
void AddMethodOption(CLI::App& command, std::string& word);
void AddEngineOption(CLI::App& command, std::string& word);
void AddEmissionOption(CLI::App& command, std::string& word);
void AddThreadsOption(CLI::App& command, std::string& word);

/// What the words mean, once the parser has accepted them.
Method MethodOf(const std::string& word);
Engine EngineOf(const std::string& word);
Emission EmissionOf(const std::string& word);
/// Throws UsageError if it is not a number of threads.
int ThreadsOf(const std::string& word);

}  // namespace truelux

#endif  // TRUELUX_CLI_ORACLE_ARGUMENTS_H_
