#include "picture/png.h"

#include "picture/deflate.h"

#include <cstdint>
#include <cstdlib>
#include <ostream>

namespace demo {

namespace {

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

int guess(int left, int above, int between) {
    const int sum = left + above - between;
    const int toLeft = std::abs(sum - left), toAbove = std::abs(sum - above),
              toBetween = std::abs(sum - between);
    if (toLeft <= toAbove && toLeft <= toBetween) return left;
    return toAbove <= toBetween ? above : between;
}

/// Each sample as its difference to a guess of it: the nearest of left, above and left + above − the one
/// between (Paeth's filter, 4), which makes most of a smooth picture zeros and ones.
Bytes filtered(const Image &image) {
    Bytes data;
    const int width = image.width;
    const auto at = [&](int column, int row) {
        return column < 0 || row < 0
                   ? Colour()
                   : image.pixels[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                                  static_cast<std::size_t>(column)];
    };
    for (int row = 0; row < image.height; ++row) {
        data.push_back(4);
        for (int column = 0; column < width; ++column) {
            const Colour here = at(column, row), left = at(column - 1, row), above = at(column, row - 1),
                         between = at(column - 1, row - 1);
            for (const auto channel : {&Colour::red, &Colour::green, &Colour::blue})
                data.push_back(static_cast<Byte>(here.*channel -
                                                 guess(left.*channel, above.*channel, between.*channel)));
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
