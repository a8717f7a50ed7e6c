// Defines those registers and bits of the STM32F103x8 that hal/stm32 and the emulated chip use.
//
// Sources: RM0008 rev. 21, the reference manual of the STM32F10xxx (each group names its section), and
// PM0056 rev. 6, the programming manual of the Cortex-M3, for the processor.
//
// This header uses C++14 without the standard library, because firmware includes it.
#pragma once

#include <stdint.h>

#include "hal/board/stm32f103c8.h"

namespace robosim {
namespace stm32 {

using Address = uint32_t;

// --- memory (RM0008 3.3)
constexpr Address kFlash = kStm32f103c8.flash_address, kRam = kStm32f103c8.ram_address;
constexpr uint32_t kFlashBytes = kStm32f103c8.flash_bytes, kRamBytes = kStm32f103c8.ram_bytes;
constexpr uint32_t kPageBytes = 1024;  // a page of flash, the smallest unit of erasure (PM0075 1.2)
/// Number of pages at the end of flash that store the emulated EEPROM (eeprom.h), if a program uses it.
constexpr uint32_t kEepromPages = 4;
constexpr Address kEepromFlash = kFlash + kFlashBytes - kEepromPages * kPageBytes;

/// Returns the address of the word in the bit-band region that stands for one bit of a peripheral's register
/// (RM0008 3.3.2; PM0056 2.2.5).
constexpr Address bit_band(Address address, uint32_t bit) {
  return 0x42000000 + (address - 0x40000000) * 32 + bit * 4;
}

// --- RCC: reset and clock control (RM0008 7.3)
constexpr Address kRcc = 0x40021000;
constexpr Address kRccCr = kRcc + 0x00, kRccCfgr = kRcc + 0x04, kRccCir = kRcc + 0x08,
                  kRccApb2Rstr = kRcc + 0x0C, kRccApb1Rstr = kRcc + 0x10, kRccAhbEnr = kRcc + 0x14,
                  kRccApb2Enr = kRcc + 0x18, kRccApb1Enr = kRcc + 0x1C, kRccBdcr = kRcc + 0x20,
                  kRccCsr = kRcc + 0x24;
// 7.3.1
constexpr uint32_t kHsiOn = 1u << 0, kHsiReady = 1u << 1, kHseOn = 1u << 16, kHseReady = 1u << 17,
                   kPllOn = 1u << 24, kPllReady = 1u << 25;
// 7.3.2: SW selects a clock, and SWS, two bits higher, confirms the selection: 0 = HSI, 1 = HSE, 2 = PLL.
constexpr uint32_t kSwMask = 3u << 0, kSwPll = 2u << 0, kSwsMask = 3u << 2, kSwsPll = 2u << 2,
                   kPpre1Half = 4u << 8, kAdcPreMask = 3u << 14, kAdcPre6 = 2u << 14, kPllSrcHse = 1u << 16,
                   kPllXtpre = 1u << 17, kPllMul9 = 7u << 18, kPllMulMask = 15u << 18;
// 7.3.6 to 7.3.8
constexpr uint32_t kDma1En = 1u << 0, kCrcUnitEn = 1u << 6;
constexpr uint32_t kAfioEn = 1u << 0, kIopaEn = 1u << 2, kIopbEn = 1u << 3, kIopcEn = 1u << 4,
                   kAdc1En = 1u << 9, kTim1En = 1u << 11, kUsart1En = 1u << 14;
constexpr uint32_t kTim2En = 1u << 0, kTim3En = 1u << 1, kTim4En = 1u << 2;
/// Return whether a peripheral is on the bus APB2, and its bit in RCC_APBnENR and RCC_APBnRSTR (7.3.3, 7.3.4;
/// n is the number of the bus). The bit's number is the peripheral's offset on the bus, in units of 0x400
/// bytes.
constexpr bool behind_apb2(Address address) { return address >= 0x40010000; }
constexpr uint32_t clock_bit(Address address) { return 1u << ((address & 0xFFFF) / 0x400); }

// 7.3.10: causes of a reset
constexpr uint32_t kLsiOn = 1u << 0, kLsiReady = 1u << 1, kRemoveFlags = 1u << 24, kPinReset = 1u << 26,
                   kPowerOnReset = 1u << 27, kSoftwareReset = 1u << 28, kIwdgReset = 1u << 29,
                   kWwdgReset = 1u << 30;

// --- watchdogs (RM0008 19.4, 20.6)
constexpr Address kIwdg = 0x40003000, kWwdg = 0x40002C00;

// --- DMA1 (RM0008 13.4)
constexpr Address kDma1 = 0x40020000;

// --- flash interface (RM0008 3.3.3; PM0075 3)
constexpr Address kFlashIf = 0x40022000;
constexpr Address kFlashAcr = kFlashIf + 0x00, kFlashKeyr = kFlashIf + 0x04, kFlashSr = kFlashIf + 0x0C,
                  kFlashCr = kFlashIf + 0x10, kFlashAr = kFlashIf + 0x14;
constexpr uint32_t kLatencyMask = 7u << 0, kLatency2 = 2u << 0, kPrefetch = 1u << 4;
constexpr uint32_t kFlashKey1 = 0x45670123, kFlashKey2 = 0xCDEF89AB;
constexpr uint32_t kFlashBusy = 1u << 0, kFlashPgErr = 1u << 2, kFlashDone = 1u << 5;  // FLASH_SR
constexpr uint32_t kFlashPg = 1u << 0, kFlashPer = 1u << 1, kFlashStart = 1u << 6,
                   kFlashLock = 1u << 7;  // FLASH_CR

// --- GPIO (RM0008 9.2): ports A, B and C, 0x400 apart
constexpr Address kGpioA = kStm32f103c8.ports[0].address;
constexpr Address kPortBytes = 0x400;
constexpr Address kCrl = 0x00, kCrh = 0x04, kIdr = 0x08, kOdr = 0x0C, kBsrr = 0x10, kBrr = 0x14, kLckr = 0x18;
// 9.2.1: four bits per pin. MODE: 0 = input, 1 to 3 = output of 10, 2, 50 MHz.
constexpr uint32_t kAnalog = 0x0, kFloating = 0x4, kPulled = 0x8, kPushPull = 0x3, kAlternate = 0xB;

// --- AFIO: alternate functions and external interrupts (RM0008 9.4)
constexpr Address kAfio = 0x40010000;
constexpr Address kAfioEvcr = kAfio + 0x00, kAfioMapr = kAfio + 0x04,
                  kAfioExticr1 = kAfio + 0x08;  // the first of 4 registers; 4 bits per line
constexpr uint32_t kSwjMask = 7u << 24,
                   kSwjNoJtag = 2u << 24;  // 9.4.2: PA15, PB3 and PB4 become ordinary pins

// --- EXTI (RM0008 10.3): one bit per line
constexpr Address kExti = 0x40010400;
constexpr Address kExtiImr = kExti + 0x00, kExtiEmr = kExti + 0x04, kExtiRtsr = kExti + 0x08,
                  kExtiFtsr = kExti + 0x0C, kExtiSwier = kExti + 0x10, kExtiPr = kExti + 0x14;

// --- ADC1 (RM0008 11.12); ADC2 has the same registers at its own base address
constexpr Address kAdc1 = 0x40012400, kAdc2 = 0x40012800;
constexpr Address kAdcSr = kAdc1 + 0x00, kAdcCr1 = kAdc1 + 0x04, kAdcCr2 = kAdc1 + 0x08,
                  kAdcSmpr1 = kAdc1 + 0x0C, kAdcSmpr2 = kAdc1 + 0x10, kAdcSqr1 = kAdc1 + 0x2C,
                  kAdcSqr2 = kAdc1 + 0x30, kAdcSqr3 = kAdc1 + 0x34, kAdcDr = kAdc1 + 0x4C;
constexpr uint32_t kEoc = 1u << 1, kStrt = 1u << 4;  // ADC_SR
constexpr uint32_t kAdOn = 1u << 0, kCal = 1u << 2, kRstCal = 1u << 3, kAlign = 1u << 11,
                   kExtSelSw = 7u << 17, kExtTrig = 1u << 20, kSwStart = 1u << 22;  // ADC_CR2

// --- TIM1 (RM0008 14.4) and TIM2 to TIM4 (15.4)
constexpr Address timer_address(int8_t index) { return kStm32f103c8.timers[index].control; }
constexpr Address kTim1 = timer_address(stm32f103c8::kTim1), kTim2 = timer_address(stm32f103c8::kTim2),
                  kTim3 = timer_address(stm32f103c8::kTim3), kTim4 = timer_address(stm32f103c8::kTim4);
constexpr Address kTimCr1 = 0x00, kTimCr2 = 0x04, kTimSmcr = 0x08, kTimDier = 0x0C, kTimSr = 0x10,
                  kTimEgr = 0x14, kTimCcmr1 = 0x18, kTimCcmr2 = 0x1C, kTimCcer = 0x20, kTimCnt = 0x24,
                  kTimPsc = 0x28, kTimArr = 0x2C, kTimRcr = 0x30, kTimCcr1 = 0x34, kTimBdtr = 0x44;
constexpr uint32_t kCen = 1u << 0, kUrs = 1u << 2, kOpm = 1u << 3, kArpe = 1u << 7;  // TIM_CR1
constexpr uint32_t kUie = 1u << 0, kUif = 1u << 0, kUg = 1u << 0;
constexpr uint32_t kPwmMode1 = 6u << 4, kPreload = 1u << 3;  // TIM_CCMR; 8 bits higher for an even channel
constexpr uint32_t kMoe = 1u << 15;                          // TIM1_BDTR (14.4.18)

// --- USART1 (RM0008 27.6); USART2 and USART3 have the same registers
constexpr Address kUsart1 = kStm32f103c8.uarts[0].address;
constexpr Address kUsartSr = kUsart1 + 0x00, kUsartDr = kUsart1 + 0x04, kUsartBrr = kUsart1 + 0x08,
                  kUsartCr1 = kUsart1 + 0x0C, kUsartCr2 = kUsart1 + 0x10, kUsartCr3 = kUsart1 + 0x14,
                  kUsartGtpr = kUsart1 + 0x18;
constexpr uint32_t kOre = 1u << 3, kIdleLine = 1u << 4, kRxne = 1u << 5, kTc = 1u << 6,
                   kTxe = 1u << 7;  // USART_SR
constexpr uint32_t kRe = 1u << 2, kTe = 1u << 3, kIdleie = 1u << 4, kRxneie = 1u << 5, kTcie = 1u << 6,
                   kTxeie = 1u << 7, kPs = 1u << 9, kPce = 1u << 10, kM = 1u << 12,
                   kUe = 1u << 13;                    // USART_CR1
constexpr uint32_t kStop2 = 2u << 12;                 // USART_CR2
constexpr uint32_t kDmaR = 1u << 6, kDmaT = 1u << 7;  // USART_CR3

// --- SPI1, SPI2 (RM0008 25.5), I2C1, I2C2 (26.6)
constexpr Address kSpi1 = 0x40013000, kSpi2 = 0x40003800, kI2c1 = 0x40005400, kI2c2 = 0x40005800;

// --- RTC (RM0008 18.4), power control (5.4), backup registers (6.4), CRC (4.4)
constexpr Address kRtc = 0x40002800, kPwr = 0x40007000, kBkp = 0x40006C00, kCrc = 0x40023000;

// --- processor: SysTick (PM0056 4.5), NVIC (4.3), SCB (4.4)
constexpr Address kStkCtrl = 0xE000E010, kStkLoad = 0xE000E014, kStkVal = 0xE000E018, kStkCalib = 0xE000E01C;
constexpr uint32_t kStkEnable = 1u << 0, kTickInt = 1u << 1, kClkSource = 1u << 2, kCountFlag = 1u << 16;
constexpr Address kNvicIser = 0xE000E100, kNvicIcer = 0xE000E180, kNvicIspr = 0xE000E200,
                  kNvicIcpr = 0xE000E280, kNvicIabr = 0xE000E300, kNvicIpr = 0xE000E400,
                  kNvicStir = 0xE000EF00;
constexpr Address kScbCpuid = 0xE000ED00, kScbIcsr = 0xE000ED04, kScbVtor = 0xE000ED08,
                  kScbAircr = 0xE000ED0C, kScbScr = 0xE000ED10, kScbCcr = 0xE000ED14, kScbShpr1 = 0xE000ED18,
                  kScbShcsr = 0xE000ED24, kScbCfsr = 0xE000ED28, kScbHfsr = 0xE000ED2C,
                  kScbMmfar = 0xE000ED34, kScbBfar = 0xE000ED38;
constexpr uint32_t kPendStClr = 1u << 25, kPendStSet = 1u << 26, kPendSvClr = 1u << 27,
                   kPendSvSet = 1u << 28;                        // SCB_ICSR
constexpr uint32_t kDiv0Trap = 1u << 4, kUnalignTrap = 1u << 3;  // SCB_CCR
constexpr uint32_t kSleepOnExit = 1u << 1, kSleepDeep = 1u << 2,
                   kSevOnPend = 1u << 4;    // SCB_SCR
constexpr uint32_t kSysResetReq = 1u << 2;  // SCB_AIRCR

// --- numbers of interrupts (RM0008 10.1.2, table 63); SysTick is exception 15
enum Irq : uint8_t {
  kIrqWwdg = 0,
  kIrqPvd = 1,
  kIrqRtc = 3,
  kIrqExti0 = 6,
  kIrqExti1 = 7,
  kIrqExti2 = 8,
  kIrqExti3 = 9,
  kIrqExti4 = 10,
  kIrqDma1Channel1 = 11,
  kIrqAdc = 18,
  kIrqExti9_5 = 23,
  kIrqTim1Break = 24,
  kIrqTim1Update = 25,
  kIrqTim1Trigger = 26,
  kIrqTim1Capture = 27,
  kIrqTim2 = 28,
  kIrqTim3 = 29,
  kIrqTim4 = 30,
  kIrqI2c1Event = 31,
  kIrqI2c1Error = 32,
  kIrqI2c2Event = 33,
  kIrqI2c2Error = 34,
  kIrqSpi1 = 35,
  kIrqSpi2 = 36,
  kIrqUsart1 = 37,
  kIrqExti15_10 = 40,
  kIrqRtcAlarm = 41,
  kIrqUsbWakeup = 42,
  kIrqCount = 43
};

}  // namespace stm32
}  // namespace robosim
