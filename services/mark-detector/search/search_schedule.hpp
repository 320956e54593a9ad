#pragma once

// How much of each frame is searched.

namespace markservo::mark_detector {

struct SearchParameters {
  // Frames from one search of the whole image to the next; between them a mark is looked for around its last place, and
  // where it was not seen in every coarse_rows-th row. 1: always everywhere.
  int full_scan_every = 5;
  int coarse_rows = 8;     // px from row to row: a mark of 8 x 8 px crosses one
  int coarse_least = 4;    // px in one of them that make the whole image worth a search
  int track_margin = 8;    // px around a mark's last box, and an eighth of its size; outside all is searched
  int memory_frames = 30;  // frames for which the place of a mark that is not seen is remembered
};

// Memory from frame to frame of what is due.
struct SearchSchedule {
  int frames_to_full_scan = 0;
  int coarse_row = 0;

  // For each new frame: whether the whole image is searched. `at_once`: it is, whatever is due.
  bool full_scan_due(int full_scan_every, bool at_once) {
    if (!at_once && --frames_to_full_scan > 0) return false;
    frames_to_full_scan = full_scan_every;
    return true;
  }

  // The first of every coarse_rows-th row; another one each time.
  int next_coarse_row(int coarse_rows) {
    coarse_row = (coarse_row + 1) % coarse_rows;
    return coarse_row;
  }
};

}  // namespace markservo::mark_detector
