// Reads arbitrary bytes as a line of the runner protocol, both as the runner and as the client. Either the
// line is rejected with a message, or it is valid: it can be written and read again.
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "sim/wire/protocol.h"
#include "tests/fuzz/require.h"

namespace {

using namespace robosim::wire;

template <class Any>
void as_runner(const Asked<Any>& asked, Asked<Any> (*parse)(std::string_view)) {
  require(asked.request.has_value() == asked.fault.empty(), "it is a request, or there is a sentence");
  if (!asked.request) return;
  const std::string line = to_line(7, *asked.request);
  const Asked<Any> again = parse(line);
  require(again.request.has_value(), "a request that is written is read again");
  require(to_line(7, *again.request) == line, "and is the same");
}

void as_client(std::string_view text) {
  try {
    const Line line = parse_line(text);
    const std::string written = to_line(Id(std::int64_t{7}), line.content);
    require(to_line(Id(std::int64_t{7}), parse_line(written).content) == written,
            "an answer that is written is read again");
  } catch (const RunnerError& error) {
    require(*error.what() != '\0', "errors say something");
  }
  try {
    parse_hello(text, "robosim-fuzz");
  } catch (const RunnerError& error) {
    require(*error.what() != '\0', "errors say something");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  as_runner<Request>(parse_request(text), parse_request);
  as_runner<DrivenRequest>(parse_driven_request(text), parse_driven_request);
  as_client(text);
  return 0;
}
