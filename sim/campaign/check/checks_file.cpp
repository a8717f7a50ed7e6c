#include "sim/campaign/check/checks_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <set>
#include <utility>

#include "sim/base/config.h"
#include "sim/base/did_you_mean.h"
#include "sim/base/escaped.h"
#include "sim/base/file.h"
#include "sim/base/file_kind.h"
#include "sim/base/option_values.h"
#include "sim/launch/fleet.h"
#include "sim/launch/names.h"

namespace robosim::campaign {
namespace fs = std::filesystem;

namespace {

/// The meaning of a word in the file. `sent` is a text that is sent to the sketch. Paths are relative to the
/// file's folder.
enum class Text { plain, name_or_path, path, sent };

const std::vector<std::string> kVerdicts{"reached", "lost",    "stuck",       "toppled", "hung",
                                         "ended",   "crashed", "over_budget", "timeout"};

/// Returns a value as a user would type it after its flag.
std::string word_of(const ConfigValue& value, const char* key) {
  if (value.kind == ConfigValue::Kind::integer) return std::to_string(value.integer);
  if (value.kind == ConfigValue::Kind::number) return fmt::format("{}", value.number);
  const std::string& word = as_string(value, key);
  if (word.empty())
    throw InputError(value.place, fmt::format("{}: expected a word, got an empty string; omit the key", key));
  return word;
}

/// Returns the words of a string or an array of strings.
std::vector<std::string> words_of(const ConfigValue& value, const char* key) {
  if (value.kind != ConfigValue::Kind::array) return {word_of(value, key)};
  std::vector<std::string> words;
  for (const ConfigValue& item : value.items) words.push_back(word_of(item, key));
  return words;
}

std::vector<std::string> words_at(TableReader& reader, const char* key) {
  const ConfigValue* value = reader.find(key);
  return value ? words_of(*value, key) : std::vector<std::string>{};
}

/// Converts "--min-rate" in a message to "min-rate".
std::string without_hyphens(const std::string& text) {
  std::string plain;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool flag = text.compare(i, 2, "--") == 0 && i + 2 < text.size() &&
                      std::islower(static_cast<unsigned char>(text[i + 2]));
    if (flag) ++i;
    if (!flag) plain += text[i];
  }
  return plain;
}

class CheckReader {
 public:
  CheckReader(const ConfigValue& table, fs::path folder)
      : reader_(table, "[[check]]"), folder_(std::move(folder)) {}

  Check check() {
    Check check;
    check.place = reader_.table().place;
    check.name = as_string(reader_.require("name"), "name");
    if (check.name.empty())
      throw InputError(check.place, "name: expected a description of the check, got an empty string");
    check.sweep = sweep();
    check.fleet = fleet();
    check.expect = words_at(reader_, "expect");
    for (const std::string& verdict : check.expect) {
      if (std::find(kVerdicts.begin(), kVerdicts.end(), verdict) == kVerdicts.end()) {
        throw InputError(reader_.table().find("expect")->place,
                         fmt::format("expect: {}", expected_one_of(verdict, kVerdicts)));
      }
    }
    if (check.expect.empty()) check.expect = {"reached"};
    for (const Figure& figure : figures()) add_limit(figure, check);
    check.detect = !check.sweep.each.sanitize;
    if (const ConfigValue* value = reader_.find("detect")) {
      check.detect = as_boolean(*value, "detect");
      if (check.detect && check.sweep.each.sanitize)
        throw InputError(
            value->place,
            "detect and sanitize exclude each other, because detect watches the sketch as flashed; write two "
            "checks");
    }
    check.serial = words_at(reader_, "serial");
    check.shows = words_at(reader_, "shows");
    check.stations = words_at(reader_, "stations");
    reader_.finish();
    return check;
  }

 private:
  /// Returns the argument of a flag. Paths in the file are relative to the file's folder.
  std::string flag_word(const std::string& word, Text text) const {
    if (text == Text::sent) return escaped(word);
    if (text == Text::plain || (text == Text::name_or_path && !launch::is_path(word))) return word;
    return launch::path_from(folder_, word);
  }

  std::string fleet() {
    const ConfigValue* value = reader_.find("fleet");
    if (!value) return "";
    const std::string word = word_of(*value, "fleet");
    if (!launch::is_fleet_file(word))
      throw InputError(value->place,
                       fmt::format("fleet: expected a .toml file with [[agent]], got “{}”", word));
    return flag_word(word, Text::path);
  }

  /// Reads the keys that are flags of `run` and `sweep`. A key is the flag's name without the hyphens.
  SweepOptions sweep() {
    SweepOptions sweep;
    SweepTexts texts;
    launch::RunTexts run;
    launch::RunSettings& each = sweep.each;
    read_words("map", Text::name_or_path, sweep.maps);
    read_words("robot", Text::name_or_path, sweep.robots);
    read_words("target", Text::plain, sweep.targets);
    read_words("send", Text::sent, each.send);
    read_words("libraries", Text::path, each.libraries);
    read_word("start", Text::plain, each.request.start);
    read_word("goal", Text::plain, each.request.goal);
    read_word("for", Text::plain, run.duration);
    read_word("clock", Text::plain, run.clock);
    read_word("profile", Text::plain, each.request.profile);
    read_word("script", Text::path, each.script);
    read_word("env", Text::plain, each.environment);
    read_word("min-rate", Text::plain, texts.min_rate);
    read_flag("sanitize", each.sanitize);
    read_flag("sure", sweep.sure);
    read_flag("stop-early", sweep.stop_early);
    read_word("seeds", Text::plain, texts.seeds);
    if (const auto seed = only_seed()) texts.seeds = *seed;
    try {
      take(run, each);
      take(texts, sweep);
    } catch (const InputError& error) {
      throw InputError(place_of(error.message()), without_hyphens(error.message()));
    }
    return sweep;
  }

  void read_word(const char* key, Text text, std::string& word) {
    if (const ConfigValue* value = reader_.find(key)) word = flag_word(word_of(*value, key), text);
  }
  void read_words(const char* key, Text text, std::vector<std::string>& words) {
    for (const std::string& word : words_at(reader_, key)) words.push_back(flag_word(word, text));
  }
  void read_flag(const char* key, bool& flag) {
    if (const ConfigValue* value = reader_.find(key)) flag = as_boolean(*value, key);
  }

  /// Returns the value of the key `seed`. Returns 1 if neither `seed` nor `seeds` is given, and nullopt if
  /// `seeds` is given.
  std::optional<std::string> only_seed() {
    const ConfigValue* seed = reader_.find("seed");
    const ConfigValue* seeds = reader_.table().find("seeds");
    if (seed && seeds)
      throw InputError(seed->place, "seed and seeds exclude each other; give one of the keys");
    if (!seed) return seeds ? std::nullopt : std::optional<std::string>("1");
    const std::string word = word_of(*seed, "seed");
    try {
      whole_number("seed", word, 0, kMostSeed);
    } catch (const InputError& error) {
      throw InputError(seed->place, error.message());
    }
    return word;
  }

  /// Returns the place of the key whose flag is the first word of the message.
  Place place_of(const std::string& message) const {
    if (!message.starts_with("--")) return reader_.table().place;
    const std::string key = message.substr(2, message.find_first_of(": ") - 2);
    const ConfigValue* value = reader_.table().find(key);
    return value ? value->place : reader_.table().place;
  }

  void add_limit(const Figure& figure, Check& check) {
    const ConfigValue* value = reader_.find(figure.name);
    if (!value) return;
    if (value->kind != ConfigValue::Kind::table) {
      throw InputError(value->place, fmt::format("{}: expected a table with min, max or both, as in {{ max = "
                                                 "10 }}, got {}",
                                                 figure.name, to_string(value->kind)));
    }
    TableReader limits(*value, figure.name);
    FigureLimit limit{&figure, {}, {}};
    for (const auto& [key, end] : {std::pair{"min", &limit.min}, {"max", &limit.max}}) {
      const ConfigValue* number = limits.find(key);
      if (!number) continue;
      if (number->kind != ConfigValue::Kind::integer && number->kind != ConfigValue::Kind::number) {
        throw InputError(
            number->place,
            fmt::format("{} of {}: expected a number, in the unit that ends the key's name, got {}", key,
                        figure.name, to_string(number->kind)));
      }
      *end = number->number;
    }
    limits.finish();
    if (!limit.min && !limit.max)
      throw InputError(value->place,
                       fmt::format("{} requires min, max or both, as in {{ max = 10 }}", figure.name));
    const std::vector<std::string>& targets = check.sweep.targets;
    const bool on_host =
        targets.empty() || std::find(targets.begin(), targets.end(), "host") != targets.end();
    if (figure.chip_only && on_host) {
      throw InputError(value->place,
                       fmt::format("{} requires a chip target, but this check runs on the host; add target = "
                                   "\"avr\"",
                                   figure.name));
    }
    check.limits.push_back(limit);
  }

  TableReader reader_;
  fs::path folder_;
};

}  // namespace

std::vector<TextAssertion> text_assertions_in(const fs::path& file) {
  std::error_code error;
  if (!fs::exists(file, error)) return {};
  const ConfigValue root = parse_toml(read_file(file), file.string());
  TableReader reader(root, file.filename().string());
  return read_text_assertions(reader);
}

std::vector<Check> read_checks(const fs::path& file) {
  const std::string text = read_file(file);
  return read_as(FileKind::checks, text, file.string(), [&] { return parse_checks(text, file); });
}

std::vector<Check> parse_checks(std::string_view text, const fs::path& file) {
  const ConfigValue root = parse_toml(text, file.string());
  TableReader reader(root, file.filename().string());
  const std::vector<TextAssertion> assertions = read_text_assertions(reader);
  const ConfigValue* tables = reader.find("check");
  reader.finish();
  if (!tables || tables->kind != ConfigValue::Kind::array || tables->items.empty())
    throw InputError({file.string(), 0, 0}, "expected at least one [[check]]");
  std::vector<Check> checks;
  std::set<std::string> names;
  for (const ConfigValue& table : tables->items) {
    checks.push_back(CheckReader(table, file.parent_path()).check());
    checks.back().assertions = assertions;
    if (!names.insert(checks.back().name).second)
      throw InputError(checks.back().place, fmt::format("duplicate check name “{}”", checks.back().name));
  }
  return checks;
}

}  // namespace robosim::campaign
