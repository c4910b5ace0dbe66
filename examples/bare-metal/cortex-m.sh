#!/usr/bin/env bash
# Builds the programs for a Cortex-M4, looks for panics and allocators in them, runs them under QEMU, and compares
# their traces with this machine's, bit by bit. Exit status: 0 equal, 77 skipped for want of a tool, else failed.
set -euo pipefail
cd "$(dirname "$0")"
. ./debian-rust.sh

need cargo rustc qemu-system-arm readelf
build_for thumbv7em-none-eabihf cortex-m4
firmware=$built/cortex-m4

symbols=$(readelf --wide --symbols "$firmware")
grep -q ' main$' <<<"$symbols" || { echo "$firmware has no symbols to look at" >&2; exit 1; }
# What core, alloc and the language's own hooks call their panics and allocators.
if grep -E 'panic|unwrap_failed|expect_failed|index_fail|rust_begin_unwind|__rust_(no_)?alloc|__rust_(de|re)alloc|malloc' <<<"$symbols"; then
  echo "a panic or an allocator is left" >&2
  exit 1
fi
printf 'no panic and no allocator among %d functions\n' "$(grep -c ' FUNC ' <<<"$symbols")"

traces_of_host
# With -icount shift=5 an instruction takes 2^5 ns; a tick of the board's timer, at 25 MHz, takes 40 ns.
timeout 1800 qemu-system-arm -M mps2-an386 -cpu cortex-m4 -icount shift=5 -nographic -monitor none -serial none \
  -semihosting-config enable=on,target=native -kernel "$firmware" >"$target/cortex-m.trace" 2>"$target/cortex-m.report" ||
  { cat "$target/cortex-m.report" >&2; exit 1; }
awk '/ticks of a cycle/ {
  printf "%s instructions of a cycle, program, controller and simulated robot: %d on average, %d at most\n", $1, $6 * 40 / 32, $9 * 40 / 32
  next
} 1' "$target/cortex-m.report"
compare "$target/cortex-m.trace"

readelf --wide --sections "$firmware" | sed 's/\[ */[/' |
  while read -r _ name _ _ _ size _; do
    case $name in
      .text | .rodata | .data | .bss) printf 'bytes of %s: %d\n' "$name" "0x$size" ;;
    esac
  done
