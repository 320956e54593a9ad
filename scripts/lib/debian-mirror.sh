# shellcheck shell=bash
# To be sourced, by what makes a Debian 12 in a folder.

# debian_mirror: where this host has its packages of Debian 12 from.
debian_mirror() {
  # shellcheck disable=SC2016 # apt's variable, not the shell's
  apt-get indextargets --format '$(REPO_URI)' 'Created-By: Packages' 'Codename: bookworm' | sed -n 1p | grep . ||
    { printf 'this host has no source of Debian 12 (bookworm)\n' >&2; return 1; }
}
