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
  return counts_ ? static_cast<std::uint32_t>(link_.clock.now - zero_at_) : held_;
}

std::uint32_t Tracing::read(Address address) {
  if (address < kItmPortsEnd) return 1;  // ready
  if (address == kDbgmcuIdcode) return kMediumDensity;
  if (address == kDwtCyccnt) return cycles();
  const auto found = kept_.find(address);
  return found == kept_.end() ? 0 : found->second;
}

bool Tracing::write(Address address, std::uint32_t value) {
  if (address < kItmPortsEnd || address == kDbgmcuIdcode) return true;
  held_ = address == kDwtCyccnt ? value : cycles();
  if (address != kDwtCyccnt) kept_[address] = value;
  counts_ = kept_[kDwtCtrl] & kCycCntEna && kept_[kDemcr] & kTrcEna;
  zero_at_ = link_.clock.now - held_;
  return true;
}

void Tracing::reset(Address) {
  kept_.clear();
  counts_ = false;
  held_ = 0;
}

}  // namespace robosim::exec::stm32
