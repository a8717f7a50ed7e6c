// Models DMA1 (RM0008 13): seven channels that move items between memory and peripherals.
//
// A peripheral's request is served at once, and takes no processor time. A memory-to-memory transfer takes 5
// cycles for each item (AN2548, 3.3). The first half of the items arrives halfway through the transfer, and
// the other items arrive at its end. If several requests are pending, the request with the highest priority
// is served first.
#pragma once

#include "sim/exec/stm32/peripheral.h"

namespace robosim::exec::stm32 {

/// The interface by which DMA accesses memory and peripherals. `bytes` is 1, 2 or 4.
class DmaBus {
 public:
  /// Returns false if the address is invalid.
  virtual bool dma_load(Address address, unsigned bytes, std::uint32_t& value) = 0;
  virtual bool dma_store(Address address, unsigned bytes, std::uint32_t value) = 0;

 protected:
  ~DmaBus() = default;
};

class Dma final : public Peripheral {
 public:
  static constexpr int kChannels = 7;

  Dma(Link& link, DmaBus& bus) : link_(link), bus_(bus) { link.snapshots.add(state_); }

  std::uint32_t read(Address address) override;
  bool write(Address address, std::uint32_t value) override;
  void reset(Address block) override;
  Cycle next_event() const override;
  void update() override;

  /// Returns the channels that can move an item on a peripheral's request, as a set of dma_channel() bits.
  unsigned waiting() const { return state_.waiting; }
  /// Moves one item through the channel with the highest priority in the set `channels`, a subset of
  /// waiting(). Returns the channel's number, 1 to 7.
  int serve(unsigned channels);

 private:
  struct Channel {
    std::uint32_t control = 0, count = 0, peripheral = 0, memory = 0;
    std::uint32_t left = 0, next_peripheral = 0, next_memory = 0;  ///< state of the running transfer
    Cycle stage_at = kNoCycle;  ///< for a memory-to-memory transfer, the time at which more items arrive
  };

  struct State {
    std::array<Channel, kChannels> channels{};
    std::uint32_t status = 0;
    unsigned waiting = 0;
  };

  void refresh(int index);
  void begin(Channel& channel);
  void move(int index);
  void flag(int index, std::uint32_t flags);
  std::uint32_t next_stage(const Channel& channel) const;

  Link& link_;
  DmaBus& bus_;
  State state_;
};

}  // namespace robosim::exec::stm32
