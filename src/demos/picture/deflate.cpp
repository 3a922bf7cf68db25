#include "picture/deflate.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <queue>
#include <utility>

namespace demo {

namespace {

constexpr unsigned END = 256, LITERALS = 286, DISTANCES = 30;  // the alphabets of RFC 1951
constexpr unsigned LONGEST_CODE = 15;

/// Bits in deflate's order: numbers begin with their lowest bit, Huffman codes with their highest.
class BitWriter {
public:
    void number(unsigned value, unsigned count) {
        for (unsigned n = 0; n < count; ++n) bit(value >> n & 1);
    }
    void code(unsigned value, unsigned count) {
        for (unsigned n = count; n-- > 0;) bit(value >> n & 1);
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

/// A Huffman code whose words are at most LONGEST_CODE bits long.
class HuffmanCode {
public:
    explicit HuffmanCode(std::vector<std::size_t> counts) {
        // At least two words: a code of one would be incomplete.
        for (std::size_t n = 0; std::count(counts.begin(), counts.end(), 0u) > long(counts.size()) - 2; ++n)
            counts[n] = std::max<std::size_t>(counts[n], 1);
        while (!measure(counts))
            for (std::size_t &count : counts) count = (count + 1) / 2;
        number();
    }

    void writeLengths(BitWriter &out) const {
        for (const unsigned length : lengths) out.code(length, 4);
    }
    void write(BitWriter &out, unsigned symbol) const { out.code(words[symbol], lengths[symbol]); }

private:
    /// Huffman 1952: the two rarest become one, again and again. False if a word is too long.
    bool measure(const std::vector<std::size_t> &counts) {
        using Node = std::pair<std::size_t, std::size_t>;  // count, index
        std::priority_queue<Node, std::vector<Node>, std::greater<Node>> rarest;
        for (std::size_t n = 0; n < counts.size(); ++n)
            if (counts[n] > 0) rarest.push({counts[n], n});
        std::vector<std::size_t> parents(counts.size(), 0);
        while (rarest.size() > 1) {
            const Node a = rarest.top();
            rarest.pop();
            const Node b = rarest.top();
            rarest.pop();
            parents[a.second] = parents[b.second] = parents.size();
            rarest.push({a.first + b.first, parents.size()});
            parents.push_back(0);
        }
        std::vector<unsigned> depths(parents.size(), 0);  // the root comes last
        for (std::size_t n = parents.size() - 1; n-- > 0;)
            if (parents[n] != 0) depths[n] = depths[parents[n]] + 1;
        lengths.assign(depths.begin(), depths.begin() + static_cast<std::ptrdiff_t>(counts.size()));
        return *std::max_element(lengths.begin(), lengths.end()) <= LONGEST_CODE;
    }

    /// RFC 1951, 3.2.2: shorter words first, then in the alphabet's order.
    void number() {
        words.assign(lengths.size(), 0);
        unsigned word = 0;
        for (unsigned length = 1; length <= LONGEST_CODE; ++length, word <<= 1)
            for (std::size_t n = 0; n < lengths.size(); ++n)
                if (lengths[n] == length) words[n] = word++;
    }

    std::vector<unsigned> lengths, words;
};

/// A number as deflate writes it: a symbol, and how far beyond that symbol's least number.
struct Step {
    unsigned symbol, beyond, bits;
};

/// `symbols` of them have no further bits, then `each` symbols have one, `each` two and so on.
Step stepOf(unsigned value, unsigned base, unsigned symbols, unsigned each) {
    unsigned symbol = 0, bits = 0;
    while (value >= base + (1u << bits)) {
        base += 1u << bits;
        ++symbol;
        bits = symbol < symbols ? 0 : (symbol - symbols) / each + 1;
    }
    return {symbol, value - base, bits};
}

Step lengthStep(unsigned length) {
    if (length == 258) return {285, 0, 0};
    Step step = stepOf(length, 3, 8, 4);
    step.symbol += END + 1;
    return step;
}

Step distanceStep(unsigned distance) { return stepOf(distance, 1, 4, 2); }

/// A byte as it is, or what came `distance` bytes ago again, `length` bytes of it.
struct Token {
    Byte literal = 0;
    unsigned length = 0, distance = 0;  // 0: a literal
};

/// With the latest match of every three bytes, if it is long enough: in their own code, a few bytes of a
/// picture take fewer bits than a distance does.
std::vector<Token> tokensOf(const Bytes &data) {
    constexpr std::size_t WINDOW = 32768, LONGEST = 258, HASHED = 3, SHORTEST = 10,
                          NONE = static_cast<std::size_t>(-1);
    std::vector<std::size_t> latest(1 << 15, NONE);
    const auto slot = [&](std::size_t at) -> std::size_t & {
        const unsigned key =
            data[at] | static_cast<unsigned>(data[at + 1]) << 8 | static_cast<unsigned>(data[at + 2]) << 16;
        return latest[(key * 2654435761u) >> 17];
    };
    std::vector<Token> tokens;
    for (std::size_t at = 0; at < data.size();) {
        std::size_t length = 0, from = 0;
        if (at + HASHED <= data.size()) {
            from = slot(at);
            if (from != NONE && at - from <= WINDOW)
                while (length < LONGEST && at + length < data.size() &&
                       data[from + length] == data[at + length])
                    ++length;
        }
        const bool matches = length >= SHORTEST;
        if (matches)
            tokens.push_back({0, static_cast<unsigned>(length), static_cast<unsigned>(at - from)});
        else
            tokens.push_back({data[at], 0, 0});
        const std::size_t taken = matches ? length : 1;
        for (std::size_t n = at; n < at + taken && n + HASHED <= data.size(); ++n) slot(n) = n;
        at += taken;
    }
    return tokens;
}

/// The only block, in a code of its own. The lengths of that code's words are written plainly, 4 bits each.
Bytes blockOf(const std::vector<Token> &tokens) {
    std::vector<std::size_t> literals(LITERALS, 0), distances(DISTANCES, 0);
    ++literals[END];
    for (const Token &token : tokens) {
        ++literals[token.length ? lengthStep(token.length).symbol : token.literal];
        if (token.length) ++distances[distanceStep(token.distance).symbol];
    }
    const HuffmanCode literalCode(literals), distanceCode(distances);

    BitWriter out;
    out.number(1, 1);  // the last block
    out.number(2, 2);  // its own code
    out.number(LITERALS - 257, 5);
    out.number(DISTANCES - 1, 5);
    out.number(19 - 4, 4);
    for (int n = 0; n < 19; ++n) out.number(n < 3 ? 0 : 4, 3);  // no repeats; every length in 4 bits
    literalCode.writeLengths(out);
    distanceCode.writeLengths(out);
    for (const Token &token : tokens) {
        if (!token.length) {
            literalCode.write(out, token.literal);
            continue;
        }
        const Step length = lengthStep(token.length), distance = distanceStep(token.distance);
        literalCode.write(out, length.symbol);
        out.number(length.beyond, length.bits);
        distanceCode.write(out, distance.symbol);
        out.number(distance.beyond, distance.bits);
    }
    literalCode.write(out, END);
    return out.finished();
}

std::uint32_t adler32(const Bytes &bytes) {
    std::uint32_t a = 1, b = 0;
    for (const Byte byte : bytes) {
        a = (a + byte) % 65521;
        b = (b + a) % 65521;
    }
    return b << 16 | a;
}

}  // namespace

void appendBigEndian(Bytes &bytes, std::uint32_t value) {
    for (int shift = 24; shift >= 0; shift -= 8) bytes.push_back(static_cast<Byte>(value >> shift));
}

Bytes compressed(const Bytes &data) {
    Bytes bytes = {0x78, 0x9C};
    const Bytes block = blockOf(tokensOf(data));
    bytes.insert(bytes.end(), block.begin(), block.end());
    appendBigEndian(bytes, adler32(data));
    return bytes;
}

}  // namespace demo
