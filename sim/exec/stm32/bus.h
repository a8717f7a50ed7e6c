// Routes the processor's loads and stores outside flash and RAM to peripheral registers. Each address belongs
// to one register of one peripheral. Unmodelled accesses are recorded with the register's name.
//
// The bus also works without a processor. In tests, the functions of hal/stm32 access the bus directly.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sim/exec/stm32/adc.h"
#include "sim/exec/stm32/backup.h"
#include "sim/exec/stm32/clocks.h"
#include "sim/exec/stm32/crc.h"
#include "sim/exec/stm32/dma.h"
#include "sim/exec/stm32/flash.h"
#include "sim/exec/stm32/i2c.h"
#include "sim/exec/stm32/ports.h"
#include "sim/exec/stm32/spi.h"
#include "sim/exec/stm32/systick.h"
#include "sim/exec/stm32/timers.h"
#include "sim/exec/stm32/tracing.h"
#include "sim/exec/stm32/usart.h"
#include "sim/exec/stm32/watchdogs.h"

namespace robosim::exec::stm32 {

constexpr Address kPeripherals = 0x40000000;
constexpr Address kBitBand = 0x42000000;  ///< one word for each bit of the peripherals' registers

/// An access that is not modelled.
struct Unmodelled {
  Address address = 0;
  std::uint32_t value = 0;  ///< the written value
  bool write = false;
  std::string what;  ///< "register 0x40005400 (I2C1)"
};

class Bus : DmaBus {
 public:
  Bus(ClockedBoard& board, FlashMemory& memory, SimTime began);

  /// Loads from an address; `size` is 1, 2 or 4 bytes.
  std::uint32_t load(Address address, unsigned size);
  void store(Address address, std::uint32_t value, unsigned size);
  /// Returns whether a store is in progress. If so, this store is the cause of a pin change that is reported
  /// now.
  bool is_storing() const { return state_.storing; }
  /// Sets a function that is called before each store.
  void before_stores(std::function<void(Address)> watcher) { before_store_ = std::move(watcher); }
  /// Returns the cycle before which load() always returns the same value; see Peripheral::same_until().
  Cycle same_until(Address address);

  /// Returns the time of the next event of any peripheral; kNoCycle if no event is due.
  Cycle next_event() const { return state_.next_event; }
  /// Runs all peripheral events that are due now.
  void update();
  /// Returns whether a store programs flash; see Flash::programs().
  bool programs(Address address, unsigned size) const { return flash_.programs(address, size); }
  const FlashMemory& flash() const { return flash_.memory(); }
  const RamMemory& ram() const { return ram_; }
  /// Returns the flash page that has changed since the last call; nullopt if no page has changed.
  std::optional<Address> take_changed_page() { return flash_.take_changed(); }
  /// Delivers the inputs that the robot has sent so far.
  void take_inputs();

  /// Resets everything except the backup domain. Reports link().reset_cause in RCC_CSR, and then clears
  /// reset_cause.
  void reset();

  /// Saves all state that changes during a run, including RAM, except the content of flash.
  SnapshotRegistry::Snapshot save() const { return link_.snapshots.save(); }
  void restore(const SnapshotRegistry::Snapshot& saved) { link_.snapshots.restore(saved); }

  Link& link() { return link_; }
  const Link& link() const { return link_; }
  /// Returns whether the independent watchdog runs. This watchdog can reset the chip without an earlier
  /// interrupt.
  bool may_reset() const { return iwdg_.next_event() != kNoCycle; }
  const Ports& ports() const { return ports_; }
  const std::optional<Unmodelled>& unmodelled() const { return state_.unmodelled; }
  /// Returns the address of the last access.
  Address last_address() const { return state_.last_address; }

  /// Returns the name of the peripheral at an address (RM0008 3.3, table 3): "I2C1". Returns an empty text if
  /// no peripheral is there.
  static const char* name_at(Address address);

 private:
  static constexpr Address kBlockBytes = 0x400, kEnd = 0x40024000;
  /// An address range of a peripheral. A peripheral may have several ranges.
  struct Block {
    Peripheral* peripheral = nullptr;
    Gate gate;
  };

  struct State {
    std::vector<Cycle> events;    ///< next_event() of each peripheral, as last recorded
    Cycle next_event = kNoCycle;  ///< the earliest of `events`
    std::optional<Unmodelled> unmodelled;
    Address last_address = 0;
    bool serves_dma = false, storing = false;
  };

  void place(Peripheral& peripheral, Address block);
  void add(Peripheral& peripheral);
  Block* block_at(Address address);
  PinDrive alternate(ChipPin pin) const;
  Pulse pulse(ChipPin pin) const;
  bool watched(ChipPin pin) const;
  void edge(const BoardInput& edge);
  bool dma_load(Address address, unsigned bytes, std::uint32_t& value) override;
  bool dma_store(Address address, unsigned bytes, std::uint32_t value) override;
  void serve_dma();
  void note_signals(Peripheral& peripheral);
  void signal(Signals signals);
  void note_event(Peripheral& peripheral);
  void note_all_events();
  void find_next_event();
  void clocks_changed();
  void reset_held();
  std::uint32_t load_word(Address address);
  void store_part(Address address, std::uint32_t value, unsigned size);
  void store_word(Address address, std::uint32_t value);
  bool load_private(Address address, std::uint32_t& value);
  bool store_private(Address address, std::uint32_t value);
  bool load_bit(Address address, std::uint32_t& value);
  bool store_bit(Address address, std::uint32_t value);
  void refuse(Address address, bool write, std::uint32_t value = 0);

  Link link_;
  RamMemory ram_;
  Clocks clocks_;
  Flash flash_;
  Ports ports_;
  SysTick systick_;
  std::array<Timer, 4> timers_;
  SharedLine adc_line_;
  std::array<Adc, 2> adcs_;
  std::array<Usart, 3> usarts_;
  Dma dma_;
  IndependentWatchdog iwdg_;
  WindowWatchdog wwdg_;
  std::array<Spi, 2> spis_;
  std::array<I2c, 2> i2cs_;
  Power power_;
  Backup backup_;
  Rtc rtc_;
  Crc crc_;
  Tracing tracing_;
  std::array<Block, (kEnd - kPeripherals) / kBlockBytes> blocks_{};
  std::vector<Peripheral*> peripherals_;       ///< each peripheral once; the first one that drives a pin wins
  std::function<void(Address)> before_store_;  ///< may be empty
  State state_;
};

}  // namespace robosim::exec::stm32
