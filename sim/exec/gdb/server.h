// gdb's remote protocol for any executor that can say what its processor holds. While the processor is
// halted, control does not return to the simulation: the world stands still with it, and no simulated time
// passes.
//
//   executor ──── stand_still(processor, why) ───► Server ◄── packets ──► gdb
//            ◄─── go, or one instruction ─────────
//
// Why not an emulator's own: it listens at all network addresses, prints to the standard output (which
// belongs to the runner protocol), asks its socket at every instruction, and serves one emulator only.
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "sim/exec/gdb/connection.h"

namespace robosim::exec::gdb {

/// Signals by gdb's numbers.
enum class Signal { none = 0, interrupt = 2, illegal = 4, trap = 5, fault = 11 };

enum class Access { write = 2, read = 3, any = 4 };  ///< as in Z2, Z3, Z4

/// An end of what can be run again.
enum class Edge { none, begin, end };

/// Why a processor stands still.
struct Stop {
  Signal signal = Signal::trap;
  std::optional<Access> access;  ///< a watchpoint's
  std::uint32_t address = 0;     ///< of that watchpoint, as gdb gave it
  Edge edge = Edge::none;        ///< it can go no further
};

/// A processor while it stands still. Addresses are gdb's; bytes are in the target's order.
class Processor {
 public:
  /// All registers, one behind the other, in gdb's order.
  virtual std::string registers() const = 0;
  /// Empty: there is no such register.
  virtual std::string read_register(unsigned number) const = 0;
  virtual bool write_register(unsigned number, std::string_view bytes) = 0;
  /// Fewer bytes than asked for, or none, where memory ends.
  virtual std::string read_memory(std::uint32_t address, std::uint32_t size) const = 0;
  virtual bool write_memory(std::uint32_t address, std::string_view bytes) = 0;
  virtual bool set_breakpoint(std::uint32_t address, bool set) = 0;
  virtual bool set_watchpoint(std::uint32_t address, std::uint32_t size, Access access, bool set) = 0;
  /// XML of gdb's "target.xml"; empty = gdb knows this processor's registers by itself.
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

  /// From now on the run can go back; `history` outlives this. Else gdb says that it cannot.
  void go_back_in(History& history) { history_ = &history; }
  /// Null where it cannot.
  History* history() const { return history_; }

  enum class Order { go, step, go_back, step_back };
  /// Waits for the debugger the first time, then tells it why `processor` stands still, and serves it until
  /// it says how to go on. If it has detached, killed the program, or gone, nothing is attached any more, and
  /// the order is go.
  Order stand_still(Processor& processor, const Stop& stop);
  /// Whether a debugger is attached, or still waited for.
  bool attached() const { return !met_ || connection_.open(); }
  /// Whether the debugger asks for a halt by Ctrl-C; does not wait, costs a system call.
  bool asks_to_halt() { return met_ && connection_.asks_to_halt(); }
  /// Prints a line in the debugger, which waits for the next halt.
  void say(const std::string& line);
  /// The run is over, with this exit status.
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
