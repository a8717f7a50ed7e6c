#include "sim/build/vector_hints.h"

#include <fmt/format.h>

#include <fstream>
#include <optional>
#include <regex>
#include <string_view>
#include <vector>

#include "sim/build/pin_warnings.h"
#include "sim/build/tokens.h"

namespace robosim::build {
namespace fs = std::filesystem;

namespace {

constexpr std::string_view kVector = "__vector_";

/// Returns the owner of a handler in words, from its place in the linker's message.
std::string owner_of(const std::string& place) {
  static const std::regex library(R"(libraries/([^/]+)/.*)");
  static const std::regex core(R"(core/([^/:]+)(:\d+)?)");
  std::smatch match;
  if (std::regex_match(place, match, library)) return "the library " + match[1].str();
  if (!std::regex_match(place, match, core)) return place;
  if (match[1] == "Tone.cpp") return "tone()";
  if (match[1] == "WInterrupts.c") return "attachInterrupt()";
  return fmt::format("{} of Arduino's core", match[1].str());
}

bool is_one_of(const std::string& owner, const std::string& first, const std::string& second) {
  return owner == first || owner == second;
}

/// Returns advice for a program with two handlers of the vector called `name`.
std::string advice_for(const std::string& name, const std::string& first, const std::string& second,
                       const BoardSpec& board) {
  const std::string serial = "the library SoftwareSerial";
  if (name.starts_with("PCINT") && is_one_of(serial, first, second))
    return fmt::format(
        "SoftwareSerial handles the pin changes of all pins; read the other pins by attachInterrupt(), "
        "which works for {}, or use another serial library",
        interrupt_pins(board));
  if (name.starts_with("PCINT"))
    return fmt::format("read the pins of one of them by attachInterrupt(), which works for {}",
                       interrupt_pins(board));
  if (is_one_of("attachInterrupt()", first, second))
    return "attachInterrupt() handles all external interrupts; call it for this interrupt, too, instead of "
           "ISR()";
  if (name.starts_with("TIM")) {
    const std::string timer = name.substr(0, name.find('_'));
    return fmt::format(
        "both use {}{}; use another timer for one of them{}", timer.starts_with("TIMER") ? "timer " : "",
        timer.starts_with("TIMER") ? timer.substr(5) : timer,
        is_one_of("tone()", first, second) ? ", or do without tone()" : ", or a library that needs no timer");
  }
  return "remove one of the two handlers";
}

}  // namespace

std::string vector_name(const Vectors& vectors, int number) {
  std::ifstream header(vectors.avr_libc / vectors.chip.registers);
  const std::regex definition(fmt::format(R"(\s*#\s*define\s+(\w+_vect)\s+_VECTOR\(\s*{}\s*\).*)", number));
  std::string found, line;
  while (std::getline(header, line)) {
    constexpr std::size_t kLongest = 500;  // std::regex needs stack for each character
    std::smatch match;
    // An ATtiny85's header has two names for a vector, such as TIM0_OVF_vect and TIMER0_OVF_vect. Prefers the
    // second.
    if (line.size() < kLongest && std::regex_match(line, match, definition) &&
        (found.empty() || match[1].str().starts_with("TIMER")))
      found = match[1];
  }
  return found;
}

std::string vector_hint(const std::string& messages, const std::string& own_lines, const BoardSpec& board,
                        const Vectors& vectors) {
  static const std::regex twice(
      "(?:^|\n)([^\n ][^\n]*): multiple definition of `__vector_(\\d{1,3})'[^\n]*"
      "(?:\n([^\n ][^\n]*): first defined here)?");
  std::smatch match;
  if (!std::regex_search(messages, match, twice)) return "";
  const std::string vector = std::string(kVector) + match[2].str();
  const std::string name = vector_name(vectors, std::stoi(match[2]));
  const std::vector<Token> words = tokens_of(own_lines);
  const auto owner = [&](const std::string& place) {
    for (const Token& word : words)
      if (word.text == vector && word.file == place) return fmt::format("{}:{}", place, word.line);
    return owner_of(place);
  };
  const std::string second = owner(match[1]), first = owner(match[3]);
  return fmt::format(
      "{} can have only one handler, but {} and {} both define one: {}",
      name.empty() ? "the interrupt " + vector : fmt::format("the interrupt {} ({})", name, vector),
      first.empty() ? "another file" : first, second, advice_for(name, first, second, board));
}

std::string core_handler_warnings(const std::string& own_lines, const BoardSpec& board,
                                  const fs::path& avr_libc) {
  const ChipSpec& chip = *board.chip;
  // If the board has a host model, the host simulates the interrupts of another chip.
  if (board.host_model || own_lines.find(kVector) == own_lines.npos) return "";
  constexpr int kToneTimer = 2;
  const std::vector<Token> words = tokens_of(own_lines);
  const auto calls = [&](std::string_view function) {
    for (std::size_t i = 1; i + 1 < words.size(); ++i)
      if (words[i].text == function && words[i + 1].text == "(" && words[i - 1].text != "." &&
          words[i - 1].text != ">" && !is_name(words[i - 1].text))
        return true;
    return false;
  };
  std::string text;
  std::optional<int> last;
  for (const Token& word : words) {
    if (!word.text.starts_with(kVector)) continue;
    const auto number = number_of(word.text.substr(kVector.size()));
    if (!number || number == last) continue;  // ISR() declares the handler, and then defines it
    last = number;
    const bool external =
        *number >= chip.external_vector && *number < chip.external_vector + chip.external_count;
    const char* function = nullptr;
    if (external && calls("attachInterrupt")) function = "attachInterrupt()";
    for (int i = 0; i < chip.timer_count; ++i)
      if (chip.timers[i].number == kToneTimer && *number == chip.timers[i].vector && calls("tone"))
        function = "tone()";
    if (!function) continue;
    const std::string name = vector_name({chip, avr_libc}, *number);
    text += fmt::format(
        "{}{}:{}: warning: the interrupt {} can have only one handler, but {} also defines one: the sketch "
        "does not link for the chip; {}",
        text.empty() ? "" : "\n", word.file, word.line, name.empty() ? std::string(word.text) : name,
        function, advice_for(name, function, "", board));
  }
  return text;
}

}  // namespace robosim::build
