// Serves gdb's remote protocol for any executor that can report the state of its processor. While the
// processor is halted, stand_still() does not return. Therefore the world stops, too, and no simulated time
// passes.
//
//   executor ──── stand_still(processor, why) ───► Server ◄── packets ──► gdb
//            ◄─── go, or one instruction ─────────
//
// The gdb servers of existing emulators are not suitable. They listen at all network addresses, and each
// server works with one emulator only. They print to standard output, which the runner protocol uses. They
// poll their socket at every instruction.
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "sim/exec/gdb/connection.h"

namespace robosim::exec::gdb {

/// Signals, with gdb's numbers.
enum class Signal { none = 0, interrupt = 2, illegal = 4, trap = 5, fault = 11 };

enum class Access { write = 2, read = 3, any = 4 };  ///< as in the packets Z2, Z3, Z4

/// The beginning or the end of the time span in which the debugger can move.
enum class Edge { none, begin, end };

/// The reason why a processor is halted.
struct Stop {
  Signal signal = Signal::trap;
  std::optional<Access> access;  ///< the access detected by a watchpoint
  std::uint32_t address = 0;     ///< address of this watchpoint, as set by gdb
  Edge edge = Edge::none;        ///< set if the processor has halted at this edge of the time span
};

/// A halted processor. Addresses are in gdb's numbering. Bytes are in the byte order of the target.
class Processor {
 public:
  /// Returns all registers, concatenated in gdb's order.
  virtual std::string registers() const = 0;
  /// Returns the bytes of a register; empty if the register does not exist.
  virtual std::string read_register(unsigned number) const = 0;
  virtual bool write_register(unsigned number, std::string_view bytes) = 0;
  /// Returns bytes of memory. If the range reaches past the end of a memory, returns only the bytes before
  /// the end, possibly none.
  virtual std::string read_memory(std::uint32_t address, std::uint32_t size) const = 0;
  virtual bool write_memory(std::uint32_t address, std::string_view bytes) = 0;
  virtual bool set_breakpoint(std::uint32_t address, bool set) = 0;
  virtual bool set_watchpoint(std::uint32_t address, std::uint32_t size, Access access, bool set) = 0;
  /// Returns the XML of gdb's "target.xml"; empty if gdb already knows the registers of this processor.
  virtual std::string description() const { return ""; }
  /// Returns the answer to `monitor COMMAND`, with a line feed at the end.
  virtual std::string monitor(const std::string& command) = 0;

 protected:
  ~Processor() = default;
};

class History;

class Server {
 public:
  /// For the arguments, see Connection. Sets `interrupted` when the debugger kills the program.
  Server(std::uint16_t port, std::atomic<bool>& interrupted)
      : connection_(port, interrupted), interrupted_(interrupted) {}

  /// Enables reverse execution. `history` must outlive this server. Without this call, gdb reports that
  /// reverse execution is unavailable.
  void go_back_in(History& history) { history_ = &history; }
  /// Returns the history; null if reverse execution is not enabled.
  History* history() const { return history_; }

  enum class Order { go, step, go_back, step_back };
  /// Reports why `processor` is halted, and serves the debugger until the debugger continues the program. The
  /// first call also waits for the debugger to attach. If the debugger detaches, kills the program, or
  /// disconnects, returns Order::go. Afterwards no debugger is attached.
  Order stand_still(Processor& processor, const Stop& stop);
  /// Returns whether a debugger is attached or still expected.
  bool attached() const { return !met_ || connection_.open(); }
  /// Returns whether the debugger requests a halt by Ctrl-C, or has disconnected. Does not wait, but makes a
  /// system call.
  bool asks_to_halt() { return met_ && connection_.asks_to_halt(); }
  /// Prints a line in the debugger at the next halt.
  void say(const std::string& line);
  /// Reports to the debugger that the run has ended with this exit status, and closes the connection.
  void ended(int status);

 private:
  std::optional<Order> obey(Processor& processor, const std::string& packet);
  std::string answer(Processor& processor, const std::string& packet);
  std::string query(Processor& processor, const std::string& packet);
  std::string write(Processor& processor, const std::string& packet);
  std::string stop_reply() const;

  Connection connection_;
  std::atomic<bool>& interrupted_;
  History* history_ = nullptr;
  bool met_ = false;
  Stop stop_;
};

}  // namespace robosim::exec::gdb
