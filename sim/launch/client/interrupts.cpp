#include "sim/launch/client/interrupts.h"

#include <algorithm>

namespace robosim::client {
namespace {

Runner* volatile the_runner = nullptr;
Pool* volatile the_pool = nullptr;
volatile sig_atomic_t the_count = 0;
volatile sig_atomic_t the_signal = 0;

extern "C" void on_interrupt(int number) {
  Runner* runner = the_runner;
  the_count = the_count + 1;
  if (the_count == 1) the_signal = number;
  if (Pool* pool = the_pool) {
    pool->interrupt();
  } else if (the_count == 1) {
    runner->interrupt();
  } else {
    runner->kill();
  }
}

}  // namespace

Interrupts::Interrupts(Runner& runner) {
  the_runner = &runner;
  the_pool = nullptr;
  catch_signals();
}

Interrupts::Interrupts(Pool& pool) {
  the_pool = &pool;
  catch_signals();
}

void Interrupts::catch_signals() {
  the_count = 0;
  the_signal = 0;
  struct sigaction action {};
  action.sa_handler = on_interrupt;
  ::sigemptyset(&action.sa_mask);
  for (const int number : kSignals) ::sigaddset(&action.sa_mask, number);
  for (std::size_t i = 0; i < kSignals.size(); ++i) ::sigaction(kSignals[i], &action, &before_[i]);
}

Interrupts::~Interrupts() {
  for (std::size_t i = 0; i < kSignals.size(); ++i) ::sigaction(kSignals[i], &before_[i], nullptr);
}

bool make_runs(const Batch& batch, std::size_t jobs) {
  Pool pool(std::clamp<std::size_t>(jobs, 1, std::max<std::size_t>(1, batch.count)));
  const Interrupts interrupts(pool);
  return pool.run(batch);
}

int Interrupts::count() { return the_count; }
int Interrupts::signal() { return the_signal; }

}  // namespace robosim::client
