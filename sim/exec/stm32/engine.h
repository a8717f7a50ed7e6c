// libunicorn's emulator of one chip. The code that it makes needs a large piece of memory that is writable
// and executable, which a confined process cannot have anew (sim/exec/host/confinement.h). So it is made
// once, before the run begins, and lasts over all of the chip's power cycles.
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
  /// Of a chip with this flash, which outlives it. Throws std::runtime_error.
  explicit Engine(const FlashMemory& flash);
  ~Engine();
  Engine(const Engine&) = delete;
  Engine& operator=(const Engine&) = delete;

  /// Until end() it is the emulator of `cpu`, and as new. `ram`: as RamMemory has it.
  void begin(Cpu& cpu, std::uint8_t* ram);
  void end();

  uc_struct* uc() const { return uc_; }

  /// What it knows from one instruction to the next: the monitor of LDREX and STREX. A Cpu gives it
  /// everything else each time.
  using Context = std::shared_ptr<const uc_context>;
  Context save() const;
  void restore(const Context& saved);
  /// An instruction is about to run.
  void runs() { context_.reset(); }

 private:
  friend class Cpu;

  template <Address kBase>
  void map_registers(std::uint32_t bytes);
  void close();

  uc_struct* uc_ = nullptr;
  Context as_new_;
  mutable Context context_;  ///< its present one; null = nobody has asked since an instruction has run
  Cpu* cpu_ = nullptr;       ///< null = the chip has no power
};

}  // namespace robosim::exec::stm32
