# shellcheck shell=bash disable=SC2154 # variables of the sourcing script
# What scripts/doctor asks of the stack: programs, configuration, and who else is on the bus. Each check_ function says
# what it finds by `well` and `wrong`. To be sourced by scripts/doctor.

check_packages() {
  local missing
  missing=$(missing_packages run | paste -sd ' ')
  if [[ -n $missing ]]; then
    # shellcheck disable=SC2086 # a word each
    wrong programs "missing packages: $missing" "$(get_packages $missing)"
  else
    well programs "all packages are installed"
  fi
}

check_executables() {
  local service missing=() targets=() plan
  for service in "${services[@]}" bus-census task-operator; do
    if [[ -x $build_dir/bin/$service ]]; then targets+=("bin/$service"); else missing+=("$service"); fi
  done
  if ((${#missing[@]} > 0)); then
    wrong programs "not built: ${missing[*]} (in $build_dir/bin)" "$get_programs"
  fi
  if [[ $installed == yes && $build_dir == "$default_build_dir" ]]; then
    if ((${#missing[@]} == 0)); then well programs "executables are installed"; fi
  elif [[ ! -f $build_dir/build.ninja ]] || ! command -v ninja >/dev/null; then
    well programs "executables are there; nothing tells whether they are newer than their sources"
  elif ((${#targets[@]} > 0)); then
    # ninja knows what each was made from; it builds nothing here. By its relative name it would first plan to make
    # build.ninja anew, for CMake's globs, and tell no more.
    plan=$(ninja -C "$build_dir" -f "$(realpath -- "$build_dir")/build.ninja" -n "${targets[@]}" 2>&1) || true
    if grep -q 'no work to do' <<<"$plan"; then
      well programs "executables are newer than their sources"
    else
      wrong programs "executables are older than their sources ($(grep -c '^\[' <<<"$plan") steps to build)" \
        "$get_programs"
    fi
  fi
}

# check_settings SERVICE: by the service itself; prints what it objects to, without its own name.
check_settings() {
  local arguments=(--check --robot-file "$robot_file")
  if [[ -f $config_dir/$1.conf ]]; then arguments+=(--config "$config_dir/$1.conf"); fi
  # From the project's folder: settings may name files in it.
  (cd -- "$repository" && "$build_dir/bin/$1" "${arguments[@]}" 2>&1 >/dev/null) | tail -n 1 | sed "s/^$1: //"
  return "${PIPESTATUS[0]}"
}

# mend_for_robot_file: the command that brings back the one that cannot be read, where one does.
mend_for_robot_file() {
  local another="name another with --robot-file" brought=$repository/config/robot.yaml
  if [[ -e $robot_file ]]; then
    printf '%s\n' "chmod a+r ${robot_file@Q}, or $another"
  elif [[ $robot_file == "$brought" ]]; then
    if [[ $installed == yes ]]; then
      printf '%s\n' "$get_programs"
    else
      printf '%s\n' "git -C ${repository@Q} checkout config/robot.yaml, or $another"
    fi
  elif [[ $robot_file == "$default_config_dir/robot.yaml" ]]; then
    printf '%s\n' "cp -- ${brought@Q} ${robot_file@Q}"
  else
    printf '%s\n' "$another"
  fi
}

check_configuration() {
  local service file conf objection wrong_before=$faults mend
  local -A told=()
  if [[ ! -r $robot_file ]]; then
    wrong configuration "$robot_file cannot be read" "$(mend_for_robot_file)"
    return
  fi
  robot_file=$(realpath -s -- "$robot_file") config_dir=$(realpath -s -- "$config_dir")
  for service in "${services[@]}"; do
    if [[ ! -x $build_dir/bin/$service ]]; then continue; fi
    if objection=$(check_settings "$service"); then continue; fi
    # The same fault of robot.yaml is found by all that read it.
    if [[ -n ${told[$objection]-} ]]; then continue; fi
    told[$objection]=yes
    conf=$config_dir/$service.conf
    mend="edit ${robot_file@Q}"
    if [[ -f $conf ]]; then
      if [[ $objection != *"$robot_file"* ]]; then mend="edit ${conf@Q}"; fi
      mend+=", then: ${build_dir@Q}/bin/$service --check --robot-file ${robot_file@Q} --config ${conf@Q}"
    else
      mend+=", then: ${build_dir@Q}/bin/$service --check --robot-file ${robot_file@Q}"
    fi
    wrong configuration "$service: ${objection:-fails without a word}" "$mend"
  done
  for file in "$config_dir"/*.conf; do
    service=$(basename -- "$file" .conf)
    # supervisord.conf is scripts/stack's template.
    if [[ ! -e $file || $service == supervisord || -d $repository/services/$service || -x $build_dir/bin/$service ]]; then continue; fi
    wrong configuration "$file: no service is called $service, so nobody reads it" "rename it to SERVICE.conf, or: rm ${file@Q}"
  done
  if ((faults == wrong_before)); then well configuration "$robot_file and the services' settings are valid"; fi
}

check_versions() {
  local different
  different=$(jq -r '.version as $ours | [.services[] | select(.version != $ours) |
    "\(.name) on \(.host) is \(.version)"] | unique | join(", ")' "$heard_file")
  if [[ -n $different ]]; then
    wrong programs "we are version $(jq -r .version "$heard_file"), but $different" \
      "on that host: $get_this_version"
  else
    well programs "version $(jq -r .version "$heard_file"), as all on the bus"
  fi
}

check_others() {
  local line mend findings_of_others wrong_before=$faults
  findings_of_others=$(jq -r --arg get_this_version "$get_this_version" '
    # Who it is, as far as the bus tells.
    def who($services; $session): first($services[] | select(.session == $session) |
      "\(.name) (version \(.version)) on \(.host)") // "one that does not say its name (session \($session))";
    ([.services[] | select(.duplicate)] | group_by([.robot, .name])[]
      | ["\(length) processes are \(.[0].name): " + (map("\(.pid) on \(.host)") | join(", ")),
         "end all but one: " + (map("kill \(.pid) (on \(.host))") | join(" or "))]),
    (.services as $services | .channels[] | select(.two_writers)
      | [.writers[] | .session as $session | $services[] | select(.session == $session)] as $known
      # Two of one name are told of above.
      | select(([$known[] | select(.duplicate | not)] | length) > 0 or ($known | length) < (.writers | length))
      | ["two write \(.channel), where one may: " +
          ([.writers[] | .service // "one that does not say its name (session \(.session))"] | join(", ")),
         if ($known | length) > 0
         then "end all but one: " + ([$known[] | "kill \(.pid) (\(.name) on \(.host))"] | join(" or "))
         else "build/release/bin/bus-census (and end what is no service of ours)" end]),
    (.services as $services | .channels[] | .channel as $channel | .other_versions[]?
      | [$services[] | select(any(.channels[]?; .channel == $channel and .decode_failures > 0)).session] as $readers
      | ["\(who($services; .session)) writes \($channel) as another version of \(.type), \(.hash), than " +
          (if $readers == [] then "ours" else [$readers[] | who($services; .)] | join(", ") + " can read" end) +
          ", \(.our_hash)",
         "the same version on each host: \($get_this_version)"]),
    (.channels[] | select(.several_types and (.other_versions // []) == [])
      | ["\(.channel) carries several types: its writers are of different versions",
         "on each host: \($get_this_version)"])
    | @tsv' "$heard_file")
  while IFS=$'\t' read -r line mend; do
    if [[ -n $line ]]; then wrong others "$line" "$mend"; fi
  done <<<"$findings_of_others"
  if ((faults == wrong_before)); then
    well others "$(jq -r 'if .services == [] then "nobody is on the bus" else
      "on the bus, each once: " + ([.services[].name] | unique | join(" ")) end' "$heard_file")"
  fi
}
