# shellcheck shell=bash
# Small Debian systems to build and to try packages in. Sourced by tools/package and its test after tools/setup/prepare.sh.
#
# mmdebstrap makes them, in the mode that this user can (root, else unshare); they are kept as archives for a day. Commands
# run in one in a mount and process namespace of their own, where a user needs a range of ids in /etc/subuid.

# shellcheck disable=SC2154  # of prepare.sh
roots=$root/build/packaging/roots

# Prints apt's lines for a release of Debian, with the mirrors that this machine uses.
debian_sources() {
    local suite=$1
    # shellcheck disable=SC2016  # apt's fields
    apt-get indextargets --format '$(REPO_URI) $(CODENAME) $(COMPONENT)' 'Created-By: Packages' 'Origin: Debian' |
        sort -u | while read -r mirror codename component; do
        case $codename in
            bookworm) printf 'deb %s %s %s\n' "$mirror" "$suite" "$component" ;;
            bookworm-updates | bookworm-security)
                [[ $suite != bookworm ]] || printf 'deb %s %s %s\n' "$mirror" "$codename" "$component" ;;
        esac
    done
}

# make_root NAME SUITE [PACKAGES…]: build/packaging/roots/NAME.tar, with apt and these packages.
make_root() {
    local name=$1 suite=$2 archive=$roots/$1.tar wanted include=()
    shift 2
    wanted="$suite $*"
    [[ $# -eq 0 ]] || include=("--include=$(tr ' ' ',' <<<"$*")")
    if [[ -f $archive && -n $(find "$archive" -mtime -1) && $(cat "$archive.wanted" 2>/dev/null) == "$wanted" ]]; then
        return
    fi
    mkdir -p "$roots"
    rm -f "$archive.wanted"
    debian_sources "$suite" >"$roots/$name.list"
    [[ -s $roots/$name.list ]] || fail "apt names no mirror of Debian 12 on this machine"
    # Not Debian's default of a sync for each file; apt's lists stay, so that packages can be installed later.
    quietly "making a root of $suite: $name" mmdebstrap --variant=apt "${include[@]}" --dpkgopt=force-unsafe-io \
        --skip=cleanup/apt/lists "$suite" "$archive" "$roots/$name.list"
    printf '%s' "$wanted" >"$archive.wanted"
}

# in_root NAME FOLDER COMMAND…: runs a command as root in a fresh copy of a root, with FOLDER as /exchange.
in_root() {
    local name=$1 folder=$2 namespaces=(--mount --pid --fork --kill-child) scratch failed=0
    shift 2
    [[ $EUID -eq 0 ]] || namespaces+=(--user --map-root-user --map-auto)
    mkdir -p "$root/build/packaging"
    scratch=$(mktemp -d "$root/build/packaging/$name.XXXXXX")
    # shellcheck disable=SC2016  # expanded inside
    unshare "${namespaces[@]}" bash -euc '
        scratch=$1 archive=$2 folder=$3
        shift 3
        chmod 755 "$scratch"
        tar -C "$scratch" --exclude=./dev -xf "$archive"
        mkdir -p "$scratch/dev" "$scratch/exchange"
        mount --rbind /dev "$scratch/dev"
        mount -t proc proc "$scratch/proc"
        mount --bind "$folder" "$scratch/exchange"
        cp -L /etc/resolv.conf /etc/hosts "$scratch/etc/"
        exec chroot "$scratch" /usr/bin/env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 \
            DEBIAN_FRONTEND=noninteractive "$@"
    ' in_root "$scratch" "$roots/$name.tar" "$folder" "$@" || failed=$?
    # The mounts ended with the namespace. What another id owns is removed as that id.
    unshare "${namespaces[@]}" rm -rf --one-file-system "$scratch"
    return "$failed"
}
