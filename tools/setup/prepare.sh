# Shared by tools/run and tools/test: installs what is missing and says one line a stage. Sourced.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
build=$root/build/release

fail() {
    printf '%s: %s\n' "$(basename "$0")" "$1" >&2
    exit 3
}

# quietly STAGE COMMAND…: a line for the stage; the command's output only when it fails.
quietly() {
    local stage=$1 log=$root/build/setup.log
    shift
    mkdir -p "$root/build"
    printf '== %s\n' "$stage" >&2
    if ! "$@" >"$log" 2>&1; then
        cat "$log" >&2
        fail "$stage failed; its output is above"
    fi
}

# install_missing LIST…: packages named in the lists that dpkg doesn't know as installed.
install_missing() {
    local wanted missing=() sudo=() package
    mapfile -t wanted < <(cat "$@")
    command -v dpkg-query >/dev/null || fail "this set-up knows Debian 12; elsewhere install: ${wanted[*]}"
    for package in "${wanted[@]}"; do
        [[ $(dpkg-query -W -f '${Status}' "$package" 2>/dev/null) == "install ok installed" ]] || missing+=("$package")
    done
    [[ ${#missing[@]} -eq 0 ]] && return
    if [[ $EUID -ne 0 ]]; then
        command -v sudo >/dev/null || fail "run as root: apt-get install ${missing[*]}"
        sudo=(sudo)
    fi
    quietly "updating the package lists" "${sudo[@]}" apt-get update -q
    quietly "installing ${#missing[@]} packages" "${sudo[@]}" env DEBIAN_FRONTEND=noninteractive \
        apt-get install -y -q --no-install-recommends "${missing[@]}"
}

# configure_and_build [CMAKE ARGS…]
configure_and_build() {
    if [[ ! -f $build/build.ninja || $# -gt 0 ]]; then
        quietly "configuring" cmake -S "$root" --preset release "$@"
    fi
    if ! cmake --build "$build" -- -n | grep -q 'no work to do'; then
        printf '== building\n' >&2
        cmake --build "$build" >&2 || fail "the build failed; its output is above"
    fi
}
