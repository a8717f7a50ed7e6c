// Implements the connection to one debugger at a TCP port of this computer. It exchanges packets of the form
// "$BODY#SUM". A '+' acknowledges each packet. TCP is reliable, so the debugger can turn acknowledgements off
// ("Debugging with GDB", appendix E, Remote Protocol).
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "sim/base/descriptor.h"

namespace robosim::exec::gdb {

class Connection {
 public:
  /// Listens at 127.0.0.1. Throws InputError if the port is in use or not allowed for this user. All
  /// functions stop waiting when a signal handler sets `interrupted`.
  Connection(std::uint16_t port, const std::atomic<bool>& interrupted);
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  /// Waits for a debugger. Afterwards no other debugger can connect. Returns false if the wait was
  /// interrupted.
  bool accept();
  bool open() const { return peer_.is_open(); }
  void close() { peer_.close(); }

  /// Waits for the next packet. If the debugger disconnects, or the wait is interrupted, closes the
  /// connection and returns nullopt.
  std::optional<std::string> receive();
  void send(std::string_view body);
  /// Turns off acknowledgements.
  void trust() { trusted_ = true; }

  /// Returns whether the user has pressed Ctrl-C in the debugger, or the debugger has disconnected. Closes
  /// the connection if the debugger has disconnected. Does not wait.
  bool asks_to_halt();

 private:
  bool wait(int descriptor);
  bool fill();
  void write(std::string_view bytes);
  std::optional<std::string> take_packet();

  const std::atomic<bool>& interrupted_;
  Descriptor listener_, peer_;
  bool trusted_ = false;
  std::string received_;
};

}  // namespace robosim::exec::gdb
