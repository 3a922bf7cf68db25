#include "base/files.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <stdexcept>

using namespace demo;

namespace {

class DemoKeptFile : public testing::Test {
protected:
    std::string path =
        testing::TempDir() + "cyclone_kept_" + testing::UnitTest::GetInstance()->current_test_info()->name();
    void TearDown() override {
        for (const char *ending : {"", ".new", ".link"}) std::remove((path + ending).c_str());
    }
    void write(const std::string &text) const { std::ofstream(path, std::ios::binary) << text; }
    bool exists(const std::string &file) const { return std::filesystem::exists(file); }
};

}  // namespace

TEST_F(DemoKeptFile, OneThatIsNotThereHasNoTextAndIsNotMadeWithoutOne) {
    {
        const KeptFile file(path);
        EXPECT_EQ(file.getText(), "");
    }
    EXPECT_FALSE(exists(path));
    EXPECT_FALSE(exists(path + ".new"));
}

TEST_F(DemoKeptFile, IsReadAndReplacedAsAWhole) {
    write("old\n");
    {
        KeptFile file(path);
        EXPECT_EQ(file.getText(), "old\n");
        EXPECT_EQ(readFile(path), "old\n");
        file.replace("new\n");
    }
    EXPECT_EQ(readFile(path), "new\n");
    EXPECT_FALSE(exists(path + ".new"));
}

TEST_F(DemoKeptFile, StaysAsItIsWhenNotReplaced) {
    write("old\n");
    { const KeptFile file(path); }
    EXPECT_EQ(readFile(path), "old\n");
    EXPECT_FALSE(exists(path + ".new"));
}

TEST_F(DemoKeptFile, WhatCannotBeReadOrWrittenIsSaidAtOnce) {
    EXPECT_THROW(KeptFile{testing::TempDir()}, std::runtime_error) << "a folder";
    EXPECT_THROW(KeptFile(testing::TempDir() + "no/such/directory/file"), std::runtime_error);
}

TEST_F(DemoKeptFile, ALinkStaysALink) {
    write("old\n");
    std::error_code error;
    std::filesystem::create_symlink(path, path + ".link", error);
    if (error) GTEST_SKIP() << "no links here: " << error.message();
    KeptFile(path + ".link").replace("new\n");
    EXPECT_TRUE(std::filesystem::is_symlink(path + ".link"));
    EXPECT_EQ(readFile(path), "new\n");
}
