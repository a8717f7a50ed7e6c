#include "sim/campaign/wiring/sketch_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "sim/base/error.h"
#include "sim/base/file.h"
#include "sim/build/project.h"
#include "sim/build/sketch.h"
#include "sim/campaign/wiring/counted_loops.h"
#include "sim/campaign/wiring/pin_remarks.h"

namespace robosim::wiring {
namespace {

constexpr std::size_t kLongestList = 400;  // tokens of a list of arguments
constexpr int kMostSteps = 8;              // longest chain of names that refer to names
constexpr std::size_t kMostSources_bytes = std::size_t{512} << 10;  // larger sketches are mostly data

const std::set<std::string>& pin_functions() {
  static const std::set<std::string> names = {
      "pinMode",        "digitalWrite",    "digitalRead",           "analogRead",      "analogWrite",
      "tone",           "pulseIn",         "digitalPinToInterrupt", "attach",          "noTone",
      "shiftOut",       "attachInterrupt", "digitalWriteFast",      "digitalReadFast", "attachPCINT",
      "enableInterrupt"};
  return names;
}

// Returns whether a word is a numeric type, or a qualifier of one.
bool is_number_type(const std::string& word) {
  static const std::set<std::string> names = {"int",      "byte",    "char",   "short",    "long",
                                              "unsigned", "uint8_t", "int8_t", "uint16_t", "int16_t",
                                              "uint32_t", "int32_t", "word",   "size_t",   "pin_t"};
  return names.count(word) != 0;
}

// Returns whether a word is the class of a device on the two-wire bus. Its objects get no pins.
bool is_device(const std::string& word) {
  static const std::set<std::string> names = {
      "MPU6050",          "Adafruit_MPU6050", "Adafruit_TCS34725", "VL53L0X",
      "Adafruit_VL53L0X", "Adafruit_SSD1306", "LiquidCrystal_I2C", "Adafruit_PWMServoDriver"};
  return names.count(word) != 0;
}

/// An element of an array of readings: value[0] = analogRead(A8).
struct Element {
  std::string argument;
  bool is_channel = false;
};

struct Value {
  std::vector<std::string> words;  // the value: one word, or the words of an array
  bool is_array = false;
  Spot spot;
};

// Returns the names in #include "name".
std::vector<std::string> includes_of(const std::string& source) {
  static const std::string kInclude = "#include \"";
  std::vector<std::string> names;
  for (std::size_t at = source.find(kInclude); at != std::string::npos; at = source.find(kInclude, at + 1)) {
    const std::size_t begin = at + kInclude.size(), end = source.find_first_of("\"\n", begin);
    const bool is_first = at == 0 || source[at - 1] == '\n';
    if (is_first && end != std::string::npos && source[end] == '"')
      names.push_back(source.substr(begin, end - begin));
  }
  return names;
}

class Reader {
 public:
  explicit Reader(const BoardSpec& board) : board_(board) {}

  void read(const std::string& text, const std::string& file) {
    file_ = file;
    sources_.emplace_back(file, text);
    tokens_ = sources_.back().tokens;
    for (at_ = 0; at_ < tokens_.size(); ++at_) {
      const Token& token = tokens_[at_];
      if (token.kind == Token::Kind::word && token.text.size() > 1 && token.text[0] == 'A' &&
          token.text.find_first_not_of("0123456789", 1) == std::string::npos)
        analog_words_.insert(token.str());
      reads_ports_ |= token.kind == Token::Kind::word && token.text.size() == 4 &&
                      token.text.starts_with("PIN") && token.text[3] >= 'A' && token.text[3] <= 'L';
      if (token.kind == Token::Kind::word && token.text.size() == 7 && token.text.starts_with("Serial")) {
        // SoftwareSerial Serial3(6, 7); declares a serial line.
        const bool is_declared = at_ > 0 && tokens_[at_ - 1].is("SoftwareSerial");
        (is_declared ? own_lines_ : lines_).insert(token.text[6] - '0');
      }
      for (const char* const reader : {"digitalRead", "pulseIn", "attachInterrupt", "digitalReadFast"})
        reads_levels_ |= token.is(reader);
      if (token.is("for")) loops_.read(tokens_, at_);
      if (token.kind == Token::Kind::define)
        read_define();
      else if (token.is("enum"))
        read_enum();
      else if (token.kind == Token::Kind::word)
        read_word();
    }
  }

  void read(const build::Sketch& sketch) {
    std::vector<std::string> files = sketch.headers;
    files.insert(files.end(), sketch.inos.begin(), sketch.inos.end());
    files.insert(files.end(), sketch.sources.begin(), sketch.sources.end());
    add_included(sketch, files);
    for (const std::string& file : files) read(read_file(sketch.folder / file), file);
  }

  // Adds the files of the sketch's folder that these files include: #include "Library/Motor.h". Throws
  // InputError if all files together are too large.
  static void add_included(const build::Sketch& sketch, std::vector<std::string>& files) {
    const std::filesystem::path whole = std::filesystem::canonical(sketch.folder);
    std::size_t bytes = 0;
    for (std::size_t i = 0; i < files.size(); ++i) {
      const std::filesystem::path folder = std::filesystem::path(files[i]).parent_path();
      const std::string text = read_file(sketch.folder / files[i], kMostSources_bytes);
      if ((bytes += text.size()) > kMostSources_bytes)
        throw InputError(
            {sketch.folder.string()},
            fmt::format("the sketch is too large to draft a robot: expected sources of at most {} KB",
                        kMostSources_bytes >> 10));
      for (const std::string& name : includes_of(text)) {
        const std::string file = (folder / name).lexically_normal().string();
        const bool is_known = std::find(files.begin(), files.end(), file) != files.end();
        if (!is_known && build::lies_in(sketch.folder / file, whole) &&
            std::filesystem::is_regular_file(sketch.folder / file))
          files.push_back(file);
      }
    }
  }

  SketchNames names() {
    mark_running(sources_);
    SketchNames names;
    names.reads_ports = reads_ports_;
    names.reads_levels = reads_levels_;
    const std::map<std::string, int> assignments = assignments_in(sources_);
    for (const std::string& name : order_) {
      const Value& value = values_.at(name);
      const bool used = used_.count(name) != 0;
      if (!value.is_array && !used && (handed_on_.count(name) == 0 || is_quantity(name))) continue;
      const auto count = assignments.find(name);
      const bool varies = count != assignments.end() && count->second > 1;
      if (!value.is_array && !used && varies) continue;  // such as a state
      Named named{name, {}, value.is_array, used || value.is_array, value.spot};
      const bool is_channel = channels_.count(name) != 0 && numbers_.count(name) == 0;
      for (const std::string& word : value.words)
        if (const auto pin = is_channel ? channel_of(word) : pin_of(word)) named.pins.push_back(*pin);
      const bool all = named.pins.size() == value.words.size();
      if (all && !named.pins.empty() && (!value.is_array || used || all_analog(named.pins)))
        names.named.push_back(std::move(named));
    }
    add_fills(names);
    for (std::size_t i = 0; i < given_.size(); ++i) {
      Given given = given_[i];
      if (const auto range = ranges_.find(i); range != ranges_.end()) {
        given.each.push_back(pins_of_range(range->second, given.type == "analogRead"));
        given.pins = given.each[0];
        given.arguments.clear();
      }
      for (const std::string& argument : given.arguments) {
        auto pins = given.type == "analogRead" || given.type == "QTRSensorsAnalog" ? channels_of(argument)
                                                                                   : pins_of(argument);
        given.each.push_back(pins);
        if (pins.empty()) pins.push_back(kNoPin);
        given.pins.insert(given.pins.end(), pins.begin(), pins.end());
      }
      const bool any =
          std::any_of(given.pins.begin(), given.pins.end(), [](Pin pin) { return pin != kNoPin; });
      if (any || is_device(given.type)) names.given.push_back(std::move(given));
    }
    names.blocks = pin_blocks(
        sources_, {[this](const std::string& argument) { return pins_of(argument); },
                   [&](const std::string& word) {
                     const auto count = assignments.find(word);
                     return count != assignments.end() && count->second > 1 ? word : value_of(word);
                   }});
    add_serial_keys(names);
    for (const auto& [word, handler] : handlers_)
      if (const auto pin = pin_of(word); pin && only_sets_flags(handler))
        names.flag_interrupts.push_back(*pin);
    names.level = level_in_source(sources_);
    names.remarks = remarks_of(names, sources_);
    return names;
  }

  /// Returns whether a comment names this board and no other, as in `Board: Arduino Nano`.
  bool is_named_in_comments() const {
    bool is_named = false;
    for (const SourceText& source : sources_)
      for (const Comment& comment : source.comments) {
        const WordList& words = comment.words;
        if (!says(words, {"arduino", "board", "placa", "carte", "kart", "tarjeta", "scheda"})) continue;
        for (const std::string& name : build::boards_of("avr")) {
          if (std::count(words.begin(), words.end(), name) == 0) continue;
          if (name != board_.name) return false;
          is_named = true;
        }
      }
    return is_named;
  }

  /// Counts the calls of analogWrite() for digital pins. If `has`, only counts pins with PWM on this board;
  /// otherwise only pins without PWM. Skips the values 0 and 255, which need no PWM.
  std::ptrdiff_t count_pwm(bool has) {
    std::ptrdiff_t count = 0;
    for (const PinBlock& block : names().blocks)
      count += std::count_if(block.writes.begin(), block.writes.end(), [&](const PinWrite& write) {
        const bool is_level = write.level && (*write.level == 0 || *write.level >= 255);
        const PinSpec& pin = board_.pins[write.pin];
        const bool is_of_serial = write.pin < 2;  // analogWrite(0, speed) is a mistake
        return write.is_pwm && !is_level && !is_of_serial && pin.analog_channel < 0 && pin.pwm == has;
      });
    return count;
  }

  /// Returns whether the board has all pins that the sketch passes to pin functions, and all serial lines.
  bool has_all_pins() const {
    // Serial is the line to the computer; it is a UART, except on boards with USB.
    const int lines = board_.chip->uart_count - (board_.serial_line == 0 ? 1 : 0);
    for (const int line : lines_)
      if (line > lines && line < 10 && own_lines_.count(line) == 0) return false;
    const auto lacks = [&](const std::string& word, bool is_channel) {
      const std::string value = value_of(word);
      const bool is_number = !value.empty() && value.find_first_not_of("0123456789") == std::string::npos;
      const bool is_analog = value.size() > 1 && value[0] == 'A' &&
                             value.find_first_not_of("0123456789", 1) == std::string::npos;
      const auto pin = is_channel ? channel_of(value) : pin_of(value);
      return (is_number || is_analog) && !(pin && (is_channel || is_analog || board_.pins[*pin].digital));
    };
    const auto lacks_any = [&](const std::set<std::string>& words, bool is_channel) {
      return std::any_of(words.begin(), words.end(), [&](const std::string& word) {
        const auto array = values_.find(word);
        if (array == values_.end() || !array->second.is_array) return lacks(word, is_channel);
        return std::any_of(array->second.words.begin(), array->second.words.end(),
                           [&](const std::string& element) { return lacks(element, is_channel); });
      });
    };
    const auto lacks_range = [&](const auto& range) {
      const bool is_channel = given_[range.first].type == "analogRead";
      const std::vector<std::string> words = words_in_range(range.second);
      return std::any_of(words.begin(), words.end(),
                         [&](const std::string& word) { return lacks(word, is_channel); });
    };
    if (std::any_of(ranges_.begin(), ranges_.end(), lacks_range)) return false;
    return !lacks_any(numbers_, false) && !lacks_any(channels_, true) && !lacks_any(analog_words_, false) &&
           std::none_of(modes_.begin(), modes_.end(), [&](const std::string& word) {
             return lacks(word, false) && lacks(word, true);  // sketches pass channels to pinMode(), too
           });
  }

 private:
  const Token& ahead(std::size_t n) const {
    static const Token nothing;
    return at_ + n < tokens_.size() ? tokens_[at_ + n] : nothing;
  }
  Spot spot() const { return {file_, tokens_[at_].line}; }

  // Adds the characters of `== 'F'` and `case 'F':`, if the sketch reads a serial line.
  void add_serial_keys(SketchNames& names) const {
    constexpr std::size_t kMost = 12;
    for (const SourceText& source : sources_)
      for (std::size_t i = 2; i + 1 < source.tokens.size(); ++i) {
        const Tokens& tokens = source.tokens;
        if (tokens[i].is("read") && tokens[i - 1].is(".") && tokens[i + 1].is("("))
          names.serial_object = tokens[i - 2].str();
        const bool is_compared = (tokens[i - 1].is("=") && tokens[i - 2].is("=")) || tokens[i - 1].is("case");
        const std::string_view text = tokens[i].text;
        if (!is_compared || tokens[i].kind != Token::Kind::text || text.size() != 3 ||
            std::isalnum(static_cast<unsigned char>(text[1])) == 0 || names.serial_keys.size() == kMost)
          continue;
        if (std::count(names.serial_keys.begin(), names.serial_keys.end(), text[1]) == 0)
          names.serial_keys.push_back(text[1]);
      }
  }

  // Adds the arrays that consecutive statements fill: value[0] = analogRead(A8); value[1] = analogRead(A9);
  void add_fills(SketchNames& names) const {
    for (const auto& [name, elements] : fills_) {
      Named named{name, {}, true, false, {}};
      for (const auto& [index, element] : elements)
        if (const auto pin = element.is_channel ? channel_of(element.argument) : pin_of(element.argument))
          named.pins.push_back(*pin);
      if (named.pins.size() > 1 && named.pins.size() == elements.size())
        names.named.push_back(std::move(named));
    }
  }

  void set(const std::string& name, Value value) {
    if (values_.emplace(name, std::move(value)).second) order_.push_back(name);
  }

  // Reads `#define NAME 5`, or `#define NAME (5)`.
  void read_define() {
    const std::string name = tokens_[at_].str();
    std::vector<std::string> words;
    Value value{{}, false, spot()};
    for (std::size_t i = 1; !ahead(i).text.empty() && !ahead(i).is(kEndOfDefine); ++i)
      if (!ahead(i).is("(") && !ahead(i).is(")")) words.push_back(ahead(i).str());
    if (words.size() == 1) {
      value.words = words;
      set(name, std::move(value));
    }
  }

  // Reads `enum { LEFT = 5, RIGHT = 6 };`.
  void read_enum() {
    while (!ahead(0).text.empty() && !ahead(0).is("{") && !ahead(0).is(";")) ++at_;
    for (; !ahead(0).text.empty() && !ahead(0).is("}") && !ahead(0).is(";"); ++at_)
      if (ahead(0).kind == Token::Kind::word && ahead(1).is("=") && (ahead(3).is(",") || ahead(3).is("}")))
        set(ahead(0).str(), {{ahead(2).str()}, false, spot()});
  }

  void read_word() {
    const Token& token = tokens_[at_];
    if (ahead(1).is("(") && pin_functions().count(token.str()) != 0) {
      read_call(at_ > 1 && tokens_[at_ - 1].is(".") ? tokens_[at_ - 2].str() : "");
    } else if (is_number_type(token.str()) && ahead(1).kind == Token::Kind::word) {
      if (is_number_type(ahead(1).str())) return;  // a type of several words: unsigned int
      ++at_;
      read_variables();
    } else if (ahead(1).kind == Token::Kind::word && ahead(2).is("=") && ahead(3).str() == token.str() &&
               ahead(4).is("(")) {
      read_made();
    } else if (ahead(1).kind == Token::Kind::word && ahead(2).is(";") && is_device(token.str())) {
      given_.push_back({token.str(), ahead(1).str(), {}, {}, spot()});
    } else if (token.is("new") && ahead(2).is("(")) {
      read_new();
    } else if (ahead(1).kind == Token::Kind::word && (ahead(2).is("(") || ahead(2).is("{"))) {
      read_object();
    } else if (ahead(1).is("(") && at_ > 1 && tokens_[at_ - 1].is(".")) {
      read_call(tokens_[at_ - 2].str());  // such as qtr.setSensorPins(…)
    } else if (token.is("randomSeed") && ahead(2).is("analogRead") && ahead(3).is("(")) {
      if (const auto pin = channel_of(ahead(4).str()))
        given_.push_back({"randomSeed", "", {}, {board_.pins[*pin].name}, spot()});
      at_ += 4;
    } else if (ahead(1).is("(")) {
      const auto list = arguments(1);  // such as motor(LEFT_PWM, LEFT_A, LEFT_B, speed)
      handed_on_.insert(list.begin(), list.end());
    }
  }

  // Reads `NAME = 5, OTHER = 6;` or `NAME[] = {A0, A1};`, from the first name.
  void read_variables() {
    for (;;) {
      const std::string name = ahead(0).str();
      Value value{{}, false, spot()};
      std::size_t i = 1;
      if (ahead(i).is("[")) {
        value.is_array = true;
        while (!ahead(i).text.empty() && !ahead(i).is("]")) ++i;
        ++i;
      }
      if (ahead(i).is("=")) ++i;
      if (ahead(i).is("{")) {
        for (++i; !ahead(i).text.empty() && !ahead(i).is("}"); ++i)
          if (!ahead(i).is(",")) value.words.push_back(ahead(i).str());
        ++i;
      } else if (!value.is_array && (ahead(i + 1).is(";") || ahead(i + 1).is(","))) {
        value.words.push_back(ahead(i).str());
        ++i;
      }
      if (value.is_array) handed_on_.insert(value.words.begin(), value.words.end());
      const bool is_loop = name.size() == 1 && name >= "a" && !value.is_array;  // probably a loop's variable
      if (!value.words.empty() && !is_loop) set(name, std::move(value));
      if (!ahead(i).is(",") || ahead(i + 1).kind != Token::Kind::word || is_number_type(ahead(i + 1).str()))
        return;
      at_ += i + 1;
    }
  }

  // Returns the arguments in the parentheses that are `from` tokens ahead. Tokens within an argument are
  // separated by one space.
  std::vector<std::string> arguments(std::size_t from) const {
    std::vector<std::string> list(1);
    int depth = 0;
    for (std::size_t i = from; i - from < kLongestList && !ahead(i).text.empty() && !ahead(i).is(";"); ++i) {
      // Skips the namespaces of hardware::pins::LEFT.
      if (ahead(i).kind == Token::Kind::word && ahead(i + 1).is(":") && ahead(i + 2).is(":")) {
        i += 2;
        continue;
      }
      const bool opens = ahead(i).is("(") || ahead(i).is("{"), closes = ahead(i).is(")") || ahead(i).is("}");
      if (closes && --depth == 0) break;
      if (ahead(i).is(",") && depth == 1)
        list.emplace_back();
      else if (depth > 0)
        list.back() += (list.back().empty() ? "" : " ") + ahead(i).str();
      if (opens) ++depth;
    }
    if (list.back().empty()) list.pop_back();
    return list;
  }

  // Returns the distance to the token after the parentheses that are `from` tokens ahead.
  std::size_t behind_brackets(std::size_t from) const {
    int depth = 0;
    for (std::size_t i = from; i - from < kLongestList && !ahead(i).text.empty() && !ahead(i).is(";"); ++i) {
      if (ahead(i).is("(") || ahead(i).is("{")) ++depth;
      if ((ahead(i).is(")") || ahead(i).is("}")) && --depth == 0) return i + 1;
    }
    return from;
  }

  // The arguments of an object need not be pins: QTRSensorsRC qtr(pins, COUNT, TIMEOUT).
  void note_arguments(const std::vector<std::string>& arguments) {
    for (const std::string& argument : arguments) handed_on_.insert(argument.substr(0, argument.find(' ')));
  }

  // Records the pin of a call, with the name of the function.
  void note_pin(const std::string& function, const std::vector<std::string>& list) {
    const std::string word = list[0].substr(0, list[0].find(' '));
    used_.insert(word);
    const bool is_channel = function == "analogRead";
    if (function == "pinMode")
      modes_.insert(word);
    else
      (is_channel ? channels_ : numbers_).insert(word);
    static const std::set<std::string> kUses = {"analogRead", "digitalRead", "analogWrite", "digitalWrite",
                                                "pinMode"};
    if (kUses.count(function) == 0) return;
    const bool is_output = function == "pinMode" && list.size() > 1 && list[1] == "OUTPUT";
    if (const auto range = loops_.range_of(list[0])) ranges_.emplace(given_.size(), *range);
    given_.push_back({is_output ? "OUTPUT" : function, "", {}, {list[0]}, spot()});
  }

  void read_call(const std::string& object) {
    const auto list = arguments(1);
    const bool is_pin_function = pin_functions().count(tokens_[at_].str()) != 0;
    if (!list.empty() && (tokens_[at_].is("digitalRead") || tokens_[at_].is("analogRead")))
      read_result(list[0]);
    if (is_pin_function && !list.empty()) note_pin(object.empty() ? tokens_[at_].str() : "attach", list);
    if (tokens_[at_].is("shiftOut")) note_arguments(list);
    if (tokens_[at_].is("shiftOut") && list.size() > 1)
      given_.push_back({"shiftOut", "", {}, {list[0], list[1]}, spot()});
    if (tokens_[at_].is("attachInterrupt")) {
      if (list.size() > 2 && list[2] == "FALLING")
        handlers_.emplace_back(pin_word_of_interrupt(list), list[1]);
      if (const auto pin = pin_of_interrupt(list))
        given_.push_back({"attachInterrupt", "", {}, {*pin}, spot()});
      return;
    }
    const bool tells =
        !object.empty() || tokens_[at_].is("digitalPinToInterrupt") || tokens_[at_].is("pulseIn");
    if (!tells) return;
    static const std::set<std::string> kTakesPins = {"attach", "setSensorPins", "setEmitterPin", "setPins",
                                                     "setPin", "init",          "begin"};
    const bool takes_pins = kTakesPins.count(tokens_[at_].str()) != 0;
    if (!object.empty() && takes_pins) note_arguments(list);
    // Arguments of other methods are not pins: lcd.setCursor(0, 14).
    if (!object.empty() && !takes_pins && !tokens_[at_].is("getMotor")) return;
    if (tokens_[at_].is("begin") && is_size_of_display(list)) return;
    given_.push_back({tokens_[at_].str(), object, {}, list, spot()});
  }

  // Returns whether the arguments are a display's size: lcd.begin(16, 2).
  static bool is_size_of_display(const std::vector<std::string>& list) {
    return list.size() == 2 && (list[0] == "16" || list[0] == "20" || list[0] == "8") &&
           (list[1] == "1" || list[1] == "2" || list[1] == "4");
  }

  // Reads `int leftSensor = analogRead(A1);`. The variable's name becomes the pin's name if it has no other
  // name.
  void read_result(const std::string& argument) {
    if (at_ < 2 || !tokens_[at_ - 1].is("=")) return;
    const bool is_element = at_ > 5 && tokens_[at_ - 2].is("]") && tokens_[at_ - 4].is("[") &&
                            tokens_[at_ - 3].kind == Token::Kind::number && tokens_[at_ - 3].text.size() < 3;
    if (is_element)
      fills_[tokens_[at_ - 5].str()].emplace(std::stoi(tokens_[at_ - 3].str()),
                                             Element{argument, tokens_[at_].is("analogRead")});
    const std::size_t end = behind_brackets(1);
    const bool is_compared =
        ahead(end).is("<") || ahead(end).is(">") || ahead(end).is("=") || ahead(end).is("!");
    if (tokens_[at_ - 2].kind != Token::Kind::word || is_compared) return;
    if (argument.find(' ') != std::string::npos || values_.count(argument) != 0) return;
    const std::string name = tokens_[at_ - 2].str();
    values_.erase(name);
    order_.erase(std::remove(order_.begin(), order_.end(), name), order_.end());
    set(name, {{argument}, false, spot()});
    used_.insert(name);
  }

  // Reads `Type name(5, 6);`, but not the head of a function.
  void read_object() {
    static const std::set<std::string> no_types = {"return", "else",    "new",    "case",   "void",
                                                   "bool",   "boolean", "float",  "double", "String",
                                                   "const",  "static",  "struct", "class"};
    if (no_types.count(tokens_[at_].str()) != 0) return;
    // Reads all objects of a declaration: `Wheel left(5, 7, 8), right(6, 9, 10);`
    for (std::size_t i = 1;
         ahead(i).kind == Token::Kind::word && (ahead(i + 1).is("(") || ahead(i + 1).is("{"));) {
      const auto list = arguments(i + 1);
      if (list.empty()) return;
      note_arguments(list);
      given_.push_back({tokens_[at_].str(), ahead(i).str(), {}, list, spot()});
      for (const std::string& argument : list) read_inner_object(ahead(i).str(), argument);
      i = behind_brackets(i + 1);
      if (!ahead(i).is(",")) return;
      ++i;
    }
  }

  // Reads `Type name = Type(5, 6);`.
  void read_made() {
    const auto list = arguments(4);
    note_arguments(list);
    given_.push_back({tokens_[at_].str(), ahead(1).str(), {}, list, spot()});
  }

  // Reads `name = new Type(5, 6);`.
  void read_new() {
    const bool has_name = at_ > 1 && tokens_[at_ - 1].is("=") && tokens_[at_ - 2].kind == Token::Kind::word;
    const auto list = arguments(2);
    note_arguments(list);
    given_.push_back({ahead(1).str(), has_name ? tokens_[at_ - 2].str() : ahead(1).str(), {}, list, spot()});
  }

  // Reads each argument of Motors motors(Motor(5, 7, 8), Motor(6, 9, 10)).
  void read_inner_object(const std::string& outer, const std::string& argument) {
    const Tokens inner = tokens_of(argument);
    if (inner.size() < 4 || inner[0].kind != Token::Kind::word || !inner[1].is("(")) return;
    std::vector<std::string> list;
    for (const Token& token : inner)
      if (&token != &inner[0] && token.kind != Token::Kind::punctuation) list.push_back(token.str());
    note_arguments(list);
    given_.push_back({inner[0].str(), outer, {}, list, spot()});
  }

  // Returns the pin's word, such as BUMPER in attachInterrupt(digitalPinToInterrupt(BUMPER), …).
  std::string pin_word_of_interrupt(const std::vector<std::string>& list) const {
    const std::size_t bracket = list[0].find(" ( ");
    if (bracket == std::string::npos) return pin_of_interrupt(list).value_or("");
    const std::size_t begin = bracket + 3;
    return list[0].substr(begin, list[0].find(' ', begin) - begin);
  }

  // Returns whether an interrupt's function only sets variables to single values, without counting anything.
  bool only_sets_flags(const std::string& handler) const {
    bool sets = false;
    for (const SourceText& source : sources_)
      for (const Block& block : source.blocks) {
        if (block.function != handler) continue;
        for (const Statement& statement : block.statements) {
          if (statement.tokens.size() != 3 || !statement.tokens[1].is("=")) return false;
          sets = true;
        }
      }
    return sets;
  }

  // Returns the name of the pin whose interrupt number is the first argument, as in attachInterrupt(0, …).
  std::optional<std::string> pin_of_interrupt(const std::vector<std::string>& list) const {
    if (list.empty() || list[0].size() != 1 || std::isdigit(static_cast<unsigned char>(list[0][0])) == 0)
      return {};
    for (Pin pin = 0; pin < board_.pin_count; ++pin)
      if (board_.pins[pin].interrupt == list[0][0] - '0') return board_.pins[pin].name;
    return {};
  }

  // Returns the word that a name stands for.
  std::string value_of(std::string word) const {
    for (int step = 0; step < kMostSteps; ++step) {
      const auto value = values_.find(word);
      if (value == values_.end() || value->second.is_array) break;
      word = value->second.words[0];
    }
    return word;
  }

  // Returns the pin of an argument of analogRead(), where 0 means A0.
  std::optional<Pin> channel_of(const std::string& word) const {
    const std::string value = value_of(word);
    const bool is_number =
        !value.empty() && value.size() < 4 && value.find_first_not_of("0123456789") == std::string::npos;
    if (!is_number || std::stoi(value) >= board_.analog_pin_0) return pin_of(value);
    return pin_of("A" + value);
  }

  std::optional<Pin> pin_of(const std::string& name) const {
    const std::string word = value_of(name);
    if (word == "LED_BUILTIN") return board_.led_builtin;
    const bool plain =
        !word.empty() && (std::isdigit(static_cast<unsigned char>(word[0])) != 0 || word[0] == 'A' ||
                          word[0] == 'D' || (word[0] == 'P' && word.size() > 2));
    const Pin pin = plain ? find_pin(board_, word.c_str()) : kNoPin;
    return pin == kNoPin ? std::nullopt : std::optional<Pin>(first_number(board_, pin));
  }

  // Returns the pins of an argument: one pin, or those of an array. `( const uint8_t [ ] ) { A0 , A1 }` is
  // also an array. For `pins [ 1 ]`, returns that pin; for `pins [ i ]`, all pins.
  std::vector<Pin> pins_of(const std::string& argument) const {
    if (const auto pin = pin_of(argument)) return {*pin};
    if (const std::size_t bracket = argument.find(" [ ");
        bracket != std::string::npos && argument[0] != '(') {
      const std::vector<Pin> all = pins_of(argument.substr(0, bracket));
      const std::string index = argument.substr(bracket + 3, argument.find(' ', bracket + 3) - bracket - 3);
      const bool fixed = !index.empty() && index.find_first_not_of("0123456789") == std::string::npos;
      const std::size_t at = fixed && index.size() < 4 ? std::stoul(index) : all.size();
      return at < all.size() ? std::vector<Pin>{all[at]} : all;
    }
    std::vector<std::string> words;
    if (const auto array = values_.find(argument); array != values_.end()) {
      words = array->second.words;
    } else if (const std::size_t brace = argument.find('{'); brace != std::string::npos) {
      for (const Token& token : tokens_of(std::string_view(argument).substr(brace)))
        if (token.kind == Token::Kind::word || token.kind == Token::Kind::number)
          words.push_back(token.str());
    }
    std::vector<Pin> pins;
    for (const std::string& word : words)
      if (const auto pin = pin_of(word)) pins.push_back(*pin);
    return pins.size() == words.size() ? pins : std::vector<Pin>{};
  }

  std::vector<Pin> pins_of_range(const PinRange& range, bool is_channel) const {
    std::vector<Pin> pins;
    for (const std::string& word : words_in_range(range))
      if (const auto pin = is_channel ? channel_of(word) : pin_of(word)) pins.push_back(*pin);
    return pins;
  }
  std::vector<std::string> words_in_range(const PinRange& range) const {
    return pins_in(range, [this](const std::string& word) { return value_of(word); });
  }

  // Returns the pins of an argument of analogRead().
  std::vector<Pin> channels_of(const std::string& argument) const {
    if (const auto pin = channel_of(argument)) return {*pin};
    std::vector<Pin> pins = pins_of(argument);
    for (Pin& pin : pins)
      if (pin + board_.analog_pin_0 < board_.pin_count && pin < board_.analog_pin_0 &&
          board_.pins[pin].analog_channel < 0)
        pin = static_cast<Pin>(pin + board_.analog_pin_0);
    return pins;
  }

  bool all_analog(const std::vector<Pin>& pins) const {
    return std::all_of(pins.begin(), pins.end(), [&](Pin pin) { return board_.pins[pin].name[0] == 'A'; });
  }

  const BoardSpec& board_;
  std::string file_;
  std::vector<SourceText> sources_;
  Tokens tokens_;
  std::size_t at_ = 0;
  std::map<std::string, Value> values_;
  std::vector<std::string> order_;
  std::set<std::string> handed_on_;  // names in an array, or passed to any function
  std::set<std::string> used_;       // names passed to a pin function or to an object
  std::set<std::string> channels_;   // arguments of analogRead()
  std::set<std::string> numbers_;    // arguments of the other pin functions, except pinMode()
  bool reads_levels_ = false;
  bool reads_ports_ = false;
  std::set<int> lines_, own_lines_;     // numbers of serial lines: used, and declared
  std::set<std::string> modes_;         // arguments of pinMode()
  std::set<std::string> analog_words_;  // A0, A1 …
  std::vector<Given> given_;
  std::vector<std::pair<std::string, std::string>> handlers_;  // pins and functions of interrupts on FALLING
  CountedLoops loops_;
  std::map<std::size_t, PinRange> ranges_;               // pins of calls in counted loops, by index in given_
  std::map<std::string, std::map<int, Element>> fills_;  // arrays that are filled element by element
};

}  // namespace

bool is_quantity(const std::string& name) {
  static const std::set<std::string> kWords = {"num",      "number", "numero", "nb",    "nombre",  "n",
                                               "cantidad", "quant",  "anzahl", "sayi",  "sayisi",  "jumlah",
                                               "count",    "cnt",    "size",   "total", "samples", "timeout",
                                               "max",      "min",    "baud"};
  const std::vector<std::string> words = words_of(name);
  return std::any_of(words.begin(), words.end(),
                     [](const std::string& word) { return kWords.count(word) != 0; });
}

SketchNames read_names(const build::Sketch& sketch, const BoardSpec& board) {
  Reader reader(board);
  reader.read(sketch);
  return reader.names();
}

GuessedBoard board_for(const build::Sketch& sketch) {
  const std::vector<std::string> names = build::boards_of("avr");
  const BoardSpec *first = nullptr, *with_pwm = nullptr;
  bool lacks_pwm = false;
  for (const std::string& name : names) {
    const BoardSpec& board = *find_board(name.c_str());
    Reader reader(board);
    reader.read(sketch);
    if (!reader.has_all_pins()) continue;
    if (reader.is_named_in_comments()) return {&board, ""};
    if (first == nullptr) {
      first = &board;
      lacks_pwm = reader.count_pwm(false) > 0 && reader.count_pwm(true) == 0;
    } else if (with_pwm == nullptr && lacks_pwm && board.pin_count > first->pin_count &&
               reader.count_pwm(true) > 0) {
      with_pwm = &board;
    }
  }
  if (first == nullptr) return {find_board(names.front().c_str()), "no board has all pins of the sketch"};
  if (with_pwm == nullptr) return {first, "guessed: the first board that has all pins of the sketch"};
  return {with_pwm,
          fmt::format("guessed: analogWrite() drives pins without PWM on the board {}", first->name)};
}

SketchNames names_in_text(const std::string& text, const std::string& file, const BoardSpec& board) {
  Reader reader(board);
  reader.read(text, file);
  return reader.names();
}

}  // namespace robosim::wiring
