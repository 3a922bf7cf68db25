#!/usr/bin/env bash
# Fuzzes each target for so many seconds (30 by default) from the committed corpus, with the address and
# undefined-behaviour sanitizers. Needs clang++ with its runtime (Debian: libclang-rt-14-dev). An input that fails is
# printed in base64 and, where a build folder is given, left there as crash-*; <target> crash-* runs it again. The seed
# is the same each time, so that a change is judged by the inputs that the one before it met; SEED=0 draws one.
#
#     [SEED=n] tests/fuzz/run.sh [seconds] [build folder]
set -euo pipefail
seconds=${1:-30}
root=$(cd "$(dirname "$0")/../.." && pwd)
work=${2:-$(mktemp -d)}
[ $# -ge 2 ] || trap 'rm -rf "$work"' EXIT
mkdir -p "$work"

flags=(-std=c++17 -O1 -g -ffp-contract=off -fno-omit-frame-pointer -I"$root/include" -I"$root/src"
    -fno-sanitize-recover=all)
for source in "$root"/src/*.cpp; do
    printf '%s\0' "$source"
done | xargs -0 -P 2 -I{} bash -c 'source=$1 work=$2; shift 2
    clang++ "$@" -c "$source" -o "$work/$(basename "$source").o"' _ {} "$work" "${flags[@]}" \
    -fsanitize=fuzzer-no-link,address,undefined

fuzz() { # target
    clang++ "${flags[@]}" -fsanitize=fuzzer,address,undefined "$root/tests/fuzz/$1.cpp" "$work"/*.o -pthread \
        -o "$work/$1"
    mkdir -p "$work/corpus/$1"
    cd "$work"
    "./$1" -seed="${SEED:-1}" -max_total_time="$seconds" -timeout=30 -rss_limit_mb=1500 -max_len=600 -verbosity=0 \
        -print_final_stats=1 "corpus/$1" "$root/tests/fuzz/corpus/$1"
}

# Two at a time.
failures=0
for pair in "calls precision" "snapshots inertia"; do
    started=()
    for target in $pair; do
        fuzz "$target" >"$work/$target.log" 2>&1 &
        started+=($!)
    done
    for job in "${started[@]}"; do wait "$job" || failures=$((failures + 1)); done
    for target in $pair; do
        echo "== $target, $seconds s"
        cat "$work/$target.log"
    done
done
exit $((failures > 0))
