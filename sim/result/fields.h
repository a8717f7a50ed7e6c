// Provides the means to describe the JSON keys of a message once, next to the message's struct. All code that
// writes, reads or documents the message uses this description.
//
//   struct Reading { std::string part; double volts = 0.0; };
//
//   template <class V>
//   void fields(V& v, Same<V, Reading>& r) {
//     v("part", r.part, "name of the part");
//     v("volts", r.volts, "measured voltage", {.unit = "V"});
//   }
//
// fields() calls the visitor V once for each key, in the order in which the keys are written. The visitor in
// json_writer.h writes JSON. The visitor in json_reader.h reads and checks JSON. The visitor in
// tests/unit/wire/docs_test.cpp makes the tables in docs/. This file includes no JSON library, so a header
// with a struct and its description compiles quickly.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <string>
#include <type_traits>

namespace robosim::result {

/// Is T for a visitor that reads, and const T for every other visitor.
template <class V, class T>
using Same = std::conditional_t<V::kReads, T, const T>;

/// Determines whether a reader requires a key, and whether a writer writes the key.
struct Presence {
  bool required = true;  ///< a reader rejects a missing key; false: it leaves the value unchanged
  bool written = true;
};
inline constexpr Presence kOptional{false, true};  ///< always written; optional for a reader
/// Returns the presence of a key that is written if `written` is true, and that is optional for a reader.
constexpr Presence when(bool written) { return {false, written}; }

/// Further properties of a key.
struct Rules {
  const char* unit = "";       ///< "mm"; for arrays, the elements' unit; "" = none
  const char* otherwise = "";  ///< for docs: the meaning of a request without the key; "" = the default value
  Presence presence = {};
  /// The range of an integer, both ends included.
  std::int64_t least = std::numeric_limits<std::int64_t>::min();
  std::int64_t most = std::numeric_limits<std::int64_t>::max();
  std::int64_t multiple_of = 1;
  bool not_empty = false;  ///< for text: "" is not allowed
  /// For text: all allowed values. An empty list allows every value.
  std::initializer_list<const char*> one_of = {};
};

/// Flags, written as a list of the names of the true flags: ["pin", "io"].
template <class Bool>
struct Name {
  const char* name;
  Bool* holds;
};
template <class Bool>
Name(const char*, Bool*) -> Name<Bool>;  // clang 14 cannot deduce this for aggregates
template <class Bool, std::size_t N>
struct NameList {
  std::array<Name<Bool>, N> names;
};
template <class Bool, std::size_t N>
NameList(std::array<Name<Bool>, N>) -> NameList<Bool, N>;

/// Pairs of a use and a pin, written as an object. A numeric pin ("8") is written as a number.
template <class List>
struct PinsByUse {
  List& list;
};
template <class List>
PinsByUse(List&) -> PinsByUse<List>;

/// A type that has its own fields(), which a visitor can call.
template <class V, class T>
concept Described = requires(V& v, Same<V, T>& t) {
  fields(v, t);
};

/// The maximum number of robots on one map.
inline constexpr std::size_t kMostAgents = 256;

/// Describes the key `agent`, which messages about one of several robots have.
template <class V>
void agent_field(V& v, Same<V, int>& agent) {
  v("agent", agent, "number of the robot, from 0; absent if 0",
    {.presence = when(agent != 0), .least = 0, .most = kMostAgents - 1});
}

}  // namespace robosim::result
