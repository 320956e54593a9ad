// What a recording says, read by log-tool: what the page shows is held against it.
import {mkdtempSync, readFileSync, rmSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {run} from './process.mjs';

/** Rows of a CSV file (RFC 4180) as objects by the names in its head. */
export function parseCsv(text) {
  const rows = [[]];
  for (const [, quoted, plain, end] of text.matchAll(/(?:"((?:[^"]|"")*)"|([^",\n]*))(,|\r?\n|$)/g)) {
    rows[rows.length - 1].push(quoted !== undefined ? quoted.replaceAll('""', '"') : plain);
    if (end !== ',') rows.push([]);
  }
  const [head, ...body] = rows.filter((row) => row.length > 1);
  return body.map((row) => Object.fromEntries(head.map((name, i) => [name, row[i] ?? ''])));
}

/** Whose message it is, or which frame it answers: a session has more digits than a number. */
export const idOf = (row, what = '') => `${row[`${what}session`]} ${row[`${what}seq`]}`;

const kViewNumbers = ['u', 'v', 'x', 'y', 'width', 'height'];

// {left: [{name, u, v, x, y, width, height}], right}: those that are seen.
function marksOf(row) {
  const sides = {left: [], right: []};
  for (let i = 0; i < Number(row.num_marks); ++i) {
    for (const side of ['left', 'right']) {
      const at = (field) => row[`marks[${i}].${side}.${field}`];
      if (at('seen') !== 'true') continue;
      const numbers = kViewNumbers.map((field) => [field, Number(at(field))]);
      sides[side].push({name: row[`marks[${i}].name`], ...Object.fromEntries(numbers)});
    }
  }
  return sides;
}

const kChannels = ['TASK_STATE', 'MARK_DETECTION', 'JOINT_STATE', 'ROBOT_POSE'];

/** The phases in order, each once; detections by frame, joints and poses by message, with `at`: us, their arrival. */
export async function readRecording(bin, log) {
  const folder = mkdtempSync(join(tmpdir(), 'bench-page-'));
  try {
    await run([`${bin}/log-tool`, 'export', log, folder, ...kChannels.flatMap((name) => ['--channel', name])]);
    const [tasks, detections, joints, poses] = kChannels.map((name) => parseCsv(readFileSync(join(folder, `${name}.csv`), 'utf8')));
    return {
      phases: tasks.map((row) => row.state).filter((state, i, all) => state !== all[i - 1]),
      detections: detections.map((row) => ({id: idOf(row, 'frame_'), at: Number(row.log_utime), sides: marksOf(row)})),
      joints: joints.map((row) => ({id: idOf(row), at: Number(row.log_utime), q: [0, 1, 2].map((i) => Number(row[`position[${i}]`]))})),
      poses: poses.map((row) => ({id: idOf(row), at: Number(row.log_utime),
        pose: ['x', 'y', 'heading'].map((name) => Number(row[`pose.${name}`]))})),
    };
  } finally {
    rmSync(folder, {recursive: true, force: true});
  }
}

/** The newest of `entries` at `at` (us); undefined before the first. */
export function newestAt(entries, at) {
  return entries.reduce((newest, entry) => (entry.at <= at && !(newest?.at > entry.at) ? entry : newest), undefined);
}

/** The left picture of the frame `id` as it was recorded between `from_s` and `to_s` of the log: a PNG file's bytes. */
export async function recordedPicture(bin, log, id, {from_s, to_s}) {
  const folder = mkdtempSync(join(tmpdir(), 'bench-page-'));
  try {
    await run([`${bin}/log-tool`, 'export', log, folder, '--channel', 'STEREO_FRAME', '--from', String(from_s), '--to', String(to_s)]);
    const index = parseCsv(readFileSync(join(folder, 'STEREO_FRAME.csv'), 'utf8')).findIndex((row) => idOf(row) === id);
    if (index < 0) throw new Error(`${log}: has no frame ${id} from ${from_s} to ${to_s} s`);
    return readFileSync(join(folder, 'STEREO_FRAME', `${String(index + 1).padStart(6, '0')}_left.png`));
  } finally {
    rmSync(folder, {recursive: true, force: true});
  }
}
