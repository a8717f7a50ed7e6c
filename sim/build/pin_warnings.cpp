#include "sim/build/pin_warnings.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>
#include <map>
#include <optional>
#include <set>
#include <string_view>
#include <vector>

#include "sim/build/lexing.h"

namespace robosim::build {
namespace {

/// A word of a text, which can have as many words as characters.
struct Word {
  std::string_view text;  ///< a name, a number, a string's quote, or one character
  std::string_view file;
  int line = 0;
};

std::vector<Word> words_in(const std::string& text) {
  std::vector<Word> words;
  QuoteEnds quote_ends(text);
  std::string_view file;
  int line = 1;
  bool begins = true;  // at the beginning of a line
  for (std::size_t i = 0; i < text.size();) {
    const char c = text[i];
    if (c == '\n') {
      ++line, ++i;
      begins = true;
    } else if (c == '#' && begins) {  // # 12 "name", #line 12 "name"
      const std::size_t end = text.find('\n', i);
      const std::string_view directive = std::string_view(text).substr(i, end - i);
      if (const std::size_t digit = directive.find_first_of("0123456789"); digit != directive.npos)
        line = std::atoi(text.c_str() + i + digit) - 1;
      if (const std::size_t quote = directive.find('"'); quote != directive.npos)
        file = directive.substr(quote + 1, directive.find('"', quote + 1) - quote - 1);
      i = end == std::string::npos ? text.size() : end;
    } else if (std::isspace(static_cast<unsigned char>(c))) {
      ++i;
    } else {
      std::size_t end = i + 1;
      if (c == '"' || c == '\'')
        end = quote_ends.of(i);
      else if (is_of_name(c))
        while (end < text.size() && is_of_name(text[end])) ++end;
      words.push_back({std::string_view(text).substr(i, end - i), file, line});
      i = end;
      begins = false;
    }
  }
  return words;
}

std::optional<int> number_of(std::string_view text) {
  constexpr std::size_t kLongest = 40;
  if (text.size() > kLongest) return std::nullopt;
  const std::string word(text);
  const bool binary = word.rfind("0b", 0) == 0 || word.rfind("0B", 0) == 0;
  const char* begin = word.c_str() + (binary ? 2 : 0);
  char* end = nullptr;
  const long value = std::strtol(begin, &end, binary ? 2 : 0);
  while (end && (*end == 'u' || *end == 'U' || *end == 'l' || *end == 'L')) ++end;
  if (end == begin || *end || value < 0 || value > 255) return std::nullopt;
  return static_cast<int>(value);
}

bool is_name(std::string_view word) {
  return is_of_name(word[0]) && !std::isdigit(static_cast<unsigned char>(word[0]));
}

/// Returns variables that are set exactly once, to a number.
std::map<std::string_view, int> constants_in(const std::vector<Word>& words) {
  std::map<std::string_view, int> found;
  std::set<std::string_view> several;
  for (std::size_t i = 0; i + 2 < words.size(); ++i) {
    const std::string_view name = words[i].text;
    if (!is_name(name)) continue;
    const std::string_view next = words[i + 1].text;
    const bool compares = next == "=" && words[i + 2].text == "=";
    const bool counts =
        (next == "+" || next == "-") && (words[i + 2].text == next || words[i + 2].text == "=");
    const bool counted = i > 1 && (words[i - 1].text == "+" || words[i - 1].text == "-") &&
                         words[i - 2].text == words[i - 1].text;
    const bool shared = i > 0 && words[i - 1].text == "&";
    // A parameter, a member or a local variable of the same name may have any value.
    const bool declared = i > 0 && is_name(words[i - 1].text) &&
                          (next == "," || next == ")" || next == ";" || next == ":" || next == "[");
    if (counts || counted || shared || declared) several.insert(name);
    if (next != "=" || compares) continue;
    const bool alone = i + 3 < words.size() && (words[i + 3].text == ";" || words[i + 3].text == ",");
    const auto value = alone ? number_of(words[i + 2].text) : std::nullopt;
    if (!value || !found.emplace(name, *value).second) several.insert(name);
  }
  for (const std::string_view name : several) found.erase(name);
  return found;
}

enum class Use { digital, analog, pwm };
struct Function {
  const char* name;
  Use use;
};
constexpr std::array kFunctions = {
    Function{"pinMode", Use::digital},     Function{"digitalWrite", Use::digital},
    Function{"digitalRead", Use::digital}, Function{"pulseIn", Use::digital},
    Function{"tone", Use::digital},        Function{"analogWrite", Use::pwm},
    Function{"analogRead", Use::analog},
};

/// Returns the board's pin for the function's argument `pin`; kNoPin = invalid.
Pin pin_on(const BoardSpec& board, int pin, Use use) {
  if (use == Use::analog && pin < board.analog_pin_0) return find_pin(board, fmt::format("A{}", pin).c_str());
  return pin < board.pin_count ? static_cast<Pin>(pin) : kNoPin;
}

std::string boards_with(int pin, Use use) {
  std::vector<std::string> names;
  for (int i = 0; const BoardSpec* board = board_at(i); ++i)
    if (const Pin found = pin_on(*board, pin, use); found != kNoPin && board->pins[found].digital)
      names.emplace_back(board->name);
  if (names.empty()) return "no board in Robosim has one";
  return fmt::format("these boards have one: {}", fmt::join(names, ", "));
}

std::string pwm_pins(const BoardSpec& board) {
  std::vector<std::string> names;
  for (Pin pin = 0; pin < board.pin_count; ++pin)
    if (board.pins[pin].pwm && first_number(board, pin) == pin) names.emplace_back(board.pins[pin].name);
  return fmt::format("{}", fmt::join(names, ", "));
}

/// Returns the problem with using the pin; empty = none.
std::string complaint(const BoardSpec& board, int number, Use use) {
  const Pin pin = pin_on(board, number, use);
  if (pin == kNoPin)
    return fmt::format("the {} has no pin {}; {}", board.name,
                       use == Use::analog && number < board.analog_pin_0 ? fmt::format("A{}", number)
                                                                         : std::to_string(number),
                       boards_with(number, use));
  const PinSpec& spec = board.pins[pin];
  if (use == Use::analog) return "";
  if (!spec.digital)
    return fmt::format("pin {} of the {} can only be read with analogRead()", spec.name, board.name);
  if (use == Use::pwm && !spec.pwm)
    return fmt::format(
        "pin {} of the {} has no PWM: it is LOW below 128 and HIGH otherwise; these pins have PWM: {}",
        spec.name, board.name, pwm_pins(board));
  return "";
}

bool is_number(std::string_view word) {
  return !word.empty() && word.size() < 6 && word.find_first_not_of("0123456789") == word.npos;
}

/// Detects literal calls such as analogWrite(PIN, 300) and analogWrite(PIN, -100).
std::string range_warning(const std::vector<Word>& words, std::size_t at) {
  if (words[at].text != "analogWrite" || words[at + 1].text != "(" || words[at + 3].text != ",") return "";
  std::size_t i = at + 4;
  const bool negative = i < words.size() && words[i].text == "-";
  if (negative) ++i;
  if (i + 1 >= words.size() || !is_number(words[i].text) || words[i + 1].text != ")") return "";
  const int value = (negative ? -1 : 1) * std::stoi(std::string(words[i].text));
  if (value >= 0 && value <= 255) return "";
  return fmt::format(
      "{}:{}: warning: analogWrite({}, {}): expected 0 to 255; on most pins {} has the effect of {}",
      words[at].file, words[at].line, words[at + 2].text, value, value, value & 255);
}

}  // namespace

std::string serial_warning(const std::string& own_lines, const std::string& all, const BoardSpec& board) {
  if (board.chip->uart_count == 0 || board.chip->usb.address || all.find("Serial.begin") != all.npos)
    return "";
  const std::vector<Word> words = words_in(own_lines);
  const Word* first = nullptr;
  for (std::size_t i = 0; i + 2 < words.size(); ++i) {
    if (words[i].text != "Serial") continue;
    if (words[i + 1].text != ".") return "";  // Serial is passed to code that may call begin()
    const std::string_view call = words[i + 2].text;
    if (!first && (call == "print" || call == "println" || call == "write")) first = &words[i];
  }
  if (!first) return "";
  return fmt::format(
      "{}:{}: warning: Serial is never begun, so that nothing is sent: put Serial.begin(9600); into setup()",
      first->file, first->line);
}

std::string pin_warnings(const std::string& own_lines, const BoardSpec& board) {
  const std::vector<Word> words = words_in(own_lines);
  const std::map<std::string_view, int> constants = constants_in(words);
  std::string text;
  std::set<std::string> told;
  const bool may_have_more_bits = std::any_of(
      words.begin(), words.end(), [](const Word& word) { return word.text == "analogWriteResolution"; });
  for (std::size_t i = 1; i + 3 < words.size(); ++i) {
    // Declarations have a type before the name; method calls have a . or ->.
    if (words[i + 1].text != "(" || words[i - 1].text == "." || words[i - 1].text == ">") continue;
    if (const std::string wrong = may_have_more_bits ? "" : range_warning(words, i); !wrong.empty())
      text += (text.empty() ? "" : "\n") + wrong;
    const std::string_view after = words[i + 3].text;
    if (after != "," && after != ")") continue;
    for (const Function& function : kFunctions) {
      if (words[i].text != function.name) continue;
      const std::string_view argument = words[i + 2].text;
      std::optional<int> pin = number_of(argument);
      if (const auto known = constants.find(argument); known != constants.end()) pin = known->second;
      if (!pin && argument[0] == 'A' && number_of(argument.substr(1)))
        if (const Pin named = find_pin(board, std::string(argument).c_str()); named != kNoPin) pin = named;
      if (!pin) continue;
      // analogWrite() with only 0 or 255 needs no PWM.
      const std::string_view value = i + 4 < words.size() ? words[i + 4].text : "";
      const bool plain = function.use == Use::pwm && (value == "0" || value == "255");
      const std::string wrong = complaint(board, *pin, plain ? Use::digital : function.use);
      if (wrong.empty() || !told.insert(wrong).second) continue;
      text += fmt::format("{}{}:{}: warning: {}({}{}: {}", text.empty() ? "" : "\n", words[i].file,
                          words[i].line, function.name, argument, after == "," ? ", …)" : ")", wrong);
    }
  }
  return text;
}

}  // namespace robosim::build
