#include "sim/exec/host/host_executor.h"

#include <fmt/format.h>
#include <setjmp.h>
#include <signal.h>
#include <ucontext.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>
#include <string>
#include <vector>

#include "sim/base/file.h"
#include "sim/exec/host/api_call.h"
#include "sim/exec/host/asan_shadow.h"
#include "sim/exec/host/bad_access.h"
#include "sim/exec/host/confinement.h"
#include "sim/exec/host/counters.h"
#include "sim/exec/host/fiber.h"
#include "sim/exec/host/host_fault.h"
#include "sim/exec/host/image_file.h"
#include "sim/exec/host/open_calls.h"
#include "sim/exec/host/state_cycle_detector.h"
#include "sim/exec/host/undefined.h"

namespace robosim::exec {
namespace {

constexpr std::size_t kStackBytes = 256 * 1024, kHeapBytes = 64 * 1024;
constexpr SimTime kWatch = 10 * kMillisecond;
constexpr std::array kFaults = {SIGSEGV, SIGBUS, SIGILL, SIGFPE, SIGSYS};
std::array<struct sigaction, kFaults.size()> previous_handlers;

}  // namespace

/// One power cycle of the firmware.
class HostExecutor::Instance final : public host::Host {
 public:
  Instance(HostExecutor& owner, SimTime t)
      : owner_(owner),
        image_(owner.image_),
        state_(*image_.entry().state),
        heap_(kHeapBytes),
        stack_(kStackBytes),
        fiber_(stack_, &Instance::start, this),
        shadow_(image_.entry().shadow, checked_memory()),
        cycle_detector_(image_, {heap_.begin(), heap_.end()}),
        snapshot_(image_) {
    state_.heap = reinterpret_cast<std::uint8_t*>(heap_.begin());
    state_.heap_bytes = heap_.size();
    state_.stack = reinterpret_cast<std::uint8_t*>(stack_.begin());
    state_.stack_bytes = stack_.size();
    state_.may_skip = owner.skips_waiting_;
    owner.injected_delays_.begin(state_, owner.reached_);
    state_.now = state_.wake = state_.last_call = owner.clocked_.begin_tick(t);
    owner_.divisions_.forget_addresses();
    catch_faults();
  }

  static void catch_faults();
  const host::FirmwareState& state() const { return state_; }
  void count(host::CounterSink& sink) const {
    if (image_.entry().counters) image_.entry().counters(sink);
  }

  /// Starts or stops checking whether firmware loops for ever.
  void watch(bool wanted) {
    const bool watched = wanted && !image_.entry().may_interrupt(false);
    if (watched && !state_.watched) {
      come_up();
      cycle_detector_.begin();
    }
    state_.watched = watched;
    // If the image counts how often its code runs (coverage), its state never repeats. In this case, checks
    // only whether an interrupt can still occur.
    if (wanted && image_.entry().counters) goes_round_ = !image_.entry().may_interrupt(true);
  }
  void has_called() { goes_round_ = false; }
  /// Returns the time of the firmware's last call, or `reached` while the firmware waits.
  [[gnu::always_inline]] SimTime last_call(SimTime reached) const {
    const bool waits = state_.waiting || (state_.polls && state_.polls_by_calls);
    return waits && !owner_.crash_ ? reached : owner_.clocked_.to_world(state_.last_call);
  }
  bool is_unwatched() const { return !state_.watched && !goes_round_; }  ///< not checked, and no loop found
  bool hangs() const {
    return state_.stopped_by || goes_round_ || (state_.endless && !image_.entry().may_interrupt(false));
  }

  /// Runs the firmware to `t`; returns false if it has crashed.
  bool run_until(SimTime t) {
    if (owner_.crash_) return false;
    state_.limit = owner_.clocked_.begin_tick(t);
    state_.next_input = owner_.clocked_.next_input();
    if (std::min(state_.wake, state_.next_input) >= state_.limit) return true;
    resume();
    return !owner_.crash_;
  }

  /// If the firmware only polls, its fiber may have been suspended for some time. In this case, runs the
  /// firmware up to the present time limit.
  void come_up() {
    if (!state_.polls || owner_.crash_) return;
    state_.called_up = true;
    resume();
    state_.called_up = false;
  }

  /// Returns whether the watchdog has reset the chip. If so, a new Instance must replace this Instance.
  bool bitten() const { return bitten_; }

  SourceLine place() const {
    std::vector<CodeAddress> addresses = {{state_.place, true}};
    calls_.add_stack(static_cast<const std::byte*>(suspended_at_), addresses);
    return image_.locate(addresses);
  }

  /// Returns the source line of the current call of the API. Must be called during this call.
  SourceLine source() {
    std::vector<CodeAddress> addresses = {{state_.place, true}};
    calls_.add_callers(addresses);
    std::vector<const void*> key;
    for (const CodeAddress& address : addresses) key.push_back(address.pc);
    const auto [known, fresh] = sources_.try_emplace(std::move(key));
    if (fresh) known->second = image_.locate(addresses);
    return known->second;
  }

  // Functions of host::Host, which the firmware calls on its fiber.
  void yield() override { suspend(); }
  void block_begins(const std::uint8_t* stack) override {
    // Checks again whether an interrupt can occur, since the answer may have changed since watch(). During
    // watch(), a handler may have been running, or the sketch may have disabled interrupts briefly.
    const bool alive = image_.entry().may_interrupt(false);
    goes_round_ = !alive && cycle_detector_.sees(state_.place, from(stack));
    if (goes_round_ || alive) state_.watched = false;
  }
  void take_state(const std::uint8_t* stack) override { snapshot_.take(state_, from(stack)); }
  bool has_state(const std::uint8_t* stack) override { return snapshot_.is_like(state_, from(stack)); }
  SimTime same_until(Pin pin, SimTime now) override { return owner_.clocked_.same_until(pin, now); }

  bool take_input(SimTime until, host::Input& input) override {
    BoardInput taken;
    const bool found = owner_.clocked_.take_input(until, taken);
    state_.next_input = owner_.clocked_.next_input();
    if (!found) return false;
    const bool edge = taken.kind == BoardInput::Kind::edge;
    input = {edge ? host::Input::Kind::edge : host::Input::Kind::byte, taken.pin, taken.value, taken.at};
    return true;
  }

  bool want_edges(Pin pin, bool wanted, SimTime now) override {
    const bool level = owner_.clocked_.set_wants_edges(pin, wanted, now);
    state_.next_input = owner_.clocked_.next_input();
    return level;
  }

  void listen(SimTime byte_time, SimTime now) override {
    owner_.clocked_.listen(byte_time, now);
    state_.next_input = owner_.clocked_.next_input();
  }

  void crash(const char* reason, const char* file, std::uint32_t line, const void* where) override {
    report({"", reason, file ? file : "", static_cast<int>(line)}, where);
  }

  void bite() override {
    bitten_ = true;
    suspend();
  }

  void undefined(const char* check, const void* data, std::uintptr_t value, std::uintptr_t other,
                 const void* where) override {
    report(explain_undefined(check, data, value, other), where);
  }

  void divides_by_zero(const void* data, const void* where) override {
    if (owner_.divisions_.count(where)) return;
    const Undefined found = data ? explain_undefined("divrem_overflow", data, 0, 0) : Undefined{};
    owner_.divisions_.add(where, place_of(found, where), owner_.clocked_.to_world(state_.now));
  }

  void lacks(const char* what, const void* where) override {
    if (owner_.unsupported_features_.has(what)) return;
    owner_.unsupported_features_.add(what, place_of({}, where), owner_.clocked_.to_world(state_.now));
  }

  void acted(const FirmwareAction& action) override {
    if (owner_.action_watcher_) owner_.action_watcher_->acted(action, owner_.clocked_.to_world(state_.now));
  }

  void globals(const host::GlobalRecord* records, std::size_t count) override {
    globals_.insert(globals_.end(), records, records + count);
  }

  void bad_access(const host::BadAccess& access, const void* where) override {
    const auto why = explain(access, globals_, {stack_.begin(), stack_.end()}, image_.entry().shadow);
    report({"bad_access", why, "", 0}, where);
  }

 private:
  void resume() {
    running_ = this;
    const ConstantCanary canary;
    if (sigsetjmp(escape_, 0) == 0) {
      fiber_.resume();
    } else {
      report_fault();
    }
    running_ = nullptr;
  }

  FirmwareSnapshot::Memory from(const std::uint8_t* stack) const {
    return {reinterpret_cast<const std::byte*>(stack), stack_.end()};
  }

  static void start(void* argument) {
    auto& self = *static_cast<Instance*>(argument);
    self.image_.entry().run(self.owner_.clocked_, self, self.state_.now);
  }

  std::vector<MemoryRange> checked_memory() const {
    const auto* const begin = static_cast<const std::byte*>(image_.entry().begin);
    const auto* const end = static_cast<const std::byte*>(image_.entry().end);
    return {{begin, end}, {heap_.begin(), heap_.end()}, {stack_.begin(), stack_.end()}};
  }

  /// Reports a fault that a check in the firmware has detected. Must be called on the fiber.
  void report(const Undefined& fault, const void* where) {
    owner_.crash_ = Crash{fault.reason, place_of(fault, where)};
    owner_.crash_->check = fault.check;
    suspend();
  }

  SourceLine place_of(const Undefined& fault, const void* where) {
    std::vector<CodeAddress> addresses = {{where, true}};
    calls_.add_callers(addresses);
    addresses.push_back({state_.place, true});
    SourceLine place = image_.locate(addresses);
    take_place(fault, place);
    return place;
  }

  void suspend() {
    suspended_at_ = __builtin_frame_address(0);
    fiber_.suspend();
  }

  static void on_fault(int signal, siginfo_t* info, void* context);

  void report_fault() {
    std::vector<CodeAddress> addresses = {{fault_.pc, fault_.signal == SIGSYS}};
    if (image_.has_code(fault_.link)) addresses.push_back({fault_.link, true});
    calls_.add_stack(std::max(fault_.stack_pointer, static_cast<const std::byte*>(stack_.begin())),
                     addresses);
    addresses.push_back({state_.place, true});
    owner_.crash_ = Crash{reason_of(fault_, heap_, stack_), image_.locate(addresses)};
    if (fault_.signal == SIGSYS && fault_.own_signal == 0) owner_.crash_->check = kSandboxCheck;
  }

  static thread_local Instance* running_;

  HostExecutor& owner_;
  LoadedImage image_;
  host::FirmwareState& state_;
  GuardedMemory heap_;
  GuardedMemory stack_;
  Fiber fiber_;
  ShadowMemory shadow_;
  std::vector<host::GlobalRecord> globals_;
  OpenCalls calls_{image_, stack_};
  StateCycleDetector cycle_detector_;
  FirmwareSnapshot snapshot_;
  bool goes_round_ = false, bitten_ = false;
  const void* suspended_at_ = nullptr;
  std::map<std::vector<const void*>, SourceLine> sources_;
  HostFault fault_;
  sigjmp_buf escape_;
};

thread_local HostExecutor::Instance* HostExecutor::Instance::running_ = nullptr;

void HostExecutor::Instance::catch_faults() {
  ensure_signal_stack();
  for (std::size_t i = 0; i < kFaults.size(); ++i) {
    struct sigaction present {};
    sigaction(kFaults[i], nullptr, &present);
    if ((present.sa_flags & SA_SIGINFO) && present.sa_sigaction == &Instance::on_fault) continue;
    previous_handlers[i] = present;
    struct sigaction ours {};
    ours.sa_sigaction = &Instance::on_fault;
    ours.sa_flags = SA_SIGINFO | SA_ONSTACK | SA_NODEFER;
    sigemptyset(&ours.sa_mask);
    sigaction(kFaults[i], &ours, nullptr);
  }
}

void HostExecutor::Instance::on_fault(int signal, siginfo_t* info, void* context) {
  const bool refused = signal == SIGSYS && is_confined();
  if (refused && serve_call(*info, *static_cast<ucontext_t*>(context))) return;
  if (Instance* const self = running_) {
    const HostFault fault = describe(signal, *info, *static_cast<ucontext_t*>(context));
    // A fault in Robosim's own code counts as a fault of the firmware if it occurs on the firmware's stack.
    // Bad arguments from the firmware cause such faults.
    const bool firmware = self->stack_.in_guard_before(fault.address) ||
                          self->stack_.contains(fault.stack_pointer) ||
                          !in_same_object(fault.pc, reinterpret_cast<const void*>(&Instance::on_fault));
    if (firmware) {
      self->fault_ = fault;
      siglongjmp(self->escape_, 1);
    }
  }
  if (refused) {
    if (const int sent = own_signal(*info, *static_cast<ucontext_t*>(context))) end_by_signal(sent);
    keyed_exit(kRefusedStatus);
  }
  // Firmware did not cause the fault. Restores the previous handler, which the kernel calls when the faulting
  // instruction runs again.
  for (std::size_t i = 0; i < kFaults.size(); ++i)
    if (kFaults[i] == signal) sigaction(signal, &previous_handlers[i], nullptr);
}

HostExecutor::HostExecutor(const BoardSpec& spec, std::filesystem::path image) : board_(spec) {
  const char* const wish = std::getenv("ROBOSIM_SKIP_WAITING");
  skips_waiting_ = !wish || std::string_view(wish) != "off";
  image_.name = std::move(image);
}

HostExecutor::~HostExecutor() = default;

void HostExecutor::power_on(SimTime t) {
  power_off(t);
  instance_ = std::make_unique<Instance>(*this, t);
}

void HostExecutor::prepare_for_confinement(AddressLines lines, std::shared_ptr<const ImageContent> image) {
  image_.content = image ? std::move(image) : std::make_shared<const ImageContent>(image_.name);
  image_.lines = std::move(lines);
  Instance::catch_faults();
}

void HostExecutor::power_off(SimTime t) {
  counters_ = counters();
  instance_.reset();
  crash_.reset();
  watchdog_resets_.end_row();
  board_.reset(t);
  reached_ = t;
}

void HostExecutor::run_until(SimTime t) {
  if (!instance_ || crash_) return;
  look_at_silence();
  while (instance_->run_until(t) && instance_->bitten()) restart();
  if (!crash_) reached_ = t;
  board_.forget_edges(t);
}

SimTime HostExecutor::sleeps_until() const {
  if (!instance_ || crash_ || reached_ < watch_until_ || !instance_->is_unwatched()) return 0;
  return std::min({clocked_.to_world(instance_->state().wake), board_.next_input(),
                   instance_->last_call(reached_) + HangProbeBackoff::kFirstLook});
}

void HostExecutor::restart() {
  const SimTime now = clocked_.to_world(instance_->state().now);
  if (watchdog_resets_.add(now)) {
    crash_ = Crash{WatchdogResets::reason(), instance_->place()};
    return;
  }
  const WatchdogResets watchdog_resets = watchdog_resets_;
  power_on(now);
  watchdog_resets_ = watchdog_resets;
}

void HostExecutor::look_at_silence() {
  const SimTime since = instance_->last_call(reached_);
  if (reached_ - since < HangProbeBackoff::kFirstLook && reached_ >= watch_until_ &&
      instance_->is_unwatched())
    return;
  if (!hang_probe_backoff_.lasts_since(since)) instance_->has_called();
  if (hang_probe_backoff_.is_time(since, reached_)) watch_until_ = reached_ + kWatch;
  instance_->watch(reached_ < watch_until_ && !instance_->hangs());
}

std::vector<ArchivedFile> HostExecutor::counters() {
  Counters all(counters_);
  if (instance_) instance_->count(all);
  return all.files();
}

SimTime HostExecutor::last_call() const { return instance_ ? instance_->last_call(reached_) : reached_; }
bool HostExecutor::hangs() { return instance_ && !crash_ && instance_->hangs(); }
SourceLine HostExecutor::source() { return instance_ ? instance_->source() : SourceLine{}; }
std::string HostExecutor::call_now() const { return instance_ ? text_of(instance_->state().call) : ""; }

Activity HostExecutor::activity() {
  if (instance_) instance_->come_up();
  Activity activity{.last_call = last_call()};
  if (!instance_) return activity;
  const host::FirmwareState& state = instance_->state();
  activity.call = text_of(state.call);
  activity.pin = state.call.pin;
  if (reached_ - clocked_.to_world(state.read_at) <= kSecond) activity.polled = state.reads.only_pin();
  activity.where = crash_ ? crash_->where : instance_->place();
  if (state.stopped_by) activity.stopped_by = state.stopped_by;
  return activity;
}

}  // namespace robosim::exec
