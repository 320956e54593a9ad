# shellcheck shell=bash disable=SC2034 # variables of the sourcing script
# The reference logs and the services that are run on each. To be sourced.

# log, service, tolerance of its numbers (SI units and px). Perception's is wider: another processor's vector units round
# differently, and a sum of thousands of pixels shows it.
reference_runs=(
  'frames mark-detector 1e-5'
  'detections target-locator 1e-5'
  'drive-and-grasp visual-servo 1e-6'
  'drive-and-grasp task-manager 1e-6'
  'drive-and-grasp rfid-localizer 1e-6'
  'drive-and-grasp base-navigator 1e-6'
)

# s after the recording's first message
frames_from=7.0 frames_to=7.6
detections_from=22.0 detections_to=24.5
