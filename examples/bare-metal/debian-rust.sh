# Read by the scripts beside it: a compiler with the source of its libraries, which the stock toolchain
# has not. Debian packages one; it is unpacked below the target folder, nothing is installed.
# shellcheck disable=SC2034 # what is set here, those scripts read

. ../../tests/external/need.sh

target=${CARGO_TARGET_DIR:-$PWD/target}
unpacked=$target/debian-rust

# The package of which a package depends whose name begins as told.
dependency() {
  apt-cache depends "$1" | sed -n "s/^ *Depends: \($2.*\)/\1/p" | head -n 1
}

unpack() {
  need apt-get apt-cache dpkg
  local library llvm version packages archive
  version=$(apt-cache policy rustc-web | sed -n 's/^ *Candidate: //p')
  case $version in
    '' | '(none)') skip "Debian's package rustc-web is not known here; apt-get update may help" ;;
  esac
  dpkg --compare-versions "$version" ge 1.89 || skip "rustc-web $version is older than 1.89; apt-get update may help"
  library=$(dependency libstd-rust-web-dev libstd-rust-web-)
  llvm=$(dependency "$library" libllvm)
  packages=(rustc-web rust-web-src libstd-rust-web-dev "$library" "$llvm" "$(dependency "$llvm" libz3)")
  printf 'unpacking %s, version %s\n' "${packages[*]}" "$version"
  rm -rf "$unpacked" "$unpacked.part"
  mkdir -p "$unpacked.part/packages"
  (cd "$unpacked.part/packages" && apt-get -qq -o APT::Sandbox::User=root download "${packages[@]}") || skip "the packages cannot be downloaded"
  for archive in "$unpacked.part/packages"/*.deb; do
    dpkg -x "$archive" "$unpacked.part"
  done
  rm -r "$unpacked.part/packages"
  mv "$unpacked.part" "$unpacked"
}

# Runs a command whose cargo uses that compiler: the libraries of Rust that are built for the target, the command, its arguments.
with_debian() {
  local libraries=$1
  shift
  [[ -d $unpacked ]] || unpack
  env LD_LIBRARY_PATH="$unpacked/usr/lib/$(uname -m)-linux-gnu" \
    RUSTC="$unpacked/usr/bin/rustc" RUSTC_BOOTSTRAP=1 CARGO_TARGET_DIR="$target/debian" CARGO_UNSTABLE_BUILD_STD="$libraries" "$@"
}

# Runs a command of cargo with that compiler: the libraries of Rust, the command, its arguments.
debian_cargo() {
  local libraries=$1 verb=$2
  shift 2
  with_debian "$libraries" cargo "$verb" --locked "$@"
}

# Sets `tools` to the folder of the stock toolchain's linker, which links for a target from now on.
link_for() {
  local host
  host=$(rustc -vV | sed -n 's/^host: //p')
  tools=$(rustc --print sysroot)/lib/rustlib/$host/bin
  [[ -x $tools/rust-lld ]] || skip "the stock toolchain has no rust-lld"
  export "CARGO_TARGET_$(tr a-z- A-Z_ <<<"$1")_LINKER=$tools/rust-lld"
}

# Gives that compiler what static programs for musl are linked with, and what rustup's target of this name has: Debian's C library,
# LLVM's unwinder, and the beginning and end of a program by GCC.
link_musl() {
  local triple=$1 processor folder part packages archive apt
  link_for "$triple"
  [[ -d $unpacked ]] || unpack
  folder=$unpacked/usr/lib/rustlib/$triple/lib/self-contained
  [[ ! -d $folder ]] || return 0
  case $triple in
    x86_64-*) processor=amd64 ;;
    aarch64-*) processor=arm64 ;;
  esac
  part=$unpacked/$triple.part
  rm -rf "$part"
  mkdir -p "$part/lists/partial" "$part/packages" "${folder%/*}"
  # Lists of its own, since this machine's have packages for its own processor alone.
  apt=(-o "APT::Architectures::=$(dpkg --print-architecture)" -o "APT::Architectures::=$processor" -o "Dir::State::Lists=$part/lists"
    -o "Dir::Cache=$part" -o APT::Sandbox::User=root)
  apt-get -qq "${apt[@]}" update || skip "the lists of packages for $processor cannot be downloaded"
  mapfile -t packages < <(printf '%s\n' musl-dev
    for name in libunwind libgcc; do
      apt-cache "${apt[@]}" search --names-only "^$name-[0-9]+-dev\$" | sed 's/ .*//' | sort -V | head -n 1
    done)
  (cd "$part/packages" && apt-get -qq "${apt[@]}" download "${packages[@]/%/:$processor}") || skip "the packages for $triple cannot be downloaded"
  for archive in "$part/packages"/*.deb; do
    dpkg -x "$archive" "$part"
  done
  mkdir "$part/found"
  find "$part/usr" \( -name 'crt*.o' -o -name '*crt1.o' -o -path '*-musl/lib*.a' -o -path '*/llvm-*/libunwind.a' \) -exec cp {} "$part/found" \;
  # The unwinder is of another C library: it prints by this function before it aborts.
  LD_LIBRARY_PATH=$(rustc --print sysroot)/lib "$tools/rust-objcopy" --redefine-sym __fprintf_chk=abort "$part/found/libunwind.a"
  mv "$part/found" "$folder"
  rm -r "$part"
}

# Builds a package for a target by a profile, with those libraries of Rust's that are told; the stock toolchain's linker
# links it.
build_for() {
  local triple=$1 package=$2 profile=${3:-release} libraries=${4:-core}
  link_for "$triple"
  debian_cargo "$libraries" build --profile "$profile" --target "$triple" --package "$package"
  built=$target/debian/$triple/$profile
}

# The traces of this machine, made by the stock toolchain.
traces_of_host() {
  CARGO_TARGET_DIR=$target cargo run --release --locked --quiet --package host >"$target/host.trace"
}

# Ends with an error unless both traces are the same to the byte.
compare() {
  local trace=$1
  cmp "$target/host.trace" "$trace" || { echo "the traces DIFFER" >&2; exit 1; }
  printf 'traces equal: %d control cycles\n' "$(wc -l <"$trace")"
}
