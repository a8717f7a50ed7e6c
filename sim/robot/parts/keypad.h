// type = "keypad": a matrix of keys. Each key connects the wires of its row and its column. Scripts press
// keys: `press keypad.5 100ms`.
//
// The matrix contains only keys, no diodes. Pressed keys join wires into groups. If firmware drives a wire of
// a group, all pins of the group have the level of that wire. Otherwise, a pull-up on one of the group's pins
// makes all of them high. Without a pull-up, the pins float and read low. Three pressed keys on corners of a
// rectangle also connect the wires of the fourth key. Not modelled: bounce.
#pragma once

#include <array>

#include "sim/robot/part.h"
#include "sim/robot/part_context.h"
#include "sim/robot/part_reader.h"

namespace robosim::robot {

std::shared_ptr<const PartSpec> read_keypad(PartReader&);

class KeypadSpec final : public PartSpec {
 public:
  std::vector<Pin> rows, columns;
  std::vector<std::string> keys;  ///< "123A", one per row, one character per column

  std::unique_ptr<Part> make(PartContext&) const override;
};

class KeypadPart final : public Part {
 public:
  KeypadPart(const KeypadSpec&, PartContext&);

  void register_with(PartRegistry&) override;
  void read(std::vector<Reading>&) const override;

 private:
  /// One key, with its name in scripts: "keypad.5".
  class Key final : public Pressable {
   public:
    Key(KeypadPart& keypad, std::string name, std::size_t number)
        : keypad_(keypad), name_(std::move(name)), number_(number) {}
    const std::string& name() const override { return name_; }
    void hold(bool down, SimTime t) override { keypad_.hold(number_, down, t); }

   private:
    KeypadPart& keypad_;
    const std::string name_;
    const std::size_t number_;
  };
  /// One wire. Rows are numbered before columns.
  class Lead final : public PinSource {
   public:
    Lead(KeypadPart& keypad, std::size_t number) : keypad_(keypad), number_(number) {}
    bool level(SimTime) override { return keypad_.level(number_); }

   private:
    KeypadPart& keypad_;
    const std::size_t number_;
  };

  void hold(std::size_t key, bool down, SimTime t);
  bool level(std::size_t lead) const;

  struct State {
    std::uint64_t down = 0;  // one bit per key
  };

  const KeypadSpec& spec_;
  PartContext& context_;
  std::vector<Pin> pins_;  ///< by lead
  std::vector<std::unique_ptr<Key>> keys_;
  std::vector<std::unique_ptr<Lead>> leads_;
  State state_;
};

}  // namespace robosim::robot
