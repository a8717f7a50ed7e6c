// Wraps libunicorn's emulator for one chip. libunicorn generates code, and needs a large range of writable
// and executable memory. A confined process cannot allocate such memory (sim/exec/host/confinement.h).
// Therefore the emulator is created before the run begins, and is used for all power cycles of the chip.
#pragma once

#include <cstdint>
#include <memory>

#include "sim/exec/stm32/memory.h"

struct uc_struct;
struct uc_context;

namespace robosim::exec::stm32 {

class Cpu;

class Engine {
 public:
  /// Creates the emulator. `flash` must outlive this object. Throws std::runtime_error if libunicorn fails.
  explicit Engine(const FlashMemory& flash);
  ~Engine();
  Engine(const Engine&) = delete;
  Engine& operator=(const Engine&) = delete;

  /// Resets the emulator, and attaches the emulator to `cpu` until end(). `ram` is the data of a RamMemory.
  void begin(Cpu& cpu, std::uint8_t* ram);
  void end();

  uc_struct* uc() const { return uc_; }

  /// The state that libunicorn stores from one instruction to the next: the monitor of LDREX and STREX. The
  /// Cpu sets all other state before each instruction.
  using Context = std::shared_ptr<const uc_context>;
  Context save() const;
  void restore(const Context& saved);
  /// Must be called before libunicorn runs an instruction, because the instruction may change the Context.
  void runs() { context_.reset(); }

 private:
  friend class Cpu;

  template <Address kBase>
  void map_registers(std::uint32_t bytes);
  void close();

  uc_struct* uc_ = nullptr;
  Context as_new_;
  mutable Context context_;  ///< the present state; null = an instruction has run since the last save()
  Cpu* cpu_ = nullptr;       ///< null while the power is off
};

}  // namespace robosim::exec::stm32
