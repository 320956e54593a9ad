// What stands in the page, read inside it; `installProbe` runs there before the page's own programs.

/** Makes `probe`: what mmi told the page, which frame each canvas was given, and what is drawn at each animation frame. */
export function installProbe() {
  const kShownBefore_ms = 3000; // the page draws the state at its own pace, a busy machine slower
  const kGrid_m = 0.1; // of the view from the right
  const frames_of_jpeg = new Map(); // a JPEG's hash: the frames that it came with
  const frames_of_bitmap = new WeakMap();
  const frames_of_canvas = new WeakMap();
  const heard = {JOINT_STATE: [], ROBOT_POSE: []};
  const keys = new Set();
  let past_since = null;
  const probe = (window.probe = {play: null, log: null, images: 0, foreign: [], marks: [], arms: [], poses: []});

  function hashOf(bytes) {
    let hash = 0x811c9dc5;
    for (const byte of bytes) hash = Math.imul(hash ^ byte, 0x01000193);
    return `${bytes.length} ${hash}`;
  }

  function hear({data}) {
    if (typeof data !== 'string') {
      const size = new DataView(data).getUint32(0, true);
      const header = JSON.parse(new TextDecoder().decode(new Uint8Array(data, 4, size)));
      const left = 4 + size;
      const right = left + header.left_size;
      for (const [side, begin, length] of [['left', left, header.left_size], ['right', right, header.right_size]]) {
        const hash = hashOf(new Uint8Array(data, begin, length));
        frames_of_jpeg.set(hash, [...(frames_of_jpeg.get(hash) ?? []), `${side} ${header.frame_session} ${header.frame_seq}`]);
      }
      return;
    }
    const message = JSON.parse(data);
    if (message.log) probe.log = message.log;
    if (message.play) probe.play = message.play;
    for (const slot of message.slots ?? []) {
      if (slot.message) heard[slot.channel]?.push({id: `${slot.message.session} ${slot.message.seq}`, at: performance.now()});
    }
  }

  window.WebSocket = class extends WebSocket {
    constructor(...place) {
      super(...place);
      this.addEventListener('message', hear);
    }
  };
  const decode = window.createImageBitmap.bind(window);
  window.createImageBitmap = async (blob) => {
    const bitmap = await decode(blob);
    frames_of_bitmap.set(bitmap, frames_of_jpeg.get(hashOf(new Uint8Array(await blob.arrayBuffer()))) ?? []);
    return bitmap;
  };
  const {drawImage, clearRect} = CanvasRenderingContext2D.prototype;
  CanvasRenderingContext2D.prototype.drawImage = function (bitmap, ...place) {
    frames_of_canvas.set(this.canvas, frames_of_bitmap.get(bitmap) ?? []);
    return drawImage.call(this, bitmap, ...place);
  };
  CanvasRenderingContext2D.prototype.clearRect = function (...place) {
    frames_of_canvas.set(this.canvas, []);
    return clearRect.call(this, ...place);
  };

  const numbers = (element, ...names) => names.map((name) => Number(element.dataset[name]));

  // Corners of what an element of the overlay fills, but for its line's width, in px of the image.
  function cornersOf(element, canvas) {
    const box = element.getBBox();
    const picture = canvas.getBoundingClientRect();
    return [[box.x, box.y], [box.x + box.width, box.y + box.height]].map(([x, y]) => {
      const on_screen = new DOMPoint(x, y).matrixTransform(element.getScreenCTM());
      return [((on_screen.x - picture.left) / picture.width) * canvas.width,
        ((on_screen.y - picture.top) / picture.height) * canvas.height];
    });
  }

  function marksOf(frame) {
    const canvas = frame.querySelector('canvas');
    return [...frame.querySelectorAll('[data-mark]')].map((mark) => {
      const [[left, top], [right, bottom]] = cornersOf(mark.querySelector('.cross'), canvas);
      const [u, v, x, y, width, height] = numbers(mark, 'u', 'v', 'x', 'y', 'width', 'height');
      return {name: mark.dataset.mark, u, v, x, y, width, height,
        cross: [(left + right - 1) / 2, (top + bottom - 1) / 2], box: cornersOf(mark.querySelector('.box'), canvas)};
    });
  }

  function headOf(frame) {
    const {side, frameSession, frameSeq} = frame.dataset;
    const drawn = frames_of_canvas.get(frame.querySelector('canvas')) ?? [];
    return {side, id: frameSeq === '' ? '' : `${frameSession} ${frameSeq}`, drawn};
  }

  const images = () => [...document.querySelectorAll('.image-frame')];

  /** Each image: the frame it says it is of, those its picture is of, and its marks. */
  probe.readImages = () => images().map((frame) => ({...headOf(frame), marks: marksOf(frame)}));

  /** The measured arm's points by attributes and, of the view from the right, by the grid that is drawn under them: m. */
  probe.readArm = () => [...document.querySelectorAll('.sides svg[role=img]')].map((view, index) => {
    const circles = [...view.querySelectorAll('circle[data-arm=measured][data-joint]')];
    const points = circles.map((circle) => numbers(circle, 'x', 'y', 'z'));
    if (index > 0) return {points};
    const endsOf = (line) => ['x1', 'x2', 'y1', 'y2'].map((name) => Number(line.getAttribute(name)));
    const lines = [...view.querySelectorAll('line.grid')].map(endsOf);
    const across = [...new Set(lines.filter(([x1, x2]) => x1 === x2).map(([x1]) => x1))].sort((a, b) => a - b);
    const zeros = [...view.querySelectorAll('line.grid.is-zero')].map(endsOf);
    const [zero_x] = zeros.find(([x1, x2]) => x1 === x2);
    const zero_z = zeros.find(([, , y1, y2]) => y1 === y2)[2];
    const metres = kGrid_m / (across[1] - across[0]);
    const drawn = circles.map((circle) => [circle.getAttribute('cx') - zero_x, zero_z - circle.getAttribute('cy')]);
    return {points, drawn: drawn.map((place) => place.map((value) => value * metres))};
  });

  /** The fused pose by attributes, and where it and the tags of the lowest and the highest uid are drawn; null: there is none. */
  probe.readPose = () => {
    const pose = document.querySelector('[data-pose=fused]');
    if (!pose) return null;
    const circle = pose.querySelector('circle');
    const tags = [...document.querySelectorAll('[data-tag]')].sort((a, b) => (a.dataset.tag < b.dataset.tag ? -1 : 1));
    const placeOf = (tag) => {
      const [, x, y] = /translate\((\S+) (\S+)\)/.exec(tag.getAttribute('transform'));
      return {uid: tag.dataset.tag, at: [Number(x), Number(y)]};
    };
    return {pose: numbers(pose, 'x', 'y', 'heading'), at: [Number(circle.getAttribute('cx')), Number(circle.getAttribute('cy'))],
      tags: tags.length > 1 ? [placeOf(tags[0]), placeOf(tags.at(-1))] : null};
  };

  /** The event list's rows of TASK_STATE, the oldest first. */
  probe.readTaskEvents = () => [...document.querySelectorAll('[data-event]')].reverse()
    .filter((row) => row.querySelector('button').title.startsWith('TASK_STATE'))
    .map((row) => row.querySelector('.event-text').textContent.trim());

  // Messages of which one is shown, and since when (ms) a newer one is known: that heard last before the page's pace, and
  // those since.
  function candidates(channel, now) {
    const until = past_since ?? now;
    const list = heard[channel];
    const first = list.findLastIndex((entry) => entry.at < until - kShownBefore_ms);
    return list.slice(Math.max(0, first)).map((entry, i, some) => (
      {id: entry.id, behind_ms: Math.max(0, until - (some[i + 1]?.at ?? until))}));
  }

  // Layout is asked for only where something is new: what watches must not slow what is watched.
  function keepNew(list, key, make) {
    if (keys.has(key)) return;
    keys.add(key);
    list.push(make());
  }

  const attributesOf = (elements, ...names) =>
    [...elements].map((element) => names.map((name) => element.getAttribute(name)).join()).join(' ');

  function sampleImage(frame, now) {
    const head = headOf(frame);
    if (head.id === '' && head.drawn.length === 0) return;
    ++probe.images;
    if (!head.drawn.includes(`${head.side} ${head.id}`)) probe.foreign.push({...head, at: now});
    const marks = attributesOf(frame.querySelectorAll('[data-mark]'), 'data-mark', 'data-u', 'data-v');
    keepNew(probe.marks, `marks ${head.side} ${head.id} ${marks}`, () => ({...head, marks: marksOf(frame)}));
  }

  function sample(now) {
    past_since = document.body?.dataset.past === 'yes' ? (past_since ?? now) : null;
    for (const frame of images()) sampleImage(frame, now);
    const joints = attributesOf(document.querySelectorAll('circle[data-arm=measured]'), 'data-x', 'data-y', 'data-z', 'cx', 'cy');
    if (joints) keepNew(probe.arms, `arm ${joints}`, () => ({views: probe.readArm(), of: candidates('JOINT_STATE', now)}));
    const pose = attributesOf(document.querySelectorAll('[data-pose=fused]'), 'data-x', 'data-y', 'data-heading');
    if (pose) keepNew(probe.poses, `pose ${pose}`, () => ({...probe.readPose(), of: candidates('ROBOT_POSE', now)}));
  }

  requestAnimationFrame(function tick(now) {
    sample(now);
    requestAnimationFrame(tick);
  });
}

/** Calls `probe[name]` inside the page. */
export const ask = (page, name) => page.evaluate((method) => window.probe[method](), name);

/** What was sampled at all animation frames so far. */
export const sampled = (page) => page.evaluate(() => {
  const {images, foreign, marks, arms, poses} = window.probe;
  return {images, foreign, marks, arms, poses};
});
