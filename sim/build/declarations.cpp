#include "sim/build/declarations.h"

#include <algorithm>
#include <array>

#include "sim/build/lexing.h"

namespace robosim::build {
namespace {

struct NamedType {
  std::string_view name;
  ArithmeticType type;
};
constexpr std::array kNamedTypes = {
    NamedType{"byte", {8, false, false}},      NamedType{"uint8_t", {8, false, false}},
    NamedType{"int8_t", {8, true, false}},     NamedType{"word", {0, false, false}},
    NamedType{"uint16_t", {16, false, false}}, NamedType{"int16_t", {16, true, false}},
    NamedType{"uint32_t", {32, false, false}}, NamedType{"int32_t", {32, true, false}},
    NamedType{"uint64_t", {64, false, false}}, NamedType{"int64_t", {64, true, false}},
    NamedType{"float", {32, true, true}},      NamedType{"double", {32, true, true}},
};
constexpr std::array<std::string_view, 6> kBaseWords = {"unsigned", "signed", "short", "int", "char", "long"};
/// Maximum number of words that a search examines. Without a limit, the searches could take quadratic time.
constexpr std::size_t kMostWords = 400;
constexpr int kMostQualifiers = 8;

constexpr std::array<std::string_view, 9> kQualifiers = {
    "const", "volatile", "static", "constexpr", "mutable", "register", "extern", "inline", "thread_local"};
/// Keywords that precede a name without declaring it.
constexpr std::array<std::string_view, 16> kNoTypes = {
    "return", "else",     "do",  "case", "goto", "new",    "delete", "throw",
    "sizeof", "operator", "and", "or",   "not",  "typeid", "using",  "namespace"};

template <typename List>
bool contains(const List& list, std::string_view word) {
  return std::find(list.begin(), list.end(), word) != list.end();
}

const NamedType* named_type(std::string_view word) {
  for (const NamedType& one : kNamedTypes)
    if (one.name == word) return &one;
  return nullptr;
}

bool may_follow_name(std::string_view word) {
  constexpr std::array<std::string_view, 8> kFollowing = {";", "=", ",", ")", "[", "(", "{", ":"};
  return contains(kFollowing, word);
}

bool may_be_template_argument(std::string_view word) {
  return !word.empty() && (is_of_name(word[0]) || word == "," || word == ":" || word == "*");
}

}  // namespace

Declarations::Declarations(const std::vector<Token>& words, int int_bits)
    : words_(words), int_bits_(int_bits), partners_(words.size(), kNone) {
  find_partners();
  read_declarations();
  for (std::size_t i = 0; i < declarations_.size(); ++i) by_name_.emplace(declarations_[i].name, i);
}

void Declarations::find_partners() {
  std::vector<std::size_t> open;
  for (std::size_t i = 0; i < words_.size(); ++i) {
    const std::string_view word = text(i);
    if (word == "(" || word == "[" || word == "{") open.push_back(i);
    if (word != ")" && word != "]" && word != "}") continue;
    const std::string_view begin = word == ")" ? "(" : word == "]" ? "[" : "{";
    if (open.empty() || text(open.back()) != begin) continue;
    partners_[i] = open.back();
    partners_[open.back()] = i;
    open.pop_back();
  }
}

bool Declarations::is_class(std::size_t brace) const {
  bool found = false;
  for (std::size_t i = brace; i-- > 0 && brace - i < kMostWords;) {
    const std::string_view word = text(i);
    if (word == ";" || word == "{" || word == "}") break;
    if (word == "(") return false;
    found |= word == "struct" || word == "class" || word == "union" || word == "namespace" ||
             word == "enum" || word == "extern";
  }
  return found;
}

std::size_t Declarations::read_type(std::size_t at, ArithmeticType& type) const {
  bool is_unsigned = false, is_short = false, is_char = false;
  int base_words = 0, longs = 0, qualifiers = 0;
  const NamedType* named = nullptr;
  std::size_t end = at;
  for (;; ++end) {
    const std::string_view word = text(end);
    if (contains(kQualifiers, word)) {
      if (++qualifiers > kMostQualifiers) return at;
      continue;
    }
    const bool is_base = contains(kBaseWords, word);
    if (const NamedType* found = named_type(word); found && !named && base_words == 0)
      named = found;
    else if (is_base && !named)
      ++base_words;
    else
      break;
    is_unsigned |= word == "unsigned";
    is_short |= word == "short";
    is_char |= word == "char";
    longs += word == "long";
  }
  if (!named && base_words == 0) return at;
  if (named) {
    type = named->type;
    if (type.bits == 0) type.bits = int_bits_;
  } else {
    const int bits = is_char ? 8 : is_short ? 16 : longs > 1 ? 64 : longs == 1 ? 32 : int_bits_;
    type = {bits, !is_unsigned, false};
  }
  return end;
}

bool Declarations::names_type(std::size_t at) const {
  const std::string_view word = text(at);
  return !word.empty() && is_name(word) && !contains(kNoTypes, word);
}

void Declarations::add(std::size_t at, const ArithmeticType& type, std::size_t open) {
  Declaration one{text(at), type, at, 0};
  if (open != kNone && text(open) == "(") {  // a parameter, or the variable of a loop
    std::size_t end = partners_[open] == kNone ? words_.size() : partners_[open] + 1;
    const std::size_t last = std::min(end + kMostWords, words_.size());
    while (end < last && text(end) != "{" && text(end) != ";") ++end;
    if (end < words_.size() && text(end) == "{" && partners_[end] != kNone) end = partners_[end];
    one.end = end;
  } else if (open != kNone && !is_class(open)) {
    one.end = partners_[open] == kNone ? words_.size() : partners_[open];
  }
  declarations_.push_back(one);
}

std::size_t Declarations::read_declarators(std::size_t at, const ArithmeticType& type, std::size_t open) {
  const bool in_parentheses = open != kNone && text(open) == "(";
  for (;;) {
    bool is_pointer = false;
    const std::size_t last_star = at + kMostWords;
    for (; at < last_star && (text(at) == "*" || text(at) == "&" || text(at) == "const"); ++at)
      is_pointer |= text(at) == "*";
    if (!names_type(at) || !may_follow_name(text(at + 1))) return at;
    const std::string_view next = text(at + 1);
    // The type is unknown for a bit-field, whose width is not read, and for a function.
    const bool is_time = next == "(" && (text(at + 2) == "millis" || text(at + 2) == "micros");
    const bool is_known = !is_pointer && next != ":" && (next != "(" || is_time);
    add(at, is_known ? type : ArithmeticType{}, open);
    const std::size_t after_name = at + 1;
    if (next == "(" && !is_time) return after_name;
    const std::size_t last = at + kMostWords;
    for (++at; at < last; ++at) {
      const std::string_view word = text(at);
      if (word.empty() || word == "," || word == ";" || word == ")" || word == "}") break;
      if ((word == "(" || word == "[" || word == "{") && partners_[at] != kNone) at = partners_[at];
    }
    const bool continues = text(at) == "," && (!in_parentheses || text(at + 2) == "=");
    if (!continues) return after_name;
    ++at;
  }
}

void Declarations::read_declarations() {
  std::vector<std::size_t> open;
  for (std::size_t i = 0; i < words_.size(); ++i) {
    const std::string_view word = text(i);
    if ((word == "(" || word == "[" || word == "{") && partners_[i] != kNone) open.push_back(i);
    if (!open.empty() && partners_[open.back()] == i) open.pop_back();
    if (word.empty() || !is_name(word)) continue;
    const std::size_t inside = open.empty() ? kNone : open.back();
    ArithmeticType type;
    if (const std::size_t end = read_type(i, type); end != i) {
      read_declarators(end, type, inside);
      i = end - 1;
      continue;
    }
    if (!names_type(i) || contains(kQualifiers, word)) continue;
    // Reads a type that is not arithmetic, with or without template arguments.
    std::size_t end = i + 1;
    if (text(end) == "<") {
      while (may_be_template_argument(text(end + 1)) && end - i < kMostWords) ++end;
      if (text(++end) != ">") continue;
      ++end;
    }
    const bool points = text(end) == "*" || text(end) == "&";
    const std::string_view before = i > 0 ? text(i - 1) : ";";
    if (points && before != ";" && before != "{" && before != "}" && before != "(" && before != "," &&
        before != "const" && before != ":")
      continue;
    if (word == "auto" && text(end + 1) == "=" && (text(end + 2) == "millis" || text(end + 2) == "micros"))
      type = {32, false, false};
    read_declarators(end, type, inside);
  }
}

std::size_t Declarations::resolve(std::size_t at, bool is_member) const {
  std::size_t best = kNone, other = kNone;
  const auto [begin, end] = by_name_.equal_range(text(at));
  std::size_t count = 0;
  for (auto found = begin; found != end; ++found) {
    if (++count > kMostOfName) return kNone;
    const Declaration& one = declarations_[found->second];
    if (one.end == 0)
      other = std::min(other, found->second);
    else if (!is_member && one.at <= at && at < one.end && (best == kNone || one.at > declarations_[best].at))
      best = found->second;
  }
  return best == kNone ? other : best;
}

}  // namespace robosim::build
