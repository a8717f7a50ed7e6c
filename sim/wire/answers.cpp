// Converts the answers of a runner to lines and back (protocol.h).
#include <algorithm>
#include <charconv>

#include "sim/wire/columns_line.h"
#include "sim/wire/json_parse.h"
#include "sim/wire/json_reader.h"
#include "sim/wire/json_text.h"
#include "sim/wire/protocol.h"

namespace robosim::wire {
namespace {

using Json = nlohmann::json;

constexpr const char* kEeprom = "eeprom";
constexpr const char* kRefused = "refused";

// The first bytes of a line, which contain its id and the name of its event. Searching only these is fast.
constexpr std::size_t kBegin_bytes = 64;

// ---- Writing ----

std::string id_text(const Id& id) {
  std::string text;
  std::visit(
      [&](const auto& number) {
        if constexpr (std::is_same_v<std::decay_t<decltype(number)>, std::monostate>)
          text = "null";
        else
          JsonText::append(text, number);
      },
      id);
  return text;
}

std::string hexadecimal(const std::vector<std::uint8_t>& bytes) {
  static constexpr char kDigits[] = "0123456789abcdef";
  std::string text;
  for (const std::uint8_t byte : bytes) {
    text += kDigits[byte >> 4];
    text += kDigits[byte & 15];
  }
  return text;
}

struct Adder {
  JsonText& line;

  template <class T>
  void operator()(const T& message) const {
    line.add(T::kKey, message);
  }
  void operator()(const Event& event) const {
    std::visit(
        [this](const auto& happened) {
          line.add("event", std::string_view(happened.kEvent));
          fields(line, happened);
        },
        event);
  }
  void operator()(const Hello& hello) const { fields(line, hello); }
  void operator()(const Eeprom& memory) const { line.add(kEeprom, hexadecimal(memory.bytes)); }
  void operator()(const Refused& refused) const { line.add(kRefused, refused.message); }
};

// ---- Reading ----

template <class T>
T read(const Json& object) {
  T message;
  JsonReader::read(object, message, JsonReader::Unknown::allowed);
  return message;
}

/// Returns a value that must exist and be text.
const std::string& text_at(const Json& object, const char* key) {
  const auto found = object.find(key);
  if (found == object.end()) throw BadValue(key, "missing key; expected a string");
  if (!found->is_string()) throw BadValue(key, "expected a string");
  return found->get_ref<const std::string&>();
}

template <std::size_t I = 0>
Event event_named(const std::string& name, const Json& object) {
  if constexpr (I == std::variant_size_v<Event>) {
    throw BadValue("event", "unknown event " + excerpt(name));
  } else {
    using Kind = std::variant_alternative_t<I, Event>;
    if (name == Kind::kEvent) return read<Kind>(object);
    return event_named<I + 1>(name, object);
  }
}

Eeprom eeprom_of(const std::string& digits) {
  Eeprom memory;
  for (std::size_t i = 0; i < digits.size(); i += 2) {
    std::uint8_t byte = 0;
    const char* end = digits.data() + std::min(i + 2, digits.size());
    const auto [read_to, error] = std::from_chars(digits.data() + i, end, byte, 16);
    if (error != std::errc() || read_to != digits.data() + i + 2)
      throw BadValue(kEeprom, "expected two hexadecimal digits for each byte");
    memory.bytes.push_back(byte);
  }
  return memory;
}

template <class... Kinds>
std::optional<Answer> keyed(const Json& object) {
  std::optional<Answer> answer;
  const auto try_one = [&]<class T>(const T*) {
    const auto found = object.find(T::kKey);
    if (answer || found == object.end()) return;
    try {
      answer = read<T>(*found);
    } catch (const BadValue& bad) {
      throw bad.inside(T::kKey);
    }
  };
  (try_one(static_cast<const Kinds*>(nullptr)), ...);
  return answer;
}

Answer answer_of(const Json& object) {
  if (object.contains("event")) return Answer(event_named(text_at(object, "event"), object));
  if (auto answer = keyed<RunResult, RobotInfo, Paused, Accepted>(object)) return std::move(*answer);
  if (object.contains(kEeprom)) return eeprom_of(text_at(object, kEeprom));
  if (object.contains(kRefused)) return Refused{text_at(object, kRefused)};
  if (auto answer = keyed<ErrorAnswer>(object)) return std::move(*answer);
  throw BadValue("result", "missing, like every other answer");
}

Line line_of(const Json& object) {
  if (!object.is_object()) throw BadValue("line", "expected an object");
  if (object.contains("hello")) return {-1, read<Hello>(object)};
  const auto id = object.find("id");
  if (id == object.end() || !(id->is_number_integer() || id->is_null()))
    throw BadValue("id", "expected a whole number");
  return {id->is_null() ? -1 : id->get<long long>(), answer_of(object)};
}

}  // namespace

std::string to_line(const Id& id, const Answer& answer) {
  const auto* event = std::get_if<Event>(&answer);
  if (const auto* batch = event ? std::get_if<Batch>(event) : nullptr)
    return batch_line(id, batch->bytes.size()) + batch->bytes;
  std::string text;
  JsonText line(text);
  if (!std::holds_alternative<Hello>(answer)) line.add_text("id", id_text(id));
  if (const auto* columns = event ? std::get_if<Columns>(event) : nullptr) {
    line.add("event", std::string_view(Columns::kEvent));
    if (columns->agent != 0) line.add("agent", columns->agent);
    text += ',';
    return text.append(columns_text(*columns), 1) + "\n";  // includes the object's closing brace
  }
  std::visit(Adder{line}, answer);
  line.end();
  return text + "\n";
}

std::string batch_line(const Id& id, std::size_t bytes) {
  return R"({"id":)" + id_text(id) + R"(,"event":"batch","size":)" + std::to_string(bytes) + "}\n";
}

Hello parse_hello(std::string_view text, const std::string& program) {
  const Json json = Json::parse(text, nullptr, false);
  if (!json.is_object() || !json.contains("hello") || !json.contains("protocol")) {
    throw RunnerError(program + " is not a Robosim runner: expected a hello message, got " + excerpt(text));
  }
  const Json& protocol = json["protocol"];
  if (protocol != kProtocol) {
    throw RunnerError("the runner " + program + " has another Robosim version: expected protocol " +
                      std::to_string(kProtocol) + ", got " +
                      (protocol.is_number() ? text_of(protocol) : "an unknown one"));
  }
  return std::get<Hello>(parse_line(text).content);
}

Line parse_line(std::string_view text) {
  const bool has_columns = text.substr(0, kBegin_bytes).find(R"("event":"columns")") != text.npos;
  LongTexts long_texts;
  std::string left;
  if (has_columns) left = long_texts.cut(text);
  const Json json = parsed_json(has_columns ? std::string_view(left) : text);
  if (json.is_discarded()) throw RunnerError("unexpected line of the runner (not JSON): " + excerpt(text));
  try {
    Line line = line_of(json);
    if (auto* event = std::get_if<Event>(&line.content))
      if (auto* columns = std::get_if<Columns>(event)) long_texts.put_back(*columns);
    return line;
  } catch (const BadValue& error) {
    throw RunnerError(std::string("unexpected line of the runner (") + error.what() + "): " + excerpt(text));
  }
}

}  // namespace robosim::wire
