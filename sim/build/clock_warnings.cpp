#include "sim/build/clock_warnings.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include "sim/base/terminal_text.h"
#include "sim/build/declarations.h"
#include "sim/build/prototypes.h"

namespace robosim::build {
namespace {

constexpr int kClockBits = 32;
/// Maximum number of words that a search in an expression examines. Without a limit, the searches could take
/// quadratic time.
constexpr std::size_t kMostOfExpression = 100;
constexpr std::size_t kNone = Declarations::kNone;

bool is_narrow(const ArithmeticType& type) {
  return type.bits > 0 && type.bits < kClockBits && !type.is_float;
}
bool is_wide(const ArithmeticType& type) { return type.bits >= kClockBits; }

/// A variable or member in an expression: `since`, `timers[i].since`, `this->since`.
struct Operand {
  std::size_t end = 0;   ///< index after the operand
  std::size_t name = 0;  ///< index of the last name
  bool is_member = false;
};

enum class TimeUnit : char { none, ms, us };

/// A warning, and the name of its variable.
struct Found {
  std::string_view name;
  std::string text;
};

class ClockCheck {
 public:
  ClockCheck(const std::vector<Token>& words, int int_bits)
      : words_(words), names_(words, int_bits), times_(names_.all().size()) {
    constexpr int kMostSteps = 5;  // one for each assignment in a chain: since = now; before = since; ...
    for (int step = 0; step < kMostSteps && mark_times(); ++step) continue;
  }

  std::vector<Found> warnings() {
    std::vector<Found> found;
    for (std::size_t i = 1; i < words_.size(); ++i) {
      if (!begins_operand(i)) continue;
      if (const std::size_t end = read_clock(i); end != i)
        check(i, end, unit_of_clock(i), found);
      else if (const auto operand = read_operand(i))
        check_variable(i, *operand, found);
    }
    return found;
  }

 private:
  std::string_view text(std::size_t at) const { return at < words_.size() ? words_[at].text : ""; }
  /// Returns whether two characters at `at` are one operator, such as `&&`.
  bool is_pair(std::size_t at, char first, char second) const {
    return text(at).size() == 1 && text(at + 1).size() == 1 && text(at)[0] == first &&
           text(at + 1)[0] == second && text(at).data() + 1 == text(at + 1).data();
  }
  bool is_adjacent(std::size_t at) const { return text(at).data() + text(at).size() == text(at + 1).data(); }

  bool is_assignment(std::size_t at) const { return text(at) == "=" && text(at + 1) != "="; }

  bool begins_operand(std::size_t at) const {
    if (!is_name(text(at)) || at == 0) return false;
    const std::string_view before = text(at - 1);
    return before != "." && !(at > 1 && (is_pair(at - 2, '-', '>') || is_pair(at - 2, ':', ':')));
  }

  /// Returns the index after the call of a clock, millis() or micros(), that begins at `at`. Returns `at` if
  /// no such call begins there.
  std::size_t read_clock(std::size_t at) const {
    const bool calls =
        (text(at) == "millis" || text(at) == "micros") && text(at + 1) == "(" && text(at + 2) == ")";
    return calls ? at + 3 : at;
  }

  std::optional<Operand> read_operand(std::size_t at) const {
    Operand operand;
    if (text(at).empty() || !is_name(text(at))) return std::nullopt;
    for (;;) {
      operand.name = at++;
      while (text(at) == "[" && names_.partner(at) != kNone) at = names_.partner(at) + 1;
      if (text(at) == "." && is_name_at(at + 1)) {
        ++at;
      } else if ((is_pair(at, '-', '>') || is_pair(at, ':', ':')) && is_name_at(at + 2)) {
        at += 2;
      } else {
        break;
      }
      operand.is_member = true;
    }
    operand.end = at;
    if (text(at) == "(") return std::nullopt;
    return operand;
  }
  bool is_name_at(std::size_t at) const { return !text(at).empty() && is_name(text(at)); }

  /// Returns the index of the operand's declaration if `accepts` returns true for the types of all
  /// declarations of its name. Otherwise returns kNone.
  std::size_t declared(const Operand& operand, bool accepts(const ArithmeticType&)) const {
    if (!names_.all_of(text(operand.name), accepts)) return kNone;
    return names_.resolve(operand.name, operand.is_member);
  }
  TimeUnit unit_of_variable(std::size_t declaration) const {
    return declaration == kNone ? TimeUnit::none : times_[declaration];
  }
  bool is_time(std::size_t declaration) const { return unit_of_variable(declaration) != TimeUnit::none; }
  TimeUnit unit_of_clock(std::size_t at) const { return text(at) == "micros" ? TimeUnit::us : TimeUnit::ms; }

  // Finding the variables that hold times

  /// Marks the variables that are set to a time. Returns whether any variable was newly marked.
  bool mark_times() {
    bool more = false;
    const auto mark = [&](const Operand& operand, TimeUnit unit) {
      const std::size_t declaration = names_.resolve(operand.name, operand.is_member);
      if (unit == TimeUnit::none || declaration == kNone || times_[declaration] != TimeUnit::none) return;
      times_[declaration] = unit;
      more = true;
    };
    for (std::size_t i = 1; i < words_.size(); ++i) {
      if (!begins_operand(i)) continue;
      const std::size_t open = i + 1;  // since(millis())
      const bool initialises = (text(open) == "(" || text(open) == "{") && names_.partner(open) != kNone;
      if (initialises) mark({open, i, false}, unit_of(open + 1, 0));
      const auto operand = read_operand(i);
      if (operand && is_assignment(operand->end)) mark(*operand, unit_of(operand->end + 1, 0));
    }
    return more;
  }

  /// Returns the unit of the expression at `at` if it is a time: a clock, a variable that holds a time, or a
  /// sum that begins with one of them. A difference has no unit, because it may be a duration.
  TimeUnit unit_of(std::size_t at, int depth) const {
    constexpr int kDeepest = 4;
    if (depth > kDeepest) return TimeUnit::none;
    ArithmeticType type;
    if (text(at) == "(") {
      const std::size_t end = names_.read_type(at + 1, type);
      if (end == at + 1 || text(end) != ")") return TimeUnit::none;
      return unit_of(end + 1, depth + 1);
    }
    if (text(at) == "static_cast" && text(at + 1) == "<") {
      const std::size_t end = names_.read_type(at + 2, type);
      return text(end) == ">" && text(end + 1) == "(" ? unit_of(end + 2, depth + 1) : TimeUnit::none;
    }
    std::size_t end = read_clock(at);
    TimeUnit unit = unit_of_clock(at);
    if (end == at) {
      const auto operand = read_operand(at);
      if (!operand) return TimeUnit::none;
      if (is_assignment(operand->end)) return unit_of(operand->end + 1, depth + 1);
      unit = unit_of_variable(names_.resolve(operand->name, operand->is_member));
      end = operand->end;
    }
    if (!is_pair(end, '+', '+') && !is_pair(end, '+', '=')) end = end_of_sum(end);
    const bool ends = text(end) == ";" || text(end) == "," || text(end) == ")" || text(end) == "}";
    return ends ? unit : TimeUnit::none;
  }
  /// Returns the index after the summands that follow `at`; `at` itself if there are none.
  std::size_t end_of_sum(std::size_t at) const {
    std::size_t end = at;
    if (text(at) == "+")
      while (is_sum(text(end)) && end - at < kMostOfExpression) ++end;
    return end;
  }
  static bool is_sum(std::string_view word) {
    return !word.empty() &&
           (is_name(word) || (word[0] >= '0' && word[0] <= '9') || word == "+" || word == "*" || word == ".");
  }

  // Finding the places where too few bits matter

  /// Checks the operator after a clock, or after a variable that has all bits of a clock.
  void check(std::size_t begin, std::size_t end, TimeUnit unit, std::vector<Found>& found) {
    if (text(end) == "-" && !is_pair(end, '-', '-') && !is_pair(end, '-', '=')) {
      if (const auto operand = read_operand(end + 1)) check_difference(begin, unit, *operand, found);
    } else if (const std::size_t after = comparison_at(end); after != end && may_precede(begin)) {
      const auto operand = read_operand(after);
      if (!operand || !is_time(declared(*operand, is_narrow))) return;
      const std::size_t last = end_of_sum(operand->end);
      if (may_follow(last)) report({begin, last}, *operand, unit, false, found);
    }
  }

  void check_variable(std::size_t begin, const Operand& operand, std::vector<Found>& found) {
    if (const TimeUnit unit = unit_of_variable(declared(operand, is_wide)); unit != TimeUnit::none)
      return check(begin, operand.end, unit, found);
    if (!is_time(declared(operand, is_narrow)) || !may_precede(begin)) return;
    const std::size_t end = end_of_sum(operand.end);
    const std::size_t after = comparison_at(end);
    if (after == end || !begins_operand(after)) return;
    const std::size_t last = read_clock(after);
    if (last != after && may_follow(last)) report({begin, last}, operand, unit_of_clock(after), false, found);
  }

  void check_difference(std::size_t begin, TimeUnit unit, const Operand& operand, std::vector<Found>& found) {
    const std::size_t declaration = declared(operand, is_narrow);
    if (declaration == kNone) return;
    std::size_t first = begin, end = operand.end;
    const bool peeled = peel(first, end);
    if (!matters(first, end, peeled)) return;
    if (!is_time(declaration) && !is_advanced(operand, end)) return;
    report({begin, operand.end}, operand, unit, true, found);
  }

  /// Extends the range of an expression by parentheses and by casts to types that keep all bits. Returns
  /// whether the range was extended.
  bool peel(std::size_t& begin, std::size_t& end) const {
    bool peeled = false;
    while (begin > 1 && text(begin - 1) == "(" && text(end) == ")") {
      const std::size_t open = begin - 1;
      const std::string_view before = text(open - 1);
      ArithmeticType type;
      std::size_t first = open;
      if (before == ")" && names_.partner(open - 1) != kNone) {  // (long)(a - b)
        const std::size_t cast = names_.partner(open - 1);
        if (names_.read_type(cast + 1, type) != open - 1 || !is_wide(type)) return peeled;
        first = cast;
      } else if (before == ">" && !(open > 1 && is_adjacent(open - 2) && text(open - 2) == "-")) {
        std::size_t less = open - 1;
        while (less > 0 && open - less < 6 && text(less) != "<") --less;
        if (less > 0 && text(less - 1) == "static_cast") {
          if (names_.read_type(less + 1, type) != open - 1 || !is_wide(type)) return peeled;
          first = less - 1;
        }
      } else if (is_name(before) && before != "return") {  // float(a - b)
        if (names_.read_type(open - 1, type) != open || !is_wide(type)) return peeled;
        first = open - 1;
      }
      begin = first;
      ++end;
      peeled = true;
    }
    return peeled;
  }

  /// Returns whether a wrong difference certainly has an effect: it is compared, divided, multiplied by a
  /// fraction, or stored with all bits. A variable with 16 bits stores only the correct bits.
  bool matters(std::size_t begin, std::size_t end, bool peeled) const {
    if (comparison_at(end) != end) return may_precede(begin);
    if (is_comparison_before(begin)) return may_follow(end);
    if (peeled && text(end) == "/") return may_precede(begin);
    if (peeled && text(end) == "*" && text(end + 2) == "." && is_adjacent(end + 1)) return may_precede(begin);
    if (peeled && text(begin - 1) == "/") return true;
    const bool stores = text(begin - 1) == "=" && (text(end) == ";" || text(end) == ",");
    return stores && is_kept(begin - 2);
  }

  /// Returns whether the variable before the `=` keeps all bits. Its name ends at `at`.
  bool is_kept(std::size_t at) const {
    if (text(at) == "+") --at;
    if (text(at) == "]" && names_.partner(at) != kNone) at = names_.partner(at) - 1;
    return is_name_at(at) && names_.all_of(text(at), is_wide);
  }

  /// Returns whether the variable is advanced by the value that the difference is compared with:
  /// `if (millis() - next >= 500) next += 500;`. The comparison begins at `at`.
  bool is_advanced(const Operand& operand, std::size_t at) const {
    const std::size_t period = comparison_at(at);
    if (period == at || text(period + 1) != ")") return false;
    const std::size_t wanted = names_.resolve(operand.name, operand.is_member);
    for (std::size_t i = period; i < words_.size() && i - period < kMostOfExpression; ++i) {
      if (!begins_operand(i)) continue;
      const auto other = read_operand(i);
      if (other && is_pair(other->end, '+', '=') && text(other->end + 2) == text(period) &&
          text(other->end + 3) == ";" && names_.resolve(other->name, other->is_member) == wanted)
        return true;
    }
    return false;
  }

  /// Returns the index after the comparison operator at `at`, or `at` if no such operator begins there.
  std::size_t comparison_at(std::size_t at) const {
    if (is_pair(at, '=', '=') || is_pair(at, '!', '=') || is_pair(at, '<', '=') || is_pair(at, '>', '='))
      return at + 2;
    const bool is_one =
        (text(at) == "<" && !is_pair(at, '<', '<')) || (text(at) == ">" && !is_pair(at, '>', '>'));
    return is_one ? at + 1 : at;
  }
  bool is_comparison_before(std::size_t at) const {
    if (at < 3) return false;
    const std::size_t last = at - 1;
    if (text(last) == "=") return comparison_at(last - 1) == at;
    return comparison_at(last) == at && !is_pair(last - 1, '-', '>') &&
           !is_pair(last - 1, text(last)[0], text(last)[0]);
  }

  /// Returns whether a comparison can begin at `at`: no operator before it binds more tightly.
  bool may_precede(std::size_t at) const {
    if (at == 0) return true;
    const std::string_view before = text(at - 1);
    return (before.size() == 1 && std::string_view("({};,?:=").find(before) != before.npos) ||
           before == "return" || (at > 1 && (is_pair(at - 2, '&', '&') || is_pair(at - 2, '|', '|')));
  }
  /// Returns whether a comparison can end before `at`.
  bool may_follow(std::size_t at) const {
    const std::string_view after = text(at);
    return (after.size() == 1 && std::string_view(");,?:").find(after) != after.npos) ||
           is_pair(at, '&', '&') || is_pair(at, '|', '|');
  }

  void report(std::pair<std::size_t, std::size_t> range, const Operand& operand, TimeUnit unit,
              bool is_difference, std::vector<Found>& found) {
    const std::size_t declaration = names_.resolve(operand.name, operand.is_member);
    if (!told_.insert(declaration).second) return;
    const ArithmeticType type = names_.all()[declaration].type;
    const std::string_view name = text(operand.name);
    const Token& first = words_[range.first];
    const std::string expression = in_one_line(source(range.first, range.second));
    const int least_wrong = 1 << (type.bits - (type.is_signed ? 1 : 0));
    std::string warning = fmt::format(
        "{}:{}: warning: '{}' is wrong from {:.3f} {} after power-on, because '{}' cannot exceed {}: declare "
        "'{}' as unsigned long",
        first.file, first.line, expression, least_wrong / 1000.0, unit == TimeUnit::ms ? "s" : "ms", name,
        least_wrong - 1, name);
    if (is_difference) warning += fmt::format(", or write (uint{}_t)({})", type.bits, expression);
    found.push_back({name, std::move(warning)});
  }

  /// Returns the words from `begin` to `end`, with spaces around binary operators.
  std::string source(std::size_t begin, std::size_t end) const {
    std::string result;
    for (std::size_t i = begin; i < end; ++i) {
      const bool is_arrow = is_pair(i, '-', '>') || (i > begin && is_pair(i - 1, '-', '>'));
      const bool joins = i > begin && is_operator(text(i - 1)) && is_operator(text(i)) && is_adjacent(i - 1);
      const bool spaced = !is_arrow && is_operator(text(i));
      if (spaced && !joins) result += ' ';
      result += text(i);
      const bool goes_on = is_operator(text(i + 1)) && is_adjacent(i);
      if (spaced && !goes_on) result += ' ';
    }
    return result;
  }
  static bool is_operator(std::string_view word) {
    return word.size() == 1 && std::string_view("-+*<>=!").find(word) != word.npos;
  }

  const std::vector<Token>& words_;
  Declarations names_;
  std::vector<TimeUnit> times_;  ///< per declaration; `none` if the variable is not set to a time
  std::set<std::size_t> told_;
};

int int_bits_of(const BoardSpec& board) { return std::string_view(board.chip->target) == "avr" ? 16 : 32; }

}  // namespace

std::string clock_warnings(const std::string& preprocessed, const std::vector<std::string>& own_files,
                           const BoardSpec& board) {
  const std::string own = own_lines(preprocessed, own_files);
  const std::vector<Token> words = tokens_of(own);
  const std::vector<Found> found = ClockCheck(words, int_bits_of(board)).warnings();
  if (found.empty()) return "";
  // Skips warnings about doubtful names: a library's class may have a member with this name, but with another
  // type.
  const std::vector<Token> all = tokens_of(preprocessed);
  const Declarations names(all, int_bits_of(board));
  std::set<std::string_view> in_doubt;
  for (const Declaration& one : names.all())
    if (one.end == 0 && !is_narrow(one.type)) in_doubt.insert(one.name);
  std::string text;
  for (const Found& one : found)
    if (!in_doubt.contains(one.name)) text += (text.empty() ? "" : "\n") + one.text;
  return text;
}

}  // namespace robosim::build
