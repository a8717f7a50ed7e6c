#include "sim/campaign/wiring/name_words.h"

#include <algorithm>
#include <string_view>

namespace robosim::wiring {
namespace {

using Words = std::initializer_list<const char*>;

bool is_one_of(const std::string& word, Words list) {
  return std::any_of(list.begin(), list.end(), [&](const char* one) { return word == one; });
}

bool contains_one_of(const std::string& word, Words list) {
  return std::any_of(list.begin(), list.end(),
                     [&](const char* one) { return word.find(one) != std::string::npos; });
}

// Matches lm, rmf, lpwm, rsensor: a letter, followed by a name of one motor or sensor.
bool begins_side(const std::string& word, char letter) {
  static const Words rests = {"",    "f",   "b",   "s",   "d",   "e",   "w",     "en",    "in",    "ir",
                              "fwd", "bwd", "rev", "pwm", "dir", "enc", "speed", "wheel", "servo", "sensor"};
  constexpr std::size_t kLongestShort = 4;
  if (word.empty() || word[0] != letter) return false;
  const bool is_motor = word.size() > 1 && word[1] == 'm';
  if (is_motor && (word.size() <= kLongestShort || word.substr(1, 3) == "mot")) return true;
  return is_one_of(word.substr(1), rests);
}

// Matches the Turkish sol and sag, alone or before another word: solmotor, sagileri.
bool is_turkish(const std::string& word, const char* side) {
  static const Words rests = {"motor", "sens", "ileri", "geri", "arka", "teker", "hiz", "pwm", "cizgi"};
  if (word.rfind(side, 0) != 0) return false;
  const std::string rest = word.substr(3);
  return rest.empty() ||
         std::any_of(rests.begin(), rests.end(), [&](const char* one) { return rest.rfind(one, 0) == 0; });
}

// Matches the Indonesian ki (kiri) and ka (kanan) after another word: motorki, sensorkaf.
bool is_indonesian(const std::string& word, const char* side) {
  for (const char* const before : {"motor", "sensor"})
    if (word.rfind(before, 0) == 0 && word.size() <= std::string_view(before).size() + 3)
      return word.compare(std::string_view(before).size(), 2, side) == 0;
  return false;
}

bool is_left(const std::string& word) {
  return is_indonesian(word, "ki") ||
         contains_one_of(word, {"left", "izquierd", "esquerd", "gauche", "sinistr", "kiri"}) ||
         is_one_of(word, {"lft", "izq", "esq", "links", "linke", "linker", "linkes", "sx", "baya", "baye",
                          "sl", "ml", "baaye", "bayen", "bayan", "baayan", "baayen"}) ||
         is_turkish(word, "sol");
}

bool is_right(const std::string& word) {
  return is_indonesian(word, "ka") ||
         (contains_one_of(word, {"right", "derech", "direit", "droit", "rechts", "kanan"}) &&
          !contains_one_of(word, {"bright", "copyright"})) ||
         is_one_of(word,
                   {"rgt", "rt", "sr", "mr", "der", "rechte", "rechter", "rechtes", "dx", "destra", "destro",
                    "daya", "daaye", "daye", "dayen", "dayan", "daayan", "dahina", "dahine"}) ||
         is_turkish(word, "sag");
}

Side of_digit(char digit, bool four) {
  if (digit == '1' || (four && digit == '2')) return Side::left;
  if (digit == '2' || (four && (digit == '3' || digit == '4'))) return Side::right;
  return Side::unknown;
}

// Reads the number of a motor (M2), of an input (IN3), or of both (M21, the first input of motor 2).
Side numbered(const std::string& number, bool is_input) {
  if (number.size() == 1) return of_digit(number[0], is_input);
  const bool both = number.size() == 2 && (number[1] == '1' || number[1] == '2');
  return both ? of_digit(number[0], false) : Side::unknown;
}

}  // namespace

Side spelled_side(const std::vector<std::string>& words) {
  for (const std::string& word : words) {
    if (is_left(word)) return Side::left;
    if (is_right(word)) return Side::right;
  }
  for (const std::string& word : words) {
    if (begins_side(word, 'l') || word == "lt") return Side::left;
    if (begins_side(word, 'r')) return Side::right;
  }
  return Side::unknown;
}

Side only_side(const std::vector<std::string>& words) {
  Side side = Side::unknown;
  for (const std::string& word : words) {
    const Side one = spelled_side({word});
    if (one == Side::unknown) continue;
    if (side != Side::unknown && side != one) return Side::unknown;
    side = one;
  }
  return side;
}

Side side_of(const std::vector<std::string>& words) {
  if (const Side side = spelled_side(words); side != Side::unknown) return side;
  for (std::size_t i = 0; i + 1 < words.size(); ++i) {  // before the letters: motor1DirB
    if (!is_one_of(words[i], {"m", "motor", "wheel"})) continue;
    if (const Side side = numbered(words[i + 1], false); side != Side::unknown) return side;
  }
  for (const std::string& word : words) {  // before the other numbers: IN1_B
    if (is_one_of(word, {"a", "ena", "pwma", "ain", "motora", "dira", "speeda", "ma"})) return Side::left;
    if (is_one_of(word, {"b", "enb", "pwmb", "bin", "motorb", "dirb", "speedb", "mb"})) return Side::right;
  }
  for (std::size_t i = 0; i + 1 < words.size(); ++i) {
    const bool is_input = is_one_of(words[i], {"in", "input"});
    if (!is_input && !is_one_of(words[i], {"e", "en", "dir", "pwm", "speed"})) continue;
    if (const Side side = numbered(words[i + 1], is_input); side != Side::unknown) return side;
  }
  return Side::unknown;
}

bool says(const std::vector<std::string>& words, Words beginnings) {
  return std::any_of(words.begin(), words.end(), [&](const std::string& word) {
    return std::any_of(beginnings.begin(), beginnings.end(),
                       [&](const char* one) { return word.rfind(one, 0) == 0; });
  });
}

bool says_forward(const std::vector<std::string>& words) {
  return says(words, {"fwd", "forw", "farw", "fow", "front", "ahead", "avan", "cw", "plus", "pos", "adelante",
                      "frente", "vorw", "ileri", "maju", "aage"});
}

bool says_backward(const std::vector<std::string>& words) {
  return says(words,
              {"bwd", "back", "rev", "ccw", "retro", "minus", "neg", "atras", "tras", "arriere", "rueckw",
               "ruckw", "zuruck", "zurueck", "indietro", "geri", "mundur", "peeche", "piche"});
}

bool function_goes_forward(const std::vector<std::string>& words) {
  const bool is_straight =
      says(words, {"fwd", "forw", "farw", "front", "ahead", "avan", "adelante", "frente", "vorw", "ileri",
                   "maju", "aage", "straight", "recto", "reto", "lurus", "duz", "gerade"});
  return is_straight && !function_goes_backward(words);
}

bool function_goes_backward(const std::vector<std::string>& words) {
  return says(words, {"bwd", "back", "revers", "retro", "atras", "tras", "arriere", "rueckw", "ruckw",
                      "zuruck", "zurueck", "indietro", "geri", "mundur", "peeche", "piche"});
}

Side turn_of_function(const std::vector<std::string>& words) {
  if (function_goes_forward(words) || function_goes_backward(words)) return Side::unknown;
  for (const std::string& word : words) {
    if (is_one_of(word, {"sola", "soladon"})) return Side::left;
    if (is_one_of(word, {"saga", "sagadon"})) return Side::right;
  }
  return spelled_side(words);
}

bool names_motor(const std::vector<std::string>& words) {
  return says(words, {"mot", "wheel", "rueda", "roda", "roue", "ruota", "teker", "engine"});
}

}  // namespace robosim::wiring
