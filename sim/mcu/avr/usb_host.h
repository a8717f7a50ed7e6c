// Models the computer at the other end of a chip's USB cable. The host enumerates the device, and opens the
// device's serial port, if any (USB 2.0, chapters 7.1.7 and 9; CDC PSTN 1.2, 6.3).
//
//   attached ── 100 ms ── reset, 10 ms ── 10 ms ── descriptors, address, configuration
//            ── line coding (115200 8N1), DTR
//
// The port is then open. ChipEnvironment::sent() receives the device's bytes, with the number after the last
// UART as line. Bytes for the device wait here until the device accepts them. A transaction takes 100 us.
//
// The host opens the port as soon as the port exists, as if a user were waiting for it. Earlier output of a
// sketch is lost, unless the sketch waits for the port.
#pragma once

#include <array>
#include <cstdint>

#include "sim/mcu/avr/usb_device.h"

namespace robosim::avr {

class UsbHost final : public Peripheral {
 public:
  UsbHost(Core& core, UsbDevice& device);

  void reset(Cycle at) override;
  void clock_runs(bool runs, Cycle at) override;

  /// Sends a byte to the device.
  void receive(std::uint8_t byte);

 private:
  enum class Phase : std::uint8_t { absent, debouncing, resetting, recovering, asking, open, refused };
  enum class Stage : std::uint8_t { setup, in, out, status_in, status_out };
  static constexpr std::size_t kMostDescriptors = 256, kMostWaiting = 1024;
  struct State {
    Phase phase = Phase::absent;
    Stage stage = Stage::setup;
    std::uint8_t step = 0;
    std::uint8_t control_interface = 0, data_in = 0,
                 data_out = 0;  ///< interface and endpoints of the serial port
    std::uint8_t configuration = 0;
    std::uint16_t received = 0;
    std::array<std::uint8_t, kMostDescriptors> descriptors{};
    std::array<std::uint8_t, kMostWaiting> waiting{};
    std::uint16_t first = 0, count = 0;  ///< position and number of the waiting bytes
    Core::Held held_act, held_frame;
  };
  struct Request {
    std::uint8_t type, request;
    std::uint16_t value, index, length;
  };

  Request request() const;
  void attachment_changed();
  void filled();
  void act(Cycle at);
  void frame(Cycle at);
  void ask();
  void answered();
  void read_descriptors();
  void move_bytes(Cycle at);
  int line() const { return core_.chip.uart_count; }

  Core& core_;
  UsbDevice& device_;
  Events::Id act_ = 0, frame_ = 0;
  State state_;
};

}  // namespace robosim::avr
