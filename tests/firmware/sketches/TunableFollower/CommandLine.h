// Reads lines from Serial: a word, and optionally a number.
#ifndef COMMAND_LINE_H
#define COMMAND_LINE_H

#include <Arduino.h>

class CommandLine {
 public:
  static const uint8_t kLongest = 20;  ///< longer lines are not commands

  /// Handles received bytes. Returns true if a line is complete. The line stays valid until the next call.
  bool read() {
    while (Serial.available() > 0) {
      const char c = Serial.read();
      if (c == '\r') continue;
      if (c != '\n') {
        if (length_ <= kLongest) text_[length_++] = c;
        continue;
      }
      text_[length_ > kLongest ? 0 : length_] = 0;
      length_ = 0;
      return true;
    }
    return false;
  }

  /// Returns whether the line's word equals `word`, which is in flash.
  bool is(const char* word) const {
    const uint8_t length = static_cast<uint8_t>(strlen_P(word));
    return strncmp_P(text_, word, length) == 0 && (text_[length] == 0 || text_[length] == ' ');
  }
  /// Returns the number after the word, or 0.
  long number() const {
    const char* space = strchr(text_, ' ');
    return space == nullptr ? 0 : atol(space);
  }

 private:
  char text_[kLongest + 1];
  uint8_t length_ = 0;
};

#endif
