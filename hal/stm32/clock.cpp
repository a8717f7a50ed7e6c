#include "hal/stm32/clock.h"

volatile uint32_t robosim_millis;

namespace robosim {
namespace stm32 {

void start_clocks() {
#if F_CPU == 72000000L
  // Above 48 MHz, flash needs two wait states (RM0008 3.3.3). APB1 runs at 36 MHz at most (7.2).
  at(kFlashAcr) = kLatency2 | kPrefetch;
  at(kRccCr) |= kHseOn;
  at(kRccCr).await(kHseReady, kHseReady);
  at(kRccCfgr) = kPllMul9 | kPllSrcHse | kPpre1Half | kAdcPre6;
  at(kRccCr) |= kPllOn;
  at(kRccCr).await(kPllReady, kPllReady);
  at(kRccCfgr) |= kSwPll;
  at(kRccCfgr).await(kSwsMask, kSwsPll);
#elif F_CPU != 8000000L
#error "F_CPU: this core knows 72 MHz and 8 MHz"
#endif
}

void start_systick() {
  at(kStkLoad) = F_CPU / 1000u - 1;
  at(kStkVal) = 0;
  at(kStkCtrl) = kStkEnable | kTickInt | kClkSource;
}

void sleep_for(uint32_t us) {
  at(kRccApb1Enr) |= kTim2En;
  // Prepares one pulse of `us` microseconds (RM0008 15.3.10). UG loads the prescaler, and URS prevents the
  // interrupt that UG would cause.
  at(kTim2 + kTimCr1) = kUrs | kOpm;
  at(kTim2 + kTimPsc) = kCyclesPerMicro - 1;
  at(kTim2 + kTimArr) = us;
  at(kTim2 + kTimEgr) = kUg;
  at(kTim2 + kTimSr) = 0;
  at(kTim2 + kTimDier) = kUie;
  enable_irq(kIrqTim2);
  {
    // With interrupts off, the timer's interrupt ends the sleep even if it occurs before the sleep begins.
    const Quiet quiet;
    at(kTim2 + kTimCr1) = kUrs | kOpm | kCen;
    wait_for_interrupt();
  }
  at(kTim2 + kTimDier) = 0;
}

}  // namespace stm32
}  // namespace robosim

extern "C" {

void SysTick_Handler() { robosim_millis = robosim_millis + 1; }

void TIM2_IRQHandler() {
  using namespace robosim::stm32;
  at(kTim2 + kTimSr) = 0;
}

}  // extern "C"
