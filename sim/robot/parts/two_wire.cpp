#include "sim/robot/parts/two_wire.h"

namespace robosim::robot {
namespace {

constexpr int kFirstAddress = 0x08, kLastAddress = 0x77;  // other addresses are reserved

}  // namespace

std::uint8_t read_two_wire(PartReader& reader, int usual_address) {
  reader.take_two_wire();
  return static_cast<std::uint8_t>(
      reader.table().integer("address", usual_address, kFirstAddress, kLastAddress));
}

bool RegisterDevice::address(std::uint8_t address, bool, SimTime t) {
  if (address != address_) return false;
  cursor_.numbered = false;
  hold(t);
  return true;
}

bool RegisterDevice::write(std::uint8_t byte, SimTime t) {
  if (!cursor_.numbered) {
    cursor_.numbered = true;
    cursor_.number = numbered(byte);
    return true;
  }
  set(cursor_.number, byte, t);
  cursor_.number = behind(cursor_.number);
  return true;
}

std::uint8_t RegisterDevice::read(SimTime t) {
  const std::uint8_t value = get(cursor_.number, t);
  cursor_.number = behind(cursor_.number);
  return value;
}

}  // namespace robosim::robot
