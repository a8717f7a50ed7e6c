// Registers of an AVR (data sheet DS40002061B, chapter 36), for the target host and the emulated chip.
//
//   reg    addresses in data memory that are the same in every ATmega that Robosim supports; a ChipSpec
//          (chip_spec.h) stores the addresses that differ between chips
//   bits   masks of bits, by avr-libc's names without the number of the module: kTxc is _BV(TXC0)
#pragma once

#include <stdint.h>

namespace robosim {
namespace avr {
namespace reg {

using Address = uint16_t;

constexpr Address kTifr0 = 0x35, kTifr2 = 0x37, kPcifr = 0x3B, kEifr = 0x3C, kEimsk = 0x3D;
constexpr Address kEecr = 0x3F, kEedr = 0x40, kEearL = 0x41, kEearH = 0x42;
constexpr Address kGtccr = 0x43;
constexpr Address kSmcr = 0x53, kMcusr = 0x54, kMcucr = 0x55, kSpmcsr = 0x57;
constexpr Address kSpL = 0x5D, kSpH = 0x5E, kSreg = 0x5F;
constexpr Address kWdtcsr = 0x60, kClkpr = 0x61, kPrr = 0x64, kPcicr = 0x68, kEicra = 0x69;
constexpr Address kPcmsk0 = 0x6B, kPcmsk1 = 0x6C, kPcmsk2 = 0x6D;
constexpr Address kAdcL = 0x78, kAdcH = 0x79, kAdcsra = 0x7A, kAdcsrb = 0x7B, kAdmux = 0x7C, kDidr2 = 0x7D,
                  kDidr0 = 0x7E, kDidr1 = 0x7F;

constexpr Address kFirstIo = 0x20;  ///< lower addresses are the 32 registers of the processor

}  // namespace reg

inline namespace bits {

constexpr uint8_t kI = 0x80;                                                                         // SREG
constexpr uint8_t kSe = 0x01, kSm = 0x0E;                                                            // SMCR
constexpr uint8_t kWdrf = 0x08, kBorf = 0x04, kExtrf = 0x02, kPorf = 0x01;                           // MCUSR
constexpr uint8_t kPud = 0x10;                                                                       // MCUCR
constexpr uint8_t kClkpce = 0x80;                                                                    // CLKPR
constexpr uint8_t kWdif = 0x80, kWdie = 0x40, kWdp3 = 0x20, kWdce = 0x10, kWde = 0x08, kWdp = 0x27;  // WDTCSR
constexpr uint8_t kEepm = 0x30, kEerie = 0x08, kEempe = 0x04, kEepe = 0x02, kEere = 0x01;            // EECR

constexpr uint8_t kComa1 = 0x80, kComa0 = 0x40, kComb1 = 0x20, kComb0 = 0x10, kWgm1 = 0x02,
                  kWgm0 = 0x01;                                                       // TCCRnA
constexpr uint8_t kWgm3 = 0x10, kWgm2 = 0x08, kCs2 = 0x04, kCs1 = 0x02, kCs0 = 0x01;  // TCCRnB
constexpr uint8_t kFoca = 0x80, kFocb = 0x40;              // TCCRnB, or TCCRnC of a 16-bit timer
constexpr uint8_t kIcnc = 0x80, kIces = 0x40, kCs = 0x07;  // TCCRnB
constexpr uint8_t kTov = 0x01, kOcfa = 0x02, kOcfb = 0x04, kOcfc = 0x08,
                  kIcf = 0x20;                                   // TIFRn; as enable bits TIMSKn
constexpr uint8_t kTsm = 0x80, kPsrasy = 0x02, kPsrsync = 0x01;  // GTCCR

constexpr uint8_t kRxc = 0x80, kTxc = 0x40, kUdre = 0x20, kDor = 0x08, kU2x = 0x02, kMpcm = 0x01;  // UCSRnA
constexpr uint8_t kRxcie = 0x80, kTxcie = 0x40, kUdrie = 0x20, kRxen = 0x10, kTxen = 0x08, kUcsz2 = 0x04,
                  kRxb8 = 0x02, kTxb8 = 0x01;                                               // UCSRnB
constexpr uint8_t kUmsel = 0xC0, kUmsel0 = 0x40, kUpm1 = 0x20, kUsbs = 0x08, kUcsz = 0x06;  // UCSRnC

constexpr uint8_t kSpie = 0x80, kSpe = 0x40, kMstr = 0x10, kCpol = 0x08, kSpr = 0x03;  // SPCR
constexpr uint8_t kSpif = 0x80, kWcol = 0x40, kSpi2x = 0x01;                           // SPSR

constexpr uint8_t kTwint = 0x80, kTwea = 0x40, kTwsta = 0x20, kTwsto = 0x10, kTwwc = 0x08, kTwen = 0x04,
                  kTwie = 0x01;  // TWCR
constexpr uint8_t kTwps = 0x03;  // TWSR

constexpr uint8_t kAcd = 0x80, kAcbg = 0x40, kAco = 0x20, kAci = 0x10, kAcie = 0x08, kAcic = 0x04,
                  kAcis = 0x03;                                                           // ACSR
constexpr uint8_t kAden = 0x80, kAdsc = 0x40, kAdate = 0x20, kAdif = 0x10, kAdie = 0x08;  // ADCSRA
constexpr uint8_t kAcme = 0x40, kAdts = 0x07;                                             // ADCSRB
constexpr uint8_t kRefs = 0xC0, kAdlar = 0x20;                                            // ADMUX

}  // namespace bits
}  // namespace avr
}  // namespace robosim
