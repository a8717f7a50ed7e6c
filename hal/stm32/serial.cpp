// Implements Serial: USART1 on PA9 (TX, pin 1) and PA10 (RX, pin 0), with buffers of 64 bytes as on an Uno
// (RM0008 27.3).
#include <Arduino.h>

#include "hal/stm32/pins.h"

using namespace robosim::stm32;

HardwareSerial Serial;

namespace {

constexpr uint8_t kMask = SERIAL_TX_BUFFER_SIZE - 1;

struct Ring {
  volatile uint8_t bytes[SERIAL_TX_BUFFER_SIZE];
  volatile uint8_t head, tail;

  bool empty() const { return head == tail; }
  uint8_t size() const { return (head - tail) & kMask; }
  bool full() const { return size() == kMask; }
  void put(uint8_t byte) {
    bytes[head] = byte;
    head = (head + 1) & kMask;
  }
  uint8_t take() {
    const uint8_t byte = bytes[tail];
    tail = (tail + 1) & kMask;
    return byte;
  }
} received, waiting;

bool started;

void serve() {
  const uint32_t status = load(kUsartSr);
  if (status & (kRxne | kOre)) {
    const auto byte = static_cast<uint8_t>(load(kUsartDr));  // after SR; this clears RXNE and ORE (27.6.1)
    if (status & kRxne && !received.full()) received.put(byte);
  }
  if (status & kTxe && load(kUsartCr1) & kTxeie) {
    if (waiting.empty())
      at(kUsartCr1) &= ~kTxeie;
    else
      at(kUsartDr) = waiting.take();
  }
}

}  // namespace

void HardwareSerial::begin(unsigned long baud, uint8_t config) {
  at(kRccApb2Enr) |= kUsart1En;
  configure(*pin_at(1), kAlternate);
  configure(*pin_at(0), kFloating);
  if (baud == 0) baud = 1;
  at(kUsartBrr) = (F_CPU + baud / 2) / baud;
  // Formats such as SERIAL_8N1 use an AVR's bits: bits 4 and 5 for parity, bit 3 for stop bits. USART1 sends
  // the parity as a ninth data bit.
  const bool parity = config & 0x20;
  at(kUsartCr2) = config & 0x08 ? kStop2 : 0;
  at(kUsartCr1) = kUe | kTe | kRe | kRxneie | (parity ? kM | kPce : 0) | (parity && config & 0x10 ? kPs : 0);
  enable_irq(kIrqUsart1);
  started = true;
}

void HardwareSerial::end() {
  flush();
  at(kUsartCr1) = 0;
  received.tail = received.head;
  started = false;
}

int HardwareSerial::available() { return received.size(); }
int HardwareSerial::peek() { return received.empty() ? -1 : received.bytes[received.tail]; }
int HardwareSerial::read() { return received.empty() ? -1 : received.take(); }
int HardwareSerial::availableForWrite() { return kMask - waiting.size(); }

void HardwareSerial::flush() {
  if (!started) return;
  while (!waiting.empty() || !(load(kUsartSr) & kTc)) {
    const Quiet quiet;  // calls serve(), so the loop also ends if interrupts were off before
    serve();
  }
}

size_t HardwareSerial::write(uint8_t byte) {
  if (!started) return 1;
  while (waiting.full()) {
    const Quiet quiet;
    serve();
  }
  const Quiet quiet;
  waiting.put(byte);
  at(kUsartCr1) |= kTxeie;
  return 1;
}

size_t HardwareSerial::write(const uint8_t* bytes, size_t size) {
  for (size_t i = 0; i < size; ++i) write(bytes[i]);
  return size;
}

void serialEventRun() {
  if (serialEvent && Serial.available()) serialEvent();
}

extern "C" void USART1_IRQHandler() { serve(); }
