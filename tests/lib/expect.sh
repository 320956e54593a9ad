# shellcheck shell=bash
# What the tests that are scripts share: they state what they expect, and count what fails. To be sourced.

# As scripts/lib/project.sh: numbers and times have a point, whatever the language of who is here.
if [[ -n ${LC_ALL-} ]]; then
  export LANG=$LC_ALL
  unset LC_ALL
fi
export LC_NUMERIC=C

failures=0

# A command that ends the test, where nothing was expected of it, is said.
set -E
trap 'if ((BASH_SUBSHELL == 0)); then printf "FAILED  %s, line %d: %s\n" "${BASH_SOURCE[0]##*/}" "$LINENO" "$BASH_COMMAND"; fi' ERR

# expect WHAT COMMAND...: the named behaviour holds when COMMAND succeeds.
expect() {
  local what=$1
  shift
  if "$@"; then
    printf 'ok      %s\n' "$what"
  else
    printf 'FAILED  %s\n' "$what"
    failures=$((failures + 1))
  fi
}

# end_of_test: the test's last command.
end_of_test() {
  trap - ERR
  printf '%d failed\n' "$failures"
  ((failures == 0))
}

not() { ! "$@"; }
quietly() { "$@" >/dev/null; }
equals() { [[ $1 == "$2" ]] || { printf '        got "%s", expected "%s"\n' "$1" "$2"; return 1; }; }

# eventually COMMAND...: COMMAND succeeds within $patience_s (far more than it takes; only a failure waits so long).
patience_s=20
eventually() {
  local end=$((SECONDS + patience_s))
  while ((SECONDS <= end)); do
    if "$@"; then return 0; fi
    sleep 0.1
  done
  return 1
}

# says EXIT_CODE REGEX COMMAND...: it exits so and says, in one line, what matches.
says() {
  local code=$1 regex=$2 text status=0
  shift 2
  text=$("$@" 2>&1 </dev/null) || status=$?
  [[ $status == "$code" && $text =~ $regex && $(wc -l <<<"$text") == 1 ]] ||
    { printf '        exit code %d, and: %s\n' "$status" "$text"; return 1; }
}

# on_a_private_network SCRIPT ARGUMENT...: starts the test again on a network of its own, whichever it was on; returns
# where it already runs there. It must not be called within another test.
on_a_private_network() {
  if [[ ${TEST_NETWORK-} == own ]]; then return; fi
  unset MARKSERVO_PRIVATE_NETWORK MARKSERVO_LCM_URL
  TEST_NETWORK=own exec "$(dirname -- "${BASH_SOURCE[0]}")/../../scripts/private-network" "$@"
}
