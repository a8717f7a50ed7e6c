#include "sim/build/pin_warnings.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>
#include <string_view>
#include <vector>

#include "sim/build/tokens.h"

namespace robosim::build {
namespace {

enum class Use { digital, analog, pwm, interrupt };
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

/// Returns the names of the pins that `has` accepts.
template <typename Has>
std::string pins_that(const BoardSpec& board, Has has) {
  std::vector<std::string> names;
  for (Pin pin = 0; pin < board.pin_count; ++pin)
    if (has(board.pins[pin]) && first_number(board, pin) == pin) names.emplace_back(board.pins[pin].name);
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
        "pin {} of the {} has no PWM: it is LOW for values below 128, and HIGH otherwise; these pins have "
        "PWM: {}",
        spec.name, board.name, pins_that(board, [](const PinSpec& one) { return one.pwm; }));
  if (use == Use::interrupt && spec.interrupt < 0)
    return fmt::format(
        "pin {} of the {} has no external interrupt: its handler never runs; these pins have one: {}",
        spec.name, board.name, interrupt_pins(board));
  return "";
}

/// Returns the value of a number, of a constant, or of a pin's name such as A5.
std::optional<int> value_of(std::string_view word, const std::map<std::string_view, int>& constants,
                            const BoardSpec& board) {
  if (const auto known = constants.find(word); known != constants.end()) return known->second;
  if (const auto number = number_of(word)) return number;
  if (word[0] == 'A' && number_of(word.substr(1)))
    if (const Pin named = find_pin(board, std::string(word).c_str()); named != kNoPin) return named;
  return std::nullopt;
}

/// Returns the pin in the macro digitalPinToInterrupt(pin), whose expansion begins at `at`. In all cores, the
/// expansion compares the pin with numbers, and ends with -1: `((pin) == 2 ? 0 : ((pin) == 3 ? 1 : -1))`.
/// Returns an empty text for other expressions.
std::string_view pin_of_expansion(const std::vector<Token>& words, std::size_t at) {
  std::size_t end = at;
  for (int open = 0; end < words.size() && (open > 0 || words[end].text != ","); ++end) {
    open += words[end].text == "(" ? 1 : words[end].text == ")" ? -1 : 0;
    if (open < 0 || words[end].text == ";") return "";
  }
  if (end == words.size()) return "";
  std::size_t begin = at;
  while (begin < end && words[begin].text == "(") ++begin;
  while (end > begin && words[end - 1].text == ")") --end;
  if (begin == at || end < begin + 8 || words[end - 2].text != "-" || words[end - 1].text != "1") return "";
  const std::string_view after = words[begin + 2].text;
  const bool compares = words[begin + 1].text == ")" && (after == "=" || after == "<" || after == ">");
  return compares ? words[begin].text : "";
}

/// Returns the numbers that the board's pins have for attachInterrupt(): "0 (pin D2), 1 (pin D3)".
std::string interrupt_numbers(const BoardSpec& board) {
  std::map<int, const char*> found;
  for (Pin pin = 0; pin < board.pin_count; ++pin)
    if (board.pins[pin].interrupt >= 0) found.emplace(board.pins[pin].interrupt, board.pins[pin].name);
  std::string text;
  for (const auto& [number, pin] : found)
    text += fmt::format("{}{} (pin {})", text.empty() ? "" : ", ", number, pin);
  return text;
}

/// Returns the problem with the call of attachInterrupt() at `at`; empty = none.
std::string interrupt_warning(const std::vector<Token>& words, std::size_t at,
                              const std::map<std::string_view, int>& constants, const BoardSpec& board) {
  const auto warn = [&](const std::string& argument, const std::string& wrong) {
    return fmt::format("{}:{}: warning: attachInterrupt({}, …): {}", words[at].file, words[at].line, argument,
                       wrong);
  };
  if (const std::string_view pin = pin_of_expansion(words, at + 2); !pin.empty()) {
    const auto number = value_of(pin, constants, board);
    const std::string wrong = number ? complaint(board, *number, Use::interrupt) : "";
    return wrong.empty() ? "" : warn(fmt::format("digitalPinToInterrupt({})", pin), wrong);
  }
  if (words[at + 3].text != ",") return "";
  const std::string_view argument = words[at + 2].text;
  const auto number = value_of(argument, constants, board);
  if (!number) return "";
  for (Pin pin = 0; pin < board.pin_count; ++pin)
    if (board.pins[pin].interrupt == *number) return "";
  if (*number < board.pin_count && board.pins[*number].interrupt >= 0)
    return warn(std::string(argument),
                fmt::format("the {} has no interrupt {}: the handler never runs; for pin {}, write "
                            "attachInterrupt(digitalPinToInterrupt({}), …)",
                            board.name, *number, board.pins[*number].name, argument));
  return warn(std::string(argument),
              fmt::format("the {} has no interrupt {}: the handler never runs; these interrupts exist: {}",
                          board.name, *number, interrupt_numbers(board)));
}

bool is_number(std::string_view word) {
  return !word.empty() && word.size() < 6 && word.find_first_not_of("0123456789") == word.npos;
}

/// Returns a warning for a number outside 0 to 255, as in analogWrite(PIN, 300) and analogWrite(PIN, -100).
std::string range_warning(const std::vector<Token>& words, std::size_t at) {
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

std::string interrupt_pins(const BoardSpec& board) {
  return pins_that(board, [](const PinSpec& one) { return one.interrupt >= 0; });
}

std::string serial_warning(const std::string& own_lines, const std::string& all, const BoardSpec& board) {
  if (board.chip->uart_count == 0 || board.chip->usb.address || all.find("Serial.begin") != all.npos)
    return "";
  const std::vector<Token> words = tokens_of(own_lines);
  const Token* first = nullptr;
  for (std::size_t i = 0; i + 2 < words.size(); ++i) {
    if (words[i].text != "Serial") continue;
    if (words[i + 1].text != ".") return "";  // Serial is passed to code that may call begin()
    const std::string_view call = words[i + 2].text;
    if (!first && (call == "print" || call == "println" || call == "write")) first = &words[i];
  }
  if (!first) return "";
  return fmt::format(
      "{}:{}: warning: Serial.begin() is never called, so nothing is sent: put Serial.begin(9600); into "
      "setup()",
      first->file, first->line);
}

std::string usb_warning(const std::string& own_lines, const BoardSpec& board) {
  if (!board.chip->usb.address) return "";
  constexpr std::string_view kLoop[] = {"while", "(", "!", "Serial", ")"};
  const std::vector<Token> words = tokens_of(own_lines);
  const auto waits = std::search(words.begin(), words.end(), std::begin(kLoop), std::end(kLoop),
                                 [](const Token& word, std::string_view text) { return word.text == text; });
  if (waits == words.end()) return "";
  return fmt::format(
      "{}:{}: warning: 'while (!Serial)' waits until a computer opens the port: without a USB cable, the "
      "sketch never continues; in the simulation, the port is always open; to wait at most 2 s, write while "
      "(!Serial && millis() < 2000)",
      waits->file, waits->line);
}

std::string pin_warnings(const std::string& own_lines, const BoardSpec& board) {
  const std::vector<Token> words = tokens_of(own_lines);
  const std::map<std::string_view, int> constants = constants_in(words);
  std::string text;
  std::set<std::string> told;
  const bool may_have_more_bits = std::any_of(
      words.begin(), words.end(), [](const Token& word) { return word.text == "analogWriteResolution"; });
  for (std::size_t i = 1; i + 3 < words.size(); ++i) {
    // Declarations have a type before the name; method calls have a . or ->.
    if (words[i + 1].text != "(" || words[i - 1].text == "." || words[i - 1].text == ">") continue;
    if (const std::string wrong = may_have_more_bits ? "" : range_warning(words, i); !wrong.empty())
      text += (text.empty() ? "" : "\n") + wrong;
    if (words[i].text == "attachInterrupt")
      if (const std::string wrong = interrupt_warning(words, i, constants, board); !wrong.empty())
        text += (text.empty() ? "" : "\n") + wrong;
    const std::string_view after = words[i + 3].text;
    if (after != "," && after != ")") continue;
    for (const Function& function : kFunctions) {
      if (words[i].text != function.name) continue;
      const std::string_view argument = words[i + 2].text;
      const std::optional<int> pin = value_of(argument, constants, board);
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
