#include "png.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <ostream>
#include <string>

namespace demo {

namespace {

using Byte = unsigned char;
using Bytes = std::vector<Byte>;

/// Bits in deflate's order (RFC 1951): numbers begin with their lowest bit, Huffman codes with their highest.
class BitWriter {
public:
    void number(unsigned value, int count) {
        for (int n = 0; n < count; ++n) bit(value >> n & 1);
    }
    void code(unsigned value, int count) {
        for (int n = count - 1; n >= 0; --n) bit(value >> n & 1);
    }
    Bytes finished() {
        while (filled != 0) bit(0);
        return bytes;
    }

private:
    void bit(unsigned value) {
        pending = static_cast<Byte>(pending | value << filled);
        if (++filled < 8) return;
        bytes.push_back(pending);
        pending = 0;
        filled = 0;
    }

    Bytes bytes;
    Byte pending = 0;
    int filled = 0;
};

/// A symbol of the literal and length alphabet, in deflate's fixed code.
void writeSymbol(BitWriter &out, unsigned symbol) {
    if (symbol < 144)
        out.code(0x30 + symbol, 8);
    else if (symbol < 256)
        out.code(0x190 + symbol - 144, 9);
    else if (symbol < 280)
        out.code(symbol - 256, 7);
    else
        out.code(0xC0 + symbol - 280, 8);
}

void writeLength(BitWriter &out, unsigned length) {
    if (length == 258) return writeSymbol(out, 285);
    unsigned symbol = 257, base = 3, extra = 0;
    while (true) {
        extra = symbol < 265 ? 0 : (symbol - 261) / 4;
        if (length < base + (1u << extra)) break;
        base += 1u << extra;
        ++symbol;
    }
    writeSymbol(out, symbol);
    out.number(length - base, static_cast<int>(extra));
}

void writeDistance(BitWriter &out, unsigned distance) {
    unsigned symbol = 0, base = 1, extra = 0;
    while (true) {
        extra = symbol < 4 ? 0 : symbol / 2 - 1;
        if (distance < base + (1u << extra)) break;
        base += 1u << extra;
        ++symbol;
    }
    out.code(symbol, 5);
    out.number(distance - base, static_cast<int>(extra));
}

std::uint32_t adler32(const Bytes &bytes) {
    std::uint32_t a = 1, b = 0;
    for (const Byte byte : bytes) {
        a = (a + byte) % 65521;
        b = (b + a) % 65521;
    }
    return b << 16 | a;
}

void appendBigEndian(Bytes &bytes, std::uint32_t value) {
    for (int shift = 24; shift >= 0; shift -= 8) bytes.push_back(static_cast<Byte>(value >> shift));
}

/// A zlib stream (RFC 1950): one block in the fixed code, with the latest match of every three bytes.
Bytes compressed(const Bytes &data) {
    constexpr std::size_t WINDOW = 32768, LONGEST = 258, SHORTEST = 3, NONE = static_cast<std::size_t>(-1);
    std::vector<std::size_t> latest(1 << 15, NONE);
    const auto slot = [&](std::size_t at) -> std::size_t & {
        const unsigned key =
            data[at] | static_cast<unsigned>(data[at + 1]) << 8 | static_cast<unsigned>(data[at + 2]) << 16;
        return latest[(key * 2654435761u) >> 17];
    };
    BitWriter out;
    out.number(1, 1);  // the last block
    out.number(1, 2);  // fixed code
    for (std::size_t at = 0; at < data.size();) {
        std::size_t length = 0, from = 0;
        if (at + SHORTEST <= data.size()) {
            from = slot(at);
            if (from != NONE && at - from <= WINDOW)
                while (length < LONGEST && at + length < data.size() &&
                       data[from + length] == data[at + length])
                    ++length;
        }
        const std::size_t taken = length >= SHORTEST ? length : 1;
        if (length >= SHORTEST) {
            writeLength(out, static_cast<unsigned>(length));
            writeDistance(out, static_cast<unsigned>(at - from));
        } else {
            writeSymbol(out, data[at]);
        }
        for (std::size_t n = at; n < at + taken && n + SHORTEST <= data.size(); ++n) slot(n) = n;
        at += taken;
    }
    writeSymbol(out, 256);
    Bytes bytes = {0x78, 0x9C};
    const Bytes block = out.finished();
    bytes.insert(bytes.end(), block.begin(), block.end());
    appendBigEndian(bytes, adler32(data));
    return bytes;
}

std::uint32_t crc32(const Bytes &bytes) {
    std::uint32_t crc = ~0u;
    for (const Byte byte : bytes) {
        crc ^= byte;
        for (int n = 0; n < 8; ++n) crc = crc >> 1 ^ (crc & 1 ? 0xEDB88320u : 0);
    }
    return ~crc;
}

void writeChunk(std::ostream &out, const char *type, const Bytes &content) {
    Bytes bytes;
    appendBigEndian(bytes, static_cast<std::uint32_t>(content.size()));
    Bytes body(type, type + 4);
    body.insert(body.end(), content.begin(), content.end());
    bytes.insert(bytes.end(), body.begin(), body.end());
    appendBigEndian(bytes, crc32(body));
    out.write(reinterpret_cast<const char *>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
}

/// Each row as its differences to the row above (filter 2), which a sky's gradient makes mostly zeros.
Bytes filtered(const Image &image) {
    Bytes data;
    const auto width = static_cast<std::size_t>(image.width);
    for (std::size_t row = 0; row < static_cast<std::size_t>(image.height); ++row) {
        data.push_back(2);
        for (std::size_t column = 0; column < width; ++column) {
            const Colour here = image.pixels[row * width + column];
            const Colour above = row == 0 ? Colour() : image.pixels[(row - 1) * width + column];
            data.push_back(static_cast<Byte>(here.red - above.red));
            data.push_back(static_cast<Byte>(here.green - above.green));
            data.push_back(static_cast<Byte>(here.blue - above.blue));
        }
    }
    return data;
}

}  // namespace

void writePng(std::ostream &out, const Image &image) {
    out.write("\x89PNG\r\n\x1a\n", 8);
    Bytes header;
    appendBigEndian(header, static_cast<std::uint32_t>(image.width));
    appendBigEndian(header, static_cast<std::uint32_t>(image.height));
    const Bytes format = {8, 2, 0, 0, 0};  // 8 bits, RGB, and the only methods there are
    header.insert(header.end(), format.begin(), format.end());
    writeChunk(out, "IHDR", header);
    writeChunk(out, "IDAT", compressed(filtered(image)));
    writeChunk(out, "IEND", {});
}

}  // namespace demo
