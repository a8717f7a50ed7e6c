#include "sim/cli/serve/serve_arguments.h"

#include <arpa/inet.h>

#include <charconv>

#include "sim/base/error.h"
#include "sim/cli/options.h"

namespace robosim::cli {
namespace {

bool is_address(const std::string& text) {
  unsigned char bytes[16];
  return ::inet_pton(AF_INET, text.c_str(), bytes) == 1 || ::inet_pton(AF_INET6, text.c_str(), bytes) == 1;
}

}  // namespace

Command parse_serve(const std::vector<std::string>& words) {
  ServeArguments serve;
  std::string port;
  Options options("serve", "choose, run and watch a folder's sketches in the browser");
  options.positional("[FOLDER]", serve.folder,
                     "show the sketches, robots and maps of this folder (default: the current folder)",
                     PossibleValues::folder());
  options.text("--port", port, "N", "listen at this port (default: 8080, or another that is free)");
  options.text("--listen", serve.address, "ADDRESS",
               "listen at this IP address of the machine (default: 127.0.0.1); if other machines can "
               "connect, browsers need the token");
  if (const auto help = options.parse(words)) return *help;
  if (!port.empty()) {
    const auto [end, error] = std::from_chars(port.data(), port.data() + port.size(), serve.port);
    if (error != std::errc() || *end != '\0' || serve.port < 1 || serve.port > 65535)
      refuse_value("--port", port, "a port from 1 to 65535");
  }
  if (!is_address(serve.address))
    refuse_value("--listen", serve.address, "an IP address, such as 192.168.0.10");
  return serve;
}

}  // namespace robosim::cli
