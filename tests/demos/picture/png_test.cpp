#include "picture/png.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstdlib>
#include <map>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "picture/deflate.h"

using namespace demo;

namespace {

std::uint32_t bigEndian(const Bytes &bytes, std::size_t at) {
    return std::uint32_t(bytes[at]) << 24 | std::uint32_t(bytes[at + 1]) << 16 |
           std::uint32_t(bytes[at + 2]) << 8 | bytes[at + 3];
}

/// Undoes deflate with codes of its own (RFC 1951), by the tables that are written out there.
class Inflation {
public:
    /// Begins behind zlib's two bytes.
    explicit Inflation(const Bytes &s) : stream(s), at(16) {}

    Bytes read() {
        EXPECT_EQ(number(1), 1u) << "the last block";
        EXPECT_EQ(number(2), 2u) << "codes of its own";
        readCodes();
        while (readToken()) {
        }
        at = (at + 7) / 8;
        return data;
    }
    std::size_t position() const { return at; }  ///< bytes, after read()

private:
    using Code = std::map<std::string, unsigned>;  // word in bits → symbol

    char bit() {
        const unsigned value = stream.at(at / 8) >> at % 8 & 1;
        ++at;
        return value ? '1' : '0';
    }
    unsigned number(unsigned count) {
        unsigned value = 0;
        for (unsigned n = 0; n < count; ++n) value |= unsigned(bit() - '0') << n;
        return value;
    }

    /// Words of the same length count upwards; a longer one follows the last shorter one, with zeros behind.
    static Code codeOf(const std::vector<unsigned> &lengths) {
        Code code;
        unsigned next = 0, last = 0;
        for (unsigned length = 1; length <= 15; ++length)
            for (unsigned symbol = 0; symbol < lengths.size(); ++symbol) {
                if (lengths[symbol] != length) continue;
                next <<= length - last;
                last = length;
                std::string word;
                for (unsigned n = length; n-- > 0;) word += next >> n & 1 ? '1' : '0';
                EXPECT_LT(next, 1u << length) << "more words than there are";
                code[word] = symbol;
                ++next;
            }
        EXPECT_EQ(next, 1u << last) << "no word is left over";
        return code;
    }

    unsigned symbolOf(const Code &code) {
        std::string word;
        while (word.size() < 16) {
            word += bit();
            const auto found = code.find(word);
            if (found != code.end()) return found->second;
        }
        throw std::runtime_error("no such word");
    }

    void readCodes() {
        static const unsigned order[] = {16, 17, 18, 0, 8, 7, 9, 6, 10, 5, 11, 4, 12, 3, 13, 2, 14, 1, 15};
        const unsigned literalCount = number(5) + 257, distanceCount = number(5) + 1, count = number(4) + 4;
        std::vector<unsigned> lengths(19, 0);
        for (unsigned n = 0; n < count; ++n) lengths[order[n]] = number(3);
        const Code code = codeOf(lengths);
        std::vector<unsigned> all;
        while (all.size() < literalCount + distanceCount) {
            const unsigned symbol = symbolOf(code);
            if (symbol < 16)
                all.push_back(symbol);
            else if (symbol == 16)
                all.insert(all.end(), 3 + number(2), all.back());
            else
                all.insert(all.end(), symbol == 17 ? 3 + number(3) : 11 + number(7), 0);
        }
        literals = codeOf({all.begin(), all.begin() + literalCount});
        distances = codeOf({all.begin() + literalCount, all.end()});
    }

    bool readToken() {
        static const unsigned lengthBase[] = {3,  4,  5,  6,  7,  8,  9,  10, 11,  13,  15,  17,  19,  23, 27,
                                              31, 35, 43, 51, 59, 67, 83, 99, 115, 131, 163, 195, 227, 258};
        static const unsigned lengthBits[] = {0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2,
                                              2, 3, 3, 3, 3, 4, 4, 4, 4, 5, 5, 5, 5, 0};
        static const unsigned distanceBase[] = {
            1,   2,   3,   4,   5,   7,    9,    13,   17,   25,   33,   49,   65,    97,    129,
            193, 257, 385, 513, 769, 1025, 1537, 2049, 3073, 4097, 6145, 8193, 12289, 16385, 24577};
        static const unsigned distanceBits[] = {0, 0, 0, 0, 1, 1, 2, 2,  3,  3,  4,  4,  5,  5,  6,
                                                6, 7, 7, 8, 8, 9, 9, 10, 10, 11, 11, 12, 12, 13, 13};
        const unsigned symbol = symbolOf(literals);
        if (symbol == 256) return false;
        if (symbol < 256) {
            data.push_back(static_cast<unsigned char>(symbol));
            return true;
        }
        const unsigned length = lengthBase[symbol - 257] + number(lengthBits[symbol - 257]);
        const unsigned far = symbolOf(distances), distance = distanceBase[far] + number(distanceBits[far]);
        if (distance > data.size()) throw std::runtime_error("before the beginning");
        for (unsigned n = 0; n < length; ++n) data.push_back(data[data.size() - distance]);
        return true;
    }

    const Bytes &stream;
    std::size_t at;
    Code literals, distances;
    Bytes data;
};

/// RFC 1950's checksum, straight from its definition.
std::uint32_t adler(const Bytes &data) {
    std::uint64_t a = 1, b = 0;
    for (const unsigned char byte : data) b += a += byte;
    return std::uint32_t(b % 65521 << 16 | a % 65521);
}

void expectThereAndBack(const Bytes &data) {
    const Bytes stream = compressed(data);
    ASSERT_EQ((stream.at(0) * 256 + stream.at(1)) % 31, 0) << "zlib's header";
    Inflation inflation(stream);
    EXPECT_EQ(inflation.read(), data);
    ASSERT_EQ(inflation.position() + 4, stream.size());
    EXPECT_EQ(bigEndian(stream, inflation.position()), adler(data));
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
    const Bytes data = Inflation(stream).read();
    const std::size_t stride = 1 + 3 * 301;
    ASSERT_EQ(data.size(), 97 * stride);
    Bytes samples(data.size(), 0);  // as ISO/IEC 15948, 9.4: Paeth's filter
    const auto sample = [&](std::size_t y, std::size_t n, std::size_t left, std::size_t up) -> int {
        return y < up || n < 3 * left ? 0 : samples[(y - up) * stride + 1 + n - 3 * left];
    };
    for (std::size_t y = 0; y < 97; ++y) {
        ASSERT_EQ(data[y * stride], 4) << "filter";
        for (std::size_t n = 0; n < 3 * 301; ++n) {
            const int a = sample(y, n, 1, 0), b = sample(y, n, 0, 1), c = sample(y, n, 1, 1), p = a + b - c;
            const int pa = std::abs(p - a), pb = std::abs(p - b), pc = std::abs(p - c);
            const int guess = pa <= pb && pa <= pc ? a : pb <= pc ? b : c;
            samples[y * stride + 1 + n] = static_cast<unsigned char>(data[y * stride + 1 + n] + guess);
            const Colour colour = image.pixels[y * 301 + n / 3];
            const unsigned char wanted = n % 3 == 0 ? colour.red : n % 3 == 1 ? colour.green : colour.blue;
            ASSERT_EQ(samples[y * stride + 1 + n], wanted) << y << ' ' << n;
        }
    }
    EXPECT_LT(text.size(), data.size() / 3) << "it is compressed";
}

TEST(DemoDeflate, GivesEveryDataBack) {
    expectThereAndBack({});
    expectThereAndBack({7});
    expectThereAndBack(Bytes(100000, 7));  // the longest matches there are
    Bytes noise, far;
    std::uint32_t state = 5;
    for (int n = 0; n < 70000; ++n)
        noise.push_back(static_cast<unsigned char>((state = state * 1664525 + 1013904223) >> 24));
    expectThereAndBack(noise);
    for (int n = 0; n < 3; ++n)
        far.insert(far.end(), noise.begin(), noise.begin() + 32768);  // just within reach
    expectThereAndBack(far);
    EXPECT_LT(compressed(far).size(), 36000u);
}

TEST(DemoDeflate, LimitsTheLengthOfWordsWhateverTheCounts) {
    // Counts as the Fibonacci numbers make Huffman's code as deep as it can be: 22 bits.
    Bytes data;
    for (unsigned n = 0, count = 1, last = 1; n < 23; ++n, last = std::exchange(count, count + last))
        for (unsigned times = 0; times < count; ++times) data.push_back(static_cast<unsigned char>(n * 11));
    // Shuffled, so that nothing matches.
    std::uint32_t state = 1;
    for (std::size_t n = data.size(); n > 1; --n)
        std::swap(data[n - 1], data[(state = state * 1664525 + 1013904223) % n]);
    expectThereAndBack(data);
}
