#include "sim/scenario/script_line.h"

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
          fmt::format("unknown escape \\{} in a text; known are \\n, \\r, \\t, \\0, \\\\ and \\\"", c));
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
        if (i >= line.size()) throw InputError(place, "a text in double quotes is not closed");
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
  if (!more()) throw InputError(place_, fmt::format("{} is missing at the end of the line", what));
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
    refuse(fmt::format("\"{}\" is no time; it must be a number with a unit: {}", word.text,
                       unit_names(Dimension::time)));
  return *ns;
}

std::optional<SimTime> ScriptLine::optional_duration() {
  const bool announced = take_if("for");
  if (!announced && !more()) return std::nullopt;
  const SimTime time = duration();
  if (time < kTick) refuse("what is to end by itself lasts for 1ms at least");
  return time;
}

double ScriptLine::quantity(const char* what, Dimension dimension, double least, double most) {
  const Word& word = take(what);
  const auto value = parse_quantity(word.text, dimension);
  if (!value || word.quoted || *value < least || *value > most)
    refuse(fmt::format("\"{}\" is not {}", word.text, what));
  return *value;
}

std::uint64_t ScriptLine::whole(const char* what, std::uint64_t least, std::uint64_t most) {
  const Word& word = take(what);
  const auto number = parse_whole(word.text);
  if (!number || word.quoted || *number < least || *number > most)
    refuse(fmt::format("\"{}\" is not {}: allowed are {} to {}", word.text, what, least, most));
  return *number;
}

void ScriptLine::refuse(const std::string& message) const { throw InputError(place_, message); }

void ScriptLine::end() const {
  if (!more()) return;
  Place place = place_;
  place.column = words_[next_].column;
  throw InputError(place,
                   fmt::format("\"{}\" is too much; the line should end before it", words_[next_].text));
}

}  // namespace robosim::scenario
