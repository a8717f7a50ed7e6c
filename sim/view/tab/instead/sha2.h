// SHA-256 (FIPS 180-4): the part of libmd's interface that Robosim uses.
#pragma once

#include <cstddef>
#include <cstdint>

constexpr std::size_t SHA256_DIGEST_STRING_LENGTH = 65;

struct SHA2_CTX {
  std::uint32_t state[8];
  std::uint64_t bytes;     ///< number of bytes so far
  std::uint8_t block[64];  ///< the last block, while it is incomplete
};

void SHA256Init(SHA2_CTX* context);
void SHA256Update(SHA2_CTX* context, const std::uint8_t* data, std::size_t size);
/// Returns the hash in lower-case hexadecimal, with a terminating zero.
char* SHA256End(SHA2_CTX* context, char* hex);
