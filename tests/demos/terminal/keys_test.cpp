#include "terminal/keys.h"

#include <gtest/gtest.h>

#include <vector>

using namespace demo;

namespace {

std::vector<Key> keysOf(std::string bytes, bool nothingFollows = true) {
    std::vector<Key> all;
    for (Key key; (key = takeKey(bytes, nothingFollows)) != keys::NONE;) all.push_back(key);
    return all;
}

using Keys = std::vector<Key>;

TEST(DemoKeys, CharactersAreThemselvesAndLettersSmall) {
    EXPECT_EQ(keysOf("aZ+-=7 "), (Keys{'a', 'z', '+', '-', '=', '7', ' '}));
    EXPECT_EQ(keysOf("\r\n\t\x7f\x08"),
              (Keys{keys::ENTER, keys::ENTER, keys::TAB, keys::BACKSPACE, keys::BACKSPACE}));
}

TEST(DemoKeys, ArrowsAndTheirKinInBothModes) {
    EXPECT_EQ(keysOf("\x1b[A\x1b[B\x1b[C\x1b[D"), (Keys{keys::UP, keys::DOWN, keys::RIGHT, keys::LEFT}));
    EXPECT_EQ(keysOf("\x1bOA\x1bOB\x1bOC\x1bOD"), (Keys{keys::UP, keys::DOWN, keys::RIGHT, keys::LEFT}));
    EXPECT_EQ(keysOf("\x1b[H\x1b[1~\x1b[F\x1b[4~\x1b[5~\x1b[6~\x1b[2~\x1b[3~"),
              (Keys{keys::HOME, keys::HOME, keys::END, keys::END, keys::PAGE_UP, keys::PAGE_DOWN,
                    keys::INSERT, keys::DELETE_KEY}));
    EXPECT_EQ(keysOf("\x1b[1;5A"), Keys{keys::UP}) << "with Ctrl";
}

TEST(DemoKeys, EscAloneIsAKeyOnceNothingFollows) {
    std::string bytes = "\x1b";
    EXPECT_EQ(takeKey(bytes, false), keys::NONE);
    EXPECT_EQ(bytes, "\x1b");
    EXPECT_EQ(takeKey(bytes, true), keys::ESCAPE);
    EXPECT_EQ(bytes, "");
    EXPECT_EQ(keysOf("\x1b\x1b[A"), (Keys{keys::ESCAPE, keys::UP}));
}

TEST(DemoKeys, ASequenceMayArriveInPieces) {
    const std::string whole = "\x1b[1;2C";
    std::string bytes;
    for (std::size_t i = 0; i + 1 < whole.size(); ++i) {
        bytes += whole[i];
        EXPECT_EQ(takeKey(bytes, false), keys::NONE) << i;
    }
    bytes += whole.back();
    EXPECT_EQ(takeKey(bytes, false), keys::RIGHT);
    EXPECT_EQ(bytes, "");
}

TEST(DemoKeys, FragmentsAndUnknownSequencesAreDropped) {
    EXPECT_EQ(keysOf("\x1b["), Keys{});
    EXPECT_EQ(keysOf("\x1bO"), Keys{});
    EXPECT_EQ(keysOf("\x1b[15~\x1b[200~w\x1b[I"), Keys{'w'});
    EXPECT_EQ(keysOf("\x1b[12\x1b[A"), Keys{keys::UP}) << "broken off";
    EXPECT_EQ(keysOf("\x1b[99999999999999~q"), Keys{'q'});
    EXPECT_EQ(keysOf("\xc3\xa9\xff"
                     "d"),
              Keys{'d'})
        << "not ASCII";
    EXPECT_EQ(keysOf(std::string("\0s", 2)), Keys{'s'});
}

TEST(DemoKeys, AltCountsAsTheKeyItself) { EXPECT_EQ(keysOf("\x1bw"), Keys{'w'}); }

TEST(DemoKeys, EveryShortInputIsConsumed) {
    const std::string alphabet = "\x1b[O;1~Aa\x80";
    for (char a : alphabet)
        for (char b : alphabet)
            for (char c : alphabet)
                for (char d : alphabet) {
                    std::string bytes{a, b, c, d};
                    while (takeKey(bytes, true) != keys::NONE) {
                    }
                    EXPECT_EQ(bytes, "");
                }
}

}  // namespace
