// Wraps libunicorn's emulator of one chip. Its generated code needs large writable and executable memory,
// which a confined process cannot allocate (sim/exec/host/confinement.h). Therefore the emulator is created
// before the run begins, and is used for all power cycles of the chip.
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
  /// Creates the emulator of a chip. `flash` must outlive it. Throws std::runtime_error.
  explicit Engine(const FlashMemory& flash);
  ~Engine();
  Engine(const Engine&) = delete;
  Engine& operator=(const Engine&) = delete;

  /// Resets the emulator and attaches it to `cpu` until end(). `ram` is the data of a RamMemory.
  void begin(Cpu& cpu, std::uint8_t* ram);
  void end();

  uc_struct* uc() const { return uc_; }

  /// Emulator state between instructions: the monitor of LDREX and STREX. A Cpu sets all other state before
  /// each instruction.
  using Context = std::shared_ptr<const uc_context>;
  Context save() const;
  void restore(const Context& saved);
  /// Notes that an instruction is about to run.
  void runs() { context_.reset(); }

 private:
  friend class Cpu;

  template <Address kBase>
  void map_registers(std::uint32_t bytes);
  void close();

  uc_struct* uc_ = nullptr;
  Context as_new_;
  mutable Context context_;  ///< the present state; null = not read since an instruction ran
  Cpu* cpu_ = nullptr;       ///< null = the chip has no power
};

}  // namespace robosim::exec::stm32
