// Implements HardwareSerial (Arduino AVR core). Its buffers have 64 bytes, one of which stays empty.
#include <Arduino.h>

#include "hal/host/api.h"
#include "hal/host/uart.h"

namespace host = robosim::host;
namespace cost = robosim::host::cost;
using robosim::kNoPin;

HardwareSerial Serial;
#if ROBOSIM_SERIAL_LINES > 1
HardwareSerial Serial1(false);
#endif
#if ROBOSIM_SERIAL_LINES > 2
HardwareSerial Serial2(false);
#endif
#if ROBOSIM_SERIAL_LINES > 3
HardwareSerial Serial3(false);
#endif

namespace {

struct Ring {
  uint8_t bytes[SERIAL_RX_BUFFER_SIZE];
  uint8_t head, tail;
} received;

constexpr int kRingBytes = SERIAL_TX_BUFFER_SIZE - 1;

/// Returns the number of bytes in the transmit buffer. Bytes in the UART's data register or shift register do
/// not count.
int64_t buffered() {
  const int64_t sending = host::uart.sending();
  return sending > 2 ? sending - 2 : 0;
}

/// Returns whether a text is a number. The core formats numbers before sending them, at a cost per digit.
bool is_number(const uint8_t* text, size_t size) {
  for (size_t i = 0; i < size; ++i)
    if (text[i] < '0' || text[i] > '9') return false;
  return size > 0;
}

void transmit(uint8_t byte) {
  host::spend(cost::kSerialWrite);
  if (host::uart.sending() > 1) {  // the byte passes through the buffer, so the handler runs once more
    if (buffered() >= kRingBytes) host::wait_until(host::uart.until_sending(kRingBytes + 1));
    host::spend(cost::kSerialTransmitHandler);
  }
  host::uart.send(byte);
}

}  // namespace

extern "C" void robosim_serial_receive() {
  host::spend(cost::kSerialReceiveHandler);
  const uint8_t byte = host::uart.take();
  const auto next = static_cast<uint8_t>((received.head + 1) % SERIAL_RX_BUFFER_SIZE);
  if (next == received.tail) return;
  received.bytes[received.head] = byte;
  received.head = next;
}

static_assert(host::kUartReceived == 18, "the handler's name");
extern "C" __attribute__((weak, alias("robosim_serial_receive"))) void __vector_18();

bool robosim::host::serial_receives() { return __vector_18 == robosim_serial_receive; }

void HardwareSerial::begin(unsigned long baud, uint8_t config) {
  host::note_call("Serial.begin", kNoPin, 1, static_cast<int32_t>(baud));
  host::spend(cost::kSerialBegin);
  if (!connected_) return;
  constexpr unsigned long kClock = host::kClockHz;
  if (baud == 0) baud = 1;
  unsigned long divider = (kClock / 4 / baud - 1) / 2;
  host::uart.set_status(host::kU2x);
  // The core treats 57600 baud differently at 16 MHz, for the boot loader of the Duemilanove.
  if ((baud == 57600 && kClock == 16000000) || divider > 4095) {
    host::uart.set_status(0);
    divider = (kClock / 8 / baud - 1) / 2;
  }
  host::uart.set_divider(static_cast<uint16_t>(divider));
  host::uart.set_format(config);
  host::uart.set_control(host::kRxen | host::kTxen | host::kRxcie);
  host::refresh_deadline();
}

void HardwareSerial::end() {
  host::note_call("Serial.end", kNoPin, 0);
  if (!connected_) return;
  host::wait_until(host::uart.until_sending(0));
  host::uart.set_control(0);
  received.head = received.tail;
  host::refresh_deadline();
}

int HardwareSerial::available() {
  host::note_question("Serial.available", kNoPin, 0);
  host::spend_asking(cost::kSerialAvailable);
  if (!connected_) return 0;
  return (SERIAL_RX_BUFFER_SIZE + received.head - received.tail) % SERIAL_RX_BUFFER_SIZE;
}

int HardwareSerial::peek() {
  host::note_call("Serial.peek", kNoPin, 0);
  host::spend(cost::kSerialAvailable);
  return !connected_ || received.head == received.tail ? -1 : received.bytes[received.tail];
}

int HardwareSerial::read() {
  host::note_call("Serial.read", kNoPin, 0);
  host::spend(cost::kSerialRead);
  if (!connected_ || received.head == received.tail) return -1;
  const uint8_t byte = received.bytes[received.tail];
  received.tail = static_cast<uint8_t>((received.tail + 1) % SERIAL_RX_BUFFER_SIZE);
  return byte;
}

int HardwareSerial::availableForWrite() {
  host::note_call("Serial.availableForWrite", kNoPin, 0);
  host::spend(cost::kSerialAvailable);
  return connected_ ? static_cast<int>(kRingBytes - buffered()) : kRingBytes;
}

void HardwareSerial::flush() {
  host::note_call("Serial.flush", kNoPin, 0);
  if (!connected_) return;
  host::wait_until(host::uart.until_sending(0));
}

size_t HardwareSerial::write(uint8_t byte) {
  host::note_call("Serial.write", kNoPin, 1, byte);
  if (connected_) transmit(byte);
  return 1;
}

size_t HardwareSerial::write(const uint8_t* bytes, size_t size) {
  host::note_call("Serial.print", kNoPin, 0);
  if (!connected_) return size;
  if (is_number(bytes, size)) host::spend(cost::kSerialNumber + static_cast<int>(size) * cost::kSerialDigit);
  for (size_t i = 0; i < size; ++i) transmit(bytes[i]);
  return size;
}
void serialEventRun() {
  if (serialEvent && Serial.available()) serialEvent();
}
