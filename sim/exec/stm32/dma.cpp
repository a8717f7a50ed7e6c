#include "sim/exec/stm32/dma.h"

#include <algorithm>

namespace robosim::exec::stm32 {

using namespace robosim::stm32;

namespace {

// Registers and bits (RM0008 13.4). The four flags of channel n start at bit 4 * (n - 1).
constexpr Address kDmaIsr = kDma1 + 0x00, kDmaIfcr = kDma1 + 0x04, kDmaChannels = kDma1 + 0x08;
constexpr Address kChannelBytes = 20;
constexpr std::uint32_t kGlobal = 1u << 0, kComplete = 1u << 1, kHalf = 1u << 2, kError = 1u << 3;
constexpr std::uint32_t kEnable = 1u << 0, kToPeripheral = 1u << 4, kCircular = 1u << 5,
                        kPeripheralGoesOn = 1u << 6, kMemoryGoesOn = 1u << 7, kMemToMem = 1u << 14;
constexpr Cycle kItemCycles = 5;

unsigned bytes_of(std::uint32_t size) { return 1u << std::min(size & 3, 2u); }

}  // namespace

void Dma::flag(int index, std::uint32_t flags) {
  state_.status |= (flags | kGlobal) << (4 * index);
  refresh(index);
}

// Updates the channel's interrupt line and its bit in waiting(). The interrupt enable bits in CCR have the
// same positions as the flags in ISR.
void Dma::refresh(int index) {
  const Channel& channel = state_.channels[static_cast<std::size_t>(index)];
  const std::uint32_t flags = state_.status >> (4 * index) & (kComplete | kHalf | kError);
  link_.nvic.set_line(static_cast<Irq>(kIrqDma1Channel1 + index), flags & channel.control);
  const bool waits = channel.control & kEnable && !(channel.control & kMemToMem) && channel.left > 0;
  state_.waiting = (state_.waiting & ~(1u << index)) | (waits ? 1u << index : 0);
}

std::uint32_t Dma::next_stage(const Channel& channel) const {
  const std::uint32_t half = channel.count / 2;
  return channel.left > channel.count - half ? channel.left - (channel.count - half) : channel.left;
}

void Dma::begin(Channel& channel) {
  channel.left = channel.count;
  channel.next_peripheral = channel.peripheral;
  channel.next_memory = channel.memory;
  const bool stages = channel.control & kMemToMem && channel.left > 0;
  channel.stage_at = stages ? link_.clock.now + next_stage(channel) * kItemCycles : kNoCycle;
}

void Dma::move(int index) {
  Channel& channel = state_.channels[static_cast<std::size_t>(index)];
  const std::uint32_t control = channel.control;
  const unsigned of_peripheral = bytes_of(control >> 8), of_memory = bytes_of(control >> 10);
  const bool out = control & kToPeripheral;
  // A narrower target receives the lower bytes. A wider target is padded with zeros (table 77).
  std::uint32_t value = 0;
  const bool moved = out ? bus_.dma_load(channel.next_memory, of_memory, value) &&
                               bus_.dma_store(channel.next_peripheral, of_peripheral, value)
                         : bus_.dma_load(channel.next_peripheral, of_peripheral, value) &&
                               bus_.dma_store(channel.next_memory, of_memory, value);
  if (!moved) {
    channel.control &= ~kEnable;
    channel.stage_at = kNoCycle;
    return flag(index, kError);
  }
  if (control & kPeripheralGoesOn) channel.next_peripheral += of_peripheral;
  if (control & kMemoryGoesOn) channel.next_memory += of_memory;
  --channel.left;
  if (channel.left == channel.count - channel.count / 2 && channel.count > 1) flag(index, kHalf);
  if (channel.left > 0) return;
  if (control & kCircular)
    begin(channel);
  else
    channel.count = 0;
  flag(index, kComplete);
}

int Dma::serve(unsigned channels) {
  int chosen = -1;
  std::uint32_t best = 0;
  for (int i = 0; i < kChannels; ++i) {
    const std::uint32_t priority = state_.channels[static_cast<std::size_t>(i)].control >> 12 & 3;
    if (channels >> i & 1 && (chosen < 0 || priority > best)) {
      chosen = i;
      best = priority;
    }
  }
  move(chosen);
  return chosen + 1;
}

Cycle Dma::next_event() const {
  Cycle next = kNoCycle;
  for (const Channel& channel : state_.channels) next = std::min(next, channel.stage_at);
  return next;
}

void Dma::update() {
  for (int i = 0; i < kChannels; ++i) {
    Channel& channel = state_.channels[static_cast<std::size_t>(i)];
    while (link_.clock.now >= channel.stage_at) {
      const Cycle at = channel.stage_at;
      channel.stage_at = kNoCycle;
      for (std::uint32_t items = next_stage(channel); items > 0 && channel.control & kEnable; --items)
        move(i);
      if (channel.left > 0 && channel.control & kEnable)
        channel.stage_at = at + next_stage(channel) * kItemCycles;
    }
  }
}

void Dma::reset(Address) {
  state_.channels = {};
  state_.status = 0;
  for (int i = 0; i < kChannels; ++i) refresh(i);
}

std::uint32_t Dma::read(Address address) {
  update();
  if (address == kDmaIsr) return state_.status;
  if (address < kDmaChannels) return 0;
  const std::size_t index = (address - kDmaChannels) / kChannelBytes;
  if (index >= state_.channels.size()) return 0;
  const Channel& channel = state_.channels[index];
  switch ((address - kDmaChannels) % kChannelBytes) {
    case 0x0:
      return channel.control;
    case 0x4:
      return channel.left;
    case 0x8:
      return channel.peripheral;
    case 0xC:
      return channel.memory;
    default:
      return 0;
  }
}

bool Dma::write(Address address, std::uint32_t value) {
  update();
  if (address == kDmaIfcr) {
    for (int i = 0; i < kChannels; ++i) {
      const std::uint32_t clears = value >> (4 * i) & 15;
      std::uint32_t flags = state_.status >> (4 * i) & 15 & ~(clears & kGlobal ? 15u : clears);
      if (flags == kGlobal) flags = 0;
      state_.status = (state_.status & ~(15u << (4 * i))) | flags << (4 * i);
      refresh(i);
    }
    return true;
  }
  const std::size_t index = (address - kDmaChannels) / kChannelBytes;
  if (address < kDmaChannels || index >= state_.channels.size()) return true;
  Channel& channel = state_.channels[index];
  const bool runs = channel.control & kEnable;
  switch ((address - kDmaChannels) % kChannelBytes) {
    case 0x0:
      channel.control = value & 0x7FFF;
      if (!runs && value & kEnable) {
        channel.count = channel.left;
        begin(channel);
      }
      if (!(value & kEnable)) channel.stage_at = kNoCycle;
      refresh(static_cast<int>(index));
      return true;
    case 0x4:
      if (!runs) channel.count = channel.left = value & 0xFFFF;
      return true;
    case 0x8:
      if (!runs) channel.peripheral = value;
      return true;
    case 0xC:
      if (!runs) channel.memory = value;
      return true;
    default:
      return true;
  }
}

}  // namespace robosim::exec::stm32
