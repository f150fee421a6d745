# For scripts that prove something on a bare Debian 12, in a chroot. They source it before all else: it runs them as root,
# in a mount namespace of their own, so that the chroot's /proc goes with them however they end.

((EUID == 0)) || { echo "${0##*/}: debootstrap and chroot need root; run it with sudo" >&2 && exit 1; }
[[ -n ${IN_OWN_MOUNTS-} ]] || IN_OWN_MOUNTS=1 exec unshare --mount "$0" "$@"

release=bookworm

say() { printf '%4d s  %s\n' "$SECONDS" "$*"; }
# Nothing of this machine's environment gets in.
inside() { env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LANG=C.UTF-8 chroot "$root" bash -euc "$*"; }

leave() {
    local status=$?
    mountpoint -q "$root/proc" && umount "$root/proc"
    if ((status == 0)); then
        rm -rf --one-file-system "$root"
    else
        echo "${0##*/}: FAILED; the chroot is kept in $root" >&2
    fi
}

# Main archive of this machine's apt, be it Debian's or a mirror.
mirror_of_apt() {
    apt-get indextargets --format '$(REPO_URI) $(CODENAME) $(COMPONENT)' 'Created-By: Packages' |
        awk -v codename="$release" '$2 == codename && $3 == "main" { print $1; exit }'
}

# make_bare_debian FOLDER MIRROR PACKAGE,...: a chroot in FOLDER, its name in $root; removed at the end, unless something failed.
make_bare_debian() {
    local mirror=$2 settings certificate
    [[ -n $mirror ]] || mirror=$(mirror_of_apt)
    if [[ -z $mirror ]]; then
        echo "${0##*/}: this machine's apt has no archive of $release; name one with --mirror URL" >&2
        exit 2
    fi
    root=$(mktemp -d "$1/bare-debian-XXXXXX")
    chmod 755 "$root" # for its users, as any root folder
    trap leave EXIT
    trap 'exit 1' INT TERM

    say "debootstrap $release from $mirror"
    debootstrap --variant=minbase --include="$3" "$release" "$root" "$mirror" >"$root.log" 2>&1 || {
        cat "$root.log"
        exit 1
    }
    rm -f "$root.log"
    for settings in /etc/apt/apt.conf /etc/apt/apt.conf.d/*proxy*; do
        [[ -e $settings ]] && cp "$settings" "$root$settings"
    done
    echo '127.0.0.1 localhost' >"$root/etc/hosts" # as the installer does
    mount -t proc proc "$root/proc"
    # Certificates that stand between this machine and registries.
    for certificate in /usr/local/share/ca-certificates/*.crt; do
        [[ -e $certificate ]] && cp "$certificate" "$root$certificate"
    done
    inside update-ca-certificates >/dev/null 2>&1
}
