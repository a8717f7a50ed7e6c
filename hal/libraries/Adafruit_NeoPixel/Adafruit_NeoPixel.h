// Drives strips of WS2812 LEDs, with the API of Adafruit's library. The bytes in memory have the order in
// which they are sent. A change of the brightness rescales all stored colours. A colour that is set later is
// scaled at once.
#pragma once

#include <Arduino.h>

// Encodes the order of an LED's bytes: the positions of white, red, green and blue, with two bits each. White
// has the highest bits. Equal positions of white and red mean that an LED has three bytes, without white.
#define NEO_ORDER(w, r, g, b) ((w) << 6 | (r) << 4 | (g) << 2 | (b))
#define NEO_RGB NEO_ORDER(0, 0, 1, 2)
#define NEO_RBG NEO_ORDER(0, 0, 2, 1)
#define NEO_GRB NEO_ORDER(1, 1, 0, 2)
#define NEO_GBR NEO_ORDER(2, 2, 0, 1)
#define NEO_BRG NEO_ORDER(1, 1, 2, 0)
#define NEO_BGR NEO_ORDER(2, 2, 1, 0)
#define NEO_WRGB NEO_ORDER(0, 1, 2, 3)
#define NEO_RGBW NEO_ORDER(3, 0, 1, 2)
#define NEO_GRBW NEO_ORDER(3, 1, 0, 2)
#define NEO_BRGW NEO_ORDER(3, 1, 2, 0)
#define NEO_BGRW NEO_ORDER(3, 2, 1, 0)

#define NEO_KHZ800 0x0000
#define NEO_KHZ400 0x0100

typedef uint16_t neoPixelType;

class Adafruit_NeoPixel {
 public:
  Adafruit_NeoPixel(uint16_t count, int16_t pin = 6, neoPixelType type = NEO_GRB + NEO_KHZ800);
  Adafruit_NeoPixel() {}
  ~Adafruit_NeoPixel();
  Adafruit_NeoPixel(const Adafruit_NeoPixel&) = delete;
  Adafruit_NeoPixel& operator=(const Adafruit_NeoPixel&) = delete;

  bool begin();
  void show();
  /// Returns whether the line has been quiet for 300 us, so that the LEDs have latched the previous colours.
  bool canShow();
  void setPin(int16_t pin);
  void updateLength(uint16_t count);
  void updateType(neoPixelType type);

  void setPixelColor(uint16_t n, uint8_t r, uint8_t g, uint8_t b, uint8_t w = 0);
  void setPixelColor(uint16_t n, uint32_t color);
  /// Sets `count` LEDs from `first` on. A `count` of 0 means all LEDs up to the end.
  void fill(uint32_t color = 0, uint16_t first = 0, uint16_t count = 0);
  void clear();
  void rainbow(uint16_t first_hue = 0, int8_t times = 1, uint8_t saturation = 255, uint8_t brightness = 255,
               bool gammify = true);
  void setBrightness(uint8_t brightness);

  uint8_t* getPixels() const { return bytes_; }
  uint8_t getBrightness() const { return static_cast<uint8_t>(scale_ - 1); }
  int16_t getPin() const { return pin_; }
  uint16_t numPixels() const { return count_; }
  uint32_t getPixelColor(uint16_t n) const;

  static uint8_t sine8(uint8_t x);
  static uint8_t gamma8(uint8_t x);
  static uint32_t gamma32(uint32_t color);
  static uint32_t Color(uint8_t r, uint8_t g, uint8_t b) { return Color(r, g, b, 0); }
  static uint32_t Color(uint8_t r, uint8_t g, uint8_t b, uint8_t w) {
    return static_cast<uint32_t>(w) << 24 | static_cast<uint32_t>(r) << 16 | static_cast<uint32_t>(g) << 8 |
           b;
  }
  static uint32_t ColorHSV(uint16_t hue, uint8_t saturation = 255, uint8_t brightness = 255);

 private:
  bool has_white() const { return (type_ >> 6 & 3) != (type_ >> 4 & 3); }
  uint16_t width() const { return has_white() ? 4 : 3; }
  uint16_t size() const { return static_cast<uint16_t>(count_ * width()); }
  uint8_t scaled(uint8_t value) const { return scale_ ? static_cast<uint8_t>(value * scale_ >> 8) : value; }

  uint8_t* bytes_ = nullptr;
  uint16_t count_ = 0;
  neoPixelType type_ = NEO_GRB;
  int16_t pin_ = -1;
  bool begun_ = false;
  uint8_t scale_ = 0;  ///< brightness + 1; 256, full brightness, is stored as 0
  uint32_t shown_ = 0;
};
