#pragma once

/// What a keyboard says through a terminal: bytes in, keys out.
#include <string>

namespace demo {

/// A key is the ASCII character it types, or one of `keys`. A letter comes as its small letter, so that
/// neither Shift nor Caps Lock matters.
using Key = char32_t;

namespace keys {
constexpr Key NONE = 0;
constexpr Key BACKSPACE = 0x08, TAB = 0x09, ENTER = 0x0D, ESCAPE = 0x1B;
/// These type no character.
constexpr Key UP = 0x110000, DOWN = 0x110001, RIGHT = 0x110002, LEFT = 0x110003, HOME = 0x110004,
              END = 0x110005, PAGE_UP = 0x110006, PAGE_DOWN = 0x110007, INSERT = 0x110008,
              DELETE_KEY = 0x110009;
}  // namespace keys

/// Takes the first key from the front of `bytes` and returns it; NONE if there is no whole key.
///
/// An escape sequence may arrive in pieces, and its first byte is also what the Esc key sends. So an
/// unfinished sequence stays in `bytes` until the rest has come. `nothingFollows` says that it won't (the
/// caller has waited): a lone Esc is then the key ESCAPE, and any other fragment is dropped. Sequences of no
/// known key and whatever isn't ASCII are dropped; Alt with a key counts as the key.
Key takeKey(std::string &bytes, bool nothingFollows);

}  // namespace demo
