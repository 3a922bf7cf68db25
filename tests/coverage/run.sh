#!/usr/bin/env bash
# Coverage: which lines and branches of the library the tests reach, without the demos'. Every line must be reached, and
# 98 % of the branches; those by which an exception passes through do not count.
#
# Environment: JOBS (number of processors).
set -eu
root=$(cd "$(dirname "$0")/../.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
compile="g++ --coverage -fprofile-update=atomic -std=c++17 -O0 -ffp-contract=off -DCYCLONE_TARGET_CLONES=
    -I$root/include -iquote $root/src -I$root/tests/support -iquote $root/tests -pthread"

cd "$work"
printf '%s\n' "$root"/src/*.cpp "$root"/tests/*/*_test.cpp "$root"/tests/golden/{scene,bodies,vehicles}.cpp |
    xargs -n 1 -P "${JOBS:-$(nproc)}" $compile -DCYCLONE_TEST_DATA="\"$root/tests/data\"" -c
$compile ./*.o -lgtest -lgtest_main -o tests
./tests --gtest_brief=1
gcovr --root "$root" --filter "$root/src/[a-z]*\.(cpp|h)" --filter "$root/include/" --exclude-throw-branches \
    --exclude-unreachable-branches --fail-under-line 100 --fail-under-branch 98 .
