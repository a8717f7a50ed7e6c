// Models a USART in UART mode (data sheet DS40002061B, chapter 20).
//
//   send      UDR ─► buffer ─► shift register ─► TxD      UDRE: the buffer is empty
//                                                         TXC: both are empty, after a frame has left
//
// hal/board/avr_usart.h describes frames and the receive buffer. RXC and UDRE request interrupts as long as
// they are set. Writing 1 to TXC, or entering its vector, clears TXC. RXEN = 0 empties the receive buffer.
// TXEN = 0 takes effect after the last frame; the port then drives TxD again. Frames start without delay.
//
// Not modelled: frames with errors (FE and UPE are 0), the multi-processor mode (MPCM), the clock pin and the
// USART as SPI (UMSEL 3).
#pragma once

#include <cstdint>

#include "hal/board/avr_usart.h"
#include "sim/mcu/avr/pins.h"

namespace robosim::avr {

class Usart final : public Peripheral {
 public:
  Usart(Core& core, Pins& pins, int number);

  void reset(Cycle at) override;
  void clock_runs(bool runs, Cycle at) override;
  std::uint64_t may_interrupt() const override;

  /// Delivers a whole frame at cycle `at`.
  void receive(std::uint16_t data, Cycle at);

 private:
  struct State {
    UsartReceiver receiver;
    std::uint16_t waiting_data = 0;
    bool waiting = false;  ///< a frame waits for the shift register
    bool early = false;    ///< a frame was written before TXEN was set
    bool shifting = false;
    bool drives = false;   ///< the USART drives TxD
    bool listens = false;  ///< RxD is an input, regardless of the port
    bool runs = true;
    Core::Held held;
    Cycle told = 0;  ///< frame duration that was reported to the environment; 0 = receiver off
  };

  std::uint8_t read(Address address);
  void write(Address address, std::uint8_t value);
  void write_data(std::uint8_t value);
  std::uint8_t read_data();
  void write_control(std::uint8_t value);
  void begin(std::uint16_t data, Cycle at);
  void shifted(Cycle at);
  void sent_entered(int vector);
  void request();
  void tell();
  void take_pins();
  std::uint16_t data_mask() const;
  Cycle frame() const;

  std::uint8_t data(Address address) const { return core_.cpu.data[address]; }

  Core& core_;
  Pins& pins_;
  const int number_;
  const UartSpec& spec_;
  Address status_, control_, format_, divider_, data_;
  int rx_pin_ = -1, tx_pin_ = -1;
  Events::Id shifted_ = 0;
  State state_;
};

}  // namespace robosim::avr
