#include "experiments/common/manual.h"

#include <algorithm>
#include <cctype>
#include <cstdio>

#include <fmt/format.h>

#include "cirque/core/text.h"
#include "cirque/core/version.h"

namespace cirque {
namespace {

constexpr std::size_t kIndent = 31, kUsageIndent = 42;
constexpr int kBadTopic = 2;
constexpr char kNoGroup[] = "Options";

using Flags = std::vector<CommandLine::Flag>;

std::string Paragraph(const std::string& text) { return Wrapped("", text, 2); }

std::string Lower(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

std::string GroupOf(const CommandLine::Flag& flag) {
  return flag.info.group.empty() ? kNoGroup : flag.info.group;
}

/// Those that have flags, as the manual orders them.
std::vector<std::string> Groups(const Manual& manual, const CommandLine& line) {
  std::vector<std::string> groups;
  const auto add = [&](const std::string& group) {
    if (std::find(groups.begin(), groups.end(), group) == groups.end()) groups.push_back(group);
  };
  for (const std::string& group : manual.groups) {
    const bool has_flags = std::any_of(line.flags().begin(), line.flags().end(),
                                       [&](const auto& flag) { return GroupOf(flag) == group; });
    if (has_flags) add(group);
  }
  for (const CommandLine::Flag& flag : line.flags()) {
    const bool is_question = flag.info.name == "help" || flag.info.name == "version";
    if (!is_question) add(GroupOf(flag));
  }
  for (const CommandLine::Flag& flag : line.flags()) add(GroupOf(flag));
  return groups;
}

Flags FlagsIn(const CommandLine& line, const std::string& group) {
  Flags flags;
  for (const CommandLine::Flag& flag : line.flags()) {
    if (GroupOf(flag) == group) flags.push_back(flag);
  }
  return flags;
}

std::string Entry(const CommandLine::Flag& flag, const std::string& meaning) {
  std::string value = ValueName(flag.info);
  if (flag.value_optional) value = "[" + value + "]";
  return Wrapped("  --" + flag.info.name + value + " ", meaning, kIndent);
}

std::string GroupHelp(const CommandLine& line, const std::string& group) {
  return "\n" + group + ":\n" + FlagHelp(FlagsIn(line, group));
}

std::string Head(const Manual& manual) {
  std::string text = manual.program + " " + manual.purpose + ".\n\n";
  for (const auto& [arguments, meaning] : manual.usage) {
    text += Wrapped("  " + manual.program + " " + arguments + " ", meaning, kUsageIndent);
  }
  return text;
}

std::string Foot(const Manual& manual) {
  std::string statuses;
  for (const auto& [status, meaning] : manual.statuses) {
    statuses += (statuses.empty() ? "" : "; ") + status + " " + meaning;
  }
  return statuses.empty() ? "" : "\nExit status:\n" + Paragraph(statuses + ".");
}

std::string Rules(const Manual& manual) {
  std::string text;
  for (const std::string& rule : manual.rules) text += "\n" + Paragraph(rule);
  return text;
}

/// The first sentence of what a flag means, and the words that it may be.
std::string Brief(const OptionInfo& flag) {
  const std::size_t end = std::min(flag.help.find("; "), flag.help.find(". "));
  return flag.help.substr(0, end) + (flag.words.empty() ? "" : ": " + Join(flag.words));
}

std::string FirstScreen(const Manual& manual, const CommandLine& line) {
  std::string text = Head(manual) + "\n";
  for (const std::string& name : manual.first) {
    for (const CommandLine::Flag& flag : line.flags()) {
      if (flag.info.name == name) text += Entry(flag, Brief(flag.info));
    }
  }
  const std::string groups = Lower(Join(Groups(manual, line)));
  return text + "\nAll flags: --help=all. Those of one group: --help=GROUP, of\n" +
         Paragraph(groups + ".") + Foot(manual);
}

std::string AllHelp(const Manual& manual, const CommandLine& line) {
  std::string text = Head(manual) + Rules(manual);
  for (const std::string& group : Groups(manual, line)) text += GroupHelp(line, group);
  return text + Foot(manual);
}

/// The text for roff: nothing in it is a request or an escape.
std::string Roff(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '\\') {
      escaped += "\\e";
    } else if (c == '-') {
      escaped += "\\-";
    } else if (c == '~') {
      escaped += "\\(ti";
    } else if (c == '^') {
      escaped += "\\(ha";
    } else if (c == '\'') {
      escaped += "\\(aq";
    } else if (c == '\n') {
      escaped += ' ';
    } else {
      escaped += c;
    }
  }
  return (escaped.starts_with('.') ? "\\&" : "") + escaped;
}

std::string Tagged(const std::string& tag, const std::string& text) {
  return ".TP\n" + tag + "\n" + Roff(text) + "\n";
}

std::string ManEntry(const CommandLine::Flag& flag) {
  std::string tag = "\\fB\\-\\-" + Roff(flag.info.name) + "\\fR";
  const std::string value = ValueName(flag.info);
  if (!value.empty() && flag.value_optional) tag += "[" + Roff(value) + "]";
  if (!value.empty() && !flag.value_optional) tag += Roff(value);
  for (const std::string& name : flag.also) tag += ", \\fB\\-" + Roff(name) + "\\fR";
  return Tagged(tag, Meaning(flag.info));
}

}  // namespace

std::string FlagHelp(const Flags& flags) {
  std::string text;
  for (const CommandLine::Flag& flag : flags) text += Entry(flag, Meaning(flag.info));
  return text;
}

std::string ManPage(const Manual& manual, const CommandLine& line) {
  std::string text = fmt::format(".TH \"{}\" \"1\" \"\" \"cirque {}\" \"Cirque\"\n.nh\n.ad l\n",
                                 Roff(manual.program), Version());
  text += ".SH NAME\n" + Roff(manual.program) + " \\- " + Roff(manual.purpose) + "\n.SH SYNOPSIS\n";
  for (const auto& [arguments, meaning] : manual.usage) {
    text += Tagged("\\fB" + Roff(manual.program) + "\\fR " + Roff(arguments), meaning);
  }
  text += ".SH DESCRIPTION\nThe program " + Roff(manual.purpose) + ".\n";
  for (const std::string& rule : manual.rules) text += ".PP\n" + Roff(rule) + "\n";
  text += ".SH OPTIONS\nEach may be written with one dash or two, and its value behind a blank.\n";
  for (const std::string& group : Groups(manual, line)) {
    text += ".SS " + Roff(group) + "\n";
    for (const CommandLine::Flag& flag : FlagsIn(line, group)) text += ManEntry(flag);
  }
  text += ".SH EXIT STATUS\n";
  for (const auto& [status, meaning] : manual.statuses) text += Tagged(status, meaning);
  return text;
}

StatusOr<std::string> HelpText(const Manual& manual, const CommandLine& line,
                               const std::string& topic) {
  if (topic == "man") return ManPage(manual, line);
  if (topic == "all" || (topic.empty() && manual.first.empty())) return AllHelp(manual, line);
  if (topic.empty()) return FirstScreen(manual, line);
  std::vector<std::string> known = {"all", "man"};
  for (const std::string& group : Groups(manual, line)) {
    if (Lower(group) == Lower(topic)) return GroupHelp(line, group).substr(1);
    known.push_back(Lower(group));
  }
  return Status::InvalidInput(UnknownName("help topic", topic, known));
}

std::optional<int> AnswerQuestions(const Manual& manual, const CommandLine& line,
                                   const std::vector<std::string>& others) {
  if (line.IsGiven("version")) {
    fmt::print("{} {} ({})\n", manual.program, Version(), GitCommit());
    return 0;
  }
  if (!line.help_topic()) return std::nullopt;
  std::string topic = *line.help_topic();
  if (topic.empty() && others.size() == 1) topic = others.front();
  const StatusOr<std::string> text = HelpText(manual, line, topic);
  if (text.ok()) {
    fmt::print("{}", *text);
    return 0;
  }
  fmt::print(stderr, "{}: {}\n", manual.program, text.status().message());
  return kBadTopic;
}

}  // namespace cirque
