#include "sim/exec/stm32/tracing.h"

namespace robosim::exec::stm32 {

using namespace robosim::stm32;

namespace {

constexpr Address kItm = 0xE0000000, kItmPortsEnd = 0xE0000080, kDwtCtrl = 0xE0001000,
                  kDwtCyccnt = 0xE0001004, kDwtEnd = 0xE0002000, kDemcr = 0xE000EDFC, kTpiu = 0xE0040000,
                  kTpiuEnd = 0xE0041000, kDbgmcuIdcode = 0xE0042000, kDbgmcuCr = 0xE0042004;
constexpr std::uint32_t kCycCntEna = 1u << 0, kTrcEna = 1u << 24;
constexpr std::uint32_t kMediumDensity = 0x20036410;  // RM0008 31.6.1, revision Y

}  // namespace

bool Tracing::owns(Address address) {
  return (address >= kItm && address < kDwtEnd) || address == kDemcr ||
         (address >= kTpiu && address < kTpiuEnd) || address == kDbgmcuIdcode || address == kDbgmcuCr;
}

std::uint32_t Tracing::cycles() const {
  return state_.counts ? static_cast<std::uint32_t>(link_.clock.now - state_.zero_at) : state_.held;
}

std::uint32_t Tracing::read(Address address) {
  if (address < kItmPortsEnd) return 1;  // the port can accept output
  if (address == kDbgmcuIdcode) return kMediumDensity;
  if (address == kDwtCyccnt) return cycles();
  const auto found = state_.kept.find(address);
  return found == state_.kept.end() ? 0 : found->second;
}

bool Tracing::write(Address address, std::uint32_t value) {
  if (address < kItmPortsEnd || address == kDbgmcuIdcode) return true;
  state_.held = address == kDwtCyccnt ? value : cycles();
  if (address != kDwtCyccnt) state_.kept[address] = value;
  state_.counts = state_.kept[kDwtCtrl] & kCycCntEna && state_.kept[kDemcr] & kTrcEna;
  state_.zero_at = link_.clock.now - state_.held;
  return true;
}

void Tracing::reset(Address) {
  state_.kept.clear();
  state_.counts = false;
  state_.held = 0;
}

}  // namespace robosim::exec::stm32
