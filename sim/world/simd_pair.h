// Computes with two numbers at once, for a body's two wheels. Compilers use one vector instruction per
// operation if the machine has such an instruction. The results equal those of single numbers bit for bit.
//
// Code for both wheels is a template with the parameter `Both`. For one body, `Both` is Pair. For a loop over
// many bodies (sim/world/batch), `Both` is Two: its plain members let compilers vectorise the loop.
#pragma once

#include <cmath>
#include <cstdint>

namespace robosim::world {

/// Two numbers in a vector register; the compiler implements +, - and *.
typedef double Pair __attribute__((vector_size(2 * sizeof(double))));
typedef std::int64_t PairBits __attribute__((vector_size(2 * sizeof(std::int64_t))));

inline Pair pair_of(double l, double r) { return Pair{l, r}; }
inline Pair swapped(Pair a) { return Pair{a[1], a[0]}; }
/// For each of the two numbers, returns x if a is below b, else y.
inline Pair where_less(Pair a, Pair b, Pair x, Pair y) {
  const auto less = reinterpret_cast<PairBits>(a < b);
  return reinterpret_cast<Pair>((less & reinterpret_cast<PairBits>(x)) |
                                (~less & reinterpret_cast<PairBits>(y)));
}
inline Pair abs_of(Pair a) {
  return reinterpret_cast<Pair>(reinterpret_cast<PairBits>(a) & PairBits{INT64_MAX, INT64_MAX});
}
/// Returns a, which must not be negative, with the sign of b.
inline Pair signed_as(Pair a, Pair b) {
  return reinterpret_cast<Pair>(reinterpret_cast<PairBits>(a) |
                                (reinterpret_cast<PairBits>(b) & PairBits{INT64_MIN, INT64_MIN}));
}

/// Two plain numbers.
struct Two {
  double l, r;
  double operator[](int side) const { return side ? r : l; }
};
inline Two operator+(Two a, Two b) { return {a.l + b.l, a.r + b.r}; }
inline Two operator-(Two a, Two b) { return {a.l - b.l, a.r - b.r}; }
inline Two operator*(Two a, Two b) { return {a.l * b.l, a.r * b.r}; }
inline Two operator*(Two a, double k) { return {a.l * k, a.r * k}; }
inline Two swapped(Two a) { return {a.r, a.l}; }
inline Two where_less(Two a, Two b, Two x, Two y) { return {a.l < b.l ? x.l : y.l, a.r < b.r ? x.r : y.r}; }
inline Two abs_of(Two a) { return {std::fabs(a.l), std::fabs(a.r)}; }
inline Two signed_as(Two a, Two b) { return {std::copysign(a.l, b.l), std::copysign(a.r, b.r)}; }

/// Accumulates whether all conditions are true for both numbers.
template <class Both>
class Sure;

template <>
class Sure<Pair> {
 public:
  void is_less(double a, double b) { one_ &= a < b; }
  void is_at_most(double a, double b) { one_ &= a <= b; }
  void is_less(Pair a, Pair b) { both_ &= reinterpret_cast<PairBits>(a < b); }
  void is_at_most(Pair a, Pair b) { both_ &= reinterpret_cast<PairBits>(a <= b); }
  bool holds() const { return one_ && (both_[0] & both_[1]) != 0; }

 private:
  bool one_ = true;
  PairBits both_ = {-1, -1};
};

/// Stores the result as a number, 1 or 0.
template <>
class Sure<Two> {
 public:
  void is_less(double a, double b) { sure_ = a < b ? sure_ : 0.0; }
  void is_at_most(double a, double b) { sure_ = a <= b ? sure_ : 0.0; }
  void is_less(Two a, Two b) { is_less(a.l, b.l), is_less(a.r, b.r); }
  void is_at_most(Two a, Two b) { is_at_most(a.l, b.l), is_at_most(a.r, b.r); }
  double holds() const { return sure_; }

 private:
  double sure_ = 1.0;
};

}  // namespace robosim::world
