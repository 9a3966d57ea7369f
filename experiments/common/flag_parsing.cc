#include "experiments/common/flag_parsing.h"

#include <algorithm>
#include <cstdio>

#include <fmt/format.h>
#include <gflags/gflags.h>

#include "cirque/core/text.h"

namespace cirque {
namespace {

std::vector<gflags::CommandLineFlagInfo> FlagsOf(const std::string& source) {
  std::vector<gflags::CommandLineFlagInfo> all, own;
  gflags::GetAllFlags(&all);
  for (const gflags::CommandLineFlagInfo& flag : all) {
    if (flag.filename.find(source) != std::string::npos) own.push_back(flag);
  }
  return own;
}

std::vector<std::string> NamesOf(const std::string& source) {
  std::vector<std::string> names = {"help"};
  for (const gflags::CommandLineFlagInfo& flag : FlagsOf(source)) names.push_back(flag.name);
  return names;
}

/// A flag as written: --name=value, --name value, --name and --noname of a boolean.
struct Argument {
  std::string name, value;
  bool has_value = false;
};

Argument Split(const std::string& text) {
  const std::string body = text.substr(text.starts_with("--") ? 2 : 1);
  const std::size_t equals = body.find('=');
  if (equals == std::string::npos) return {body, "", false};
  return {body.substr(0, equals), body.substr(equals + 1), true};
}

bool FindFlag(Argument* argument, gflags::CommandLineFlagInfo* info) {
  if (gflags::GetCommandLineFlagInfo(argument->name.c_str(), info)) {
    if (!argument->has_value && info->type == "bool") {
      argument->value = "true";
      argument->has_value = true;
    }
    return true;
  }
  const std::string positive =
      argument->name.starts_with("no") ? argument->name.substr(2) : std::string();
  if (argument->has_value || !gflags::GetCommandLineFlagInfo(positive.c_str(), info) ||
      info->type != "bool") {
    return false;
  }
  *argument = {positive, "false", true};
  return true;
}

Status SetFlag(const Argument& argument, const std::string& type) {
  if (!gflags::SetCommandLineOption(argument.name.c_str(), argument.value.c_str()).empty()) {
    return Status();
  }
  return Status::InvalidInput(fmt::format("--{} expects a value of type {}, not '{}'",
                                          argument.name, type, argument.value));
}

void UseNewName(const std::map<std::string, std::string>& former, Argument* argument) {
  const auto renamed = former.find(argument->name);
  if (renamed == former.end()) return;
  fmt::print(stderr, "note: --{} is called --{} now\n", argument->name, renamed->second);
  argument->name = renamed->second;
}

bool Contains(const std::vector<std::string>& words, const std::string& word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

}  // namespace

StatusOr<std::vector<std::string>> ParseFlags(int argc, char** argv, const std::string& source,
                                              const std::vector<std::string>& value_optional,
                                              const std::map<std::string, std::string>& former) {
  std::vector<std::string> others;
  for (int i = 1; i < argc; ++i) {
    const std::string text = argv[i];
    if (text == "--") {
      others.insert(others.end(), argv + i + 1, argv + argc);
      break;
    }
    if (text.size() < 2 || text[0] != '-') {
      others.push_back(text);
      continue;
    }
    Argument argument = Split(text);
    UseNewName(former, &argument);
    gflags::CommandLineFlagInfo info;
    if (!FindFlag(&argument, &info) || !Contains(NamesOf(source), argument.name)) {
      return Status::InvalidInput(UnknownName("flag", argument.name, NamesOf(source)));
    }
    if (!argument.has_value && Contains(value_optional, argument.name)) {
      argument.value = "-";
    } else if (!argument.has_value) {
      if (i + 1 == argc) return Status::InvalidInput("--" + argument.name + " needs a value");
      argument.value = argv[++i];
    }
    if (Status s = SetFlag(argument, info.type); !s.ok()) return s;
  }
  return others;
}

std::string FlagHelp(const std::string& source) {
  std::string text;
  for (const gflags::CommandLineFlagInfo& flag : FlagsOf(source)) {
    const std::string value = flag.type == "bool" ? "" : "=" + flag.type;
    const bool worth_saying = !flag.default_value.empty() && flag.type != "bool";
    std::string fallback = worth_saying ? "; default " + flag.default_value : "";
    if (flag.type == "double")
      fallback = fmt::format("; default {:g}", std::stod(flag.default_value));
    text += fmt::format("  {:<28} {}{}\n", "--" + flag.name + value, flag.description, fallback);
  }
  return text;
}

}  // namespace cirque
