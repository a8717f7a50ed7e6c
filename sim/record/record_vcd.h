// Writes recordings as .vcd: the signals at the board's pins, for GTKWave, PulseView and other wave viewers
// (IEEE 1364-2005, chapter 18). docs/reference/recordings.md lists the signals. Each robot has its own scope
// in the file.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "hal/board/board_spec.h"
#include "sim/base/new_file.h"
#include "sim/record/recorder.h"

namespace robosim::record {

/// Writes changes in the order of time. Changes arrive almost in this order. Each change waits until no
/// earlier change can arrive.
class VcdRecorder final : public Recorder {
 public:
  explicit VcdRecorder(const std::filesystem::path& path) : file_(path) {}
  void ask(wire::RunRequest& request) const override;
  void begin(const RecordedRun& run) override;
  /// Adds pin changes, the firmware's readings of pins, and serial bytes. Ignores everything else.
  void add(const wire::Event& event) override;
  void finish(const result::RunResult& result) override;

 private:
  struct Change {
    std::int64_t t_ns;
    double value;  ///< for a wire: a wire::PinLevel
    std::uint32_t signal;
  };
  struct Signal {
    enum class Kind { wire, real, byte };
    std::string name;
    Kind kind;
    std::string id;  ///< identifier in the file
  };
  /// The numbers of a pin's signals; 0xFFFFFFFF = no such signal.
  struct PinSignals {
    std::uint32_t level, duty, tone, volts;
  };

  /// A robot's board.
  struct Board {
    std::string scope;
    std::map<std::string, PinSignals> pins;
    /// A cache of the few pins with events. The keys are the bytes of the pins' names.
    std::vector<std::pair<std::uint64_t, const PinSignals*>> met;
    std::uint32_t sent[2], received[2];  ///< signals: the byte, and a wire that toggles with each byte
    bool flipped[2] = {false, false};
    std::size_t end = 0;  ///< end of the board's signals, which begin at the previous board's end
  };

  void begin_board(const std::string& scope, const BoardSpec& spec);
  std::uint32_t declare(std::string name, Signal::Kind kind);
  void change(std::int64_t t_ns, std::uint32_t signal, double value);
  void ended(const result::RunResult& result);
  void add_byte(Board& board, const wire::SerialByte& byte);
  const PinSignals* signals_of(int agent, const std::string& pin);
  static char* write(char* to, const Signal& signal, double value);
  void write_header();
  void write_changes(std::int64_t until_ns);
  char* go_to(char* to, std::int64_t t_ns);

  NewFile file_;
  std::vector<Signal> signals_;
  std::vector<Board> boards_;     ///< by robot number
  std::vector<double> values_;    ///< values of the signals in the file so far
  std::vector<Change> waiting_;   ///< sorted by time
  std::size_t most_waiting_ = 0;  ///< number of waiting changes that causes the next flush
  std::int64_t now_ns_ = 0;       ///< the file's current time
  std::int64_t last_ns_ = 0;
};

}  // namespace robosim::record
