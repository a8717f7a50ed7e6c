// Models the USB device controller (ATmega16U4/32U4 data sheet 7766J, chapters 21 and 22) and its PLL (6.11).
//
//   PLLE     PLOCK reads 1 after 100 us
//   device   attached while USBE and OTGPADE are set, and FRZCLK and DETACH are not
//   UDINT    end of reset (EORSTI) and one frame per millisecond (SOFI); a bit requests the general vector
//            while the same bit is set in UDIEN
//   UENUM    selects the endpoint that the other registers access; a flag of UEINTX that UEIENX enables
//            requests the endpoint vector
//
//   control  a SETUP packet sets RXSTPI, and UEDATX returns the packet's 8 bytes
//            TXINI: clearing TXINI sends the bytes written to UEDATX
//            RXOUTI: a packet can be read
//   IN       one or two banks; FIFOCON reads 1 while a bank can be filled, and clearing FIFOCON passes the
//            bank to the host
//   OUT      FIFOCON reads 1 while a packet can be read, and clearing FIFOCON frees the packet's bank
//
// usb_host.h models the host. Not modelled: suspend and wake-up, isochronous endpoints, ping-pong errors,
// NAKINI and NAKOUTI, VBUS interrupts (VBUS is always present).
#pragma once

#include <array>
#include <cstdint>

#include "sim/mcu/avr/core.h"

namespace robosim::avr {

class UsbDevice final : public Peripheral {
 public:
  static constexpr std::size_t kMostBytes = 64;
  struct Packet {
    std::array<std::uint8_t, kMostBytes> bytes{};
    std::uint8_t count = 0;
  };
  /// The device's answer to a packet, or to a request for a packet.
  enum class Answer : std::uint8_t { later, stall, done };

  explicit UsbDevice(Core& core);

  void reset(Cycle at) override;
  std::uint64_t may_interrupt() const override;

  // --- for the host
  bool is_attached() const;
  void bus_was_reset();
  void frame_began();
  void setup(const std::array<std::uint8_t, 8>& request);
  Answer take(std::size_t endpoint, Packet& packet);
  Answer give(std::size_t endpoint, const Packet& packet);
  /// Called when is_attached() may have changed (on_attachment), or when data for the host is ready
  /// (on_filled).
  Cpu::Call on_attachment, on_filled;

 private:
  static constexpr std::size_t kEndpoints = 7;
  struct Endpoint {
    std::uint8_t control = 0, direction = 0, layout = 0, enables = 0;  ///< UECONX, UECFG0X, UECFG1X, UEIENX
    std::uint8_t flags = 0;    ///< bits of UEINTX, except FIFOCON and RWAL
    std::uint8_t waiting = 0;  ///< number of banks that wait for the host or for firmware
    std::uint8_t read = 0;     ///< number of bytes already read from the first bank
    bool armed = false;        ///< control endpoint only: `filling` is ready for the host
    std::array<Packet, 2> banks{};
    Packet filling;

    bool is_control() const { return direction >> 6 == 0; }
    bool is_in() const { return direction & 1; }
    std::uint8_t capacity() const { return layout >> 2 & 3 ? 2 : 1; }
    std::uint8_t size() const { return static_cast<std::uint8_t>(8 << (layout >> 4 & 3)); }
    bool has_bank() const { return is_in() ? waiting < capacity() : waiting > 0; }
    bool may_access() const {
      return has_bank() && (is_in() ? filling.count < size() : read < banks[0].count);
    }
    void clear_banks();
    void drop_first();
  };
  struct State {
    std::array<Endpoint, kEndpoints> endpoints{};
    Cycle locked_at = kNoCycle;  ///< cycle at which the PLL locks
    std::uint16_t frame = 0;
  };

  std::uint8_t read(Address address);
  void write(Address address, std::uint8_t value);
  std::uint8_t read_pll(Address address);
  void write_pll(Address address, std::uint8_t value);
  void write_flags(Endpoint& endpoint, std::uint8_t value);
  void write_control_flags(Endpoint& endpoint, std::uint8_t before, std::uint8_t value);
  std::uint8_t read_flags(const Endpoint& endpoint) const;
  std::uint8_t read_data(Endpoint& endpoint);
  std::uint8_t byte_count(const Endpoint& endpoint) const;
  std::uint8_t endpoints_with_request() const;
  void request();
  Endpoint& selected();
  Address at(int offset) const { return static_cast<Address>(core_.chip.usb.address + offset); }

  Core& core_;
  State state_;
};

}  // namespace robosim::avr
