# shellcheck shell=bash
# Shared by tools/run, tools/test and the checks: installs missing packages, configures, builds; prints one line
# per stage, and nothing for stages that are done already. Sourced by scripts in tools/ and .ci/.

root=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../.." && pwd)

say() {
    printf '== %s\n' "$1" >&2
}

fail() {
    printf '%s: %s\n' "$(basename "$0")" "$1" >&2
    exit 3
}

# Prints how long a stage has been running: every second on a terminal, every half minute elsewhere.
show_time() {
    local stage=$1 start=$SECONDS
    while true; do
        if [[ -t 2 ]]; then
            sleep 1 2>/dev/null
            printf '\r== %s: %d s' "$stage" $((SECONDS - start)) >&2
        else
            sleep 30 2>/dev/null
            printf '   %s: %d s so far\n' "$stage" $((SECONDS - start)) >&2
        fi
    done
}

# quietly STAGE COMMAND…: prints a line for the stage, and the command's output only if it fails.
quietly() {
    local stage=$1 log=$root/build/setup.log failed=0 clock
    shift
    mkdir -p "$root/build"
    say "$stage"
    show_time "$stage" >/dev/null &
    clock=$!
    # shellcheck disable=SC2064  # the current value
    trap "kill $clock 2>/dev/null" EXIT
    "$@" >"$log" 2>&1 || failed=1
    kill $clock
    wait $clock 2>/dev/null || true
    trap - EXIT
    [[ ! -t 2 ]] || printf '\r\033[K' >&2
    if [[ $failed -ne 0 ]]; then
        cat "$log" >&2
        fail "$stage failed; its output is above"
    fi
}

# install_missing LIST…: installs the packages of the lists that aren't installed. Empty names are no lists.
install_missing() {
    local packages missing list lists=() sudo=()
    for list in "$@"; do
        [[ -z $list ]] || lists+=("$list")
    done
    packages=$(sort -u "${lists[@]}")
    if ! command -v dpkg-query >/dev/null; then
        command -v cmake >/dev/null ||
            fail "this setup supports Debian 12; elsewhere install what these packages contain: ${packages//$'\n'/ }"
        return
    fi
    # shellcheck disable=SC2086  # one word per package; unknown ones count as missing
    missing=$(comm -23 <(printf '%s\n' $packages) <(
        dpkg-query -W -f '${db:Status-Abbrev}${Package}\n' $packages 2>/dev/null | sed -n 's/^[ih]i //p' | sort -u))
    [[ -n $missing ]] || return 0
    command -v apt-get >/dev/null || fail "install these Debian packages: ${missing//$'\n'/ }"
    if [[ $EUID -ne 0 ]]; then
        command -v sudo >/dev/null || fail "run as root: apt-get install ${missing//$'\n'/ }"
        say "sudo apt-get install ${missing//$'\n'/ }"
        sudo true || fail "run as root: apt-get install ${missing//$'\n'/ }"
        sudo=(sudo)
    fi
    quietly "updating the package lists" "${sudo[@]}" apt-get update -q
    # Without a sync of each file: npm has hundreds of small packages. If the machine dies meanwhile, install them again.
    # shellcheck disable=SC2086
    quietly "installing $(wc -w <<<"$missing") packages and their dependencies" "${sudo[@]}" env \
        DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends \
        -o Dpkg::Options::=--force-unsafe-io $missing
}

has_viewer_tools() {
    command -v node >/dev/null && command -v npm >/dev/null
}

# Prints the list of what builds the reports' viewer, unless node and npm are there from elsewhere: such a node's package
# may come with npm, and Debian's can't be installed beside it.
viewer_packages() {
    has_viewer_tools || printf '%s\n' "$root/tools/setup/packages-viewer.txt"
}

# Whether CMake has run since the presets changed, and with these settings.
is_configured() {
    local build=$1 setting
    shift
    [[ -f $build/build.ninja && $build/.configured -nt $root/CMakePresets.json ]] || return 1
    for setting in "$@"; do
        setting=${setting#-D}
        grep -q "^${setting%%=*}:[A-Z]*=${setting#*=}\$" "$build/CMakeCache.txt" || return 1
    done
}

# configure PRESET [-DNAME=VALUE…]: runs CMake if necessary.
configure() {
    local preset=$1 build=$root/build/$1
    shift
    if ! is_configured "$build" "$@"; then
        quietly "configuring $preset" cmake -S "$root" --preset "$preset" "$@"
        touch "$build/.configured"
    fi
}

# build PRESET [TARGET]: shows ninja's progress, and prints nothing if nothing has changed.
build() {
    local preset=$1 target=${2:-all}
    if ! ninja -C "$root/build/$preset" -n "$target" 2>&1 | grep -q 'no work to do'; then
        say "building $preset"
        cmake --build "$root/build/$preset" --target "$target" >&2 || fail "the build failed; its output is above"
    fi
}
