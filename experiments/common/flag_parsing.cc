#include "experiments/common/flag_parsing.h"

#include <algorithm>
#include <cstdio>

#include <fmt/format.h>
#include <gflags/gflags.h>

#include "cirque/core/text.h"

namespace cirque {
namespace {

constexpr char kHelp[] = "help";

bool Contains(const std::vector<std::string>& words, const std::string& word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

/// All names, as UnknownName has them, would fill the screen.
std::string UnknownFlag(const std::string& name, const std::vector<std::string>& known) {
  const std::string nearest = NearestWord(name, known);
  const std::string hint = nearest.empty()
                               ? "; see --help=all"
                               : fmt::format("; did you mean '{}'? See --help", nearest);
  return fmt::format("unknown flag '{}'{}", name, hint);
}

/// A boolean's value as people write it.
std::string Boolean(const std::string& text) {
  if (Contains({"1", "t", "yes", "y"}, text)) return "true";
  if (Contains({"0", "f", "no", "n"}, text)) return "false";
  return text;
}

}  // namespace

std::string ValueName(const OptionInfo& option) {
  if (option.unit == kFileUnit) return "=FILE";
  switch (option.kind) {
    case OptionKind::kBoolean:
      return "";
    case OptionKind::kInteger:
      return "=INTEGER";
    case OptionKind::kNumber:
      return "=NUMBER";
    case OptionKind::kText:
      return option.words.empty() ? "=TEXT" : "=WORD";
    case OptionKind::kIntegers:
      return "=LIST";
  }
  return "";
}

std::string Meaning(const OptionInfo& option) {
  std::string text = option.help;
  if (!option.unit.empty() && option.unit != kFileUnit) text += fmt::format(" [{}]", option.unit);
  if (!option.words.empty()) text += "; one of " + Join(option.words);
  if (!option.default_text.empty() && option.default_text != "false") {
    text += "; default " + option.default_text;
  }
  return text;
}

/// A flag as written.
struct CommandLine::Argument {
  std::string name, value;
  bool has_value = false;

  explicit Argument(const std::string& text) {
    const std::string body = text.substr(text.starts_with("--") ? 2 : 1);
    const std::size_t equals = body.find('=');
    name = body.substr(0, equals);
    has_value = equals != std::string::npos;
    if (has_value) value = body.substr(equals + 1);
  }
};

const CommandLine::Flag* CommandLine::Find(Argument* argument) const {
  const auto called = [&](const std::string& name) -> const Flag* {
    for (const Flag& flag : flags_) {
      const bool is_it = flag.info.name == name || Contains(flag.also, name);
      if (is_it || Contains(flag.info.former, name)) return &flag;
    }
    return nullptr;
  };
  if (const Flag* flag = called(argument->name)) return flag;
  if (argument->has_value || !argument->name.starts_with("no")) return nullptr;
  const Flag* flag = called(argument->name.substr(2));
  if (!flag || flag->info.kind != OptionKind::kBoolean) return nullptr;
  argument->name = argument->name.substr(2);
  argument->value = "false";
  argument->has_value = true;
  return flag;
}

Status CommandLine::Set(Argument argument, const std::string* next, bool* took_next) {
  const Flag* flag = Find(&argument);
  if (!flag) return Status::InvalidInput(UnknownFlag(argument.name, Names()));
  const OptionInfo& info = flag->info;
  if (Contains(info.former, argument.name) && noted_.insert(argument.name).second) {
    fmt::print(stderr, "note: --{} is called --{} now\n", argument.name, info.name);
  }
  if (!argument.has_value && info.kind == OptionKind::kBoolean) {
    argument.value = "true";
  } else if (!argument.has_value && flag->value_optional) {
    argument.value = "-";
  } else if (!argument.has_value) {
    if (!next) return Status::InvalidInput("--" + info.name + " needs a value");
    argument.value = *next;
    *took_next = true;
  }
  given_.insert(info.name);
  if (info.name == kHelp) help_topic_ = argument.has_value ? argument.value : "";
  return flag->set(info.kind == OptionKind::kBoolean ? Boolean(argument.value) : argument.value);
}

StatusOr<std::vector<std::string>> CommandLine::Parse(const std::vector<std::string>& arguments) {
  std::vector<std::string> others;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::string& text = arguments[i];
    if (text == "--") {
      others.insert(others.end(), arguments.begin() + i + 1, arguments.end());
      break;
    }
    if (text.size() < 2 || text[0] != '-') {
      others.push_back(text);
      continue;
    }
    bool took_next = false;
    const std::string* next = i + 1 < arguments.size() ? &arguments[i + 1] : nullptr;
    if (Status s = Set(Argument(text), next, &took_next); !s.ok()) return s;
    i += took_next ? 1 : 0;
  }
  return others;
}

void CommandLine::AddQuestions() {
  OptionInfo help, version;
  help.name = kHelp;
  help.help =
      "the flags that most people need; =all: every flag; =GROUP: those of one group; =man: "
      "the manual page, for man -l";
  help.group = version.group = "Program";
  version.name = "version";
  version.help = "the version of the program";
  version.kind = OptionKind::kBoolean;
  const auto nothing = [](const std::string&) { return Status(); };
  Add({help, nothing, true, {"h"}});
  Add({version, nothing});
}

bool CommandLine::Knows(const std::string& name) const {
  Argument argument("-" + name);
  return Find(&argument) != nullptr;
}

std::vector<std::string> CommandLine::Names() const {
  std::vector<std::string> names;
  for (const Flag& flag : flags_) names.push_back(flag.info.name);
  return names;
}

namespace {

Status SetGflag(const std::string& name, const std::string& type, const std::string& text) {
  if (!gflags::SetCommandLineOption(name.c_str(), text.c_str()).empty()) return Status();
  return Status::InvalidInput(
      fmt::format("--{} expects a value of type {}, not '{}'", name, type, text));
}

OptionInfo InfoOf(const gflags::CommandLineFlagInfo& flag) {
  OptionInfo info;
  info.name = flag.name;
  info.help = flag.description;
  info.default_text = flag.default_value;
  if (flag.type == "bool") info.kind = OptionKind::kBoolean;
  if (flag.type == "int32") info.kind = OptionKind::kInteger;
  if (flag.type == "double") {
    info.kind = OptionKind::kNumber;
    info.default_text = fmt::format("{:g}", std::stod(flag.default_value));
  }
  return info;
}

}  // namespace

CommandLine GflagsOf(const std::string& source, const std::vector<std::string>& value_optional,
                     const std::map<std::string, std::string>& former) {
  std::vector<gflags::CommandLineFlagInfo> all;
  gflags::GetAllFlags(&all);
  CommandLine flags;
  for (const gflags::CommandLineFlagInfo& flag : all) {
    if (flag.filename.find(source) == std::string::npos) continue;
    OptionInfo info = InfoOf(flag);
    for (const auto& [once, now] : former) {
      if (now == flag.name) info.former.push_back(once);
    }
    const auto set = [name = flag.name, type = flag.type](const std::string& text) {
      return SetGflag(name, type, text);
    };
    flags.Add({info, set, Contains(value_optional, flag.name)});
  }
  flags.AddQuestions();
  return flags;
}

}  // namespace cirque
