// The lines that the case 'truth' prints: figures beside their bars.
import {judgeArms, judgeCrosses, judgeMarks, judgePoses, phasesOf} from './truth_judge.mjs';

const kDrawn_px = 1;
const kArm_m = 1e-4;
const kPose_m = 1e-3;
const kHeading_rad = 1e-3;
/** Grey levels, mean: the cameras' noise is 3, and JPEG smooths it; the wrong frame of a moving camera is far more. */
const kPicture_grey = 6;
const kViews = ['left', 'right', 'sides', 'floor'];

/** `told` begins every line: which run, live or from the log. */
export class TruthReport {
  constructor(report, told, recording, robot) {
    this.report = report;
    this.told = told;
    this.recording = recording;
    this.robot = robot;
  }

  add(what, ...figure) {
    this.report.add(`${this.told}, ${what}`, ...figure);
  }

  none(what, list) {
    this.add(what, list.length, '0', list.length === 0, {found: list.slice(0, 20)});
  }

  within(what, unit, value, bar) {
    this.add(`${what}, ${unit}`, value, String(bar), value <= bar);
  }

  phases(rows) {
    const drawn = phasesOf(rows);
    const {phases} = this.recording;
    this.add(`phases in the event list, of ${phases.length}`, drawn.length, 'all, in order',
      phases.length > 1 && drawn.join() === phases.join(), {drawn, recorded: phases, rows});
  }

  foreign(foreign, images) {
    this.none(`overlays on a foreign frame, of ${images} images`, foreign);
  }

  marks(images) {
    const marks = judgeMarks(images, this.recording.detections);
    this.add(`marks held against their frame's detection, in ${marks.images} images`, marks.marks, 'some', marks.marks > 0);
    this.none('images with other marks than their frame has', marks.wrong);
    this.add('images gone before their marks were known', marks.bare.length, null, null);
    for (const way of ['attribute', 'cross', 'box']) this.within(`marks, ${way}`, 'px', marks[way], kDrawn_px);
  }

  crosses(shots) {
    const crosses = judgeCrosses(shots, this.recording.detections);
    this.add(`crosses in the pixels of ${shots.length} screenshots`, crosses.marks, 'some', crosses.marks > 0);
    this.none('crosses that are missed or of no mark', crosses.wrong);
    this.within('crosses in the pixels', 'px', crosses.cross, kDrawn_px);
  }

  arms(samples) {
    const arms = judgeArms(samples, this.recording.joints, this.robot);
    this.add('arms held against JOINT_STATE', arms.samples, 'some', arms.samples > 0);
    this.none('arms without their JOINT_STATE', arms.wrong);
    this.within('arm, attribute', 'mm', 1000 * arms.attribute, 1000 * kArm_m);
    this.within('arm, as drawn', 'mm', 1000 * arms.drawn, 1000 * kArm_m);
    this.unrecorded('arms', arms);
    return arms;
  }

  poses(samples) {
    const poses = judgePoses(samples, this.recording.poses, this.robot);
    this.add('poses held against ROBOT_POSE', poses.samples, 'some', poses.samples > 0);
    this.none('poses without their ROBOT_POSE', poses.wrong);
    this.within('pose, attribute', 'mm', 1000 * poses.attribute, 1000 * kPose_m);
    this.within('pose, as drawn', 'mm', 1000 * poses.drawn, 1000 * kPose_m);
    this.within('heading', 'rad', poses.heading, kHeading_rad);
    this.unrecorded('poses', poses);
    return poses;
  }

  unrecorded(what, {samples, unrecorded}) {
    this.add(`${what} of a message that the recorder lost`, unrecorded, 'fewer than a tenth', 10 * unrecorded < samples);
  }

  pictures(differences) {
    this.within('pictures beside the recorded ones, worst mean', 'grey levels', Math.max(...differences), kPicture_grey);
  }

  sameTwice(first, second) {
    const other = first.flatMap((shot, i) => kViews.filter((_, k) => shot[k] !== second[i][k]).map((name) => `${name} ${i}`));
    this.none(`other pixels at the same instant, of ${first.length * kViews.length} views`, other);
  }
}
