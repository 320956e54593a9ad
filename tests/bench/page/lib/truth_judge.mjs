// How far what the page drew is from what was published. Pure: samples of page_probe, entries of recording.
import {armPoints, furthest, tagPlace} from './robot_arithmetic.mjs';

const byId = (entries) => new Map(entries.map((entry) => [entry.id, entry]));
const distance = (point, other) => Math.hypot(point[0] - other[0], point[1] - other[1]);

/** The phases that rows of the event list tell, each once; what is no word of a phase stays as it is. */
export function phasesOf(rows) {
  const said = rows.flatMap((row) => /^(?:([A-Z_]+) → )?([A-Z_]+)\b/.exec(row)?.slice(1).filter(Boolean) ?? [row]);
  return said.filter((state, i) => state !== said[i - 1]);
}

function markErrors(drawn, published) {
  const corners = [[published.x, published.y], [published.x + published.width, published.y + published.height]];
  return {
    attribute: Math.max(...['u', 'v', 'x', 'y', 'width', 'height'].map((name) => Math.abs(drawn[name] - published[name]))),
    cross: distance(drawn.cross, [published.u, published.v]),
    box: Math.max(...corners.map((corner, i) => distance(drawn.box[i], corner))),
  };
}

/**
 * Images with their marks against the detections of the very same frames. px. `wrong`: images whose marks are not those of
 * their frame; `bare`: images that were drawn, but never with the marks that their frame has.
 */
export function judgeMarks(images, detections) {
  const known = byId(detections);
  const result = {marks: 0, attribute: 0, cross: 0, box: 0, wrong: []};
  const bare = new Set();
  const dressed = new Set();
  for (const {side, id, marks} of images) {
    const published = known.get(id)?.sides[side] ?? [];
    if (published.length > 0) (marks.length > 0 ? dressed : bare).add(`${side} ${id}`);
    if (marks.length === 0) continue; // not known yet
    const names = (list) => list.map((mark) => mark.name).sort().join();
    if (names(marks) !== names(published)) {
      result.wrong.push({side, id, drawn: names(marks), published: names(published)});
      continue;
    }
    for (const mark of marks) {
      ++result.marks;
      const errors = markErrors(mark, published.find((candidate) => candidate.name === mark.name));
      for (const [name, error] of Object.entries(errors)) result[name] = Math.max(result[name], error);
    }
  }
  return {...result, images: dressed.size, bare: [...bare].filter((image) => !dressed.has(image))};
}

/** Crosses found in screenshots against the detection of the frame on screen. px. `wrong`: not found, or of no mark. */
export function judgeCrosses(shots, detections) {
  const known = byId(detections);
  const result = {marks: 0, cross: 0, wrong: []};
  for (const {id, crosses} of shots) {
    for (const side of ['left', 'right']) {
      const published = known.get(id)?.sides[side] ?? [];
      const found = crosses.filter((cross) => cross.side === side);
      for (const mark of published) {
        const cross = found.find((candidate) => candidate.name === mark.name)?.cross;
        if (!cross) {
          result.wrong.push({id, side, missed: mark.name});
          continue;
        }
        ++result.marks;
        result.cross = Math.max(result.cross, distance(cross, [mark.u, mark.v]));
      }
      const extra = found.filter((cross) => !published.some((mark) => mark.name === cross.name));
      result.wrong.push(...extra.map((cross) => ({id, side, extra: cross.name})));
    }
  }
  return result;
}

const kRounding_m = 1e-9;

// Of equals the newest: what rests is drawn as it was told last.
function nearestOf(candidates) {
  const least = Math.min(...candidates.map(({error}) => error));
  return candidates.findLast(({error}) => error <= least + kRounding_m);
}

// A recorder may lose messages on a busy machine: what is drawn is then of one that nobody can look up.
const isUnrecorded = (of, known, error) => error > kRounding_m && of.some(({id}) => !known.has(id));

/** Drawn arms, each against the nearest of the JOINT_STATEs `of` that can be meant. m. `unrecorded`: those not judged. */
export function judgeArms(samples, joints, robot) {
  const known = byId(joints);
  const result = {samples: 0, attribute: 0, drawn: 0, behind_ms: 0, unrecorded: 0, wrong: []};
  for (const {views, of} of samples) {
    const meant = of.filter(({id}) => known.has(id)).map((one) => ({...one, points: armPoints(robot, known.get(one.id).q)}));
    if (meant.length === 0 || views.some((view) => view.points.length !== 4)) {
      result.wrong.push({views, of});
      continue;
    }
    const errors = meant.map((one) => ({...one, error: Math.max(...views.map((view) => furthest(view.points, one.points)))}));
    const {points, error, behind_ms} = nearestOf(errors);
    if (isUnrecorded(of, known, error)) {
      ++result.unrecorded;
      continue;
    }
    ++result.samples;
    result.behind_ms = Math.max(result.behind_ms, behind_ms);
    result.attribute = Math.max(result.attribute, error);
    result.drawn = Math.max(result.drawn, furthest(views[0].drawn, points.map(([x, , z]) => [x, z])));
  }
  return result;
}

// Where in W a place of the drawing is, by two tags whose places are known: W's x goes right, y up, at one scale.
function placeInW(robot, tags, at) {
  const [low, high] = tags.map((tag) => ({at: tag.at, place: tagPlace(robot, tag.uid)}));
  const metres = (high.place[0] - low.place[0]) / (high.at[0] - low.at[0]);
  return [low.place[0] + (at[0] - low.at[0]) * metres, low.place[1] - (at[1] - low.at[1]) * metres];
}

/** Drawn poses, each against the nearest of the ROBOT_POSEs `of` that can be meant. m, rad. `unrecorded`: those not judged. */
export function judgePoses(samples, poses, robot) {
  const known = byId(poses);
  const result = {samples: 0, attribute: 0, heading: 0, drawn: 0, behind_ms: 0, unrecorded: 0, wrong: []};
  for (const {pose, at, tags, of} of samples) {
    const meant = of.filter(({id}) => known.has(id)).map((one) => ({...one, pose: known.get(one.id).pose}));
    if (meant.length === 0 || tags === null) {
      result.wrong.push({pose, of});
      continue;
    }
    const {pose: nearest, error, behind_ms} = nearestOf(meant.map((one) => ({...one, error: distance(one.pose, pose)})));
    if (isUnrecorded(of, known, error)) {
      ++result.unrecorded;
      continue;
    }
    ++result.samples;
    result.behind_ms = Math.max(result.behind_ms, behind_ms);
    result.attribute = Math.max(result.attribute, error);
    result.heading = Math.max(result.heading, Math.abs(nearest[2] - pose[2]));
    result.drawn = Math.max(result.drawn, distance(placeInW(robot, tags, at), nearest));
  }
  return result;
}
