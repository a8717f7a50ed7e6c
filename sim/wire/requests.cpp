// Converts the requests of a client to lines and back (protocol.h).
#include <vector>

#include "sim/wire/json_parse.h"
#include "sim/wire/json_reader.h"
#include "sim/wire/protocol.h"

namespace robosim::wire {
namespace {

using Json = nlohmann::json;

template <class Any>
std::string line_of(long long id, const Any& any) {
  return std::visit(
      [&](const auto& request) {
        Json json{{"id", id}, {"do", request.kDo}};
        JsonWriter<Json>::add(json, request);
        return text_of(json) + "\n";
      },
      any);
}

Id id_of(const Json& object) {
  const auto found = object.find("id");
  if (found == object.end() || !found->is_number()) return {};
  if (found->is_number_unsigned()) return found->get<std::uint64_t>();
  if (found->is_number_integer()) return found->get<std::int64_t>();
  return found->get<double>();
}

// Reads the alternative of Any whose name is `name`. Tries the alternatives from number I on. Returns nullopt
// if no alternative has this name.
template <class Any, std::size_t I = 0>
std::optional<Any> read_named(const std::string& name, const Json& object) {
  if constexpr (I == std::variant_size_v<Any>) {
    return std::nullopt;
  } else {
    std::variant_alternative_t<I, Any> request;
    if (name != request.kDo) return read_named<Any, I + 1>(name, object);
    JsonReader::read(object, request, JsonReader::Unknown::refused, {"id", "do", "protocol"});
    return request;
  }
}

template <class Any, std::size_t... I>
std::string names_of(std::index_sequence<I...>) {
  const std::vector<std::string> names{"\"" + std::string(std::variant_alternative_t<I, Any>::kDo) +
                                       "\"" ...};
  return one_of(names);
}

template <class Any>
Any request_of(const Json& object, const char* who) {
  if (const auto spoken = object.find("protocol"); spoken != object.end() && *spoken != kProtocol)
    throw InputError("\"protocol\" in the request: expected " + std::to_string(kProtocol) +
                     ", the version of this runner");
  const auto what = object.find("do");
  const std::string name = what != object.end() && what->is_string() ? what->get<std::string>() : "";
  try {
    if (auto request = read_named<Any>(name, object)) return std::move(*request);
  } catch (const BadValue& bad) {
    throw InputError(bad.in("the request"));
  }
  throw InputError("\"do\" in the request to " + std::string(who) + ": expected " +
                   names_of<Any>(std::make_index_sequence<std::variant_size_v<Any>>()) + ", got " +
                   (name.empty() ? "none or one that is not a string" : excerpt(name)));
}

template <class Any>
Asked<Any> parse(std::string_view text, const char* who) {
  Asked<Any> asked;
  const Json json = parsed_json(text);
  if (!json.is_object()) {
    asked.fault =
        "the request to this runner of Robosim: expected one JSON object per line, got " + excerpt(text);
    return asked;
  }
  asked.id = id_of(json);
  try {
    if (std::holds_alternative<std::monostate>(asked.id))
      throw InputError("\"id\" in the request: expected a number");
    asked.request = request_of<Any>(json, who);
  } catch (const InputError& error) {
    asked.fault = error.what();
  }
  return asked;
}

}  // namespace

std::string to_line(long long id, const Request& request) { return line_of(id, request); }
std::string to_line(long long id, const DrivenRequest& request) { return line_of(id, request); }
std::string to_line(long long id, const LiveRequest& request) { return line_of(id, request); }

Asked<Request> parse_request(std::string_view text) { return parse<Request>(text, "a runner"); }
Asked<DrivenRequest> parse_driven_request(std::string_view text) {
  return parse<DrivenRequest>(text, "a paused run");
}
Asked<LiveRequest> parse_live_request(std::string_view text) {
  return parse<LiveRequest>(text, "a watched run");
}

}  // namespace robosim::wire
