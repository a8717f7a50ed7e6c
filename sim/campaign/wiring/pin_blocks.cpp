#include "sim/campaign/wiring/pin_blocks.h"

#include <algorithm>
#include <map>
#include <set>

namespace robosim::wiring {
namespace {

bool is_number(const std::string& text) {
  return !text.empty() && text.size() < 6 && text.find_first_not_of("0123456789") == std::string::npos;
}

// Returns the level of `HIGH`, `0` or `200`.
std::optional<int> level_of(const std::string& value) {
  if (value == "HIGH" || value == "true") return 1;
  if (value == "LOW" || value == "false") return 0;
  if (is_number(value)) return std::stoi(value);
  return {};
}

class BlockResolver {
 public:
  BlockResolver(const std::vector<Comment>& comments, const Resolver& resolver)
      : comments_(comments), resolver_(resolver) {}

  PinBlock resolve(const Block& block) const {
    PinBlock result{block.function, words_of(block.function), false, sense_of(block), {}, block.runs};
    for (const Statement& statement : block.statements) {
      add_write(block, statement, result);
      result.shifts_out |= statement.tokens[0].is("shiftOut");
    }
    return result;
  }

 private:
  // Returns the direction that a condition such as `speed >= 0` or, without one, the function's name states.
  static int sense_of(const Block& block) {
    const WordList words = words_of(block.function);
    int sense = function_goes_forward(words) ? 1 : function_goes_backward(words) ? -1 : 0;
    for (const Condition& condition : block.conditions)
      if (const int sign = sign_of(condition, block); sign != 0) sense = sign;
    return sense == 0 && reads_sensors_alike(block) ? 1 : sense;
  }

  // Returns whether the block runs while several sensors read the same level: `if (left == LOW && right ==
  // LOW)`. The robot then drives straight.
  static bool reads_sensors_alike(const Block& block) {
    if (block.conditions.empty() || block.conditions.back().is_negated) return false;
    const Tokens& tokens = block.conditions.back().tokens;
    const auto count = [&](const char* text) {
      return std::count_if(tokens.begin(), tokens.end(), [&](const Token& token) { return token.is(text); });
    };
    const auto reads = count("digitalRead"), denied = count("!");
    const auto low = count("LOW") + count("0"), high = count("HIGH") + count("1");
    const bool is_plain = low + high == 0 && (denied == 0 || denied == reads);
    const bool is_compared = denied == 0 && (low == reads) != (high == reads) && low + high == reads;
    return reads >= 2 && (is_plain || is_compared);
  }

  // Returns 1 for `speed >= 0`, -1 for `speed < 0`, 0 for other conditions.
  static int sign_of(const Condition& condition, const Block& block) {
    const Tokens& tokens = condition.tokens;
    const bool has_equal = tokens.size() == 4 && tokens[2].is("=");
    if ((tokens.size() != 3 && !has_equal) || tokens[0].kind != Token::Kind::word || !tokens.back().is("0"))
      return 0;
    const WordList words = words_of(tokens[0].text);
    const bool is_speed = says(words, {"speed", "spd", "vel", "pwm", "power", "pow", "hiz", "duty", "vit",
                                       "mot", "throttle", "geschw", "tempo", "kec"}) ||
                          only_side(words) != Side::unknown;
    const bool is_parameter =
        std::find(block.parameters.begin(), block.parameters.end(), tokens[0].text) != block.parameters.end();
    const bool is_error = says(words, {"err", "pos", "dif", "turn", "corr", "pid", "dist", "dev", "adj"});
    if (!(is_speed || is_parameter) || is_error) return 0;
    const int sign = tokens[1].is(">") ? 1 : tokens[1].is("<") ? -1 : 0;
    return condition.is_negated ? -sign : sign;
  }

  void add_write(const Block& block, const Statement& statement, PinBlock& result) const {
    const Tokens& tokens = statement.tokens;
    if (tokens.size() < 5 || !tokens[1].is("(")) return;
    const bool is_pwm = tokens[0].is("analogWrite");
    if (!is_pwm && !tokens[0].text.starts_with("digitalWrite")) return;
    const auto comma = std::find_if(tokens.begin(), tokens.end(), [](const Token& t) { return t.is(","); });
    if (comma == tokens.end()) return;
    const Tokens value(comma + 1, tokens.end() - 1);
    std::string argument;
    for (auto token = tokens.begin() + 2; token != comma; ++token)
      argument += (argument.empty() ? "" : " ") + token->str();
    const std::vector<Pin> pins = resolver_.pins_of(argument);
    const auto parameter = std::find(block.parameters.begin(), block.parameters.end(), argument);
    const bool is_parameter = parameter != block.parameters.end();
    if (pins.size() != 1 && !is_parameter) return;
    PinWrite write{is_parameter ? kNoPin : pins[0], {}, is_pwm, commented_side(block, statement.line)};
    if (is_parameter) write.parameter = static_cast<int>(parameter - block.parameters.begin());
    write.is_said_off = says_off(statement.line);
    if (value.size() == 1) write.level = level_of(resolver_.value_of(value[0].str()));
    // digitalWrite(IN1, speed > 0) also shows which level is forward.
    const auto condition_end =
        std::find_if(value.begin(), value.end(), [](const Token& t) { return t.is("?"); });
    const int sign = sign_of({{value.begin(), condition_end}, false, 0}, block);
    if (sign != 0 && !is_pwm && (condition_end == value.end() || (condition_end + 1)->is("HIGH"))) {
      write.level = sign > 0 ? 1 : 0;
      if (result.sense == 0) result.sense = 1;
    }
    if (write.side == Side::unknown && is_pwm) write.side = only_side(words_of(value));
    if (write.side == Side::unknown) write.side = side_of_conditions(block);
    result.writes.push_back(write);
  }

  bool says_off(int line) const {
    return std::any_of(comments_.begin(), comments_.end(), [&](const Comment& comment) {
      return comment.line == line && !comment.is_alone &&
             says(comment.words, {"deslig", "off", "apag", "stop", "parad", "aus", "arret", "spegn"});
    });
  }

  static Side side_of_conditions(const Block& block) {
    for (const Condition& condition : block.conditions)
      if (sign_of(condition, block) != 0) return only_side(words_of(condition.tokens[0].text));
    return Side::unknown;
  }

  // Returns the side that the comment in a line names. If it names none, the last full-line comment above
  // decides. Only comments about motors count, not `// turn left`.
  Side commented_side(const Block& block, int line) const {
    Side side = Side::unknown;
    for (const Comment& comment : comments_) {
      if (comment.line > line) break;
      if (comment.line < block.first_line - 1) continue;
      const bool is_here = comment.line == line && !comment.is_alone;
      if (!is_here && !comment.is_alone) continue;
      const WordList& words = comment.words;
      const Side one = names_motor(words) ? only_side(words) : Side::unknown;
      if (comment.is_alone || one != Side::unknown) side = one;
    }
    return side;
  }

  const std::vector<Comment>& comments_;
  const Resolver& resolver_;
};

// Returns the pin of each argument of a call; kNoPin if it is not a pin.
std::vector<Pin> arguments_of(const Tokens& call, const Resolver& resolver) {
  std::vector<Pin> pins;
  std::string argument;
  int depth = 0;
  const auto finish = [&] {
    const std::vector<Pin> found = resolver.pins_of(argument);
    pins.push_back(found.size() == 1 ? found[0] : kNoPin);
    argument.clear();
  };
  for (std::size_t i = 1; i < call.size(); ++i) {
    if (call[i].is("(") && ++depth == 1) continue;
    if (call[i].is(")") && --depth == 0) break;
    if (call[i].is(",") && depth == 1)
      finish();
    else
      argument += (argument.empty() ? "" : " ") + call[i].str();
  }
  finish();
  return pins;
}

// Replaces the function's parameters by the pins of a call.
void substitute(const std::vector<Pin>& pins, std::vector<PinWrite>& writes) {
  for (PinWrite& write : writes) {
    const auto position = static_cast<std::size_t>(write.parameter);
    if (write.parameter >= 0 && position < pins.size()) write.pin = pins[position];
    write.parameter = -1;
  }
  std::erase_if(writes, [](const PinWrite& write) { return write.pin == kNoPin; });
}

// If a block has no writes, adds the writes of the functions that it calls.
void inline_calls(const std::vector<Block>& blocks, const Resolver& resolver,
                  std::vector<PinBlock>& results) {
  constexpr std::size_t kMostWrites = 4;
  std::map<std::string, std::vector<std::size_t>> by_function;
  for (std::size_t i = 0; i < results.size(); ++i) by_function[results[i].function].push_back(i);
  const std::vector<PinBlock> direct = results;
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    if (!direct[i].writes.empty()) continue;
    for (const Statement& statement : blocks[i].statements) {
      if (statement.tokens.size() < 3 || !statement.tokens[1].is("(")) continue;
      const auto callee = by_function.find(statement.tokens[0].str());
      if (callee == by_function.end() || callee->second.size() != 1) continue;
      std::vector<PinWrite> writes = direct[callee->second[0]].writes;
      substitute(arguments_of(statement.tokens, resolver), writes);
      if (writes.size() <= kMostWrites)
        results[i].writes.insert(results[i].writes.end(), writes.begin(), writes.end());
    }
  }
}

// Replaces blocks that write to parameters by one block for each call: motor(PWMA, IN1, IN2, speed).
void insert_arguments(const std::vector<Block>& blocks, const Resolver& resolver,
                      std::vector<PinBlock>& results) {
  constexpr std::size_t kMostBlocks = 2000;
  const auto has_parameter = [](const PinBlock& block) {
    return std::any_of(block.writes.begin(), block.writes.end(),
                       [](const PinWrite& write) { return write.parameter >= 0; });
  };
  std::map<std::string, std::vector<PinBlock>> templates;
  for (const PinBlock& block : results)
    if (has_parameter(block)) templates[block.function].push_back(block);
  for (const Block& block : blocks)
    for (const Statement& statement : block.statements) {
      const auto callee = statement.tokens.size() > 2 && statement.tokens[1].is("(")
                              ? templates.find(statement.tokens[0].str())
                              : templates.end();
      if (callee == templates.end() || results.size() > kMostBlocks) continue;
      const std::vector<Pin> pins = arguments_of(statement.tokens, resolver);
      for (PinBlock copy : callee->second) {
        substitute(pins, copy.writes);
        copy.runs &= block.runs;
        results.push_back(std::move(copy));
      }
    }
  std::erase_if(results, has_parameter);
}

std::optional<int> level_in(const PinBlock& block, Pin pin) {
  std::optional<int> level;
  for (const PinWrite& write : block.writes)
    if (write.pin == pin) level = write.level ? *write.level : write.is_pwm ? 255 : std::optional<int>();
  return level;
}

// Returns 1 if the block sets in1 HIGH and in2 LOW, -1 for the reverse, 0 for neither.
int turn_in(const PinBlock& block, const MotorPins& motor) {
  const std::optional<int> one = level_in(block, motor.in1);
  if (motor.in2 == kNoPin) return !one ? 0 : *one > 0 ? 1 : -1;
  const std::optional<int> two = level_in(block, motor.in2);
  if (!one || !two || (*one > 0) == (*two > 0)) return 0;
  return *one > 0 ? 1 : -1;
}

// Returns the speed with which a block drives a motor; above 0 = forward. Empty if the block does not drive
// the motor.
std::optional<int> speed_in(const PinBlock& block, const MotorPins& motor, int forward) {
  const std::optional<int> enable = level_in(block, motor.en);
  if (motor.in1 == kNoPin) return enable;
  const bool is_written = level_in(block, motor.in1) || level_in(block, motor.in2);
  if (!is_written) return {};
  if (forward == 0) return {};
  const int turn = turn_in(block, motor) * forward;
  if (turn == 0 || !enable || motor.en == kNoPin) return turn == 0 ? 0 : turn * 255;
  return turn * *enable;
}

// Returns `answer` of the blocks that run. If that result is empty, returns `answer` of all blocks.
template <typename Answer>
auto from_running_first(const std::vector<PinBlock>& blocks, Answer answer) {
  std::vector<PinBlock> running;
  std::copy_if(blocks.begin(), blocks.end(), std::back_inserter(running),
               [](const PinBlock& block) { return block.runs; });
  const auto result = answer(running);
  return result != decltype(result){} ? result : answer(blocks);
}

Side side_of_pin(const std::vector<PinBlock>& blocks, Pin pin) {
  constexpr std::size_t kMostOfOneMotor = 3;
  std::map<std::string, std::set<Pin>> written;
  for (const PinBlock& block : blocks)
    for (const PinWrite& write : block.writes) written[block.function].insert(write.pin);
  Side side = Side::unknown;
  for (const PinBlock& block : blocks)
    for (const PinWrite& write : block.writes) {
      if (write.pin != pin) continue;
      const bool is_one_motor =
          written[block.function].size() <= kMostOfOneMotor && written[block.function].size() > 1;
      const Side one = write.side != Side::unknown ? write.side
                       : is_one_motor              ? only_side(block.words)
                                                   : Side::unknown;
      if (one == Side::unknown) continue;
      if (side != Side::unknown && side != one) return Side::unknown;
      side = one;
    }
  return side;
}

int forward_of(const std::vector<PinBlock>& blocks, const MotorPins& motor) {
  if (motor.in1 == kNoPin) return 0;
  int forward = 0, backward = 0;
  std::set<int> seen;
  for (const PinBlock& block : blocks) {
    const int turn = turn_in(block, motor);
    if (turn == 0) continue;
    seen.insert(turn);
    if (block.sense != 0) ++(turn * block.sense > 0 ? forward : backward);
  }
  if (forward != backward && std::min(forward, backward) == 0) return forward > 0 ? 1 : -1;
  if (forward + backward > 0 || seen.size() != 1) return 0;
  return *seen.begin();
}

int order_of(const std::vector<PinBlock>& blocks, const MotorPins& left, const MotorPins& right,
             int left_forward, int right_forward) {
  int confirms = 0, contradicts = 0;
  for (const PinBlock& block : blocks) {
    const Side turn = turn_of_function(block.words);
    const std::optional<int> l = speed_in(block, left, left_forward),
                             r = speed_in(block, right, right_forward);
    if (turn == Side::unknown || !l || !r || *l == *r) continue;
    ++((*l < *r) == (turn == Side::left) ? confirms : contradicts);
  }
  if (confirms > 0 && contradicts == 0) return 1;
  return contradicts > 0 && confirms == 0 ? -1 : 0;
}

}  // namespace

std::vector<PinBlock> pin_blocks(const std::vector<SourceText>& sources, const Resolver& resolver) {
  std::vector<Block> blocks;
  std::vector<PinBlock> results;
  for (const SourceText& source : sources) {
    const BlockResolver reader(source.comments, resolver);
    for (const Block& block : source.blocks) results.push_back(reader.resolve(block));
    blocks.insert(blocks.end(), source.blocks.begin(), source.blocks.end());
  }
  inline_calls(blocks, resolver, results);
  insert_arguments(blocks, resolver, results);
  std::erase_if(results, [](const PinBlock& block) { return block.writes.empty(); });
  return results;
}

Side side_in_blocks(const std::vector<PinBlock>& blocks, Pin pin) {
  return from_running_first(blocks, [&](const std::vector<PinBlock>& all) { return side_of_pin(all, pin); });
}

int forward_in_blocks(const std::vector<PinBlock>& blocks, const MotorPins& motor) {
  return from_running_first(blocks, [&](const std::vector<PinBlock>& all) { return forward_of(all, motor); });
}

int order_in_blocks(const std::vector<PinBlock>& blocks, const MotorPins& left, const MotorPins& right,
                    int left_forward, int right_forward) {
  return from_running_first(blocks, [&](const std::vector<PinBlock>& all) {
    return order_of(all, left, right, left_forward, right_forward);
  });
}

}  // namespace robosim::wiring
