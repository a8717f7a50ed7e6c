// Models firmware's access to its own flash: SPMCSR (data sheet DS40002061B, 27.8.10 and 27.9.1).
//
//   SIGRD and SPMEN written together   LPM within three cycles reads the signature row: the signature at 0, 2
//                                      and 4 (28.3). The rest of the row reads as erased
//
// The bits of SPMCSR clear themselves four cycles after they were written. The owner of the Chip handles the
// instruction SPM (Cpu::Stop::spm). Not modelled: fuses and lock bits (BLBSET).
#pragma once

#include <cstdint>

#include "sim/mcu/avr/core.h"

namespace robosim::avr {

class SelfProgramming final : public Peripheral {
 public:
  explicit SelfProgramming(Core& core);

  void reset(Cycle at) override;

 private:
  void write(Address address, std::uint8_t value);
  void window_ends(Cycle at);

  Core& core_;
  Events::Id window_ends_ = 0;
};

}  // namespace robosim::avr
