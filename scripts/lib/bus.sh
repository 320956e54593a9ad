# shellcheck shell=bash disable=SC2034 # variables of the sourcing script
# The bus as the scripts know it: its address, and the services that are started on it. To be sourced after project.sh.

# As in common/bus/bus_url.hpp.
default_lcm_url='udpm://239.255.76.67:7667?ttl=0&recv_buf_size=4194304'
# As in common/bus/network_check.hpp: bytes of receive buffer; below it 60 to 98% of raw frames are lost.
receive_buffer_for_raw_frames=2000000

# services_of PROFILE: the services of a profile of scripts/stack, one a line; fails for a name that is none.
services_of() {
  case $1 in
    sim) say simulator ;;
    robot) say stereo-camera ;;
    replay) ;;
    *) return 1 ;;
  esac
  printf '%s\n' rfid-localizer base-navigator mark-detector target-locator visual-servo task-manager
}
