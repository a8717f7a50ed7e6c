#include "sim/campaign/wiring/name_words.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <set>
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

// Matches lm, rmf, lpwm, rsensor: the letter of a side, followed by the short or full name of a part.
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

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_'; }
bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }
bool is_upper(char c) { return std::isupper(static_cast<unsigned char>(c)) != 0; }
bool is_ascii(char c) { return static_cast<unsigned char>(c) < 0x80; }

// Splits words that begin or end with `pin`: pinena, enapin.
void split_pin(WordList& words) {
  static const std::set<std::string> kWhole = {"ping",   "pinza", "pink", "pins",
                                               "pinion", "spin",  "pino", "pini"};
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string word = words[i];
    if (word.size() <= 3 || kWhole.count(word) != 0) continue;
    const std::ptrdiff_t at = static_cast<std::ptrdiff_t>(i);
    if (word.starts_with("pin")) {
      words[i] = word.substr(3);
      words.insert(words.begin() + at, "pin");
      ++i;
    } else if (word.ends_with("pin")) {
      words[i] = word.substr(0, word.size() - 3);
      words.insert(words.begin() + at + 1, "pin");
      ++i;
    }
  }
}

}  // namespace

WordList words_of_text(std::string_view text) {
  // Letters with accents, which have two bytes each in UTF-8, and the plain letters.
  static const std::map<std::string_view, const char*> kAccents = {
      {"á", "a"}, {"à", "a"}, {"â", "a"}, {"ã", "a"}, {"ä", "a"}, {"é", "e"}, {"è", "e"}, {"ê", "e"},
      {"í", "i"}, {"ì", "i"}, {"ı", "i"}, {"ó", "o"}, {"ò", "o"}, {"ô", "o"}, {"õ", "o"}, {"ö", "o"},
      {"ú", "u"}, {"ù", "u"}, {"ü", "u"}, {"ñ", "n"}, {"ç", "c"}, {"ğ", "g"}, {"ş", "s"}, {"ß", "ss"},
      {"É", "e"}, {"Ç", "c"}, {"İ", "i"}, {"Ş", "s"}, {"Ö", "o"}, {"Ü", "u"}, {"Í", "i"}, {"Ó", "o"}};
  WordList words(1);
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto accent = is_ascii(text[i]) ? kAccents.end() : kAccents.find(text.substr(i, 2));
    if (accent != kAccents.end()) {
      words.back() += accent->second;
      ++i;
    } else if (is_letter(text[i]) || is_digit(text[i])) {
      words.back() += static_cast<char>(std::tolower(static_cast<unsigned char>(text[i])));
    } else if (!words.back().empty()) {
      words.emplace_back();
    }
  }
  if (words.back().empty()) words.pop_back();
  return words;
}

WordList words_of(std::string_view name) {
  WordList words;
  for (std::size_t i = 0; i < name.size(); ++i) {
    const char c = name[i];
    if (!is_letter(c) && !is_digit(c)) continue;
    if (c == '_') continue;
    const char before = i > 0 ? name[i - 1] : '_';
    const bool turns = is_upper(c) && (!is_upper(before) || (i + 1 < name.size() && is_letter(name[i + 1]) &&
                                                             name[i + 1] != '_' && !is_upper(name[i + 1])));
    if (before == '_' || is_digit(c) != is_digit(before) || turns) words.emplace_back();
    if (words.empty()) words.emplace_back();
    words.back() += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  split_pin(words);
  return words;
}

Side spelled_side(const WordList& words) {
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

Side only_side(const WordList& words) {
  Side side = Side::unknown;
  for (const std::string& word : words) {
    const Side one = spelled_side({word});
    if (one == Side::unknown) continue;
    if (side != Side::unknown && side != one) return Side::unknown;
    side = one;
  }
  return side;
}

Side side_of(const WordList& words) {
  if (const Side side = spelled_side(words); side != Side::unknown) return side;
  for (std::size_t i = 0; i + 1 < words.size(); ++i) {  // has precedence over letters: motor1DirB
    if (!is_one_of(words[i], {"m", "motor", "wheel"})) continue;
    if (const Side side = numbered(words[i + 1], false); side != Side::unknown) return side;
  }
  for (const std::string& word : words) {  // has precedence over the other numbers: IN1_B
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

bool says(const WordList& words, Words beginnings) {
  return std::any_of(words.begin(), words.end(), [&](const std::string& word) {
    return std::any_of(beginnings.begin(), beginnings.end(),
                       [&](const char* one) { return word.rfind(one, 0) == 0; });
  });
}

bool says_forward(const WordList& words) {
  return says(words, {"fwd", "forw", "farw", "fow", "front", "ahead", "avan", "cw", "plus", "pos", "adelante",
                      "frente", "vorw", "ileri", "maju", "aage"});
}

bool says_backward(const WordList& words) {
  return says(words,
              {"bwd", "back", "rev", "ccw", "retro", "minus", "neg", "atras", "tras", "arriere", "rueckw",
               "ruckw", "zuruck", "zurueck", "indietro", "geri", "mundur", "peeche", "piche"});
}

bool function_goes_forward(const WordList& words) {
  const bool is_straight =
      says(words, {"fwd", "forw", "farw", "front", "ahead", "avan", "adelante", "frente", "vorw", "ileri",
                   "maju", "aage", "straight", "recto", "reto", "lurus", "duz", "gerade"});
  return is_straight && !function_goes_backward(words);
}

bool function_goes_backward(const WordList& words) {
  return says(words, {"bwd", "back", "revers", "retro", "atras", "tras", "arriere", "rueckw", "ruckw",
                      "zuruck", "zurueck", "indietro", "geri", "mundur", "peeche", "piche"});
}

Side turn_of_function(const WordList& words) {
  if (function_goes_forward(words) || function_goes_backward(words)) return Side::unknown;
  for (const std::string& word : words) {
    if (is_one_of(word, {"sola", "soladon"})) return Side::left;
    if (is_one_of(word, {"saga", "sagadon"})) return Side::right;
  }
  return spelled_side(words);
}

bool names_motor(const WordList& words) {
  return says(words, {"mot", "wheel", "rueda", "roda", "roue", "ruota", "teker", "engine"});
}

}  // namespace robosim::wiring
