#include "sim/run/scenario.h"

#include <fmt/format.h>

#include <array>

#include "sim/base/units.h"

namespace robosim::run {
namespace {

constexpr std::array kVerbs = {"press", "release", "send", "place", "cover", "fault", "power"};

struct Word {
  std::string text;
  bool quoted = false;
  int column = 1;
};

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

// The words of one line, taken from the left.
class Line {
 public:
  Line(std::vector<Word> words, Place place) : words_(std::move(words)), place_(std::move(place)) {}

  bool more() const { return next_ < words_.size(); }
  const Word& take(const char* what) {
    if (!more()) throw InputError(place_, fmt::format("{} is missing at the end of the line", what));
    place_.column = words_[next_].column;
    return words_[next_++];
  }
  [[noreturn]] void refuse(const std::string& message) const { throw InputError(place_, message); }

  SimTime duration() {
    const Word& word = take("a time such as 2s or 100ms");
    const auto ns = parse_duration_ns(word.text);
    if (!ns || word.quoted)
      refuse(fmt::format("\"{}\" is no time; it must be a number with a unit: {}", word.text,
                         unit_names(Dimension::time)));
    return *ns;
  }
  std::optional<SimTime> optional_duration() { return more() ? std::optional(duration()) : std::nullopt; }
  void end() const {
    if (!more()) return;
    Place place = place_;
    place.column = words_[next_].column;
    throw InputError(place,
                     fmt::format("\"{}\" is too much; the line should end before it", words_[next_].text));
  }

 private:
  std::vector<Word> words_;
  std::size_t next_ = 0;
  Place place_;
};

Trigger parse_trigger(Line& line) {
  Trigger trigger;
  const std::string when = line.take("at or after").text;
  if (when == "at") {
    trigger.time = line.duration();
    return trigger;
  }
  if (when != "after")
    line.refuse(fmt::format("a line begins with \"at TIME\" or \"after EVENT\", not with \"{}\"", when));
  const std::string event = line.take("an event: serial or station").text;
  if (event != "serial" && event != "station")
    line.refuse(fmt::format("unknown event \"{}\"; known are serial and station", event));
  trigger.kind = event == "serial" ? Trigger::Kind::serial : Trigger::Kind::station;
  trigger.text = line.take(event == "serial" ? "the text to wait for" : "the station's number or name").text;
  if (trigger.text.empty()) line.refuse("the text to wait for is empty");
  return trigger;
}

// "3" is a byte, most significant bit first; "0b101" is these bits.
std::vector<bool> parse_bits(const Line& line, const std::string& text) {
  constexpr std::size_t kMostBits = 64;
  std::vector<bool> bits;
  if (text.rfind("0b", 0) == 0) {
    const std::string digits = text.substr(2);
    if (!digits.empty() && digits.size() <= kMostBits &&
        digits.find_first_not_of("01") == std::string::npos) {
      for (const char digit : digits) bits.push_back(digit == '1');
      return bits;
    }
  } else if (!text.empty() && text.size() <= 3 && text.find_first_not_of("0123456789") == std::string::npos &&
             std::stoi(text) <= 255) {
    for (int bit = 7; bit >= 0; --bit) bits.push_back((std::stoi(text) >> bit & 1) != 0);
    return bits;
  }
  line.refuse(fmt::format(
      "\"{}\" cannot be sent by radio: allowed are a byte, 0 to 255, and bits such as 0b101, at most {}",
      text, kMostBits));
}

// send "TEXT", or send RADIO BITS.
void parse_send(Line& line, Action& action) {
  const Word first = line.take("the text to send");
  if (first.quoted || !line.more()) {
    action.text = first.text;
    return;
  }
  action.part = first.text;
  action.text = line.take("what to send").text;
  action.bits = parse_bits(line, action.text);
}

Action parse_action(Line& line) {
  Action action;
  const std::string verb = line.take("a verb").text;
  std::size_t index = 0;
  while (index < kVerbs.size() && verb != kVerbs[index]) ++index;
  if (index == kVerbs.size())
    line.refuse(fmt::format("unknown verb \"{}\"; known are {}", verb, one_of(kVerbs)));
  action.verb = static_cast<Action::Verb>(index);
  switch (action.verb) {
    case Action::Verb::press:
    case Action::Verb::cover:
      action.part = line.take("a part's name").text;
      action.duration = line.optional_duration();
      break;
    case Action::Verb::release:
      action.part = line.take("a part's name").text;
      break;
    case Action::Verb::send:
      parse_send(line, action);
      break;
    case Action::Verb::place:
      action.text = line.take("a place as X,Y,DIR").text;
      if (line.more()) action.text += "," + line.take("a direction").text;
      break;
    case Action::Verb::fault:
      action.part = line.take("a part's name").text;
      action.arguments.push_back(line.take("a kind of fault").text);
      while (line.more()) action.arguments.push_back(line.take("an argument").text);
      break;
    case Action::Verb::power:
      action.part = line.take("off or on").text;
      if (action.part != "off" && action.part != "on")
        line.refuse(fmt::format("power is \"off\" or \"on\", not \"{}\"", action.part));
      if (action.part == "off") action.duration = line.optional_duration();
      break;
  }
  line.end();
  return action;
}

}  // namespace

std::vector<Step> parse_scenario(std::string_view text, const std::string& file) {
  std::vector<Step> steps;
  int number = 0;
  while (!text.empty()) {
    ++number;
    const std::size_t end = text.find('\n');
    const std::string_view row = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    const Place place{file, number, 1};
    Line line(split(row, place), place);
    if (!line.more()) continue;
    Step step;
    step.place = {file, number, 0};
    step.trigger = parse_trigger(line);
    step.action = parse_action(line);
    steps.push_back(std::move(step));
  }
  return steps;
}

}  // namespace robosim::run
