#include "sim/exec/host/host_fault.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <cstring>

#include "sim/exec/host/confinement.h"

namespace robosim::exec {

HostFault describe(int signal, const siginfo_t& info, ucontext_t& context) {
  HostFault fault;
  fault.signal = signal;
  fault.code = info.si_code;
  fault.address = static_cast<const std::byte*>(info.si_addr);
  if (signal == SIGSYS) fault.call = info.si_syscall;
  fault.own_signal = own_signal(info, context);
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

std::string signal_text(int signal) {
  return fmt::format("it sends itself signal {} ({})", signal, ::strsignal(signal));
}

std::string reason_of(const HostFault& fault, const GuardedMemory& heap, const GuardedMemory& stack) {
  constexpr std::size_t kNullPage = 4096;
  const auto address = reinterpret_cast<std::uintptr_t>(fault.address);
  if (fault.own_signal != 0) return signal_text(fault.own_signal);
  if (fault.signal == SIGSYS) return refusal(fault.call);
  if (fault.signal == SIGILL)
    return "an instruction that does not exist (a damaged stack or pointer to a function?)";
  if (fault.signal == SIGFPE) return "a division by zero, or a division whose result does not fit";
  if (stack.in_guard_before(fault.address)) return "stack overflow (deep recursion?)";
  const char* const hint = address < kNullPage ? " (null pointer)" : "";
  if (fault.address == fault.pc) return fmt::format("jump to address {:#x}{}", address, hint);
  // An x86-64 processor does not report the address if the address is not canonical.
  if (fault.signal == SIGSEGV && fault.code == SI_KERNEL)
    return "access through an invalid pointer, or a privileged instruction";
  const bool behind_heap = fault.address >= heap.end() && fault.address < heap.end() + kNullPage;
  if (heap.in_guard_before(fault.address) || behind_heap)
    return fmt::format("{} outside the heap", fault.access());
  return fmt::format("{} of address {:#x}{}", fault.access(), address, hint);
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
