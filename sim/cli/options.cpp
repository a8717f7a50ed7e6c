#include "sim/cli/options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <utility>

#include "sim/base/error.h"
#include "sim/base/profile.h"
#include "sim/base/spelling.h"
#include "sim/base/units.h"

namespace robosim::cli {

struct Options::App {
  CLI::App cli;
};

Options::Options(const std::string& command, const std::string& what)
    : command_(command), app_(new App{CLI::App(what, "robosim " + command)}) {
  app_->cli.allow_extras();
  app_->cli.get_formatter()->column_width(28);
  app_->cli.failure_message([](const CLI::App*, const CLI::Error&) { return std::string(); });
}

Options::~Options() = default;

void Options::positional(const char* name, std::string& value, const char* what) {
  app_->cli.add_option(name, value, what)->option_text(" ");
}

void Options::positionals(const char* name, std::vector<std::string>& values, const char* what) {
  app_->cli.add_option(name, values, what)->option_text(" ");
}

void Options::text(const char* name, std::string& value, const char* meta, const char* what) {
  // parse() refuses a second value itself: CLI11's error for one has the same type as for a missing value.
  app_->cli.add_option(name, value, what)->option_text(meta)->take_last();
}

void Options::texts(const char* name, std::vector<std::string>& values, const char* meta, const char* what) {
  app_->cli.add_option(name, values, what)->option_text(meta)->allow_extra_args(false);
}

void Options::lists(const char* name, std::vector<std::string>& values, const char* meta, const char* what) {
  app_->cli.add_option(name, values, what)->option_text(meta);
}

void Options::flag(const char* name, bool& value, const char* what) { app_->cli.add_flag(name, value, what); }

std::optional<std::string> Options::parse(std::vector<std::string> words) {
  const std::string last = words.empty() ? "" : words.back();
  std::reverse(words.begin(), words.end());  // CLI11 needs this order
  try {
    app_->cli.parse(std::move(words));
  } catch (const CLI::CallForHelp&) {
    return app_->cli.help();
  } catch (const CLI::ArgumentMismatch&) {  // an option takes the next word, even another option
    throw InputError(last.substr(0, last.find('=')) + " needs a value after it");
  } catch (const CLI::ParseError& error) {
    throw InputError(command_ + ": " + error.what());
  }
  for (const CLI::Option* option : std::as_const(app_->cli).get_options()) {
    if (option->get_items_expected_max() == 1 && option->count() > 1)
      throw InputError(option->get_name() + " is given more than once");
  }
  for (const std::string& extra : app_->cli.remaining()) refuse(extra);
  return std::nullopt;
}

void Options::refuse(const std::string& word) const {
  const std::string help = "see robosim " + command_ + " --help";
  if (word.empty() || word[0] != '-') {
    throw InputError(fmt::format("{}: “{}” is one word too many; {}", command_, word, help));
  }
  std::vector<std::string> options;
  for (const CLI::Option* option : std::as_const(app_->cli).get_options()) {
    for (const std::string& known : option->get_lnames()) options.push_back("--" + known);
  }
  const auto guess = nearest(word.substr(0, word.find('=')), options);
  throw InputError(fmt::format("{} has no option {}; {}", command_, word,
                               guess ? "did you mean " + *guess + "? (" + help + ")" : help));
}

void refuse_value(const char* option, const std::string& value, const std::string& allowed) {
  throw InputError(fmt::format("{}: “{}” is not possible; it must be {}", option, value, allowed));
}

std::int64_t simulated_time(const char* option, const std::string& text) {
  const auto ns = parse_duration_ns(text);
  if (!ns || *ns <= 0) {
    refuse_value(option, text,
                 "a time above 0 with its unit, as in 60s (" + unit_names(Dimension::time) + ")");
  }
  return *ns;
}

std::uint64_t whole_number(const char* option, const std::string& text, std::uint64_t least,
                           std::uint64_t most) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || value < least || value > most) {
    refuse_value(option, text, fmt::format("a whole number from {} to {}", least, most));
  }
  return value;
}

std::uint64_t seed_number(const std::string& text) { return whole_number("--seed", text, 0, kMostSeed); }

void check_choice(const char* option, const std::string& value, const std::vector<std::string>& allowed) {
  if (std::find(allowed.begin(), allowed.end(), value) == allowed.end()) {
    refuse_value(option, value, one_of(allowed));
  }
}

void check_profile(const std::string& value) {
  check_choice("--profile", value, {kProfileNames.begin(), kProfileNames.end()});
}

}  // namespace robosim::cli
