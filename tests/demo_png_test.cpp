#include "png.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <sstream>

using namespace demo;

namespace {

using Bytes = std::vector<unsigned char>;

std::uint32_t bigEndian(const Bytes &bytes, std::size_t at) {
    return std::uint32_t(bytes[at]) << 24 | std::uint32_t(bytes[at + 1]) << 16 |
           std::uint32_t(bytes[at + 2]) << 8 | bytes[at + 3];
}

/// Undoes deflate's fixed code, after RFC 1951, by tables that are written out.
Bytes inflated(const Bytes &stream) {
    static const unsigned lengthBase[] = {3,  4,  5,  6,  7,  8,  9,  10, 11,  13,  15,  17,  19,  23, 27,
                                          31, 35, 43, 51, 59, 67, 83, 99, 115, 131, 163, 195, 227, 258};
    static const unsigned lengthBits[] = {0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2,
                                          2, 3, 3, 3, 3, 4, 4, 4, 4, 5, 5, 5, 5, 0};
    static const unsigned distanceBase[] = {1,    2,    3,    4,    5,    7,    9,    13,    17,    25,
                                            33,   49,   65,   97,   129,  193,  257,  385,   513,   769,
                                            1025, 1537, 2049, 3073, 4097, 6145, 8193, 12289, 16385, 24577};
    static const unsigned distanceBits[] = {0, 0, 0, 0, 1, 1, 2, 2,  3,  3,  4,  4,  5,  5,  6,
                                            6, 7, 7, 8, 8, 9, 9, 10, 10, 11, 11, 12, 12, 13, 13};
    std::size_t at = 16;  // bits; behind zlib's two bytes
    const auto bit = [&]() -> unsigned {
        const unsigned value = stream.at(at / 8) >> at % 8 & 1;
        ++at;
        return value;
    };
    const auto number = [&](unsigned count) {
        unsigned value = 0;
        for (unsigned n = 0; n < count; ++n) value |= bit() << n;
        return value;
    };
    const auto symbol = [&]() -> unsigned {
        unsigned code = 0, length = 0;
        while (true) {
            code = code << 1 | bit();
            ++length;
            if (length == 7 && code <= 0x17) return 256 + code;
            if (length == 8 && code >= 0x30 && code <= 0xBF) return code - 0x30;
            if (length == 8 && code >= 0xC0 && code <= 0xC7) return 280 + code - 0xC0;
            if (length == 9) return 144 + code - 0x190;
        }
    };
    EXPECT_EQ(number(1), 1u);
    EXPECT_EQ(number(2), 1u);
    Bytes data;
    for (unsigned s; (s = symbol()) != 256;) {
        if (s < 256) {
            data.push_back(static_cast<unsigned char>(s));
            continue;
        }
        const unsigned length = lengthBase[s - 257] + number(lengthBits[s - 257]);
        unsigned d = 0;
        for (int n = 0; n < 5; ++n) d = d << 1 | bit();
        const unsigned distance = distanceBase[d] + number(distanceBits[d]);
        EXPECT_LE(distance, data.size());
        for (unsigned n = 0; n < length; ++n) data.push_back(data[data.size() - distance]);
    }
    return data;
}

/// Noise, flat areas and gradients: short and long matches, near and far.
Image makeImage(int width, int height) {
    Image image{width, height, {}};
    std::uint32_t noise = 1;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            noise = noise * 1664525 + 1013904223;
            const auto level = static_cast<unsigned char>(noise >> 24);
            if (y % 8 == 0)
                image.pixels.push_back({level, static_cast<unsigned char>(x), 7});
            else
                image.pixels.push_back(
                    {200, static_cast<unsigned char>(y), static_cast<unsigned char>(x / 50)});
        }
    return image;
}

}  // namespace

TEST(DemoPng, DecodesToThePictureThatItWasMadeFrom) {
    const Image image = makeImage(301, 97);
    std::ostringstream out;
    writePng(out, image);
    const std::string text = out.str();
    const Bytes file(text.begin(), text.end());
    EXPECT_EQ(text.substr(0, 8), "\x89PNG\r\n\x1a\n");
    EXPECT_EQ(text.substr(12, 4), "IHDR");
    EXPECT_EQ(bigEndian(file, 16), 301u);
    EXPECT_EQ(bigEndian(file, 20), 97u);
    // The checksum of the chunk that every PNG ends with is known: AE 42 60 82.
    EXPECT_EQ(text.substr(text.size() - 12), std::string("\0\0\0\0IEND\xAE\x42\x60\x82", 12));

    ASSERT_EQ(text.substr(37, 4), "IDAT");
    const std::uint32_t size = bigEndian(file, 33);
    const Bytes stream(file.begin() + 41, file.begin() + 41 + size);
    EXPECT_EQ((stream[0] * 256 + stream[1]) % 31, 0) << "zlib's header";
    const Bytes data = inflated(stream);
    ASSERT_EQ(data.size(), 97u * (1 + 3 * 301));
    Bytes above(3 * 301, 0);
    for (std::size_t y = 0; y < 97; ++y) {
        const std::size_t row = y * (1 + 3 * 301);
        ASSERT_EQ(data[row], 2) << "filter";
        for (std::size_t n = 0; n < above.size(); ++n) {
            above[n] = static_cast<unsigned char>(above[n] + data[row + 1 + n]);
            const Colour colour = image.pixels[y * 301 + n / 3];
            const unsigned char wanted = n % 3 == 0 ? colour.red : n % 3 == 1 ? colour.green : colour.blue;
            ASSERT_EQ(above[n], wanted) << y << ' ' << n;
        }
    }
    EXPECT_LT(text.size(), data.size() * 2 / 3) << "it is compressed";
}
