# Joins supervisor's words (the input: an array) with what was heard on the bus ($heard: an array of one report as
# bus-census or stack-watch gives it, or of none) and the logs' last complaints ($complaints: lines of service, tab,
# complaint). $supervisor is "alive" or "dead". The first line is `well` or `wrong`; then comes, where $json is "yes",
# {"heard", "bus", "supervisor", "watch", "services": [...]}, `wrong` listing what is wrong with each, or else a table, a
# line a service, with tabs.

def ms: if . == null then "-" else . * 1000 | round | tostring end;
def hz: if . == null then "-" else . * 10 | round / 10 | tostring end;
# What came over the bus or from a log must not steer a terminal.
def printable: gsub("\\p{Cc}"; "?");
def count: if . == null then "-" else tostring end;
def duration: floor | [. / 3600, . % 3600 / 60, . % 60] | map(floor)
  | "\(.[0]):\(.[1] + 100 | tostring[1:]):\(.[2] + 100 | tostring[1:])";

($complaints | split("\n") | map(split("\t") | {(.[0] // ""): (.[1] // "")}) | add // {}) as $complaint_of
| $heard[0] as $heard
| ($heard.host) as $host
# Of many robots' services and channels, only these are looked at below.
| (map(.name) | unique) as $names
| [$heard.services[]? | select(.name as $name | $names | index($name))] as $words
| {heard: ($heard != null), bus: ($heard.url), $supervisor, watch: $heard.watch, services: map(
    . as $process
    # Where several claim to be this process, the one that has said most.
    | ([$words[] | select(.name == $process.name and .host == $host and .pid == $process.pid)] | max_by(.heard)) as $word
    | [$heard.channels[]? | . as $channel
        | select($word != null and ($word.writes | index($channel.channel)))] as $writes
    # Supervisor calls a process running once it has lived for a second; its own word counts for more.
    | (if .state == "STARTING" and $word != null then "RUNNING" else .state end) as $state
    | ($state == "RUNNING" or $state == "ORPHAN") as $lives
    | {
        name, state: $state, pid, uptime_s, spawn_error,
        says: $word.state, says_for_s: $word.state_for_s, reason: $word.reason,
        # What was said before it fell silent does not count: each speaks once a second.
        ready: (if $heard == null then null else $word.ready == true and $word.silent_s < 3 end),
        silent_s: $word.silent_s, crashes, next_start_s,
        hz: ([$writes[].hz] | max),
        age_s: ([$word.channels[]?.age_s | select(. >= 0)] | max),
        lost: (if $word then [$word.channels[].lost] | add // 0 else null end),
        skipped: (if $word then [$word.channels[].skipped] | add // 0 else null end),
        refused: (if $word then [$word.channels[] | .refused + .decode_failures] | add // 0 else null end),
        latency_p99_s: ([$word.channels[]?.latency_p99_s] | max),
        version: $word.version, config_hash: $word.config_hash, session: $word.session,
        writes: [$writes[] | {channel, hz, bytes_per_s}], channels: ($word.channels // []),
        last_complaint: ($complaint_of[.name] // ""),
        wrong: [
          (if $state == "BACKOFF" then "crashed \(.crashes) times in a row" +
             (if .next_start_s then ", is started again in \(.next_start_s | ceil) s" else "" end)
           elif $lives | not then
             "does not run" + (if .spawn_error != "" then ": " + .spawn_error elif $state == "EXITED" then
               " (exit code \(.exit_code))" else "" end)
           else empty end),
          (if $state == "ORPHAN" then "has no supervisor" else empty end),
          (if $lives and $heard != null and $word == null then "says nothing on the bus" else empty end),
          (if $lives and $word.silent_s >= 3 then "has said nothing on the bus for \($word.silent_s | floor) s" else empty end),
          (if $word and ($word.ready | not) then
             "not ready: " + $word.state + (if $word.reason == "" then "" else ": " + $word.reason end) +
               (if $word.state_for_s == null then "" else " (for \($word.state_for_s | floor) s)" end)
           else empty end),
          # Who has run for longer than was listened was not restarted meanwhile: who else speaks is another one.
          ([$words[] | select($word != null and .name == $word.name and .robot == $word.robot
              and .session != $word.session and ($process.uptime_s > $heard.listened_s + 1.5 or $word.duplicate))][0] // empty
            | "another process of this name is on the bus: \(.pid) on \(.host)"),
          ($writes[] | select(.two_writers) | "another one writes \(.channel) too"),
          ($writes[] | select(.several_types) | "\(.channel) carries several types"),
          # Both sides: who writes what this one cannot read, and what this one writes that others cannot.
          ($heard.channels[]? | .channel as $channel | .other_versions[]? | . as $other
            | (any($word.channels[]?; .channel == $channel and .decode_failures > 0)) as $reads
            | select($reads or ($word != null and .session == $word.session))
            | [$heard.services[] | select(.session == $other.session) | "\(.name) (version \(.version)) on \(.host)"][0] as $writer
            | (if $reads then "cannot read \($channel) of \($writer // "one that does not say its name")"
               else "writes \($channel) in a way that others cannot read" end) +
              ": another version of \(.type), \(.hash); ours is \(.our_hash)")
        ]
      }
    | .notes = (.wrong + [
        (if .ready and (.reason // "") != "" then .reason else empty end),
        (if .last_complaint != "" then "log: " + .last_complaint else empty end)] | join("; "))
    | .row = [.name, .state, (if .pid == 0 then "-" else .pid end), (if .pid == 0 then "-" else .uptime_s | duration end),
        (.says // "-" | printable), (.hz | hz), (.age_s | ms), (.lost | count), (.skipped | count), (.refused | count),
        (.latency_p99_s | ms), (.notes | printable)]
  )}
| (if all(.services[]; .wrong == []) then "well" else "wrong" end),
  if $json == "yes" then del(.services[].row)
  else
    (["service", "state", "pid", "uptime", "says", "Hz", "age ms", "lost", "skipped", "refused", "p99 ms", "notes"],
      .services[].row) | @tsv
  end
