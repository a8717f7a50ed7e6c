#include "sim/exec/stm32/loop_locator.h"

#include <optional>

#include "sim/exec/elf/loop_locator.h"

namespace robosim::exec::stm32 {
namespace {

using robosim::stm32::kFlash;

std::uint32_t extended(std::uint32_t value, int bits) {
  const std::uint32_t sign = 1u << (bits - 1);
  return (value ^ sign) - sign;
}

/// Returns the target of an unconditional B or of a BL (ARMv7-M ARM, A7.7.12, A7.7.18).
std::optional<std::uint32_t> jump_target(std::uint32_t pc, unsigned first, unsigned second) {
  const std::uint32_t here = pc + 4;
  if ((first & 0xF800) == 0xE000) return here + extended((first & 0x7FF) << 1, 12);
  if ((first & 0xF800) != 0xF000 || (second & 0x9000) != 0x9000) return std::nullopt;
  const unsigned s = first >> 10 & 1, j1 = second >> 13 & 1, j2 = second >> 11 & 1;
  return here + extended(s << 24 | (j1 == s ? 1u : 0u) << 23 | (j2 == s ? 1u : 0u) << 22 |
                             (first & 0x3FF) << 12 | (second & 0x7FF) << 1,
                         25);
}

class Code final : public ChipCode {
 public:
  explicit Code(const Firmware& firmware) : firmware_(firmware) {}

  std::vector<std::uint32_t> calls_of(const Symbol& function) const override {
    std::vector<std::uint32_t> calls;
    const std::uint32_t begin = function.address, end = begin + function.size;
    for (std::uint32_t pc = kFlash; pc < firmware_.code_end; pc += 2) {
      const bool within = pc >= begin && pc < end;
      if (!within && jump_target(pc, firmware_.half(pc), firmware_.half(pc + 2)) == begin)
        calls.push_back(pc);
    }
    return calls;
  }
  // Returns no steps, so that rounds of an inlined loop() are not counted. Robosim's core prevents the
  // compiler from inlining loop().
  Steps steps_of(const Symbol&) const override { return {}; }

 private:
  const Firmware& firmware_;
};

}  // namespace

LoopMarks locate_loop(const Firmware& firmware, const DebugInfo& debug) {
  return exec::locate_loop(Code(firmware), firmware.symbols, debug);
}

}  // namespace robosim::exec::stm32
