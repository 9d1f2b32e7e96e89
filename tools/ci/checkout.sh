# shellcheck shell=bash
# Shared by the steps of action.yml: what they refuse, and what they don't take from a checkout. Sourced.

fail() {
    printf '::error title=campuswalk::%s\n' "$1"
    exit 2
}

# Whether a path, or what it leads to, is in the checkout, whose files anybody may have written.
in_checkout() {
    local path root
    for path in "$(realpath --canonicalize-missing --no-symlinks -- "$1")" "$(realpath --canonicalize-missing -- "$1")"; do
        for root in "$GITHUB_WORKSPACE" "$(realpath --canonicalize-missing -- "$GITHUB_WORKSPACE")"; do
            [[ $path/ != "${root%/}"/* ]] || return 0
        done
    done
    return 1
}
