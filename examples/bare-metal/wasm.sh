#!/usr/bin/env bash
# Builds the programs for WebAssembly, runs them in node, and compares their traces with this machine's, bit by bit.
# Exit status: 0 equal, 77 skipped for want of a tool, else failed.
set -euo pipefail
cd "$(dirname "$0")"
. ./debian-rust.sh

need cargo rustc node
build_for wasm32-unknown-unknown wasm
traces_of_host
node wasm/run.mjs "$built/wasm.wasm" >"$target/wasm.trace"
compare "$target/wasm.trace"
