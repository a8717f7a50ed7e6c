#include "sim/exec/stm32/engine.h"

#include <stdexcept>
#include <string>
#include <utility>

#include "sim/exec/stm32/cpu.h"
#include "sim/exec/stm32/unicorn.h"

namespace robosim::exec::stm32 {

using namespace robosim::stm32;

namespace {

void check(uc_err error) {
  if (error != UC_ERR_OK) throw std::runtime_error(std::string("libunicorn: ") + uc_strerror(error));
}

}  // namespace

struct Cpu::Hooks {
  static Cpu& self(void* engine) { return *static_cast<Engine*>(engine)->cpu_; }

  static void code(uc_engine* uc, std::uint64_t address, std::uint32_t, void* engine) {
    Cpu& c = self(engine);
    const auto pc = static_cast<std::uint32_t>(address);
    if (std::exchange(c.first_, false) || (pc - c.state_.pc < c.block_bytes_ && !c.state_.fault)) return;
    // The chip cannot run ARM code. If a branch has selected ARM code, the fault is reported at the branch's
    // target.
    std::uint32_t cpsr = 0;
    uc_reg_read(uc, UC_ARM_REG_CPSR, &cpsr);
    constexpr std::uint32_t kThumbState = 1u << 5;
    if (!(cpsr & kThumbState)) {
      if (c.begins(pc)) return;
      c.ends_ = true;
    }
    c.after_ = pc;
    uc_emu_stop(uc);
  }
  template <Address kBase>
  static std::uint64_t load(uc_engine*, std::uint64_t offset, unsigned size, void* engine) {
    const std::uint32_t value = self(engine).bus_.load(kBase + static_cast<Address>(offset), size);
    self(engine).accessed();
    return value;
  }
  template <Address kBase>
  static void store(uc_engine*, std::uint64_t offset, unsigned size, std::uint64_t value, void* engine) {
    Cpu& c = self(engine);
    c.bus_.store(kBase + static_cast<Address>(offset), static_cast<std::uint32_t>(value), size);
    if (const auto page = c.bus_.take_changed_page()) c.forget(*page);
    c.accessed();
  }
  static bool invalid(uc_engine*, uc_mem_type type, std::uint64_t address, int, std::int64_t, void* engine) {
    Cpu& c = self(engine);
    const auto at = static_cast<std::uint32_t>(address);
    switch (type) {
      case UC_MEM_FETCH_UNMAPPED:
      case UC_MEM_FETCH_PROT:
        c.after_ = at;
        if (at >= kExceptionReturn)
          c.state_.returning = true;
        else
          c.jumped_nowhere(at);
        break;
      case UC_MEM_WRITE_PROT:
        c.fail(Fault::Kind::flash_write, c.state_.pc, at);
        break;
      case UC_MEM_WRITE_UNMAPPED:
        c.fail(Fault::Kind::bad_write, c.state_.pc, at);
        break;
      default:
        c.fail(Fault::Kind::bad_read, c.state_.pc, at);
    }
    return false;
  }
  static void interrupt(uc_engine* uc, std::uint32_t number, void* engine) {
    Cpu& c = self(engine);
    std::uint32_t pc = 0;
    uc_reg_read(uc, UC_ARM_REG_PC, &pc);
    uc_emu_stop(uc);
    constexpr std::uint32_t kUndefined = 1, kSupervisorCall = 2, kPrefetchAbort = 3, kBreakpoint = 7,
                            kExit = 8;
    if (number == kExit || (number == kPrefetchAbort && pc >= kExceptionReturn)) {
      c.after_ = pc;
      c.state_.returning = true;
    } else if (number == kSupervisorCall) {
      c.state_.next = pc;
      c.nvic_.pend(kSvcall);
    } else if (number == kBreakpoint) {
      c.fail(Fault::Kind::breakpoint, c.state_.pc);
    } else if (number == kUndefined) {
      c.fail(Fault::Kind::bad_opcode, c.state_.pc, c.opcode(c.state_.pc));
    } else {
      c.jumped_nowhere(pc);
    }
  }
  static bool undefined(uc_engine*, void* engine) {
    self(engine).fail(Fault::Kind::bad_opcode, self(engine).state_.pc,
                      self(engine).opcode(self(engine).state_.pc));
    return false;
  }
};

Engine::Engine(const FlashMemory& flash) {
  // Does not set UC_MODE_MCLASS. With it, libunicorn would ignore the CPU model, and execute instructions
  // that a Cortex-M3 does not have.
  check(uc_open(UC_ARCH_ARM, UC_MODE_THUMB, &uc_));
  try {
    check(uc_ctl_set_cpu_model(uc_, UC_CPU_ARM_CORTEX_M3));
    check(uc_mem_map_ptr(uc_, kFlash, kFlashBytes, UC_PROT_READ | UC_PROT_EXEC, flash.data()));
    // Also maps flash at address 0, as boot memory (RM0008 3.4).
    check(uc_mem_map_ptr(uc_, 0, kFlashBytes, UC_PROT_READ | UC_PROT_EXEC, flash.data()));
    map_registers<kPeripherals>(Cpu::kPeripheralBytes);
    map_registers<kBitBand>(Cpu::kBitBandBytes);
    map_registers<Cpu::kPrivate>(Cpu::kPrivateBytes);
    const auto add = [&](int type, auto* hook) {
      uc_hook handle;
      check(uc_hook_add(uc_, &handle, type, reinterpret_cast<void*>(hook), this, 1, 0));
    };
    add(UC_HOOK_CODE, &Cpu::Hooks::code);
    add(UC_HOOK_MEM_INVALID, &Cpu::Hooks::invalid);
    add(UC_HOOK_INTR, &Cpu::Hooks::interrupt);
    add(UC_HOOK_INSN_INVALID, &Cpu::Hooks::undefined);
    as_new_ = save();
  } catch (...) {
    close();
    throw;
  }
}

Engine::~Engine() { close(); }

void Engine::close() {
  as_new_.reset();
  context_.reset();
  uc_close(uc_);
}

template <Address kBase>
void Engine::map_registers(std::uint32_t bytes) {
  check(uc_mmio_map(uc_, kBase, bytes, &Cpu::Hooks::load<kBase>, this, &Cpu::Hooks::store<kBase>, this));
}

Engine::Context Engine::save() const {
  if (context_) return context_;
  uc_context* made = nullptr;
  check(uc_context_alloc(uc_, &made));
  context_ = Context(made, [](uc_context* context) { uc_context_free(context); });
  check(uc_context_save(uc_, made));
  return context_;
}

void Engine::restore(const Context& saved) {
  if (context_ == saved) return;
  check(uc_context_restore(uc_, const_cast<uc_context*>(saved.get())));
  context_ = saved;
}

void Engine::begin(Cpu& cpu, std::uint8_t* ram) {
  restore(as_new_);
  check(uc_mem_map_ptr(uc_, kRam, kRamBytes, UC_PROT_ALL, ram));
  cpu_ = &cpu;
}

void Engine::end() {
  for (const auto& [begin, bytes] :
       {std::pair{kRam, kRamBytes}, {kFlash, kFlashBytes}, {Address{0}, kFlashBytes}})
    uc_ctl_remove_cache(uc_, begin, begin + bytes);
  uc_mem_unmap(uc_, kRam, kRamBytes);
  cpu_ = nullptr;
}

}  // namespace robosim::exec::stm32
