#include "sim/run/scenario/script_line.h"

#include <fmt/format.h>

namespace robosim::scenario {
namespace {

char unescape(char c, const Place& place) {
  switch (c) {
    case 'n':
      return '\n';
    case 'r':
      return '\r';
    case 't':
      return '\t';
    case '0':
      return '\0';
    case '\\':
    case '"':
      return c;
    default:
      throw InputError(
          place,
          fmt::format("unknown escape in a text: expected \\n, \\r, \\t, \\0, \\\\ or \\\", got \\{}", c));
  }
}

std::vector<Word> split(std::string_view line, Place place) {
  std::vector<Word> words;
  std::size_t i = 0;
  while (i < line.size()) {
    if (line[i] == ' ' || line[i] == '\t' || line[i] == '\r') {
      ++i;
      continue;
    }
    if (line[i] == '#') break;
    Word word;
    word.column = static_cast<int>(i) + 1;
    if (line[i] == '"') {
      word.quoted = true;
      for (++i;; ++i) {
        place.column = word.column;
        if (i >= line.size()) throw InputError(place, "unterminated text: expected a closing double quote");
        if (line[i] == '"') break;
        if (line[i] == '\\' && i + 1 < line.size()) {
          word.text += unescape(line[++i], place);
        } else {
          word.text += line[i];
        }
      }
      ++i;
    } else {
      while (i < line.size() && line[i] != ' ' && line[i] != '\t' && line[i] != '\r' && line[i] != '#')
        word.text += line[i++];
    }
    words.push_back(std::move(word));
  }
  return words;
}

}  // namespace

ScriptLine::ScriptLine(std::string_view line, Place place, const Share& share)
    : words_(split(line, place)), place_(std::move(place)) {
  std::size_t figures = 0;
  for (Word& word : words_) {
    if (word.quoted || !has_spread(word.text)) continue;
    word.text = with_shares(word.text, share, figures, {place_.file, place_.line, word.column});
    varies_ = true;
  }
}

bool ScriptLine::next_is(std::string_view word) const {
  return more() && !words_[next_].quoted && words_[next_].text == word;
}

const Word& ScriptLine::take(const char* what) {
  if (!more()) throw InputError(place_, fmt::format("the line ends too early: expected {}", what));
  place_.column = words_[next_].column;
  return words_[next_++];
}

bool ScriptLine::take_if(std::string_view word) {
  if (!next_is(word)) return false;
  place_.column = words_[next_++].column;
  return true;
}

SimTime ScriptLine::duration() {
  const Word& word = take("a time such as 2s or 100ms");
  const auto ns = parse_duration_ns(word.text);
  if (!ns || word.quoted)
    refuse(fmt::format("invalid time: expected a number with a unit ({}), got \"{}\"",
                       unit_names(Dimension::time), word.text));
  return *ns;
}

std::optional<SimTime> ScriptLine::optional_duration() {
  const bool announced = take_if("for");
  if (!announced && !more()) return std::nullopt;
  const SimTime time = duration();
  if (time < kTick) refuse("the duration is too short: expected at least 1ms");
  return time;
}

double ScriptLine::quantity(const char* what, Dimension dimension, double least, double most) {
  const Word& word = take(what);
  const auto value = parse_quantity(word.text, dimension);
  if (!value || word.quoted || *value < least || *value > most)
    refuse(fmt::format("expected {}, got \"{}\"", what, word.text));
  return *value;
}

std::uint64_t ScriptLine::whole(const char* what, std::uint64_t least, std::uint64_t most) {
  const Word& word = take(what);
  const auto number = parse_unsigned(word.text);
  if (!number || word.quoted || *number < least || *number > most)
    refuse(fmt::format("expected {} from {} to {}, got \"{}\"", what, least, most, word.text));
  return *number;
}

void ScriptLine::refuse(const std::string& message) const { throw InputError(place_, message); }

void ScriptLine::end() const {
  if (!more()) return;
  Place place = place_;
  place.column = words_[next_].column;
  throw InputError(place, fmt::format("unexpected \"{}\": expected the end of the line", words_[next_].text));
}

}  // namespace robosim::scenario
