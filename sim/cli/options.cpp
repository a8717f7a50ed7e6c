#include "sim/cli/options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <utility>

#include "sim/base/did_you_mean.h"
#include "sim/base/error.h"
#include "sim/base/goal_forms.h"
#include "sim/base/profile.h"
#include "sim/base/units.h"

namespace robosim::cli {

Options::Options(const std::string& command, const std::string& summary, const std::string& details) {
  help_.name = command;
  help_.summary = summary;
  help_.details = details;
}

void Options::add_positional(const std::string& name, Taker taker, const char* what, PossibleValues values) {
  OptionHelp help{name, "", what, std::move(values), taker.several != nullptr, name[0] != '['};
  if (!help.is_required) help.name = name.substr(1, name.size() - 2);
  help_.arguments.push_back(std::move(help));
  arguments_.push_back(taker);
}

void Options::add_option(OptionHelp help, Taker taker) {
  help_.options.push_back(std::move(help));
  options_.push_back(taker);
}

void Options::positional(const std::string& name, std::string& value, const char* what,
                         PossibleValues values) {
  add_positional(name, {&value}, what, std::move(values));
}

void Options::positionals(const std::string& name, std::vector<std::string>& values, const char* what,
                          PossibleValues possible) {
  add_positional(name, {nullptr, &values}, what, std::move(possible));
}

void Options::text(const char* name, std::string& value, const char* meta, const char* what,
                   PossibleValues values) {
  add_option({name, meta, what, std::move(values)}, {&value});
}

void Options::texts(const char* name, std::vector<std::string>& values, const char* meta, const char* what,
                    PossibleValues possible) {
  add_option({name, meta, what, std::move(possible)}, {nullptr, &values});
}

void Options::lists(const char* name, std::vector<std::string>& values, const char* meta, const char* what,
                    PossibleValues possible) {
  add_option({name, meta, what, std::move(possible), true}, {nullptr, &values});
}

void Options::flag(const char* name, bool& value, const char* what) {
  add_option({name, "", what, {}}, {nullptr, nullptr, &value});
}

std::optional<PrintText> Options::parse(std::vector<std::string> words) {
  const auto help = [&] { return PrintText{help_text(help_), help_}; };
  if (words.size() == 1 && (words[0] == "--help" || words[0] == "-h")) return help();
  CLI::App app;
  app.allow_extras();
  for (std::size_t i = 0; i < arguments_.size(); ++i) {
    const std::string& name = help_.arguments[i].name;
    if (arguments_[i].one) app.add_option(name, *arguments_[i].one);
    if (arguments_[i].several) app.add_option(name, *arguments_[i].several);
  }
  for (std::size_t i = 0; i < options_.size(); ++i) {
    const OptionHelp& option = help_.options[i];
    if (options_[i].flag) app.add_flag(option.name, *options_[i].flag);
    // Takes the last value, and rejects repeated options below. CLI11 itself would throw the same exception
    // for a repeated option as for a missing value.
    if (options_[i].one) app.add_option(option.name, *options_[i].one)->take_last();
    if (!options_[i].several) continue;
    CLI::Option* several = app.add_option(option.name, *options_[i].several);
    if (!option.is_list) several->allow_extra_args(false);
  }
  const std::string last = words.empty() ? "" : words.back();
  std::reverse(words.begin(), words.end());  // CLI11 expects the last word first
  try {
    app.parse(std::move(words));
  } catch (const CLI::CallForHelp&) {
    return help();
  } catch (const CLI::ArgumentMismatch&) {  // only if the last word is an option without a value
    refuse_missing_value(last.substr(0, last.find('=')));
  } catch (const CLI::ParseError& error) {
    throw InputError(fmt::format("{}: {}", help_.name, error.what()));
  }
  for (const CLI::Option* option : std::as_const(app).get_options()) {
    if (option->get_items_expected_max() == 1 && option->count() > 1)
      throw InputError(option->get_name() + " is given more than once");
  }
  for (const std::string& extra : app.remaining()) refuse(extra);
  return std::nullopt;
}

void Options::refuse_missing_value(const std::string& option) const {
  for (const OptionHelp& known : help_.options)
    if (known.name == option)
      throw InputError(fmt::format("{0} requires a value: expected {0} {1}", option, known.meta));
  throw InputError(option + " requires a value");
}

void Options::refuse(const std::string& word) const {
  if (word.empty() || word[0] != '-')
    throw InputError(fmt::format("{0}: unexpected argument “{1}”; see robosim help {0}", help_.name, word));
  std::vector<std::string> options{"--help"};
  for (const OptionHelp& option : help_.options) options.push_back(option.name);
  const std::string meant = did_you_mean(word.substr(0, word.find('=')), options);
  throw InputError(fmt::format("{0}: unknown option {1}{2}{3} robosim help {0}", help_.name, word, meant,
                               meant.empty() ? "; see" : " See"));
}

PossibleValues targets() { return PossibleValues::of({"host", "avr", "stm32"}); }
PossibleValues profiles() { return PossibleValues::of({kProfileNames.begin(), kProfileNames.end()}); }
PossibleValues goals() { return PossibleValues::of({kGoalForms.begin(), kGoalForms.end()}); }

}  // namespace robosim::cli
