// gdb's remote protocol, for any executor that can report the state of its processor. While the processor is
// halted, control does not return to the simulation: the world stops with it, and no simulated time passes.
//
//   executor ──── stand_still(processor, why) ───► Server ◄── packets ──► gdb
//            ◄─── go, or one instruction ─────────
//
// An emulator's own server would not do. It listens at all network addresses, and serves one emulator only.
// It prints to the standard output, which belongs to the runner protocol, and polls its socket at every
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

enum class Access { write = 2, read = 3, any = 4 };  ///< as in Z2, Z3, Z4

/// An end of the span that can be run again.
enum class Edge { none, begin, end };

/// The reason why a processor is halted.
struct Stop {
  Signal signal = Signal::trap;
  std::optional<Access> access;  ///< the access that a watchpoint noticed
  std::uint32_t address = 0;     ///< of that watchpoint, as gdb gave it
  Edge edge = Edge::none;        ///< it cannot go further
};

/// A halted processor. Addresses are gdb's; bytes are in the target's order.
class Processor {
 public:
  /// Returns all registers, concatenated in gdb's order.
  virtual std::string registers() const = 0;
  /// Returns a register; empty if there is no such register.
  virtual std::string read_register(unsigned number) const = 0;
  virtual bool write_register(unsigned number, std::string_view bytes) = 0;
  /// Returns memory: fewer bytes than requested, or none, where memory ends.
  virtual std::string read_memory(std::uint32_t address, std::uint32_t size) const = 0;
  virtual bool write_memory(std::uint32_t address, std::string_view bytes) = 0;
  virtual bool set_breakpoint(std::uint32_t address, bool set) = 0;
  virtual bool set_watchpoint(std::uint32_t address, std::uint32_t size, Access access, bool set) = 0;
  /// Returns XML of gdb's "target.xml"; empty = gdb knows this processor's registers already.
  virtual std::string description() const { return ""; }
  /// Answers `monitor COMMAND`, with a line feed at the end.
  virtual std::string monitor(const std::string& command) = 0;

 protected:
  ~Processor() = default;
};

class History;

class Server {
 public:
  /// See Connection. `interrupted` is set when the debugger kills the program.
  Server(std::uint16_t port, std::atomic<bool>& interrupted)
      : connection_(port, interrupted), interrupted_(interrupted) {}

  /// Enables reverse execution; `history` outlives this. Without it, gdb reports that it is unavailable.
  void go_back_in(History& history) { history_ = &history; }
  /// Returns the history; null without reverse execution.
  History* history() const { return history_; }

  enum class Order { go, step, go_back, step_back };
  /// Waits for the debugger the first time. Then reports why `processor` is halted, and serves the debugger
  /// until it continues. If it has detached, killed the program, or gone, nothing is attached any more, and
  /// the order is go.
  Order stand_still(Processor& processor, const Stop& stop);
  /// Returns whether a debugger is attached, or still expected.
  bool attached() const { return !met_ || connection_.open(); }
  /// Returns whether the debugger requests a halt by Ctrl-C; does not wait, costs a system call.
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
