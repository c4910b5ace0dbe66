# Read by the scripts outside the gate: what they need, and a fresh machine may lack.

# Something needed is not to be had: that is no failure.
skip() {
  printf 'SKIPPED: %s\n' "$@" >&2
  exit 77
}

# Tools, each by the name of its command; `nightly` is a toolchain. All that are missing are named, with what installs them.
need() {
  local tool missing=()
  for tool in "$@"; do
    case $tool in
      nightly) cargo +nightly --version >/dev/null 2>&1 || missing+=("no nightly toolchain is installed: rustup toolchain install nightly") ;;
      cargo-*) command -v "$tool" >/dev/null || missing+=("$tool is not installed: cargo install $tool --locked") ;;
      *) command -v "$tool" >/dev/null || missing+=("$tool is not installed") ;;
    esac
  done
  [[ ${#missing[@]} -eq 0 ]] || skip "${missing[@]}"
}
