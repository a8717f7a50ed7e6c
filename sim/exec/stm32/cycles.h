// Defines the duration of each instruction, and the effects on the stack, interrupts and sleep that the
// emulator must check.
//
// Source: Cortex-M3 Technical Reference Manual r1p1 (ARM DDI 0337E), 18.2 "Processor instruction timings":
//
//   most instructions           1     load, one word               2     store, one word            2
//   LDM, PUSH, POP, STM of N    1+N   LDRD, STRD                   3     TBB, TBH                   2+P
//   branch, taken               1+P   branch, not taken            1     write to pc (any)          +P
//   MUL 1, MLA and MLS 2, UMULL and SMULL 4, UMLAL and SMLAL 6     SDIV, UDIV 7
//   MSR, MRS, CPS 2             DMB, DSB, ISB 4                     WFI, WFE 1
//
// P is the time to refill the pipeline. The manual gives ranges for P (1 to 3), for long multiplications, and
// for divisions (2 to 12, depending on the operands). This model uses P = 2, and the other durations as
// listed. On the chip, consecutive loads overlap; in this model they do not. Flash wait states are not
// counted, because the prefetch buffer hides most of them.
#pragma once

#include <cstdint>

namespace robosim::exec::stm32 {

constexpr unsigned kRefill_cycles = 2;  ///< P

struct Instruction {
  std::uint8_t bytes = 2;
  std::uint8_t cycles = 1;
  bool grows_stack = false;  ///< may lower the stack pointer
  bool masks = false;        ///< may change PRIMASK, FAULTMASK or BASEPRI
  bool sleeps = false;       ///< is WFI or WFE
  bool divides = false;
  std::uint8_t divisor = 0;     ///< for a division, the register that contains the divisor
  std::uint8_t predicates = 0;  ///< for IT: the number of instructions in its block
};

/// Decodes the instruction in two consecutive halfwords.
Instruction decode(std::uint16_t first, std::uint16_t second);

}  // namespace robosim::exec::stm32
