# shellcheck shell=bash
# A service that crashes comes back however often: at once when it had lived for a while or crashes for the first time,
# and then after growing pauses, so that one that always crashes leaves the machine to the others. To be sourced by what
# starts it (scripts/lib/launch.sh writes that), with one argument: the file that remembers its starts, which holds how
# often it crashed in a row, and when it was started last, or will be (hundredths of a second since boot).
# Supervisor's own pauses are not used: it gives up after so many, and takes codes that say "not again" for crashes.
lived=1000 # one that lived so long begins anew; as all times here in hundredths of a second
crashes=0 started=0
{ read -r crashes started _ <"$1"; } 2>/dev/null || true
[[ $crashes =~ ^[0-9]{1,6}$ && $started =~ ^[0-9]{1,12}$ ]] || { crashes=0 started=0; }
read -r now _ </proc/uptime
now=${now/./}
pause=0
if ((started == 0 || now - started >= lived)); then
  crashes=0
else
  crashes=$((crashes + 1))
  # 0, 1, 2, 4, 8 and then 10 s: whatever is over leaves it ready within 15 s.
  if ((crashes > 1)); then pause=$((crashes > 5 ? 10 : 1 << (crashes - 2))); fi
fi
printf '%d %d\n' "$crashes" $((now + 100 * pause)) 2>/dev/null >"$1" || true
if ((pause > 0)); then
  printf 'crashed %d times in a row: started again in %d s\n' "$crashes" "$pause" >&2
  sleep "$pause"
fi
# What stands in the log before this line was said by another process (scripts/lib/stack-health.sh).
printf -- '-- started %(%F %T)T, process %d\n' -1 $$
