#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cirque/core/status.h"

#include "experiments/common/flag_parsing.h"

namespace cirque {

/// What a program says of itself; its help and its manual page are made of this and of its flags.
struct Manual {
  using Entry = std::pair<std::string, std::string>;

  std::string program;             ///< "verify_map"
  std::string purpose;             ///< "checks a UV map": the line of `man -k`, without a full stop
  std::vector<Entry> usage;        ///< arguments of a call, and what it does
  std::vector<std::string> rules;  ///< paragraphs on what holds for every call
  std::vector<Entry> statuses;     ///< exit status and what it means
  /// Flags on the first screen, as most people need no others; empty: all.
  std::vector<std::string> first = {};
  /// The groups of flags in the order to show them in; the others follow.
  std::vector<std::string> groups = {};
};

/// The help on a topic, in lines of at most 100 columns: "": the first screen, "all": every flag, a
/// group's name in any spelling of case, or "man": the manual page. Error: another topic.
StatusOr<std::string> HelpText(const Manual& manual, const CommandLine& line,
                               const std::string& topic);

/// A page for man(1), in its macros.
std::string ManPage(const Manual& manual, const CommandLine& line);

/// Entries of these flags without headings: "  --NAME=VALUE   meaning".
std::string FlagHelp(const std::vector<CommandLine::Flag>& flags);

/// Prints what --help, -h or --version ask, and returns the exit status; nothing where they were not
/// given. `others` are the arguments that are no flags: "--help cones" is "--help=cones".
std::optional<int> AnswerQuestions(const Manual& manual, const CommandLine& line,
                                   const std::vector<std::string>& others);

}  // namespace cirque
