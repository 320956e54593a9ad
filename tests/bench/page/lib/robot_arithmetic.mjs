// The robot's geometry from robot.yaml, written a second time: what mmi computes is held against it.
import {readFileSync} from 'node:fs';

const numbers = (text) => text.split(',').map(Number);

function found(text, pattern, path) {
  const match = pattern.exec(text);
  if (!match) throw new Error(`${path}: has nothing like ${pattern}`);
  return match;
}

/** Of robot.yaml at `path`: what the functions below need. m, rad. */
export function readRobot(path) {
  const text = readFileSync(path, 'utf8');
  const [, in_use] = found(text, /^ +in_use: (\w+)/m, path);
  const grid = new RegExp(`- name: ${in_use}\\b.*\\n +grid: \\{columns: (\\d+), rows: (\\d+), spacing: ([\\d.]+), first_uid: (\\w+)\\}`);
  const [, columns, rows, spacing, first_uid] = found(text, grid, path);
  return {
    p_RC: numbers(found(text, /^ +p_RC: \[(.*?)\]/m, path)[1]),
    p_CA: numbers(found(text, /^ +p_CA: \[(.*?)\]/m, path)[1]),
    yaw_CA: (Number(found(text, /^ +yaw_CA_deg: (\S+)/m, path)[1]) * Math.PI) / 180,
    links: numbers(found(text, /^ +links: \[(.*?)\]/m, path)[1]),
    tags: {columns: Number(columns), rows: Number(rows), spacing: Number(spacing), first_uid: BigInt(`0x${first_uid}`)},
  };
}

/** Foot, shoulder, elbow and grip point in R, m, of the arm at the joints `q` (rad). */
export function armPoints(robot, q) {
  const [column, upper_arm, forearm] = robot.links;
  const yaw = robot.yaw_CA + q[0];
  const inR = (radius, height) => {
    const p_C = [robot.p_CA[0] - radius * Math.sin(yaw), robot.p_CA[1] + radius * Math.cos(yaw), robot.p_CA[2] + height];
    return [robot.p_RC[0] + p_C[1], robot.p_RC[1] - p_C[0], robot.p_RC[2] + p_C[2]];
  };
  const elbow = [upper_arm * Math.cos(q[1]), column + upper_arm * Math.sin(q[1])];
  const grip = [elbow[0] + forearm * Math.cos(q[1] + q[2]), elbow[1] + forearm * Math.sin(q[1] + q[2])];
  return [inR(0, 0), inR(0, column), inR(...elbow), inR(...grip)];
}

/** Where in W the tag `uid` lies, m; null where it is none of the field. */
export function tagPlace({tags}, uid) {
  const index = Number(BigInt(`0x${uid}`) - tags.first_uid);
  if (index < 0 || index >= tags.columns * tags.rows) return null;
  return [(index % tags.columns) * tags.spacing, Math.floor(index / tags.columns) * tags.spacing];
}

/** The largest distance between points of the same index, m. */
export function furthest(points, others) {
  return Math.max(...points.map((point, i) => Math.hypot(...point.map((value, axis) => value - others[i][axis]))));
}
