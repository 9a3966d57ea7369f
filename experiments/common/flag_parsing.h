#pragma once

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "cirque/core/option_table.h"
#include "cirque/core/status.h"

namespace cirque {

/// The flags of a program: options of tables, bound to the structs that they set.
///
/// As written: --name=value, --name value, --name and --noname of a boolean, each also with one
/// dash; "--" ends them. A misspelt name or a wrong value is a status that says what was meant.
/// Former names go on working, with a word on stderr.
class CommandLine {
 public:
  struct Flag {
    OptionInfo info;  ///< its name without dashes
    std::function<Status(const std::string& text)> set;
    bool value_optional = false;         ///< whether it is "-" when it is given without "=VALUE"
    std::vector<std::string> also = {};  ///< other names that it has: "h" for help
  };

  /// A flag for each option of the table, which sets it in `target`. @pre both outlive this.
  template <class T>
  void Add(const OptionTable<T>& table, T* target) {
    for (const Option<T>& option : table.options()) {
      Add({option.info(), [&option, target](const std::string& text) {
             OptionInfo as_flag = option.info();
             as_flag.name = "--" + as_flag.name;
             const StatusOr<OptionValue> value = ParseValue(as_flag, text);
             return value.ok() ? option.Set(text, target) : value.status();
           }});
    }
  }
  template <class T>
  void Add(OptionTable<T>&& table, T* target) = delete;

  void Add(Flag flag) { flags_.push_back(std::move(flag)); }

  /// --help, --help=TOPIC, -h and --version, as AnswerQuestions (manual.h) takes them.
  void AddQuestions();

  /// Sets what the arguments name; returns the others.
  StatusOr<std::vector<std::string>> Parse(const std::vector<std::string>& arguments);

  /// Whether Parse has met this flag.
  bool IsGiven(const std::string& name) const { return given_.contains(name); }

  /// The topic that --help was given; "" without one, nothing where it was not asked.
  const std::optional<std::string>& help_topic() const { return help_topic_; }

  const std::vector<Flag>& flags() const { return flags_; }
  std::vector<std::string> Names() const;

  /// Whether some flag is called like that, by whatever name.
  bool Knows(const std::string& name) const;

 private:
  struct Argument;

  const Flag* Find(Argument* argument) const;
  Status Set(Argument argument, const std::string* next, bool* took_next);

  std::vector<Flag> flags_;
  std::optional<std::string> help_topic_;
  std::set<std::string> given_, noted_;
};

/// The unit of texts that are names of files.
inline constexpr char kFileUnit[] = "file";

/// "=FILE", "=WORD", "=NUMBER" and the like; "" of a boolean.
std::string ValueName(const OptionInfo& option);

/// What a flag means, may be and is by default, in one line.
std::string Meaning(const OptionInfo& option);

/// The gflags that a program defines in its own sources, and the questions; `source` is a part of
/// their paths, "experiments/run_experiment/". gflags itself would end the process with status 1 on
/// the first mistake. `former`: names that flags had once, and have now.
CommandLine GflagsOf(const std::string& source, const std::vector<std::string>& value_optional = {},
                     const std::map<std::string, std::string>& former = {});

}  // namespace cirque
