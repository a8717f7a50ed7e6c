// Controls the clocks of the chip, SysTick's interrupt at each millisecond, and the timer that ends a sleep.
#pragma once

#include "hal/stm32/registers.h"

namespace robosim {
namespace stm32 {

/// Sets the chip's clock to F_CPU: 72 MHz by PLL from the 8 MHz crystal (RM0008 7.2), or 8 MHz from the
/// internal oscillator, as after a reset. All buses run at F_CPU. Exception: at 72 MHz, APB1 runs at half
/// of F_CPU, but its timers run at F_CPU.
void start_clocks();
/// Starts SysTick, which interrupts every millisecond (PM0056 4.5).
void start_systick();
/// Sleeps until the next interrupt, but at most for `us` microseconds (1 to 1000).
void sleep_for(uint32_t us);

/// The number of CPU cycles per microsecond.
constexpr uint32_t kCyclesPerMicro = F_CPU / 1000000u;

}  // namespace stm32
}  // namespace robosim

extern "C" volatile uint32_t robosim_millis;  ///< the result of millis()
