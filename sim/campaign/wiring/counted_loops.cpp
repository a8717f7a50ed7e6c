#include "sim/campaign/wiring/counted_loops.h"

namespace robosim::wiring {
namespace {

constexpr int kMostPins = 20;

std::optional<int> number_in(const std::string& text) {
  if (text.empty() || text.size() > 3 || text.find_first_not_of("0123456789") != std::string::npos) return {};
  return std::stoi(text);
}

}  // namespace

void CountedLoops::read(const std::vector<build::Token>& tokens, std::size_t at) {
  const auto is = [&](std::size_t i, const char* text) { return i < tokens.size() && tokens[i].is(text); };
  const auto is_word = [&](std::size_t i) {
    return i < tokens.size() && tokens[i].kind == build::Token::Kind::word;
  };
  std::size_t i = at + 2;
  while (is_word(i) && is_word(i + 1)) ++i;  // the type
  if (!is_word(i) || !is(i + 1, "=") || !is(i + 3, ";") || !is(i + 5, "<")) return;
  const std::string name = tokens[i].str();
  if (!tokens[i + 4].is(name)) return;
  const bool is_inclusive = is(i + 6, "=");
  const std::size_t limit = i + (is_inclusive ? 7 : 6);
  if (limit >= tokens.size()) return;
  by_variable_[name] = {"", tokens[i + 2].str(), tokens[limit].str(), is_inclusive};
}

std::optional<PinRange> CountedLoops::range_of(const std::string& argument) const {
  const std::size_t plus = argument.find(" + ");
  const std::string left = argument.substr(0, plus);
  const std::string right = plus == std::string::npos ? "" : argument.substr(plus + 3);
  for (const auto& [variable, base] : {std::pair(left, right), std::pair(right, left)}) {
    const auto loop = by_variable_.find(variable);
    if (loop == by_variable_.end() || base.find(' ') != std::string::npos) continue;
    PinRange range = loop->second;
    range.base = base;
    return range;
  }
  return {};
}

std::vector<std::string> pins_in(const PinRange& range,
                                 const std::function<std::string(const std::string&)>& value_of) {
  const std::string base = range.base.empty() ? "0" : value_of(range.base);
  const bool is_analog = base.size() > 1 && base[0] == 'A';
  const auto from = number_in(is_analog ? base.substr(1) : base);
  const auto first = number_in(value_of(range.first)), last = number_in(value_of(range.last));
  if (!from || !first || !last) return {};
  const int count = *last - *first + (range.is_inclusive ? 1 : 0);
  if (count < 1 || count > kMostPins) return {};
  std::vector<std::string> pins;
  for (int i = 0; i < count; ++i) pins.push_back((is_analog ? "A" : "") + std::to_string(*from + *first + i));
  return pins;
}

}  // namespace robosim::wiring
