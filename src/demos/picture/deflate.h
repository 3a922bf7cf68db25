#pragma once

/// Compression as PNG wants it.
#include <cstdint>
#include <vector>

namespace demo {

using Byte = unsigned char;
using Bytes = std::vector<Byte>;

/// A zlib stream (RFC 1950) of the data.
Bytes compressed(const Bytes &data);

/// Appends the highest byte first.
void appendBigEndian(Bytes &bytes, std::uint32_t value);

}  // namespace demo
