// Acts as a debugger that sends arbitrary bytes. The processor receives only requests that the packets
// contain, and the run continues when the debugger disconnects.
#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "sim/base/descriptor.h"
#include "sim/base/error.h"
#include "sim/exec/gdb/history.h"
#include "sim/exec/gdb/server.h"
#include "tests/fuzz/require.h"

namespace {

using namespace robosim;
using namespace robosim::exec::gdb;

class Memory final : public Processor {
 public:
  std::string registers() const override { return std::string(32, 'r'); }
  std::string read_register(unsigned number) const override { return number < 32 ? "r" : ""; }
  bool write_register(unsigned number, std::string_view bytes) override {
    return number < 32 && bytes.size() == 1;
  }
  std::string read_memory(std::uint32_t address, std::uint32_t size) const override {
    require(size <= 0x1000, "a read is at most 0x1000 bytes");
    return address < 0x8000 ? std::string(size, 'm') : "";
  }
  bool write_memory(std::uint32_t, std::string_view bytes) override {
    require(bytes.size() <= 1 << 16, "a write is not longer than the input");
    return true;
  }
  bool set_breakpoint(std::uint32_t, bool) override { return true; }
  bool set_watchpoint(std::uint32_t, std::uint32_t, Access access, bool) override {
    require(access >= Access::write && access <= Access::any, "a kind of access");
    return true;
  }
  std::string description() const override { return "<target/>"; }
  std::string monitor(const std::string& command) override { return command + "\n"; }
};

struct Past final : History {
  bool reaches_back() const override { return true; }
  bool is_at_front() const override { return true; }
  void forget() override {}
};

constexpr std::uint16_t kFirstPort = 20'000, kPorts = 10'000;

/// Listens on a free port.
Server& listen(std::optional<Server>& server, std::uint16_t& port, std::atomic<bool>& interrupted) {
  for (;;) {
    try {
      return server.emplace(port, interrupted);
    } catch (const InputError&) {
      port = static_cast<std::uint16_t>(kFirstPort + (port + 1 - kFirstPort) % kPorts);
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static std::uint16_t port = kFirstPort;
  if (size > 1 << 15) return 0;  // the socket's buffer cannot store more without a reader
  std::atomic<bool> interrupted{false};
  std::optional<Server> server;
  listen(server, port, interrupted);

  const Descriptor debugger(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0));
  const linger at_once{1, 0};  // makes the port free again immediately
  ::setsockopt(debugger.get(), SOL_SOCKET, SO_LINGER, &at_once, sizeof at_once);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(port);
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  if (::connect(debugger.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) {
    ++port;  // the kernel keeps the old port busy for a while
    return 0;
  }
  require(::send(debugger.get(), data, size, MSG_NOSIGNAL) == static_cast<ssize_t>(size),
          "the socket accepts the whole input");
  ::shutdown(debugger.get(), SHUT_WR);

  Past past;
  if (size % 2 == 0) server->go_back_in(past);
  Memory memory;
  for (int steps = 0; steps < 1000 && server->attached() && !interrupted; ++steps)
    server->stand_still(memory, {Signal::trap, Access::write, 0x100});
  server->ended(0);
  return 0;
}
