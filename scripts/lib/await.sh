# shellcheck shell=bash
# Waiting for a job and passing signals on to it. To be sourced.

# await JOB FORWARD: waits for the background job with process id JOB and returns its exit status. A signal that comes
# meanwhile calls `FORWARD SIGNAL JOB`.
await() {
  local signal status interrupted=yes
  for signal in HUP INT QUIT TERM USR1 USR2; do
    # shellcheck disable=SC2064 # to be filled in now
    trap "interrupted=yes; $2 $signal $1" "$signal"
  done
  # A signal ends `wait` early; only an undisturbed one tells the job's own status.
  while [[ $interrupted == yes ]]; do
    interrupted=no
    status=0
    wait "$1" || status=$?
  done
  return "$status"
}
