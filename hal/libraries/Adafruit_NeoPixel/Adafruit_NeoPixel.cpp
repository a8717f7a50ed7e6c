#include "Adafruit_NeoPixel.h"

namespace {

const unsigned long kQuiet_us = 300;

// kGamma[x] = 255 (x / 255)^2.6
const uint8_t kGamma[256] = {
    0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,
    0,   0,   0,   0,   1,   1,   1,   1,   1,   1,   1,   1,   1,   1,   1,   1,   2,   2,   2,   2,
    2,   2,   2,   2,   3,   3,   3,   3,   3,   3,   4,   4,   4,   4,   5,   5,   5,   5,   5,   6,
    6,   6,   6,   7,   7,   7,   8,   8,   8,   9,   9,   9,   10,  10,  10,  11,  11,  11,  12,  12,
    13,  13,  13,  14,  14,  15,  15,  16,  16,  17,  17,  18,  18,  19,  19,  20,  20,  21,  21,  22,
    22,  23,  24,  24,  25,  25,  26,  27,  27,  28,  29,  29,  30,  31,  31,  32,  33,  34,  34,  35,
    36,  37,  38,  38,  39,  40,  41,  42,  42,  43,  44,  45,  46,  47,  48,  49,  50,  51,  52,  53,
    54,  55,  56,  57,  58,  59,  60,  61,  62,  63,  64,  65,  66,  68,  69,  70,  71,  72,  73,  75,
    76,  77,  78,  80,  81,  82,  84,  85,  86,  88,  89,  90,  92,  93,  94,  96,  97,  99,  100, 102,
    103, 105, 106, 108, 109, 111, 112, 114, 115, 117, 119, 120, 122, 124, 125, 127, 129, 130, 132, 134,
    136, 137, 139, 141, 143, 145, 146, 148, 150, 152, 154, 156, 158, 160, 162, 164, 166, 168, 170, 172,
    174, 176, 178, 180, 182, 184, 186, 188, 191, 193, 195, 197, 199, 202, 204, 206, 209, 211, 213, 215,
    218, 220, 223, 225, 227, 230, 232, 235, 237, 240, 242, 245, 247, 250, 252, 255,
};

// kSine[x] = 127.5 (1 + sin(2 pi x / 256))
const uint8_t kSine[256] = {
    128, 131, 134, 137, 140, 143, 146, 149, 152, 155, 158, 162, 165, 167, 170, 173, 176, 179, 182, 185,
    188, 190, 193, 196, 198, 201, 203, 206, 208, 211, 213, 215, 218, 220, 222, 224, 226, 228, 230, 232,
    234, 235, 237, 238, 240, 241, 243, 244, 245, 246, 248, 249, 250, 250, 251, 252, 253, 253, 254, 254,
    254, 255, 255, 255, 255, 255, 255, 255, 254, 254, 254, 253, 253, 252, 251, 250, 250, 249, 248, 246,
    245, 244, 243, 241, 240, 238, 237, 235, 234, 232, 230, 228, 226, 224, 222, 220, 218, 215, 213, 211,
    208, 206, 203, 201, 198, 196, 193, 190, 188, 185, 182, 179, 176, 173, 170, 167, 165, 162, 158, 155,
    152, 149, 146, 143, 140, 137, 134, 131, 128, 124, 121, 118, 115, 112, 109, 106, 103, 100, 97,  93,
    90,  88,  85,  82,  79,  76,  73,  70,  67,  65,  62,  59,  57,  54,  52,  49,  47,  44,  42,  40,
    37,  35,  33,  31,  29,  27,  25,  23,  21,  20,  18,  17,  15,  14,  12,  11,  10,  9,   7,   6,
    5,   5,   4,   3,   2,   2,   1,   1,   1,   0,   0,   0,   0,   0,   0,   0,   1,   1,   1,   2,
    2,   3,   4,   5,   5,   6,   7,   9,   10,  11,  12,  14,  15,  17,  18,  20,  21,  23,  25,  27,
    29,  31,  33,  35,  37,  40,  42,  44,  47,  49,  52,  54,  57,  59,  62,  65,  67,  70,  73,  76,
    79,  82,  85,  88,  90,  93,  97,  100, 103, 106, 109, 112, 115, 118, 121, 124,
};

const uint32_t kTurn = 1530;  // six ramps from 0 to 255

/// Returns the red component at a position on the colour wheel, 0 to kTurn. For green, the caller adds two
/// thirds of kTurn to the position; for blue, the caller adds one third.
uint8_t red_at(uint32_t place) {
  if (place <= 255) return 255;
  if (place <= 510) return static_cast<uint8_t>(510 - place);
  if (place <= 1020) return 0;
  if (place <= 1275) return static_cast<uint8_t>(place - 1020);
  return 255;
}

}  // namespace

Adafruit_NeoPixel::Adafruit_NeoPixel(uint16_t count, int16_t pin, neoPixelType type) {
  updateType(type);
  updateLength(count);
  setPin(pin);
}

Adafruit_NeoPixel::~Adafruit_NeoPixel() {
  free(bytes_);
  if (pin_ >= 0) pinMode(static_cast<uint8_t>(pin_), INPUT);
}

bool Adafruit_NeoPixel::begin() {
  begun_ = true;
  setPin(pin_);
  return true;
}

void Adafruit_NeoPixel::setPin(int16_t pin) {
  if (begun_ && pin_ >= 0) pinMode(static_cast<uint8_t>(pin_), INPUT);
  pin_ = pin;
  if (!begun_ || pin < 0) return;
  pinMode(static_cast<uint8_t>(pin), OUTPUT);
  digitalWrite(static_cast<uint8_t>(pin), LOW);
}

void Adafruit_NeoPixel::updateLength(uint16_t count) {
  free(bytes_);
  count_ = count;
  bytes_ = static_cast<uint8_t*>(malloc(size()));
  if (!bytes_) count_ = 0;
  clear();
}

void Adafruit_NeoPixel::updateType(neoPixelType type) {
  const uint16_t before = width();
  type_ = type;
  if (bytes_ && width() != before) updateLength(count_);
}

bool Adafruit_NeoPixel::canShow() {
  const uint32_t now = static_cast<uint32_t>(micros());
  if (shown_ > now) shown_ = now;
  return now - shown_ >= kQuiet_us;
}

// Sends the colours to the LEDs. At 16 MHz, a bit takes 20 cycles. The pin is high for 5 cycles in a 0, and
// for 13 cycles in a 1.
void Adafruit_NeoPixel::show() {
  if (!bytes_ || pin_ < 0) return;
  while (!canShow()) {
  }
  const int period = static_cast<int>(F_CPU / (type_ & NEO_KHZ400 ? 400000 : 800000));
  noInterrupts();
  robosim_send_pulses(static_cast<uint8_t>(pin_), bytes_, size(), period / 4, period * 13 / 20, period);
  interrupts();
  shown_ = static_cast<uint32_t>(micros());
}

void Adafruit_NeoPixel::setPixelColor(uint16_t n, uint8_t r, uint8_t g, uint8_t b, uint8_t w) {
  if (n >= count_) return;
  uint8_t* const led = bytes_ + n * width();
  if (has_white()) led[type_ >> 6 & 3] = scaled(w);
  led[type_ >> 4 & 3] = scaled(r);
  led[type_ >> 2 & 3] = scaled(g);
  led[type_ & 3] = scaled(b);
}

void Adafruit_NeoPixel::setPixelColor(uint16_t n, uint32_t color) {
  setPixelColor(n, static_cast<uint8_t>(color >> 16), static_cast<uint8_t>(color >> 8),
                static_cast<uint8_t>(color), static_cast<uint8_t>(color >> 24));
}

uint32_t Adafruit_NeoPixel::getPixelColor(uint16_t n) const {
  if (n >= count_) return 0;
  const uint8_t* const led = bytes_ + n * width();
  const auto whole = [this](uint8_t value) {
    return static_cast<uint8_t>(scale_ ? (value << 8) / scale_ : value);
  };
  return Color(whole(led[type_ >> 4 & 3]), whole(led[type_ >> 2 & 3]), whole(led[type_ & 3]),
               has_white() ? whole(led[type_ >> 6 & 3]) : 0);
}

void Adafruit_NeoPixel::fill(uint32_t color, uint16_t first, uint16_t count) {
  const uint32_t end = count == 0 ? count_ : static_cast<uint32_t>(first) + count;
  for (uint32_t n = first; n < end && n < count_; ++n) setPixelColor(static_cast<uint16_t>(n), color);
}

void Adafruit_NeoPixel::clear() {
  if (bytes_) memset(bytes_, 0, size());
}

void Adafruit_NeoPixel::rainbow(uint16_t first_hue, int8_t times, uint8_t saturation, uint8_t brightness,
                                bool gammify) {
  for (uint16_t n = 0; n < count_; ++n) {
    const auto hue = static_cast<uint16_t>(first_hue + n * times * 65536L / count_);
    const uint32_t color = ColorHSV(hue, saturation, brightness);
    setPixelColor(n, gammify ? gamma32(color) : color);
  }
}

// Sets the brightness of later colours. Also rescales the stored colours, which loses precision.
void Adafruit_NeoPixel::setBrightness(uint8_t brightness) {
  const auto scale = static_cast<uint8_t>(brightness + 1);
  if (scale == scale_) return;
  const uint8_t before = getBrightness();
  const uint16_t most = brightness == 255 ? 65535 : static_cast<uint16_t>((scale << 8) - 1);
  const uint16_t factor = before ? static_cast<uint16_t>(most / before) : 0;
  for (uint16_t i = 0; i < size(); ++i)
    bytes_[i] = static_cast<uint8_t>(static_cast<uint16_t>(bytes_[i] * factor) >> 8);
  scale_ = scale;
}

uint8_t Adafruit_NeoPixel::sine8(uint8_t x) { return kSine[x]; }
uint8_t Adafruit_NeoPixel::gamma8(uint8_t x) { return kGamma[x]; }

uint32_t Adafruit_NeoPixel::gamma32(uint32_t color) {
  return Color(kGamma[color >> 16 & 255], kGamma[color >> 8 & 255], kGamma[color & 255], kGamma[color >> 24]);
}

uint32_t Adafruit_NeoPixel::ColorHSV(uint16_t hue, uint8_t saturation, uint8_t brightness) {
  const uint32_t place = (hue * kTurn + 32768) / 65536;
  const auto mixed = [&](uint32_t at) {
    const int pure = red_at(at);
    return static_cast<uint8_t>(((pure * (1 + saturation) >> 8) + 255 - saturation) * (1 + brightness) >> 8);
  };
  return Color(mixed(place), mixed((place + 2 * kTurn / 3) % kTurn), mixed((place + kTurn / 3) % kTurn));
}
