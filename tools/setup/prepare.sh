# shellcheck shell=bash
# Shared by tools/run, tools/test and the checks: installs what is missing, configures, builds; says a line
# a stage and nothing about what is done already. Sourced by scripts in tools/ and .ci/.

root=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../.." && pwd)

say() {
    printf '== %s\n' "$1" >&2
}

fail() {
    printf '%s: %s\n' "$(basename "$0")" "$1" >&2
    exit 3
}

# Says how long a stage has been going on: every second on a terminal, every half minute elsewhere.
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

# quietly STAGE COMMAND…: a line for the stage; the command's output only when it fails.
quietly() {
    local stage=$1 log=$root/build/setup.log failed=0 clock
    shift
    mkdir -p "$root/build"
    say "$stage"
    show_time "$stage" >/dev/null &
    clock=$!
    # shellcheck disable=SC2064  # the value of now
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

# install_missing LIST…: the packages named in the lists that aren't installed.
install_missing() {
    local wanted missing sudo=()
    wanted=$(sort -u "$@")
    if ! command -v dpkg-query >/dev/null; then
        command -v cmake >/dev/null ||
            fail "this set-up knows Debian 12; elsewhere install what these packages hold: ${wanted//$'\n'/ }"
        return
    fi
    # shellcheck disable=SC2086  # a word a package; unknown ones are missing ones
    missing=$(comm -23 <(printf '%s\n' $wanted) <(
        dpkg-query -W -f '${db:Status-Abbrev}${Package}\n' $wanted 2>/dev/null | sed -n 's/^[ih]i //p' | sort -u))
    [[ -n $missing ]] || return 0
    command -v apt-get >/dev/null || fail "install these Debian packages: ${missing//$'\n'/ }"
    if [[ $EUID -ne 0 ]]; then
        command -v sudo >/dev/null || fail "run as root: apt-get install ${missing//$'\n'/ }"
        say "sudo apt-get install ${missing//$'\n'/ }"
        sudo true || fail "run as root: apt-get install ${missing//$'\n'/ }"
        sudo=(sudo)
    fi
    quietly "updating the package lists" "${sudo[@]}" apt-get update -q
    # shellcheck disable=SC2086
    quietly "installing $(wc -w <<<"$missing") packages and what they need" "${sudo[@]}" env \
        DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends $missing
}

# Whether CMake has to be run: never done, the presets are newer, or a setting differs.
is_configured() {
    local build=$1 setting
    shift
    [[ -f $build/build.ninja && $build/.configured -nt $root/CMakePresets.json ]] || return 1
    for setting in "$@"; do
        setting=${setting#-D}
        grep -q "^${setting%%=*}:[A-Z]*=${setting#*=}\$" "$build/CMakeCache.txt" || return 1
    done
}

# configure PRESET [-DNAME=VALUE…]
configure() {
    local preset=$1 build=$root/build/$1
    shift
    if ! is_configured "$build" "$@"; then
        quietly "configuring $preset" cmake -S "$root" --preset "$preset" "$@"
        touch "$build/.configured"
    fi
}

# build PRESET [TARGET]: with ninja's own progress, and without a word when nothing has changed.
build() {
    local preset=$1 target=${2:-all}
    if ! ninja -C "$root/build/$preset" -n "$target" 2>&1 | grep -q 'no work to do'; then
        say "building $preset"
        cmake --build "$root/build/$preset" --target "$target" >&2 || fail "the build failed; its output is above"
    fi
}
