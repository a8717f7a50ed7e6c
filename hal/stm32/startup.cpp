// The start-up code that runs before setup(): vector table (RM0008 10.1.2, table 63), memory, clocks,
// constructors.
#include <Arduino.h>

#include "hal/stm32/clock.h"

extern "C" {

extern uint32_t _sidata[], _sdata[], _edata[], _sbss[], _ebss[], _estack[];
extern void (*__init_array_start[])();
extern void (*__init_array_end[])();

int main();

/// Handles interrupts for which the sketch and the core define no handler: loops forever.
void Default_Handler() {
  for (;;) {
  }
}

void Reset_Handler() {
  for (uint32_t *from = _sidata, *to = _sdata; to < _edata;) *to++ = *from++;
  for (uint32_t* to = _sbss; to < _ebss;) *to++ = 0;
  robosim::stm32::start_clocks();
  for (auto constructor = __init_array_start; constructor < __init_array_end; ++constructor) (*constructor)();
  main();
  Default_Handler();
}

#define ROBOSIM_VECTOR(name) void name() __attribute__((weak, alias("Default_Handler")))
ROBOSIM_VECTOR(NMI_Handler);
ROBOSIM_VECTOR(HardFault_Handler);
ROBOSIM_VECTOR(MemManage_Handler);
ROBOSIM_VECTOR(BusFault_Handler);
ROBOSIM_VECTOR(UsageFault_Handler);
ROBOSIM_VECTOR(SVC_Handler);
ROBOSIM_VECTOR(DebugMon_Handler);
ROBOSIM_VECTOR(PendSV_Handler);
ROBOSIM_VECTOR(SysTick_Handler);
ROBOSIM_VECTOR(WWDG_IRQHandler);
ROBOSIM_VECTOR(PVD_IRQHandler);
ROBOSIM_VECTOR(TAMPER_IRQHandler);
ROBOSIM_VECTOR(RTC_IRQHandler);
ROBOSIM_VECTOR(FLASH_IRQHandler);
ROBOSIM_VECTOR(RCC_IRQHandler);
ROBOSIM_VECTOR(EXTI0_IRQHandler);
ROBOSIM_VECTOR(EXTI1_IRQHandler);
ROBOSIM_VECTOR(EXTI2_IRQHandler);
ROBOSIM_VECTOR(EXTI3_IRQHandler);
ROBOSIM_VECTOR(EXTI4_IRQHandler);
ROBOSIM_VECTOR(DMA1_Channel1_IRQHandler);
ROBOSIM_VECTOR(DMA1_Channel2_IRQHandler);
ROBOSIM_VECTOR(DMA1_Channel3_IRQHandler);
ROBOSIM_VECTOR(DMA1_Channel4_IRQHandler);
ROBOSIM_VECTOR(DMA1_Channel5_IRQHandler);
ROBOSIM_VECTOR(DMA1_Channel6_IRQHandler);
ROBOSIM_VECTOR(DMA1_Channel7_IRQHandler);
ROBOSIM_VECTOR(ADC1_2_IRQHandler);
ROBOSIM_VECTOR(USB_HP_CAN1_TX_IRQHandler);
ROBOSIM_VECTOR(USB_LP_CAN1_RX0_IRQHandler);
ROBOSIM_VECTOR(CAN1_RX1_IRQHandler);
ROBOSIM_VECTOR(CAN1_SCE_IRQHandler);
ROBOSIM_VECTOR(EXTI9_5_IRQHandler);
ROBOSIM_VECTOR(TIM1_BRK_IRQHandler);
ROBOSIM_VECTOR(TIM1_UP_IRQHandler);
ROBOSIM_VECTOR(TIM1_TRG_COM_IRQHandler);
ROBOSIM_VECTOR(TIM1_CC_IRQHandler);
ROBOSIM_VECTOR(TIM2_IRQHandler);
ROBOSIM_VECTOR(TIM3_IRQHandler);
ROBOSIM_VECTOR(TIM4_IRQHandler);
ROBOSIM_VECTOR(I2C1_EV_IRQHandler);
ROBOSIM_VECTOR(I2C1_ER_IRQHandler);
ROBOSIM_VECTOR(I2C2_EV_IRQHandler);
ROBOSIM_VECTOR(I2C2_ER_IRQHandler);
ROBOSIM_VECTOR(SPI1_IRQHandler);
ROBOSIM_VECTOR(SPI2_IRQHandler);
ROBOSIM_VECTOR(USART1_IRQHandler);
ROBOSIM_VECTOR(USART2_IRQHandler);
ROBOSIM_VECTOR(USART3_IRQHandler);
ROBOSIM_VECTOR(EXTI15_10_IRQHandler);
ROBOSIM_VECTOR(RTCAlarm_IRQHandler);
ROBOSIM_VECTOR(USBWakeUp_IRQHandler);
#undef ROBOSIM_VECTOR

}  // extern "C"

using Vector = void (*)();

__attribute__((section(".isr_vector"), used)) const Vector robosim_vectors[16 + robosim::stm32::kIrqCount] = {
    reinterpret_cast<Vector>(_estack),
    Reset_Handler,
    NMI_Handler,
    HardFault_Handler,
    MemManage_Handler,
    BusFault_Handler,
    UsageFault_Handler,
    nullptr,
    nullptr,
    nullptr,
    nullptr,
    SVC_Handler,
    DebugMon_Handler,
    nullptr,
    PendSV_Handler,
    SysTick_Handler,
    WWDG_IRQHandler,
    PVD_IRQHandler,
    TAMPER_IRQHandler,
    RTC_IRQHandler,
    FLASH_IRQHandler,
    RCC_IRQHandler,
    EXTI0_IRQHandler,
    EXTI1_IRQHandler,
    EXTI2_IRQHandler,
    EXTI3_IRQHandler,
    EXTI4_IRQHandler,
    DMA1_Channel1_IRQHandler,
    DMA1_Channel2_IRQHandler,
    DMA1_Channel3_IRQHandler,
    DMA1_Channel4_IRQHandler,
    DMA1_Channel5_IRQHandler,
    DMA1_Channel6_IRQHandler,
    DMA1_Channel7_IRQHandler,
    ADC1_2_IRQHandler,
    USB_HP_CAN1_TX_IRQHandler,
    USB_LP_CAN1_RX0_IRQHandler,
    CAN1_RX1_IRQHandler,
    CAN1_SCE_IRQHandler,
    EXTI9_5_IRQHandler,
    TIM1_BRK_IRQHandler,
    TIM1_UP_IRQHandler,
    TIM1_TRG_COM_IRQHandler,
    TIM1_CC_IRQHandler,
    TIM2_IRQHandler,
    TIM3_IRQHandler,
    TIM4_IRQHandler,
    I2C1_EV_IRQHandler,
    I2C1_ER_IRQHandler,
    I2C2_EV_IRQHandler,
    I2C2_ER_IRQHandler,
    SPI1_IRQHandler,
    SPI2_IRQHandler,
    USART1_IRQHandler,
    USART2_IRQHandler,
    USART3_IRQHandler,
    EXTI15_10_IRQHandler,
    RTCAlarm_IRQHandler,
    USBWakeUp_IRQHandler,
};

// As on an AVR, a sketch may define its own main(), which must call init().
__attribute__((weak)) int main() {
  init();
  setup();
  for (;;) {
    loop();
    if (serialEventRun) serialEventRun();
  }
}
