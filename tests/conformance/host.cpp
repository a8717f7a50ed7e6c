#include "tests/conformance/host.h"

#include <string_view>

#include "sim/build/sketch.h"
#include "sim/exec/host/host_executor.h"
#include "tests/support/temporary_folder.h"

namespace robosim::conformance {
namespace {

constexpr std::string_view kEnd = "END";  // avr/host.h

/// Records the bytes that the firmware sends. If `loops`, the firmware also receives each of these bytes.
class Line final : public SerialWatcher {
 public:
  Line(RobotPort& board, bool loops) : board_(board), loops_(loops) { board.watch_serial(*this); }
  bool has_ended() const { return text_.ends_with(kEnd); }
  std::vector<std::uint8_t> reported() const {
    const std::string_view bytes = std::string_view(text_).substr(0, text_.size() - kEnd.size());
    const std::size_t count = static_cast<std::uint8_t>(bytes.back());
    const std::string_view report = bytes.substr(bytes.size() - 1 - count, count);
    return {report.begin(), report.end()};
  }

 private:
  void byte_sent(std::uint8_t byte, SimTime t) override {
    text_ += static_cast<char>(byte);
    if (loops_) board_.receive_byte(byte, t);
  }

  RobotPort& board_;
  const bool loops_;
  std::string text_;
};

std::filesystem::path compile_for_host(const Program& program) {
  const test::TemporaryFolder scratch;
  const auto sketch = scratch / "Program";
  std::filesystem::create_directory(sketch);
  std::filesystem::copy_file(program.file, sketch / "Program.ino");
  for (const auto& entry : std::filesystem::directory_iterator(program.file.parent_path()))
    if (entry.path().extension() == ".h")
      std::filesystem::copy_file(entry.path(), sketch / entry.path().filename().string());
  test::use_shared_cache();
  build::Request request{sketch, *find_board("uno")};
  request.warnings = build::Warnings::none;
  return build::build(request).image;
}

}  // namespace

Report run_on_host(const Program& program) try {
  // A step is shorter than a frame of the USART, because an input is taken at the beginning of a step.
  constexpr SimTime kStep = 4 * kMicrosecond, kReport = 10 * kMillisecond;
  exec::HostExecutor host(*find_board("uno"), compile_for_host(program));
  const Line line(host.board(), program.loop >= 0);
  host.power_on(0);
  const SimTime end = static_cast<SimTime>(program.cycles) * kMicrosecond / 16 + kReport;
  for (SimTime t = 0; t < end && !line.has_ended() && !host.crash();) host.run_until(t += kStep);
  if (!line.has_ended()) return {};
  return {line.reported(), true};
} catch (const build::CompileError&) {
  return {};
}

}  // namespace robosim::conformance
