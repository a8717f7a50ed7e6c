// Recordings as .vcd: what happened on the board's pins, for GTKWave, PulseView and other wave viewers (IEEE
// 1364-2005, chapter 18). The signals are listed in docs/recordings.md. Of several robots each has a scope.
#pragma once

#include <map>
#include <vector>

#include "hal/board/board_spec.h"
#include "sim/record/recorder.h"

namespace robosim::record {

/// Gathers changes in memory; nothing is written before the end.
class VcdRecorder final : public Recorder {
 public:
  explicit VcdRecorder(std::filesystem::path path) : path_(std::move(path)) {}
  void ask(wire::RunRequest& request) const override;
  void begin(const RecordedRun& run) override;
  /// Takes pin changes, what the firmware read on its pins, and bytes; ignores everything else.
  void add(const wire::Event& event) override;
  void finish(const wire::RunResult&) override;
  /// The whole file: every signal declared, then the changes in the order of time.
  std::string text() const;

 private:
  struct Change {
    std::int64_t t_ns;
    std::uint32_t signal;
    double value;  ///< of a wire: a wire::PinLevel
  };
  struct Signal {
    enum class Kind { wire, real, byte };
    std::string name;
    Kind kind;
    std::string id;  ///< as the file abbreviates it
  };
  /// A pin's signals by number; 0xFFFFFFFF where it has no such signal.
  struct PinSignals {
    std::uint32_t level, duty, tone, volts;
  };

  /// A robot's board.
  struct Board {
    std::string scope;
    std::map<std::string, PinSignals> pins;
    std::uint32_t sent[2], received[2];  ///< the byte, and a wire that flips with each
    bool flipped[2] = {false, false};
    std::size_t end = 0;  ///< its signals are those before, from the end of the board before it
  };

  void begin_board(const std::string& scope, const BoardSpec& spec);
  std::uint32_t declare(std::string name, Signal::Kind kind);
  void change(std::int64_t t_ns, std::uint32_t signal, double value);
  void add_byte(Board& board, const wire::SerialByte& byte);
  static void write(std::string& out, const Signal& signal, double value);

  std::filesystem::path path_;
  std::vector<Signal> signals_;
  std::vector<Board> boards_;  ///< by the robots' numbers
  std::vector<Change> changes_;
  std::int64_t last_ns_ = 0;
};

}  // namespace robosim::record
