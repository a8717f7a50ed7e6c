// SHA-256 (FIPS 180-4), as much of libmd's interface as Robosim uses.
#pragma once

#include <cstddef>
#include <cstdint>

constexpr std::size_t SHA256_DIGEST_STRING_LENGTH = 65;

struct SHA2_CTX {
  std::uint32_t state[8];
  std::uint64_t bytes;     ///< so far
  std::uint8_t block[64];  ///< the last of them, until it is full
};

void SHA256Init(SHA2_CTX* context);
void SHA256Update(SHA2_CTX* context, const std::uint8_t* data, std::size_t size);
/// Lower-case hexadecimal, with a zero at the end.
char* SHA256End(SHA2_CTX* context, char* hex);
