// Debounces a push button, without making the program wait.
//
// Contacts bounce: for some milliseconds after a press the pin goes up and down. So a new level counts only
// after it has been stable for the debounce time. update() reads the pin once; call it in every loop(), as
// often as you like.
//
// Wiring: by default, the button connects the pin to ground. The chip's pull-up keeps the pin HIGH, and a
// press makes it LOW. With `PushButton::PressedIs::high`, the button connects the pin to 5 V, and a resistor
// of 10 kilohm connects the pin to ground.
//
// Example:
//
//   PushButton start_button(2);
//   void setup() { start_button.begin(); }
//   void loop() {
//     start_button.update();
//     if (start_button.wasPressed()) running = !running;
//   }
#ifndef LINEKIT_PUSH_BUTTON_H
#define LINEKIT_PUSH_BUTTON_H

#include <Arduino.h>

class PushButton {
 public:
  enum class PressedIs : uint8_t { low, high };

  /// `debounce_ms` is the time for which a level must be stable before it counts; 20 ms suits most buttons.
  explicit PushButton(uint8_t pin, PressedIs pressed_is = PressedIs::low, uint8_t debounce_ms = 20)
      : pin_(pin), debounce_ms_(debounce_ms), pressed_is_(pressed_is) {}

  /// Sets the pin's mode and uses its present level as the state. A button held at power-on therefore counts
  /// as pressed at once.
  void begin();
  /// Reads the pin.
  void update();

  bool isPressed() const { return pressed_; }
  /// Returns true after the update() that detects a press, until the next update().
  bool wasPressed() const { return changed_ && pressed_; }
  /// Returns true once for each release.
  bool wasReleased() const { return changed_ && !pressed_; }
  /// Returns how long the present state has lasted, in ms.
  uint32_t heldFor() const { return millis() - changed_at_; }

 private:
  bool look() const { return (digitalRead(pin_) == HIGH) == (pressed_is_ == PressedIs::high); }

  uint8_t pin_;
  uint8_t debounce_ms_;
  PressedIs pressed_is_;
  bool pressed_ = false;
  bool changed_ = false;
  bool candidate_ = false;
  uint32_t candidate_since_ = 0;
  uint32_t changed_at_ = 0;
};

#endif
