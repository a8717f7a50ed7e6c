// Implements Bus::name_at(), which names the peripherals on the bus (RM0008 3.3, table 3; PM0056 4.1).
#include "sim/exec/stm32/bus.h"

namespace robosim::exec::stm32 {
namespace {

struct Range {
  Address begin, end;
  const char* name;
};
constexpr Range kRanges[] = {
    {0x40000000, 0x40000400, "TIM2"},   {0x40000400, 0x40000800, "TIM3"},
    {0x40000800, 0x40000C00, "TIM4"},   {0x40002800, 0x40002C00, "RTC"},
    {0x40002C00, 0x40003000, "WWDG"},   {0x40003000, 0x40003400, "IWDG"},
    {0x40003800, 0x40003C00, "SPI2"},   {0x40004400, 0x40004800, "USART2"},
    {0x40004800, 0x40004C00, "USART3"}, {0x40005400, 0x40005800, "I2C1"},
    {0x40005800, 0x40005C00, "I2C2"},   {0x40005C00, 0x40006000, "USB"},
    {0x40006000, 0x40006400, "USB"},    {0x40006400, 0x40006800, "CAN1"},
    {0x40006C00, 0x40007000, "BKP"},    {0x40007000, 0x40007400, "PWR"},
    {0x40010000, 0x40010400, "AFIO"},   {0x40010400, 0x40010800, "EXTI"},
    {0x40010800, 0x40010C00, "GPIOA"},  {0x40010C00, 0x40011000, "GPIOB"},
    {0x40011000, 0x40011400, "GPIOC"},  {0x40011400, 0x40011800, "GPIOD"},
    {0x40011800, 0x40011C00, "GPIOE"},  {0x40012400, 0x40012800, "ADC1"},
    {0x40012800, 0x40012C00, "ADC2"},   {0x40012C00, 0x40013000, "TIM1"},
    {0x40013000, 0x40013400, "SPI1"},   {0x40013800, 0x40013C00, "USART1"},
    {0x40020000, 0x40020400, "DMA1"},   {0x40021000, 0x40021400, "RCC"},
    {0x40022000, 0x40022400, "FLASH"},  {0x40023000, 0x40023400, "CRC"},
    {0xE0000000, 0xE0001000, "ITM"},    {0xE0001000, 0xE0002000, "DWT"},
    {0xE0002000, 0xE0003000, "FPB"},    {0xE000E010, 0xE000E020, "SysTick"},
    {0xE000E100, 0xE000ED00, "NVIC"},   {0xE000ED00, 0xE000ED90, "SCB"},
    {0xE000EDF0, 0xE000EF00, "debug"},  {0xE0042000, 0xE0042400, "DBGMCU"},
};

}  // namespace

const char* Bus::name_at(Address address) {
  for (const Range& range : kRanges)
    if (address >= range.begin && address < range.end) return range.name;
  return "";
}

}  // namespace robosim::exec::stm32
