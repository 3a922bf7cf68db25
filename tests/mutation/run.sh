#!/usr/bin/env bash
# Mutants: how many small faults in src/*.cpp the tests notice. Makes one change at a time (see mutate.cpp), rebuilds
# and runs the tests, without the demos': those of the header first, then the quick ones, the golden program, the slow
# ones. Survivors must be listed in survivors.txt, with the reason why the change cannot be seen; these need not pass
# the slow ones. Of the others at least 97 % must be killed.
#
#     run.sh [how many, 300 if not said] [only files that match this]
#
# The mutants are spread evenly over all files, the same ones each time as long as the source is the same.
# Environment: CXX (g++), JOBS (number of processors).
set -eu
root=$(cd "$(dirname "$0")/../.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
count=${1:-300} only=${2:-} jobs_at_once=${JOBS:-$(nproc)}
compile="${CXX:-g++} -std=c++17 -O1 -ffp-contract=off -fno-math-errno -I$root/include -iquote $root/src
    -I$root/tests/support -iquote $root/tests -pthread"
of_library="-fPIC -fsanitize=bounds -fsanitize-undefined-trap-on-error"  # indices out of bounds end the program
link="$compile $(! command -v ld.lld >/dev/null || echo -fuse-ld=lld)"

wait_for_turn() { while [ "$(jobs -rp | wc -l)" -ge "$jobs_at_once" ]; do wait -n || true; done; }

# The library is a shared one, so that a mutant takes the linking of no program.
build_all() {
    mkdir "$work/src" "$work/tests" "$work/golden"
    $compile "$root/tests/mutation/mutate.cpp" -o "$work/mutate"
    local source folder options
    for source in "$root"/src/*.cpp "$root"/tests/golden/*.cpp "$root"/tests/*/*_test.cpp; do
        folder=tests options="-DCYCLONE_TEST_DATA=\"$root/tests/data\""
        case $source in
        "$root"/src/*) folder=src options=$of_library ;;
        */golden/*) folder=golden ;;
        esac
        wait_for_turn
        $compile $options -c "$source" -o "$work/$folder/$(basename "$source" .cpp).o" &
    done
    wait
    $link -shared "$work"/src/*.o -o "$work/libcyclone.so"
    $link "$work"/tests/*.o "$work"/golden/{scene,bodies,vehicles}.o -L"$work" -lcyclone -lgtest -lgtest_main -o "$work/all_tests"
    $link "$work"/golden/*.o -L"$work" -lcyclone -o "$work/all_golden"
}

# The tests of the header that the source belongs to, to be run first.
nearest_tests() { # name of the source
    sed -nE 's/^(TEST|TEST_F|TEST_P)\((\w+),.*/*\2.*/p' "$root"/tests/*/"$1_test.cpp" 2>/dev/null | sort -u | paste -sd:
}

# With the library that is in the folder, and so many seconds of a processor's time; waiting may take 20 times as long.
passes() { # folder, seconds, program, arguments…
    (ulimit -v 8000000 -t "$2"; cd "$1" && LD_LIBRARY_PATH=$1 timeout $((20 * $2)) "$work/$3" "${@:4}") 2>/dev/null
}
passes_tests() { # folder, seconds, filter
    passes "$1" "$2" all_tests --gtest_fail_fast --gtest_filter="$3" >/dev/null
}

# Sets `slow` to the tests that take a twentieth of a second and more, to be run last, and `patience` to the time for
# them.
time_tests() {
    local TIMEFORMAT=%0U
    if ! patience=$( { time passes "$work" 600 all_tests >"$work/times"; } 2>&1) ||
        ! passes "$work" 600 all_golden >/dev/null; then
        echo "Without any change the tests fail:"
        grep -E '^\[  FAILED' "$work/times"
        exit 1
    fi
    patience=$((10 + 2 * patience))
    slow=$(sed -nE 's/^\[ +OK \] ([^ ,]+).* \(([5-9][0-9]|[0-9]{3,}) ms\)/\1/p' "$work/times" | paste -sd:)
}

# Writes what becomes of the mutant to its result.
try() { # number of the mutant, name of the source, number of its change
    local at=$work/mutant$1 result=survived
    mkdir "$at"
    "$work/mutate" "$root/src/$2.cpp" "$3" >"$at/$2.cpp" 2>"$at/change"
    if ! $compile $of_library -c "$at/$2.cpp" -o "$at/$2.o" 2>/dev/null; then
        result="does not build"
    elif cmp -s "$at/$2.o" "$work/src/$2.o"; then
        result="same code"
    elif ! $link -shared $(printf '%s\n' "$work"/src/*.o | grep -v "/$2.o$") "$at/$2.o" -o "$at/libcyclone.so" 2>/dev/null; then
        result="does not build"
    elif ! passes_tests "$at" 15 "$(nearest_tests "$2")" || ! passes_tests "$at" 15 "-$slow"; then
        result="killed"
    elif ! passes "$at" 15 all_golden >/dev/null; then
        result="killed by the golden number"
    elif grep -qxF -f "$at/change" "$root/tests/mutation/survivors.txt"; then
        result="explained"
    elif ! passes_tests "$at" "$patience" "$slow"; then
        result="killed"
    fi
    echo "$result" >"$at/result"
    [ "$result" != "survived" ] || echo "$result: $2.cpp: $(cat "$at/change")"
    rm -f "$at"/*.o "$at"/*.so
}

results_like() { grep -lx "$1" "$work"/mutant*/result | wc -l; }

build_all
time_tests
changes=()
for source in "$root"/src/*"$only"*.cpp; do
    name=$(basename "$source" .cpp)
    for ((n = 0, last = $("$work/mutate" "$source"); n < last; ++n)); do changes+=("$name $n"); done
done
[ "$count" -lt "${#changes[@]}" ] || count=${#changes[@]}
for ((n = 0; n < count; ++n)); do
    wait_for_turn
    try "$n" ${changes[$(((2 * n + 1) * ${#changes[@]} / (2 * count)))]} &
done
wait

killed=$(results_like "killed") by_number=$(results_like "killed by the golden number") survived=$(results_like "survived")
echo "$count mutants of ${#changes[@]}: $(results_like "does not build") do not build, $(results_like "same code") are the same code,"
echo "$killed killed by tests, $by_number by the golden number before the slow ones, $survived survived, $(results_like "explained") more as explained"
[ $((100 * (killed + by_number))) -ge $((97 * (killed + by_number + survived))) ]
