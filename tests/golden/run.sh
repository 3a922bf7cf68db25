#!/usr/bin/env bash
# Same input, same bits: builds the library and the golden scene with several compilers, at several levels of
# optimisation, for several processors, and runs each. One line per configuration; exit status 0 if all give
# the golden number and write the same snapshot, byte by byte, which each has gone on from. Needs on Debian:
# g++, clang, qemu-user-static, g++-{aarch64,riscv64,s390x,i686}-linux-gnu, g++-arm-linux-gnueabihf, nodejs, lld,
# libc++-dev-wasm32, libclang-rt-dev-wasm32.
set -eu
root=$(cd "$(dirname "$0")/../.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# The emulator, if any, before the colon; compiler and options after it.
wasm="node --no-warnings --experimental-wasi-unstable-preview1 $root/tests/golden/wasi.mjs"
configurations=(
    ": g++ -O0"
    ": g++ -O3 -march=native -flto"
    ": clang++ -O3 -march=native -flto"
    "qemu-aarch64-static: aarch64-linux-gnu-g++ -O2 -static"
    "qemu-riscv64-static: riscv64-linux-gnu-g++ -O2 -static"
    "qemu-s390x-static: s390x-linux-gnu-g++ -O2 -static"  # big-endian
    "qemu-arm-static: arm-linux-gnueabihf-g++ -O2 -static -Wno-psabi"
    "qemu-i386-static: i686-linux-gnu-g++ -O2 -static -msse2 -mfpmath=sse"
    "$wasm: clang++ --target=wasm32-wasi --sysroot=/usr -O2 -fno-exceptions"
)
flags="-std=c++17 -ffp-contract=off -fno-math-errno -I$root/include"

# In one piece, as some games build: it takes a third of the time.
threads=$work/threads.cpp
no_threads=$work/nothreads.cpp
printf '#include "%s"\n' "$root"/src/*.cpp "$root"/tests/golden/*.cpp >"$threads"
sed "s#$root/src/jobs.cpp#$root/tests/golden/nothreads/jobs.cpp#" "$threads" >"$no_threads"

build() { # program compiler options…
    local program=$1
    shift
    case "$*" in
        *wasm32*) "$@" $flags "$no_threads" -o "$program" ;;
        *) "$@" $flags -pthread "$threads" -o "$program" ;;
    esac
}

# Writes "same" or what went wrong to its result.
check() { # number emulator compiler options…
    local program=$work/golden$1 snapshot=$work/snapshot$1 log=$work/log$1 result=$work/result$1 emulator=$2
    shift 2
    if ! build "$program" "$@" >"$log" 2>&1; then
        echo "does not build" >"$result"
    elif ! timeout 300 $emulator "$program" --snapshot "$snapshot" >"$log" 2>&1; then
        echo "differs or fails" >"$result"
    else
        echo "same" >"$result"
    fi
}

jobs_at_once=$(nproc)
for n in "${!configurations[@]}"; do
    while [ "$(jobs -rp | wc -l)" -ge "$jobs_at_once" ]; do wait -n; done
    check "$n" "${configurations[$n]%%:*}" ${configurations[$n]#*: } &
done
wait

failures=0
for n in "${!configurations[@]}"; do
    result=$(cat "$work/result$n")
    [ "$result" != same ] || cmp -s "$work/snapshot0" "$work/snapshot$n" || result="writes another snapshot"
    printf '%-66s %s\n' "${configurations[$n]#*: }" "$result"
    [ "$result" = same ] && continue
    failures=$((failures + 1))
    tail -n 20 "$work/log$n"
done

# Arithmetic that is not exact is refused.
for options in "g++ -ffast-math" "g++ -Ofast" "g++ -ffinite-math-only" "clang++ -ffast-math" "clang++ -Ofast"; do
    if $options $flags -fsyntax-only "$root/tests/golden/golden.cpp" >"$work/refusal" 2>&1 ||
        ! grep -q "error.*Cyclone" "$work/refusal"; then
        printf '%-66s %s\n' "$options" "is not refused"
        failures=$((failures + 1))
    else
        printf '%-66s %s\n' "$options" "refused"
    fi
done

if [ $failures -gt 0 ]; then
    echo "Same input, same bits: $failures failures"
    exit 1
fi
echo "Same input, same bits: ${#configurations[@]} configurations agree"
