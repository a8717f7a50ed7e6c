#include "sim/exec/host/host_fault.h"

#include <dlfcn.h>

#include "sim/exec/host/fiber.h"

namespace robosim::exec {

HostFault describe(int signal, const siginfo_t& info, const ucontext_t& context) {
  HostFault fault;
  fault.signal = signal;
  fault.code = info.si_code;
  fault.address = static_cast<const std::byte*>(info.si_addr);
  if (signal == SIGSYS) fault.call = info.si_syscall;
#if defined(__x86_64__)
  const auto& registers = context.uc_mcontext.gregs;
  fault.pc = reinterpret_cast<const std::byte*>(registers[REG_RIP]);
  fault.stack_pointer = reinterpret_cast<const std::byte*>(registers[REG_RSP]);
  fault.known_write = registers[REG_ERR] & 2;
  fault.known_read = !fault.known_write;
#elif defined(__aarch64__)
  fault.pc = reinterpret_cast<const std::byte*>(context.uc_mcontext.pc);
  fault.stack_pointer = reinterpret_cast<const std::byte*>(context.uc_mcontext.sp);
  fault.link = reinterpret_cast<const void*>(context.uc_mcontext.regs[30]);
#elif defined(__arm__)
  fault.pc = reinterpret_cast<const std::byte*>(context.uc_mcontext.arm_pc);
  fault.stack_pointer = reinterpret_cast<const std::byte*>(context.uc_mcontext.arm_sp);
  fault.link = reinterpret_cast<const void*>(context.uc_mcontext.arm_lr);
#endif
  return fault;
}

bool in_same_object(const void* a, const void* b) {
  Dl_info first{}, second{};
  return dladdr(a, &first) && dladdr(b, &second) && first.dli_fbase == second.dli_fbase;
}

void ensure_signal_stack() {
  stack_t present{};
  if (sigaltstack(nullptr, &present) == 0 && !(present.ss_flags & SS_DISABLE)) return;
  static thread_local const GuardedMemory memory(64 * 1024);
  stack_t ours{};
  ours.ss_sp = memory.begin();
  ours.ss_size = memory.size();
  sigaltstack(&ours, nullptr);
}

}  // namespace robosim::exec
