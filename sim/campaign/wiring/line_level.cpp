#include "sim/campaign/wiring/line_level.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "sim/campaign/wiring/colour_words.h"
#include "sim/campaign/wiring/name_words.h"

namespace robosim::wiring {
namespace {

// A part of a condition: a comparison of a reading with a level or a threshold.
struct Test {
  int sign = 0;  // 1: true for a high reading; -1: for a low one; 0: not a test of a sensor
  Side side = Side::unknown;
};

// Removes parentheses around the whole text.
Tokens without_brackets(Tokens tokens) {
  while (tokens.size() > 2 && tokens.front().is("(") && tokens.back().is(")")) {
    int depth = 0;
    std::size_t end = 0;
    for (; end < tokens.size(); ++end) {
      if (tokens[end].is("(")) ++depth;
      if (tokens[end].is(")") && --depth == 0) break;
    }
    if (end + 1 != tokens.size()) break;
    tokens = {tokens.begin() + 1, tokens.end() - 1};
  }
  return tokens;
}

// Splits a condition at && and ||.
std::vector<Tokens> parts_of(const Tokens& condition) {
  std::vector<Tokens> parts(1);
  const Tokens tokens = without_brackets(condition);
  int depth = 0;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    if (tokens[i].is("(")) ++depth;
    if (tokens[i].is(")")) --depth;
    const bool is_joint = tokens[i].is("&") || tokens[i].is("|") || tokens[i].is("and") || tokens[i].is("or");
    if (depth > 0 || !is_joint)
      parts.back().push_back(tokens[i]);
    else if (!parts.back().empty())
      parts.emplace_back();
  }
  return parts;
}

class TestReader {
 public:
  using Constants = std::map<std::string, std::string>;
  explicit TestReader(const Constants& constants) : constants_(constants) {}

  Test read(const Tokens& expression) const {
    Tokens tokens = without_brackets(expression);
    int sign = 1;
    while (!tokens.empty() && tokens.front().is("!")) {
      sign = -sign;
      tokens = without_brackets({tokens.begin() + 1, tokens.end()});
    }
    const std::size_t at = operator_in(tokens);
    if (at == tokens.size()) return plain(tokens, sign);
    const bool has_equal = at + 1 < tokens.size() && tokens[at + 1].is("=");
    Tokens left = without_brackets({tokens.begin(), tokens.begin() + static_cast<std::ptrdiff_t>(at)});
    Tokens right = without_brackets(
        {tokens.begin() + static_cast<std::ptrdiff_t>(at + (has_equal ? 2 : 1)), tokens.end()});
    const bool is_equality = has_equal && (tokens[at].is("=") || tokens[at].is("!"));
    if (is_equality) return equality(left, right, tokens[at].is("!") ? -sign : sign);
    if (is_constant(left) && !is_constant(right)) {
      std::swap(left, right);
      sign = -sign;
    }
    return compared(left, tokens[at].is(">") ? sign : -sign);
  }

 private:
  // Returns the index of the comparison outside of brackets.
  static std::size_t operator_in(const Tokens& tokens) {
    int depth = 0;
    for (std::size_t i = 0; i < tokens.size(); ++i) {
      if (tokens[i].is("(") || tokens[i].is("[")) ++depth;
      if (tokens[i].is(")") || tokens[i].is("]")) --depth;
      if (depth > 0) continue;
      const bool is_shift = (i > 0 && tokens[i].is(tokens[i - 1].text)) ||
                            (i + 1 < tokens.size() && tokens[i + 1].is(tokens[i].text));
      if (is_shift && !tokens[i].is("=")) continue;
      const bool is_next_equal = i + 1 < tokens.size() && tokens[i + 1].is("=");
      if (tokens[i].is("<") || tokens[i].is(">") ||
          (is_next_equal && (tokens[i].is("=") || tokens[i].is("!"))))
        return i;
    }
    return tokens.size();
  }

  bool is_constant(const Tokens& tokens) const {
    if (tokens.size() != 1) return false;
    const std::string value = value_of(tokens[0].str());
    return tokens[0].kind == Token::Kind::number || value == "HIGH" || value == "LOW" || value == "true" ||
           value == "false" || (!value.empty() && std::isdigit(static_cast<unsigned char>(value[0])) != 0);
  }

  static bool is_call_of(const Tokens& tokens, const char* function) {
    return std::any_of(tokens.begin(), tokens.end(), [&](const Token& token) { return token.is(function); });
  }

  // Returns whether the tokens can be a sensor's reading.
  static bool is_reading(const Tokens& tokens) {
    if (tokens.empty() || tokens[0].kind != Token::Kind::word) return false;
    return !says(words_of(tokens),
                 {"dist",  "cm",   "time", "millis", "count", "sum",   "err",   "pos",   "speed", "serial",
                  "avail", "butt", "btn",  "bot",    "puls",  "start", "mode",  "flag",  "i",     "total",
                  "vel",   "dur",  "ping", "son",    "echo",  "batt",  "state", "timer", "delay", "ultra"}) ||
           is_call_of(tokens, "digitalRead") || is_call_of(tokens, "analogRead");
  }

  Test compared(const Tokens& reading, int sign) const {
    const bool is_inverted =
        reading.size() > 2 && reading[0].kind == Token::Kind::number && reading[1].is("-");
    const Tokens inner = is_inverted ? Tokens(reading.begin() + 2, reading.end()) : reading;
    if (!is_reading(inner)) return {};
    return {is_inverted ? -sign : sign, only_side(words_of(inner))};
  }

  // Reads `digitalRead(LEFT)` without a comparison.
  Test plain(const Tokens& tokens, int sign) const {
    const bool is_read = !tokens.empty() && tokens[0].is("digitalRead");
    const bool is_side = tokens.size() == 1 && only_side(words_of(tokens)) != Side::unknown;
    return is_read || is_side ? compared(tokens, sign) : Test{};
  }

  Test equality(Tokens left, Tokens right, int sign) const {
    if (is_constant(left)) std::swap(left, right);
    if (right.size() != 1) return {};
    const std::string value = value_of(right[0].str());
    const bool is_high = value == "HIGH" || value == "1" || value == "true";
    const bool is_low = value == "LOW" || value == "0" || value == "false";
    // A comparison with BLACK shows no level.
    if ((!is_high && !is_low) || colour_of(words_of(right[0].text)) != 0) return {};
    return compared(left, is_high ? sign : -sign);
  }

  // Returns the value of a constant, or the word itself.
  std::string value_of(std::string word) const {
    constexpr int kMostSteps = 8;
    for (int step = 0; step < kMostSteps && constants_.count(word) != 0; ++step) word = constants_.at(word);
    return word;
  }

  const Constants& constants_;
};

// The levels that the source states, each with its place.
class Votes {
 public:
  enum class Kind { code, remark, inversion };

  void add(Kind kind, int sign, const std::string& text, const std::string& file, int line) {
    if (sign == 0) return;
    Count& count = counts_[kind];
    ++(sign > 0 ? count.high : count.low);
    std::string& why = sign > 0 ? count.why_high : count.why_low;
    if (why.empty()) why = fmt::format("{}, {}:{}", text, file, line);
  }

  // Adds the level that follows from a name such as turnLeft(). If the name is wrong, so is the level.
  void add_turn(int sign, const std::string& file, int line) {
    ++turns_;
    add(Kind::remark, sign, "the turn", file, line);
  }

  bool is_empty() const { return counts_.empty(); }

  std::optional<StatedLevel> result() const {
    Count all;
    for (const Kind kind : {Kind::code, Kind::remark, Kind::inversion}) {
      const auto count = counts_.find(kind);
      if (count == counts_.end()) continue;
      all.high += count->second.high;
      all.low += count->second.low;
      if (all.why_high.empty()) all.why_high = count->second.why_high;
      if (all.why_low.empty()) all.why_low = count->second.why_low;
      if (kind == Kind::code) break;
    }
    constexpr int kClear = 3;
    if (all.high > kClear * all.low) return StatedLevel{true, all.why_high, all.high == turns_};
    if (all.low > kClear * all.high) return StatedLevel{false, all.why_low, all.low == turns_};
    return {};
  }

 private:
  struct Count {
    int high = 0, low = 0;
    std::string why_high, why_low;
  };
  std::map<Kind, Count> counts_;
  int turns_ = 0;
};

class LevelReader {
 public:
  explicit LevelReader(const std::vector<SourceText>& sources)
      : sources_(sources), assignments_(assignments_in(sources)), tests_(constants_) {
    find_constants();
    for (const SourceText& source : sources)
      for (std::size_t i = 1; i < source.tokens.size(); ++i)
        reads_plainly_ |= source.tokens[i].is("digitalRead") && source.tokens[i - 1].is("=");
    bool white = false, black = false;
    for (const SourceText& source : sources) {
      for (const Comment& comment : source.comments) {
        const WordList& words = comment.words;
        if (is_instruction(words) || is_condition(words)) continue;
        white |= has_white_line(words);
        black |= has_black_line(words);
      }
      for (const Token& token : source.tokens) {
        if (token.kind != Token::Kind::word) continue;
        white |= token.is("readLineWhite") || has_white_line(words_of(token.text));
        black |= token.is("readLineBlack") || has_black_line(words_of(token.text));
      }
    }
    line_ = white && !black ? -1 : 1;
  }

  std::optional<StatedLevel> read() {
    // Code that does not run counts only if running code states nothing.
    for (const bool only_running : {true, false}) {
      for (const SourceText& source : sources_) read_source(source, only_running);
      if (!votes_.is_empty()) break;
    }
    return votes_.result();
  }

 private:
  void read_source(const SourceText& source, bool only_running) {
    source_ = &source;
    read_library();
    read_constants();
    std::set<int> idle;  // lines of blocks that do not run; their comments do not count
    for (const Block& block : source.blocks)
      if (only_running && !block.runs)
        for (int line = block.first_line; line <= block.last_line; ++line) idle.insert(line);
      else
        read_block(block);
    // A comment next to a computed value, such as `error`, describes that value.
    for (const Token& token : source.tokens)
      if (token.kind == Token::Kind::word &&
          says(words_of(token.text),
               {"err", "pos", "offset", "dev", "diff", "turn", "steer", "corr", "speed"}))
        idle.insert(token.line);
    for (const Comment& comment : source.comments)
      if (!idle.contains(comment.line) && !is_instruction(comment.words)) read_comment(comment);
  }

  // Returns 1 if the words name black or the black line, -1 for white.
  int meaning_of(const WordList& words) const {
    const int colour = colour_of(words);
    return colour != 0 ? colour : line_of(words) * line_;
  }
  int meaning_of_sentence(const WordList& words) const {
    const int colour = colour_of(words);
    return colour != 0 ? colour : line_in_sentence(words) * line_;
  }

  void add(Votes::Kind kind, int sign, const std::string& text, int line) {
    votes_.add(kind, sign, text, source_->file, line);
  }

  // Pololu's library returns large readings over black, and searches the readings for a black or a white
  // line.
  void read_library() {
    for (const Token& token : source_->tokens)
      if (token.kind == Token::Kind::word && token.text.starts_with("QTRSensors")) {
        add(Votes::Kind::code, 1, token.str(), token.line);
        return;
      }
  }

  // Reads `#define BLACK HIGH` and `const int white = 0;`.
  void read_constants() {
    const Tokens& tokens = source_->tokens;
    for (std::size_t i = 0; i + 2 < tokens.size(); ++i) {
      const bool is_define = tokens[i].kind == Token::Kind::define && tokens[i + 2].is(kEndOfDefine);
      const bool is_value = tokens[i].kind == Token::Kind::word && tokens[i + 1].is("=") &&
                            i + 3 < tokens.size() && !tokens[i + 2].is("=") && is_end(tokens[i + 3]);
      if (!is_define && !(is_value && is_assigned_once(tokens[i].str()))) continue;
      const std::string_view value = tokens[i + (is_define ? 1 : 2)].text;
      const bool is_word = value == "HIGH" || value == "LOW";
      if (!is_word && value != "0" && value != "1" && value != "true" && value != "false") continue;
      const WordList words = words_of(tokens[i].text);
      if (says(words, {"led", "rgb", "pin", "max", "min", "count", "num"})) continue;
      const int meaning = colour_of(words) != 0 ? colour_of(words) : is_word ? meaning_of(words) : 0;
      const bool is_high = value == "HIGH" || value == "1" || value == "true";
      add(Votes::Kind::code, is_high ? meaning : -meaning, fmt::format("{} {}", tokens[i].text, value),
          tokens[i].line);
    }
  }

  static bool is_end(const Token& token) { return token.is(";") || token.is(",") || token.is("}"); }

  // Finds the constants: words that are assigned only once, and whose value is a single word.
  void find_constants() {
    for (const SourceText& source : sources_)
      for (std::size_t i = 0; i + 2 < source.tokens.size(); ++i) {
        const Tokens& tokens = source.tokens;
        const bool is_define = tokens[i].kind == Token::Kind::define && tokens[i + 2].is(kEndOfDefine);
        const bool is_set = tokens[i].kind == Token::Kind::word && tokens[i + 1].is("=") &&
                            i + 3 < tokens.size() && is_end(tokens[i + 3]) &&
                            is_assigned_once(tokens[i].str());
        if (is_define || is_set) constants_[tokens[i].str()] = tokens[i + (is_define ? 1 : 2)].str();
      }
  }

  bool is_assigned_once(const std::string& name) const {
    const auto count = assignments_.find(name);
    return count != assignments_.end() && count->second == 1;
  }

  // Replaces arrows by spaces, and signs by words.
  static std::string with_signs_as_words(std::string_view text) {
    std::string result;
    for (std::size_t i = 0; i < text.size(); ++i) {
      const std::string_view two = text.substr(i, 2);
      const bool is_arrow = two == "->" || two == "=>" || two == "<-";
      if (is_arrow) ++i;
      result += is_arrow        ? " "
                : two[0] == '>' ? " gt "
                : two[0] == '<' ? " lt "
                : two[0] == '=' ? " eq "
                                : two.substr(0, 1);
    }
    return result;
  }

  // Reads "HIGH = black, LOW = white" and "1 sobre la linea".
  void read_comment(const Comment& comment) {
    const WordList words = words_of_text(with_signs_as_words(comment.text));
    const auto numbers = std::count_if(words.begin(), words.end(), [](const std::string& word) {
      return std::isdigit(static_cast<unsigned char>(word[0])) != 0;
    });
    constexpr std::ptrdiff_t kMostNumbers = 2;  // more are a table of readings
    const bool has_both =
        std::count(words.begin(), words.end(), "0") == 1 && std::count(words.begin(), words.end(), "1") == 1;
    if (numbers > kMostNumbers || (numbers == kMostNumbers && !has_both)) return;
    if (says(words, {"led", "butt", "boton", "botao", "puls", "motor", "pin", "buzz"})) return;
    int sign = 0, level = 0, meaning = 0;
    std::size_t since = 0;
    constexpr std::size_t kFar = 5;  // maximum distance in words between a level and its colour
    const bool has_colour = std::any_of(words.begin(), words.end(), is_black) ||
                            std::any_of(words.begin(), words.end(), is_white);
    for (std::size_t i = 0; i < words.size(); ++i) {
      const bool is_stated = i + 1 < words.size() && words[i + 1] == "eq";
      const bool is_index =
          i > 0 && !is_stated && says({words[i - 1]}, {"sens", "ir", "chan", "kanal", "cas", "step", "s"});
      // A comparison with 0, as in "> 0: the line is on the right", is about a difference, not a level.
      const bool is_comparison = words[i] == "gt" || words[i] == "lt";
      const std::size_t bound = i + (i + 1 < words.size() && words[i + 1] == "eq" ? 2 : 1);
      if (is_comparison && bound < words.size() && words[bound] == "0") return;
      const int one_level = is_index ? 0 : level_of_word(words[i]);
      const int one_meaning = has_colour          ? colour_of({words[i]})
                              : is_line(words[i]) ? line_of({i > 0 ? words[i - 1] : "", words[i]}) * line_
                                                  : 0;
      if (one_level == 0 && one_meaning == 0) continue;
      if (i - since > kFar) level = meaning = 0;
      since = i;
      if (one_level != 0) level = one_level;
      if (one_meaning != 0) meaning = one_meaning;
      if (level == 0 || meaning == 0) continue;
      if (sign != 0 && sign != level * meaning) return;
      sign = level * meaning;
      level = meaning = 0;
    }
    add(Votes::Kind::remark, sign, "a comment", comment.line);
  }

  void read_block(const Block& block) {
    for (const Statement& statement : block.statements) {
      read_assignment(statement);
      read_inversion(statement);
    }
    read_return(block);
    read_flag(block);
    read_branch(block);
  }

  // Reads `bool onLine = analogRead(A0) > 500`.
  void read_assignment(const Statement& statement) {
    const Tokens& tokens = statement.tokens;
    const auto equal = std::find_if(tokens.begin(), tokens.end(), [](const Token& t) { return t.is("="); });
    if (equal == tokens.end() || equal == tokens.begin() || equal + 1 == tokens.end() || (equal + 1)->is("="))
      return;
    const WordList words = words_of({tokens.begin(), equal});
    const bool is_plain = (equal + 1)->is("digitalRead");  // the name lineLeft alone states no level
    const int meaning = is_plain && statement.tokens.back().is(")") ? colour_of(words) : meaning_of(words);
    if (meaning == 0) return;
    const auto question = std::find_if(equal, tokens.end(), [](const Token& t) { return t.is("?"); });
    const Test test = tests_.read({equal + 1, question});
    add(Votes::Kind::code, test.sign * meaning, "a variable of this name", statement.line);
  }

  // Reads `value = 1023 - value` and `seen[i] = !digitalRead(pins[i])`. If a sketch also reads without an
  // inversion, it has two modes, and the inversion shows nothing.
  void read_inversion(const Statement& statement) {
    const Tokens& tokens = statement.tokens;
    for (std::size_t i = 1; i + 2 < tokens.size(); ++i) {
      if (!tokens[i].is("=")) continue;
      const bool is_not = tokens[i + 1].is("!") && tokens[i + 2].is("digitalRead") && !reads_plainly_;
      const bool is_less = (tokens[i + 1].is("1023") || tokens[i + 1].is("1024")) && tokens[i + 2].is("-");
      if (is_not || is_less) add(Votes::Kind::inversion, -line_, "the inverted reading", statement.line);
    }
  }

  // Returns the test of the innermost condition, if all its parts agree. The side is known only if the
  // condition has a single part and is not negated.
  Test test_of(const Block& block) const {
    if (block.conditions.empty()) return {};
    const Condition& condition = block.conditions.back();
    const std::vector<Tokens> parts = parts_of(condition.tokens);
    if (condition.is_negated && parts.size() > 1) return {};
    Test result;
    for (const Tokens& part : parts) {
      const Test test = tests_.read(part);
      if (test.sign == 0 || (result.sign != 0 && result.sign != test.sign)) return {};
      result = test;
    }
    if (parts.size() > 1) result.side = Side::unknown;
    if (condition.is_negated) result = {-result.sign, Side::unknown};
    return result;
  }

  // Reads `bool isBlack(…) { return …; }`, `if (…) return true;` in it, and `case HIGH: return kWhite;`.
  void read_return(const Block& block) {
    const int of_function = meaning_of(words_of(block.function));
    for (const Statement& statement : block.statements) {
      const Tokens& tokens = statement.tokens;
      if (tokens.size() < 2 || !tokens[0].is("return")) continue;
      const Tokens value(tokens.begin() + 1, tokens.end());
      const std::string last = value.back().str();
      const bool is_true = last == "true" || last == "1", is_false = last == "false" || last == "0";
      const int of_value = colour_of(words_of(last));
      if (value.size() == 1 && (is_true || is_false))
        add(Votes::Kind::code, test_of(block).sign * of_function * (is_true ? 1 : -1), block.function + "()",
            statement.line);
      else if (of_value != 0)
        add(Votes::Kind::code, test_of(block).sign * of_value, last, statement.line);
      else
        add(Votes::Kind::code, tests_.read(value).sign * of_function, block.function + "()", statement.line);
    }
  }

  // Reads `if (value > 500) seen = 1;`. A sketch sets such a flag where it sees the line.
  void read_flag(const Block& block) {
    if (block.conditions.empty() || block.conditions.back().is_negated) return;
    const Tokens& condition = block.conditions.back().tokens;
    const bool is_threshold = std::any_of(condition.begin(), condition.end(),
                                          [](const Token& t) { return t.is("<") || t.is(">"); });
    if (!is_threshold || block.statements.size() != 1) return;
    const Statement& statement = block.statements[0];
    const std::size_t size = statement.tokens.size();
    if (size < 3 || !statement.tokens[size - 2].is("=")) return;
    const bool is_set = statement.tokens.back().is("1") || statement.tokens.back().is("true");
    if (is_set) add(Votes::Kind::inversion, test_of(block).sign * line_, "the flag", statement.line);
  }

  // Reads the comments and texts of a branch, and the function that it calls.
  void read_branch(const Block& block) {
    if (block.conditions.empty()) return;
    const Test test = test_of(block);
    const int line = block.conditions.back().line;
    if (test.sign != 0) {
      add(Votes::Kind::remark, test.sign * meaning_of_sentence(words_beside(block)), "a comment", line);
      add(Votes::Kind::remark, test.sign * meaning_of_sentence(texts_of(block)), "a text", line);
    }
    const Side turn = turn_of(block);
    if (turn == Side::unknown || block.conditions.back().is_negated) return;
    int left = 0, right = 0;
    for (const Tokens& part : parts_of(block.conditions.back().tokens)) {
      const Test one = tests_.read(part);
      if (one.side == Side::left) left = one.sign;
      if (one.side == Side::right) right = one.sign;
    }
    // The robot turns towards the sensor that sees the line.
    const int towards = turn == Side::left ? left : right, other = turn == Side::left ? right : left;
    if (towards != 0 && towards != other) votes_.add_turn(towards * line_, source_->file, line);
  }

  // Returns the words of the comment after the condition, or above it.
  const WordList& words_beside(const Block& block) const {
    static const WordList kNone;
    const Condition& condition = block.conditions.back();
    if (condition.is_negated) return kNone;
    for (const Comment& comment : source_->comments) {
      const bool is_above = comment.is_alone && comment.line == condition.line - 1;
      const bool is_after = !comment.is_alone && comment.line == condition.line;
      if (is_above || is_after) return is_instruction(comment.words) ? kNone : comment.words;
    }
    return kNone;
  }

  // Returns the words of the texts that the first statements of a block print.
  static WordList texts_of(const Block& block) {
    constexpr std::size_t kFirstStatements = 2;
    WordList words;
    for (std::size_t i = 0; i < std::min(kFirstStatements, block.statements.size()); ++i) {
      const Tokens& tokens = block.statements[i].tokens;
      if (tokens.size() > 2 && tokens[2].text.starts_with("print"))
        for (const Token& token : tokens)
          if (token.kind == Token::Kind::text) {
            const WordList more = words_of_text(token.text);
            words.insert(words.end(), more.begin(), more.end());
          }
    }
    return words;
  }

  // Returns the side to which the block's first calls turn.
  static Side turn_of(const Block& block) {
    constexpr std::size_t kFirstStatements = 4;
    for (std::size_t i = 0; i < std::min(kFirstStatements, block.statements.size()); ++i) {
      const Tokens& tokens = block.statements[i].tokens;
      if (tokens.size() < 3 || tokens[0].kind != Token::Kind::word || !tokens[1].is("(")) continue;
      const WordList words = words_of(tokens[0].text);
      if (says(words, {"digital", "analog", "delay", "pin"})) continue;
      return turn_of_function(words);
    }
    return Side::unknown;
  }

  const std::vector<SourceText>& sources_;
  std::map<std::string, int> assignments_;
  TestReader::Constants constants_;
  TestReader tests_;
  const SourceText* source_ = nullptr;
  bool reads_plainly_ = false;  // the sketch stores a digitalRead() as it is, not inverted
  int line_ = 1;                // colour of the line: 1 = black, -1 = white
  Votes votes_;
};

}  // namespace

std::optional<StatedLevel> level_in_source(const std::vector<SourceText>& sources) {
  return LevelReader(sources).read();
}

}  // namespace robosim::wiring
