#!/usr/bin/env bash
# Mutants: how many small faults in src/*.cpp the tests notice. Makes one change at a time (see mutate.cpp), rebuilds
# and runs the tests, without the demos', and then the golden program. Survivors must be listed in survivors.txt, with
# the reason why the change cannot be seen; of the others at least 97 % must be killed.
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
link="${CXX:-g++} -pthread $(command -v ld.lld >/dev/null && echo -fuse-ld=lld)"

wait_for_turn() { while [ "$(jobs -rp | wc -l)" -ge "$jobs_at_once" ]; do wait -n || true; done; }

build_all() {
    mkdir "$work/src" "$work/tests" "$work/golden"
    $compile "$root/tests/mutation/mutate.cpp" -o "$work/mutate"
    local source folder
    for source in "$root"/src/*.cpp "$root"/tests/golden/*.cpp "$root"/tests/*/*_test.cpp; do
        folder=tests
        case $source in "$root"/src/*) folder=src ;; */golden/*) folder=golden ;; esac
        wait_for_turn
        $compile -DCYCLONE_TEST_DATA="\"$root/tests/data\"" -c "$source" \
            -o "$work/$folder/$(basename "$source" .cpp).o" &
    done
    wait
}

# The tests of the header that the source belongs to, to be run first.
nearest_tests() { # name of the source
    sed -nE 's/^(TEST|TEST_F|TEST_P)\((\w+),.*/*\2.*/p' "$root"/tests/*/"$1_test.cpp" 2>/dev/null | sort -u | paste -sd:
}

passes() { # program arguments…
    (ulimit -v 8000000; cd "$work" && timeout 180 "$@") >/dev/null 2>&1
}

# Writes what becomes of the mutant to its result.
try() { # number of the mutant, name of the source, number of its change
    local at=$work/mutant$1 objects
    mkdir "$at"
    "$work/mutate" "$root/src/$2.cpp" "$3" >"$at/$2.cpp" 2>"$at/change"
    objects=$(printf '%s\n' "$work"/src/*.o | grep -v "/$2.o$")
    if ! $compile -c "$at/$2.cpp" -o "$at/$2.o" 2>/dev/null; then
        echo "does not build" >"$at/result"
    elif cmp -s "$at/$2.o" "$work/src/$2.o"; then
        echo "same code" >"$at/result"
    elif ! $link $objects "$at/$2.o" "$work"/tests/*.o "$work"/golden/{scene,bodies,vehicles}.o -lgtest -lgtest_main -o "$at/tests" 2>/dev/null ||
        ! $link $objects "$at/$2.o" "$work"/golden/*.o -o "$at/golden" 2>/dev/null; then
        echo "does not build" >"$at/result"
    elif ! passes "$at/tests" --gtest_fail_fast --gtest_filter="$(nearest_tests "$2")" ||
        ! passes "$at/tests" --gtest_fail_fast; then
        echo "killed" >"$at/result"
    elif ! passes "$at/golden"; then
        echo "killed by the golden number" >"$at/result"
    elif grep -qxF -f "$at/change" "$root/tests/mutation/survivors.txt"; then
        echo "explained" >"$at/result"
    else
        echo "survived" >"$at/result"
        echo "survived: $2.cpp: $(cat "$at/change")"
    fi
    rm -f "$at"/*.o "$at/tests" "$at/golden"
}

results_like() { grep -lx "$1" "$work"/mutant*/result | wc -l; }

build_all
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
echo "$killed killed, $by_number more by the golden number alone, $survived survived, $(results_like "explained") more as explained"
[ $((100 * (killed + by_number))) -ge $((97 * (killed + by_number + survived))) ]
