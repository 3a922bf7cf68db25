#include "terminal/keys.h"

#include <cstddef>

namespace demo {

namespace {

constexpr char ESC = '\x1b';

/// What the front of the input is: a key, or something without meaning (NONE), of `length` bytes; length 0:
/// unfinished.
struct Token {
    Key key = keys::NONE;
    std::size_t length = 0;
};

/// CSI sequences end in a letter, or in ~ after a number (xterm, vt220).
Key keyOfSequence(char final, int number) {
    switch (final) {
        case 'A':
            return keys::UP;
        case 'B':
            return keys::DOWN;
        case 'C':
            return keys::RIGHT;
        case 'D':
            return keys::LEFT;
        case 'H':
            return keys::HOME;
        case 'F':
            return keys::END;
        case 'M':
            return keys::ENTER;  // the keypad's, in application mode
        case '~':
            break;
        default:
            return keys::NONE;
    }
    switch (number) {
        case 1:
        case 7:
            return keys::HOME;
        case 2:
            return keys::INSERT;
        case 3:
            return keys::DELETE_KEY;
        case 4:
        case 8:
            return keys::END;
        case 5:
            return keys::PAGE_UP;
        case 6:
            return keys::PAGE_DOWN;
        default:
            return keys::NONE;
    }
}

/// ESC [ parameters and intermediates (0x20 to 0x3F), then a final byte (0x40 to 0x7E): ECMA-48, section 5.4.
Token readControlSequence(const std::string &bytes) {
    int number = 0;
    bool firstParameter = true;
    for (std::size_t i = 2; i < bytes.size(); ++i) {
        const char c = bytes[i];
        if (c >= '@' && c <= '~') return {keyOfSequence(c, number), i + 1};
        if (c < ' ' || c > '?') return {keys::NONE, i};  // broken off by something else
        const bool digit = c >= '0' && c <= '9';
        firstParameter = firstParameter && digit;
        if (firstParameter && number < 1000) number = number * 10 + (c - '0');
    }
    return {};
}

Token readEscape(const std::string &bytes, bool nothingFollows) {
    if (bytes.size() == 1) return nothingFollows ? Token{keys::ESCAPE, 1} : Token{};
    if (bytes[1] == ESC) return {keys::ESCAPE, 1};
    Token token;
    if (bytes[1] == '[') {
        token = readControlSequence(bytes);
    } else if (bytes[1] == 'O') {
        if (bytes.size() > 2) token = {keyOfSequence(bytes[2], 0), 3};
    } else {
        return {keys::NONE, 1};  // Alt: the key itself follows
    }
    if (token.length == 0 && nothingFollows) return {keys::NONE, bytes.size()};
    return token;
}

Token readCharacter(char c) {
    if (c >= 'A' && c <= 'Z') return {static_cast<Key>(c - 'A' + 'a'), 1};
    if (c == '\n') return {keys::ENTER, 1};
    if (c == 0x7F) return {keys::BACKSPACE, 1};
    return {c > 0 && c < 0x7F ? static_cast<Key>(c) : keys::NONE, 1};
}

}  // namespace

Key takeKey(std::string &bytes, bool nothingFollows) {
    while (!bytes.empty()) {
        const Token token = bytes[0] == ESC ? readEscape(bytes, nothingFollows) : readCharacter(bytes[0]);
        if (token.length == 0) break;
        bytes.erase(0, token.length);
        if (token.key != keys::NONE) return token.key;
    }
    return keys::NONE;
}

}  // namespace demo
