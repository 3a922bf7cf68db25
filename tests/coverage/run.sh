#!/usr/bin/env bash
# Coverage: which lines and branches of the library the tests reach, without the demos'. Every line must be reached, and
# 98 % of the branches; those by which an exception passes through do not count. A function counts once, however often
# it is inlined or compiled for another processor.
#
# Environment: JOBS (number of processors).
set -eu
root=$(cd "$(dirname "$0")/../.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
compile="g++ --coverage -fprofile-update=atomic -std=c++17 -O0 -ffp-contract=off -DCYCLONE_TARGET_CLONES=
    -DCYCLONE_INLINE=inline -I$root/include -iquote $root/src -I$root/tests/support -iquote $root/tests -pthread"

cd "$work"
printf '%s\n' "$root"/src/*.cpp "$root"/tests/*/*_test.cpp "$root"/tests/golden/{scene,bodies,vehicles}.cpp |
    xargs -n 1 -P "${JOBS:-$(nproc)}" $compile -DCYCLONE_TEST_DATA="\"$root/tests/data\"" -c
$compile ./*.o -lgtest -lgtest_main -o tests
./tests --gtest_brief=1

# Many files have copies of a header's functions. Of those that are never called there, gcov does not say which branches
# are exceptions: they are left to the files that call them.
gcov --branch-probabilities --branch-counts --long-file-names --preserve-paths --relative-only --source-prefix "$root" \
    ./*.gcda >/dev/null
sed -i -E '/^ *(#####|=====):/,/^ *([0-9]+\*?|-):/{/^branch/d}' ./*.gcov
cd "$root"
gcovr --use-gcov-files --filter src/ --filter include/ --exclude-throw-branches --exclude-unreachable-branches \
    --fail-under-line 100 --fail-under-branch 98 --branches --print-summary "$work"
