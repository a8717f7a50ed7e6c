// How a message says what its keys are: once, beside its struct, for all who write it, read it or explain it.
//
//   struct Reading { std::string part; double volts = 0.0; };
//
//   template <class V>
//   void fields(V& v, Same<V, Reading>& r) {
//     v("part", r.part, "name of the part");
//     v("volts", r.volts, "what it reads", {.unit = "V"});
//   }
//
// A visitor V is called for each key in the order in which the keys are written: json.h has one that writes
// JSON and one that reads and checks it, tables.cpp one that makes the tables in docs/. Nothing in here knows
// JSON, so a struct and its description cost little to include.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <string>
#include <type_traits>

namespace robosim::wire {

/// T for a visitor that reads, const T for all others.
template <class V, class T>
using Same = std::conditional_t<V::kReads, T, const T>;

/// Whether a key is there.
struct Presence {
  bool required = true;  ///< a reader insists on it; else what is absent keeps its default
  bool written = true;
};
inline constexpr Presence kOptional{false, true};  ///< always written; a reader does without
/// Written only now; a reader does without.
constexpr Presence when(bool written) { return {false, written}; }

/// What else there is to say of a key.
struct Rules {
  const char* unit = "";       ///< "mm"; of an array: of its elements; "" = none
  const char* otherwise = "";  ///< for people: what an absent key of a request means; "" = its default
  Presence presence = {};
  /// Of whole numbers, both ends included.
  std::int64_t least = std::numeric_limits<std::int64_t>::min();
  std::int64_t most = std::numeric_limits<std::int64_t>::max();
  std::int64_t multiple_of = 1;
  bool not_empty = false;  ///< of text
  /// Of text: all that is allowed, if not empty.
  std::initializer_list<const char*> one_of = {};
};

/// Truths that are written as a list of the names of those that hold: ["pin", "io"].
template <class Bool>
struct Name {
  const char* name;
  Bool* holds;
};
template <class Bool>
Name(const char*, Bool*) -> Name<Bool>;  // clang 14 deduces nothing for aggregates
template <class Bool, std::size_t N>
struct NameList {
  std::array<Name<Bool>, N> names;
};
template <class Bool, std::size_t N>
NameList(std::array<Name<Bool>, N>) -> NameList<Bool, N>;

/// Pairs of a use and a pin, written as an object; a pin that is a number ("8") is written as one.
template <class List>
struct PinsByUse {
  List& list;
};
template <class List>
PinsByUse(List&) -> PinsByUse<List>;

/// A member that a visitor can go into.
template <class V, class T>
concept Described = requires(V& v, Same<V, T>& t) {
  fields(v, t);
};

/// As many robots as there may be on one map.
inline constexpr std::size_t kMostAgents = 256;

/// The key of all that is about one of several robots.
template <class V>
void agent_field(V& v, Same<V, int>& agent) {
  v("agent", agent, "number of the robot that it is about, from 0; absent where 0",
    {.presence = when(agent != 0), .least = 0, .most = kMostAgents - 1});
}

}  // namespace robosim::wire
