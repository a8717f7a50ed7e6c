// Serves gdb's remote protocol for any executor that can report the state of its processor. While the
// processor is halted, control does not return to the simulation: the world stops, too, and no simulated time
// passes.
//
//   executor ──── stand_still(processor, why) ───► Server ◄── packets ──► gdb
//            ◄─── go, or one instruction ─────────
//
// The emulators' own servers are not suitable. They listen at all network addresses, and serve one emulator
// only. They print to standard output, which the runner protocol uses, and poll their socket at every
// instruction.
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

/// An end of the time span that can be repeated.
enum class Edge { none, begin, end };

/// The reason why a processor is halted.
struct Stop {
  Signal signal = Signal::trap;
  std::optional<Access> access;  ///< the access detected by a watchpoint
  std::uint32_t address = 0;     ///< address of that watchpoint, as gdb gave it
  Edge edge = Edge::none;        ///< end of the time span that was reached
};

/// A halted processor. Addresses are gdb's; bytes are in the target's order.
class Processor {
 public:
  /// Returns all registers, concatenated in gdb's order.
  virtual std::string registers() const = 0;
  /// Returns a register; empty if it does not exist.
  virtual std::string read_register(unsigned number) const = 0;
  virtual bool write_register(unsigned number, std::string_view bytes) = 0;
  /// Returns bytes of memory. If memory ends, returns fewer bytes than requested, or none.
  virtual std::string read_memory(std::uint32_t address, std::uint32_t size) const = 0;
  virtual bool write_memory(std::uint32_t address, std::string_view bytes) = 0;
  virtual bool set_breakpoint(std::uint32_t address, bool set) = 0;
  virtual bool set_watchpoint(std::uint32_t address, std::uint32_t size, Access access, bool set) = 0;
  /// Returns the XML of gdb's "target.xml"; empty if gdb has the list of this processor's registers already.
  virtual std::string description() const { return ""; }
  /// Returns the answer to `monitor COMMAND`, with a line feed at the end.
  virtual std::string monitor(const std::string& command) = 0;

 protected:
  ~Processor() = default;
};

class History;

class Server {
 public:
  /// See Connection. Sets `interrupted` when the debugger kills the program.
  Server(std::uint16_t port, std::atomic<bool>& interrupted)
      : connection_(port, interrupted), interrupted_(interrupted) {}

  /// Enables reverse execution. `history` outlives this server. Without it, gdb reports that reverse
  /// execution is unavailable.
  void go_back_in(History& history) { history_ = &history; }
  /// Returns the history; null without reverse execution.
  History* history() const { return history_; }

  enum class Order { go, step, go_back, step_back };
  /// Reports why `processor` is halted, and serves the debugger until it continues. The first call also waits
  /// for the debugger to attach. If the debugger detaches, kills the program, or disconnects, returns
  /// Order::go, and no debugger is attached any more.
  Order stand_still(Processor& processor, const Stop& stop);
  /// Returns whether a debugger is attached or still expected.
  bool attached() const { return !met_ || connection_.open(); }
  /// Returns whether the debugger requests a halt by Ctrl-C. Does not wait, but costs a system call.
  bool asks_to_halt() { return met_ && connection_.asks_to_halt(); }
  /// Prints a line in the debugger at the next halt.
  void say(const std::string& line);
  /// Reports the end of the run, with this exit status.
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
