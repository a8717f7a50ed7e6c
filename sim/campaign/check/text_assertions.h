// Reads the keys `never`, `sometimes` and `always` of checks.toml: texts that a sketch must never, sometimes
// or always send or show.
#pragma once

#include <string>
#include <vector>

#include "sim/base/config.h"
#include "sim/result/run_result.h"

namespace robosim::campaign {

struct TextAssertion {
  enum class When { never, sometimes, always };
  When when = When::never;
  bool shown = false;  ///< shown by a display or a Bluetooth module; otherwise sent over the serial port
  std::string words;

  bool is_in(const result::RunResult& result) const;
  /// Returns the assertion as written in the file: "serial: arrived".
  std::string text() const;
};

/// Reads the keys `never`, `sometimes` and `always` of a file of checks. Throws InputError.
std::vector<TextAssertion> read_text_assertions(TableReader& file);

/// Returns why a run breaks a `never` or `always` assertion, in one sentence; empty if the run does not break
/// it. A text of `always` must appear by the end of a run.
std::string why_broken(const TextAssertion& assertion, const result::RunResult& result);

}  // namespace robosim::campaign
