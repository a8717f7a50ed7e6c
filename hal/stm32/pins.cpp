#include "hal/stm32/pins.h"

namespace robosim {
namespace stm32 {
namespace {

constexpr uint8_t A = 0, B = 1, C = 2;

constexpr PinMap kPinMap[kPins] = {
    {A, 10, -1, 1, 3}, {A, 9, -1, 1, 2},  {B, 12, -1, 0, 0}, {A, 8, -1, 1, 1},   // 0 to 3
    {B, 13, -1, 0, 0}, {B, 6, -1, 4, 1},  {B, 7, -1, 4, 2},  {B, 14, -1, 0, 0},  // 4 to 7
    {B, 15, -1, 0, 0}, {B, 8, -1, 4, 3},  {B, 9, -1, 4, 4},  {A, 7, 7, 3, 2},    // 8 to 11
    {A, 6, 6, 3, 1},   {C, 13, -1, 0, 0},                                        // 12, 13
    {A, 0, 0, 0, 0},   {A, 1, 1, 0, 0},   {A, 2, 2, 0, 0},   {A, 3, 3, 0, 0},    // A0 to A3
    {A, 4, 4, 0, 0},   {A, 5, 5, 0, 0},   {B, 0, 8, 3, 3},   {B, 1, 9, 3, 4},    // A4 to A7
    {B, 5, -1, 0, 0},  {B, 10, -1, 0, 0}, {B, 11, -1, 0, 0}, {A, 15, -1, 0, 0},  // 22 to 25
    {B, 3, -1, 0, 0},  {B, 4, -1, 0, 0},  {A, 11, -1, 1, 4}, {A, 12, -1, 0, 0},  // 26 to 29
    {C, 14, -1, 0, 0}, {C, 15, -1, 0, 0},                                        // 30, 31
};

Address configuration_register(const PinMap& pin) { return port_of(pin) + (pin.bit < 8 ? kCrl : kCrh); }
uint32_t shift_of(const PinMap& pin) { return 4u * (pin.bit % 8u); }

}  // namespace

const PinMap* pin_at(uint8_t number) { return number < kPins ? &kPinMap[number] : nullptr; }

uint32_t configuration(const PinMap& pin) { return load(configuration_register(pin)) >> shift_of(pin) & 15u; }

void configure(const PinMap& pin, uint32_t configuration) {
  const Quiet quiet;  // a handler may configure another pin of this register
  at(configuration_register(pin)).set(15u << shift_of(pin), configuration << shift_of(pin));
}

void toggle_pin(const PinMap& pin) { write_pin(pin, !(load(port_of(pin) + kOdr) >> pin.bit & 1u)); }

void start_pins() {
  at(kRccApb2Enr) |= kAfioEn | kIopaEn | kIopbEn | kIopcEn;
  at(kAfioMapr).set(kSwjMask, kSwjNoJtag);
}

}  // namespace stm32
}  // namespace robosim
