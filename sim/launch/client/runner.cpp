#include "sim/launch/client/runner.h"

#include <filesystem>
#include <system_error>

#include "sim/base/error.h"
#include "sim/base/file.h"
#include "sim/base/system_error.h"
#include "sim/base/utf8.h"
#include "sim/launch/client/process.h"

namespace robosim::client {
namespace fs = std::filesystem;

namespace {

// Limit of wall time for the runner's first message. The limit is generous, since the runner itself may run
// under an emulator (qemu-user).
constexpr int kHelloPatience_ms = 30'000;

std::string program_of(const std::string& target) {
  const fs::path program = helper_folder() / ("robosim-" + target);
  std::error_code error;
  if (!fs::exists(program, error)) {
    const std::string packages = target == "avr"     ? "libdw-dev"
                                 : target == "stm32" ? "libunicorn-dev libdw-dev"
                                                     : "";
    if (!packages.empty() && helper_folder().filename() == "robosim") {  // libexec/robosim: an installation
      throw ToolMissing("the target " + target + " is missing: it is the package robosim-" + target +
                        " (sudo apt install robosim-" + target + ")");
    }
    if (!packages.empty()) {
      throw ToolMissing(
          "the target " + target + " is missing: Robosim was built without the Debian packages " + packages +
          ". Install them (sudo apt install " + packages + "), configure and build Robosim again");
    }
    throw ToolMissing("the runner of target " + target + " is missing: " + program.string() +
                      ". This version has " + one_of(available_targets()) + ".");
  }
  return program.string();
}

/// Changes the verdict to `crashed`, because the sketch has overwritten the events of its own run. The result
/// of such a run cannot be trusted.
void blame_for_batch(result::RunResult& result) {
  if (result.verdict == "crashed") return;
  if (!result.others.empty())
    throw InputError(
        "one of the sketches on the host has overwritten the events of the run: run each sketch alone or on "
        "its chip");
  const std::string cause = "it overwrote the events of its run";
  result.crash.emplace().reason = cause;
  result.crash->check = "sandbox";
  result.verdict = "crashed";
  result.status = static_cast<int>(ExitStatus::failed);
  result.why = "The sketch crashed: " + cause + ".";
}

// Throws InputError if the name of a file is not UTF-8. JSON cannot carry such a name, and the runner would
// receive the name of another file.
void check_name(const std::string& file) {
  if (!is_utf8(file)) throw InputError({file}, "cannot be used: the name of a file must be UTF-8");
}

}  // namespace

const std::vector<std::string>& available_targets() {
  static const std::vector<std::string> targets{"host", "avr", "stm32"};
  return targets;
}

Runner::Runner(const std::string& target) : Runner(Program{program_of(target)}) {}

Runner Runner::from_program(const std::string& path) { return Runner(Program{path}); }

Runner::Runner(const Program& program) : name_(fs::path(program.path).filename().string()) {
  try {
    process_ = std::make_unique<Process>(program.path);
  } catch (const std::system_error& error) {
    if (const std::string fault = system_error_of(error); !fault.empty()) throw ToolMissing(fault);
    throw wire::RunnerError(error.what());
  }
  const auto text = process_->read_line(kHelloPatience_ms);
  if (!text) throw wire::RunnerError("the runner " + name_ + " sent no hello: it " + process_->finish());
  hello_ = wire::parse_hello(*text, name_);
}

Runner::~Runner() = default;
Runner::Runner(Runner&&) noexcept = default;
Runner& Runner::operator=(Runner&&) noexcept = default;

void Runner::fail_silent() {
  if (process_->interrupted()) {
    kill();
    process_->finish();
    throw wire::Unstoppable("the run did not stop when it was interrupted, and was killed");
  }
  throw wire::RunnerError("the runner " + name_ + " " + process_->finish() +
                          " before it answered; this is a fault of Robosim, not of your sketch");
}

std::optional<wire::Line> Runner::answer(bool wait, const wire::OnEvent& on_event) {
  bool answered = false;
  try {
    for (;;) {
      const auto text = process_->read_line(wait ? -1 : 0);
      if (!text && !wait && !process_->silent()) return std::nullopt;
      if (!text) fail_silent();
      wire::Line line = wire::parse_line(*text);
      const auto* error = std::get_if<wire::ErrorAnswer>(&line.content);
      if (error && line.id < 0) throw wire::RunnerError(error->message);  // the request was unreadable
      if (line.id != last_id_) {
        throw wire::RunnerError("the runner " + name_ + " answered request " + std::to_string(line.id) +
                                " instead of " + std::to_string(last_id_));
      }
      if (const auto* event = std::get_if<wire::Event>(&line.content)) {
        if (const auto* batch = std::get_if<wire::Batch>(event)) {
          const auto bytes = process_->read_bytes(static_cast<std::size_t>(batch->size));
          if (!bytes) fail_silent();
          if (on_event) read_batch(*bytes, on_event);
          continue;
        }
        if (const auto* started = std::get_if<wire::Started>(event)) batches_.begin(*started);
        if (on_event) on_event(*event);
        continue;
      }
      if (on_event) batches_.finish(on_event);
      answered = true;
      process_->forget_interrupt();
      if (auto* result = std::get_if<result::RunResult>(&line.content); result && batch_is_damaged_)
        blame_for_batch(*result);
      if (!error) return line;
      if (error->kind == "input") throw InputError(error->message);
      if (error->kind == "tool") throw ToolMissing(error->message);
      throw wire::RunnerError(error->message);
    }
  } catch (...) {
    if (!answered) kill();  // the runner may be in the middle of a run, with more output to come
    throw;
  }
}

void Runner::read_batch(std::string_view bytes, const wire::OnEvent& on_event) {
  try {
    if (!batch_is_damaged_) batches_.read(bytes, on_event);
  } catch (const wire::RunnerError&) {
    // Firmware on the host can overwrite the batches, since it shares memory with the runner.
    if (hello_.sandbox.empty()) throw;
    batch_is_damaged_ = true;
  }
}

template <typename Answer>
std::optional<Answer> Runner::take(bool wait, const wire::OnEvent& on_event) {
  std::optional<wire::Line> line = answer(wait, on_event);
  if (!line) return std::nullopt;
  if (auto* wanted = std::get_if<Answer>(&line->content)) return std::move(*wanted);
  throw wire::RunnerError("unexpected answer of the runner " + name_);
}

wire::RobotInfo Runner::describe_robot(const std::string& robot, bool full) {
  check_name(robot);
  process_->write(wire::to_line(++last_id_, wire::Request(wire::DescribeRobot{robot, full})));
  return *take<wire::RobotInfo>(true, {});
}

result::RunResult Runner::run(const wire::RunRequest& request, const wire::OnEvent& on_event) {
  begin(request);
  return *take<result::RunResult>(true, on_event);
}

void Runner::begin(const wire::RunRequest& request) {
  for (const std::string* file : {&request.image, &request.map, &request.robot, &request.counters})
    check_name(*file);
  batches_ = wire::BatchReader(request);
  batch_is_damaged_ = false;
  process_->write(wire::to_line(++last_id_, wire::Request(request)));
}

std::optional<result::RunResult> Runner::take(const wire::OnEvent& on_event) {
  return take<result::RunResult>(false, on_event);
}

int Runner::descriptor() const noexcept { return process_->descriptor(); }

void Runner::keep_close() noexcept { process_->keep_close(); }

void Runner::interrupt() noexcept { process_->interrupt(); }

void Runner::kill() noexcept { process_->kill(); }

}  // namespace robosim::client
