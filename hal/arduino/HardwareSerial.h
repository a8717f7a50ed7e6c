// Declares the serial port, with the API of the AVR core. The UART sends and receives bytes at its baud rate.
// The transmit buffer and the receive buffer have 64 bytes each, as on an Uno.
#pragma once
#ifndef HardwareSerial_h
#define HardwareSerial_h

#include <inttypes.h>

#include "Stream.h"

#define SERIAL_TX_BUFFER_SIZE 64
#define SERIAL_RX_BUFFER_SIZE 64

// Values of `config` in Serial.begin(baud, config): the bits of UCSR0C (data sheet DS40002061B, 20.11.4).
#define SERIAL_5N1 0x00
#define SERIAL_6N1 0x02
#define SERIAL_7N1 0x04
#define SERIAL_8N1 0x06
#define SERIAL_5N2 0x08
#define SERIAL_6N2 0x0A
#define SERIAL_7N2 0x0C
#define SERIAL_8N2 0x0E
#define SERIAL_5E1 0x20
#define SERIAL_6E1 0x22
#define SERIAL_7E1 0x24
#define SERIAL_8E1 0x26
#define SERIAL_5E2 0x28
#define SERIAL_6E2 0x2A
#define SERIAL_7E2 0x2C
#define SERIAL_8E2 0x2E
#define SERIAL_5O1 0x30
#define SERIAL_6O1 0x32
#define SERIAL_7O1 0x34
#define SERIAL_8O1 0x36
#define SERIAL_5O2 0x38
#define SERIAL_6O2 0x3A
#define SERIAL_7O2 0x3C
#define SERIAL_8O2 0x3E

class HardwareSerial : public Stream {
 public:
  /// Creates a port. `connected` means that it is connected to the computer, which is true only for Serial.
  explicit HardwareSerial(bool connected = true) : connected_(connected) {}
  void begin(unsigned long baud) { begin(baud, SERIAL_8N1); }
  void begin(unsigned long baud, uint8_t config);
  void end();
  int available() override;
  int peek() override;
  int read() override;
  int availableForWrite() override;
  void flush() override;
  size_t write(uint8_t byte) override;
  size_t write(const uint8_t* bytes, size_t size) override;
  size_t write(unsigned long n) { return write((uint8_t)n); }
  size_t write(long n) { return write((uint8_t)n); }
  size_t write(unsigned int n) { return write((uint8_t)n); }
  size_t write(int n) { return write((uint8_t)n); }
  using Print::write;
  operator bool() { return true; }

 private:
  bool connected_;
};

extern HardwareSerial Serial;
#define HAVE_HWSERIAL0
#if ROBOSIM_SERIAL_LINES > 1
extern HardwareSerial Serial1;
#define HAVE_HWSERIAL1
#endif
#if ROBOSIM_SERIAL_LINES > 2
extern HardwareSerial Serial2;
#define HAVE_HWSERIAL2
#endif
#if ROBOSIM_SERIAL_LINES > 3
extern HardwareSerial Serial3;
#define HAVE_HWSERIAL3
#endif

/// Handles received bytes. A sketch may define this function. It is called after each loop(), if unread bytes
/// are available.
extern void serialEvent() __attribute__((weak));
extern void serialEventRun() __attribute__((weak));

#endif  // HardwareSerial_h
