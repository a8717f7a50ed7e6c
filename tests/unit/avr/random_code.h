// Generates AVR machine code for tests, either word by word or as random instructions.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <random>
#include <vector>

namespace robosim::avr {

constexpr unsigned kAdd = 0x0C00, kAdc = 0x1C00, kSub = 0x1800, kSbc = 0x0800, kCp = 0x1400, kCpc = 0x0400,
                   kAnd = 0x2000, kOr = 0x2800, kEor = 0x2400, kMov = 0x2C00, kMul = 0x9C00;
constexpr unsigned kSubi = 0x5000, kSbci = 0x4000, kCpi = 0x3000, kAndi = 0x7000, kOri = 0x6000;
/// Builds a program word by word.
class Program {
 public:
  void word(unsigned word) {
    flash.push_back(static_cast<std::uint8_t>(word));
    flash.push_back(static_cast<std::uint8_t>(word >> 8));
  }
  unsigned here() const { return static_cast<unsigned>(flash.size() / 2); }
  void two(unsigned op, unsigned d, unsigned r) { word(op | (r & 16) << 5 | d << 4 | (r & 15)); }
  void immediate(unsigned op, unsigned d, unsigned k) {
    word(op | (k & 0xF0) << 4 | (d & 15) << 4 | (k & 15));
  }
  void ldi(unsigned d, unsigned k) { immediate(0xE000, d, k); }
  void lds(unsigned d, unsigned address) {
    word(0x9000 | d << 4);
    word(address);
  }
  void sts(unsigned address, unsigned r) {
    word(0x9200 | r << 4);
    word(address);
  }
  void jmp(unsigned to) {
    word(0x940C);
    word(to);
  }
  void call(unsigned to) {
    word(0x940E);
    word(to);
  }
  /// Adds a branch to `to`. The branch is taken if bit `flag` of SREG equals `set`.
  void branch(unsigned flag, bool set, unsigned to) {
    word((set ? 0xF000 : 0xF400) | ((to - here() - 1) & 0x7F) << 3 | flag);
  }
  void put(unsigned address, unsigned value) {
    ldi(24, value);
    sts(address, 24);
  }

  std::vector<std::uint8_t> flash;
};

/// Builds a program of random instructions that only compute.
class RandomCode : public Program {
 public:
  explicit RandomCode(unsigned seed) : engine_(seed) {}

  unsigned below(unsigned count) { return static_cast<unsigned>(engine_() % count); }
  unsigned pick(std::initializer_list<unsigned> of) {
    return *(of.begin() + below(static_cast<unsigned>(of.size())));
  }
  unsigned any() { return 2 + below(22); }  // r2 to r23
  unsigned upper() { return 16 + below(8); }

  void junk(unsigned count) {
    for (unsigned i = 0; i < count; ++i) {
      switch (below(8)) {
        case 0:
          two(pick({kAdd, kAdc, kSub, kSbc}), any(), any());
          break;
        case 1:
          two(pick({kCp, kCpc}), any(), any());
          break;
        case 2:
          two(pick({kAnd, kOr, kEor, kMov, kMov, kMul}), any(), any());
          break;
        case 3:
          immediate(pick({kSubi, kSbci, kCpi, kAndi, kOri, 0xE000}), upper(), below(256));
          break;
        case 4:
          word(0x9400 | any() << 4 | pick({0, 1, 2, 3, 5, 6, 7, 10}));  // com neg swap inc asr lsr ror dec
          break;
        case 5:
          word(0x9408 | below(6) << 4 | (below(2) ? 0x80 : 0));  // set or clear a flag
          break;
        case 6:
          word(0xFA00 | any() << 4 | below(8));  // bst
          word(0xF800 | any() << 4 | below(8));  // bld
          break;
        default:
          word(0xFC00 | any() << 4 | below(8) | (below(2) ? 0x200 : 0));  // sbrc, sbrs
          two(kMov, any(), any());
      }
    }
  }

 private:
  std::mt19937 engine_;
};

}  // namespace robosim::avr
