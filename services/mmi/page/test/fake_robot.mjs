// An invented robot for trying the page: one grasp in 40 s, over and over, as the messages that mmi would send.
import {deflateSync} from 'node:zlib';

const kPhases = [
  'IDLE',
  'LOOK',
  'APPROACH',
  'SERVO',
  'GRIP',
  'LIFT',
  'VERIFY',
  'LIFT_ON',
  'CARRY',
  'RELEASE',
  'GO_HOME',
  'HOLD_LIFTED',
  'DONE',
  'REFUSED',
  'FAILED',
  'STOPPED',
  'DRIVE',
];
const kWay = [
  ['IDLE', 3],
  ['DRIVE', 8],
  ['LOOK', 1],
  ['APPROACH', 4],
  ['SERVO', 9],
  ['GRIP', 2],
  ['LIFT', 2],
  ['VERIFY', 1],
  ['LIFT_ON', 2],
  ['CARRY', 3],
  ['RELEASE', 1],
  ['GO_HOME', 3],
  ['DONE', 1],
];
export const kRoundSeconds = kWay.reduce((sum, [, seconds]) => sum + seconds, 0);
export const kBegin = 1600000000000000;
const kWidth = 640;
const kHeight = 480;
const kMarks = [
  {name: 'hand', role: 'manipulator', size: 0.02, surface: 'plane', outline: 'square', colour: '#31b45a', width: null},
  {name: 'red_book', role: 'target', size: 0.025, surface: 'plane', outline: 'square', colour: '#c0392f', width: 0.025},
  {
    name: 'blue_book',
    role: 'target',
    size: 0.025,
    surface: 'plane',
    outline: 'square',
    colour: '#3566c0',
    width: 0.025,
  },
];

export function phaseAt(t) {
  let rest = ((t % kRoundSeconds) + kRoundSeconds) % kRoundSeconds;
  for (const [phase, seconds] of kWay) {
    if (rest < seconds) return {phase, for_s: rest};
    rest -= seconds;
  }
  return {phase: 'IDLE', for_s: 0};
}

const us = (t) => String(kBegin + Math.round(t * 1e6));

function tags() {
  const list = [];
  for (let y = 0; y < 12; y++) {
    for (let x = 0; x < 5; x++) {
      list.push({uid: (0xe004015000001000n + BigInt(y * 5 + x)).toString(16).toUpperCase(), place: [x / 10, y / 10]});
    }
  }
  return list;
}

const transitions = [
  ...kWay.slice(0, -1).map(([from], i) => ({from, to: kWay[i + 1][0], when: 'it is there'})),
  {from: 'IDLE', to: 'LOOK', when: 'START without drive'},
  {from: 'LOOK', to: 'REFUSED', when: 'it cannot be taken'},
  {from: 'VERIFY', to: 'APPROACH', when: 'the object stayed; another try'},
  {from: 'VERIFY', to: 'FAILED', when: 'tries are used up'},
  {from: 'LIFT_ON', to: 'HOLD_LIFTED', when: 'lifted, and not to be carried'},
  {from: 'DONE', to: 'IDLE', when: 'START'},
  ...kPhases
    .filter((phase) => !['DONE', 'FAILED', 'STOPPED', 'REFUSED', 'HOLD_LIFTED'].includes(phase))
    .map((from) => ({from, to: 'STOPPED', when: 'STOP or ABORT'})),
];

export function hello(mode, seconds, events) {
  const channel = (name, type, what, truth = false) => ({
    name,
    type,
    what,
    writers: ['simulator'],
    readers: ['mmi'],
    truth,
    moves_robot: false,
  });
  return {
    type: 'hello',
    protocol: 1,
    mode,
    version: 'fake',
    robot: '',
    bus: mode === 'log' ? 'logs/last-night' : 'udpm://239.255.76.67:7667',
    robot_file: {path: 'config/robot.yaml', from: 'option'},
    update_at_least_every: 0.25,
    channels: [
      channel('STEREO_FRAME', 'StereoFrame', 'image pairs'),
      channel('TASK_STATE', 'TaskState', 'the procedure'),
      channel('SERVO_STATUS', 'ServoStatus', 'how the goal stands'),
      channel('JOINT_STATE', 'JointState', 'where the arm is'),
      channel('ROBOT_POSE', 'RobotPose', 'where the robot is'),
      channel('SONAR_SCAN', 'SonarScan', 'sonars'),
      channel('BASE_STATUS', 'BaseStatus', 'how the drive stands'),
      channel('SIM_BASE_TRUTH', 'SimBaseTruth', 'where the base really is', true),
    ],
    phases: kPhases,
    transitions,
    states: {
      SERVO_STATUS: ['HOLD', 'POSTURE', 'SERVO', 'CONVERGED', 'LOST', 'UNREACHABLE', 'STALE', 'STOPPED'],
      BASE_STATUS: ['HOLD', 'DRIVING', 'ARRIVED', 'BLOCKED', 'LOST', 'STALE', 'STOPPED'],
      ROBOT_POSE: ['SEARCHING', 'LOCALISED', 'LOST'],
      PROCESS_STATUS: ['STOPPED', 'STARTING', 'RUNNING', 'SILENT', 'WAITING', 'ENDED', 'FAILED'],
      MARK: ['LOCATED', 'UNSEEN'],
      CUE: ['NONE', 'TEXTURE', 'OUTLINE', 'CENTROID'],
    },
    stop_devices: ['arm', 'base'],
    scene: {
      cameras: {
        width_px: kWidth,
        height_px: kHeight,
        fx_px: 784,
        fy_px: 784,
        cx_left_px: 319.5,
        cx_right_px: 319.5,
        cy_px: 239.5,
        baseline: 0.065,
        p_RC: [0.1, 0.0325, 0.7],
      },
      arm: {foot_R: [0.16, 0, 0.25], column_top_R: [0.16, 0, 0.4], reach: 0.4},
      base: {front: 0.22, rear: 0.18, half_width: 0.18, sonars: {number: 16, beam_width: 0.5236, max_range: 5}},
      rfid: {p_RF: [0, 0], reading_radius: 0.1},
      tags: tags(),
      marks: kMarks,
    },
    ...(mode === 'log'
      ? {
          log: {
            path: 'logs/last-night',
            begin: us(0),
            end: us(seconds),
            damaged: false,
            note: 'robot.yaml of the recording',
          },
        }
      : {}),
    events,
  };
}

function arm(t) {
  const {phase, for_s} = phaseAt(t);
  const out = ['SERVO', 'GRIP', 'LIFT', 'VERIFY', 'LIFT_ON'].includes(phase)
    ? 1
    : phase === 'APPROACH'
      ? for_s / 4
      : phase === 'CARRY'
        ? 1 - for_s / 3
        : 0;
  const points = (extra) => {
    const shoulder = 1.9 - 1.3 * out + extra;
    const fore = shoulder - 2.4 + 1.9 * out;
    const elbow = [0.16 + 0.2 * Math.cos(shoulder), 0.02 * Math.sin(t), 0.4 + 0.2 * Math.sin(shoulder)];
    return [
      [0.16, 0, 0.25],
      [0.16, 0, 0.4],
      elbow,
      [elbow[0] + 0.2 * Math.cos(fore), elbow[1] * 2, elbow[2] + 0.2 * Math.sin(fore)],
    ];
  };
  return {utime: us(t), measured: points(0), commanded: points(0.03)};
}

function pose(t) {
  const {phase, for_s} = phaseAt(t);
  const s = phase === 'DRIVE' ? for_s / 8 : phase === 'IDLE' ? 0 : 1;
  return {x: 0.2 + 0.05 * Math.sin(3 * s), y: 0.1 + 0.75 * s, heading: Math.PI / 2 + 0.15 * Math.cos(4 * s)};
}

function slots(t, look) {
  const {phase} = phaseAt(t);
  const session = '7777777777777777777';
  const base = {utime: us(t), session, seq: String(Math.round(t * 30))};
  const by_sight = phase === 'SERVO';
  const where = pose(t);
  const slot = (channel, message, key = '') => ({channel, key, at: us(t), message});
  const shrink = Math.exp(-phaseAt(t).for_s / 2);
  const list = [
    slot('TASK_STATE', {
      ...base,
      state: kPhases.indexOf(phase),
      attempt: 1,
      result: 0,
      target: phase === 'IDLE' ? '' : 'red_book',
      reason: '',
    }),
    slot('SERVO_STATUS', {
      ...base,
      state: by_sight ? 2 : 0,
      settled: false,
      error_C: {x: 0.02 * shrink, y: -0.06 * shrink, z: 0.015 * shrink},
      covariance: {xx: 1e-6, xy: 0, xz: 0, yy: 4e-6, yz: 0, zz: 1e-6},
      reason: '',
    }),
    slot('JOINT_STATE', {
      ...base,
      num_joints: 3,
      position: [0.1 * Math.sin(t), 1.2, -1.4],
      speed: [0, 0, 0],
      measured: true,
      moving: by_sight,
      gripper_opening: 0.05,
    }),
    slot('ROBOT_POSE', {
      ...base,
      state: 1,
      pose: where,
      covariance: {xx: 4e-5, xy: 1e-5, xh: 0, yy: 9e-5, yh: 0, hh: 1e-3},
      speed: 0.1,
      turn_rate: 0,
      delay: 0.19,
      delay_sigma: 0.005,
      odometry_used: true,
      reason: '',
      paper: {
        measured_known: true,
        measured_x: where.x + 0.02,
        measured_y: where.y - 0.05,
        direction_known: true,
        direction: where.heading,
        speed: 0.1,
        delay: 0.19,
        compensated_x: where.x + 0.01,
        compensated_y: where.y - 0.015,
      },
    }),
    slot('SIM_BASE_TRUTH', {...base, pose: {...where, x: where.x + 0.004}, speed: 0.1, nearest: 0.31, touched: false}),
    slot('BASE_GOAL', {...base, goal_id: '3', kind: 1, frame: 0, pose: {x: 0.21, y: 0.85, heading: 1.6}}),
    slot('BASE_STATUS', {
      ...base,
      state: phase === 'DRIVE' ? 1 : 2,
      distance: 0.85 - where.y,
      heading_error: 0.02,
      reason: '',
    }),
    slot('SONAR_SCAN', {
      ...base,
      beam_width: 0.5236,
      min_range: 0.1,
      max_range: 5,
      num_echoes: 16,
      echoes: [...Array(16).keys()].map((i) => {
        const a = (i * Math.PI) / 8;
        return {
          pose: {x: 0.22 * Math.cos(a), y: 0.22 * Math.sin(a), heading: a},
          heard: i % 5 !== 2,
          range: i % 5 === 2 ? 5 : 0.5 + 0.3 * Math.sin(i * 2),
        };
      }),
    }),
  ];
  if (Math.floor(t * 20) % 20 === 0) {
    for (const name of [
      'simulator',
      'mark-detector',
      'target-locator',
      'visual-servo',
      'task-manager',
      'rfid-localizer',
    ]) {
      list.push(
        slot(
          'SERVICE_STATUS',
          {
            ...base,
            name,
            host: 'robot',
            pid: 1000 + name.length,
            version: '1.0',
            config_hash: '12345678901234567',
            state: 'ready',
            reason: '',
            num_channels: 1,
            channels: [
              {
                channel: 'STEREO_FRAME',
                received: '120',
                skipped: '0',
                lost: '0',
                decode_failures: '0',
                refused: '0',
                second_writer: false,
                age: 0.02,
                latency_p50: 0.01,
                latency_p99: 0.03,
              },
            ],
          },
          `${name}@robot`,
        ),
      );
      list.push(
        slot(
          'PROCESS_STATUS',
          {...base, name, host: 'robot', state: 2, pid: 1000 + name.length, start_utime: us(0), restarts: 0, why: ''},
          `${name}@robot`,
        ),
      );
    }
    list.push(
      slot(
        'RECORDER_STATUS',
        {
          ...base,
          folder: 'logs/today',
          host: 'robot',
          recording: true,
          bytes: String(Math.round(t * 2e7)),
          free_bytes: '50000000000',
          parts: 1,
          why: '',
        },
        'robot:logs/today',
      ),
    );
  }
  return list.filter((one) => look === null || look.has(one.channel) || !one.channel.startsWith('WHEEL'));
}

function floor(t) {
  const where = pose(t);
  const near = tags().filter((tag) => Math.hypot(tag.place[0] - where.x, tag.place[1] - where.y) < 0.11);
  const read = near.filter((_, i) => i % 3 !== 2);
  return {
    utime: us(t),
    expected: near.map((tag) => tag.uid),
    missed: near.filter((_, i) => i % 3 === 2).map((tag) => tag.uid),
    unexpected: [],
    read: read.map((tag) => ({uid: tag.uid, rssi: -52.5, at: us(t), count: 7, place: tag.place})),
  };
}

function places(t) {
  const grip = arm(t).measured[3];
  return {
    utime: us(t),
    frame_seq: String(Math.round(t * 10)),
    marks: [
      {
        name: 'hand',
        role: 'manipulator',
        status: 'LOCATED',
        cue: 'TEXTURE',
        p_R: [grip[0] - 0.03, grip[1], grip[2] + 0.03],
        covariance_R: [4e-6, 0, 0, 1e-6, 0, 1e-6],
        normal_R: [-0.9, 0, 0.43],
      },
      {
        name: 'red_book',
        role: 'target',
        status: 'LOCATED',
        cue: 'TEXTURE',
        p_R: [0.52, 0.01, 0.48],
        covariance_R: [4e-5, 0, 0, 4e-6, 0, 4e-6],
        normal_R: [-1, 0, 0],
      },
      {
        name: 'blue_book',
        role: 'target',
        status: 'LOCATED',
        cue: 'TEXTURE',
        p_R: [0.52, -0.06, 0.48],
        covariance_R: [4e-5, 0, 0, 4e-6, 0, 4e-6],
        normal_R: [-1, 0, 0],
      },
    ],
    grip_goal_R: [0.47, 0.01, 0.45],
  };
}

/** All events until t, numbered from 1. */
export function events(from, to) {
  const list = [];
  for (let round = 0; round * kRoundSeconds <= to; round++) {
    let t = round * kRoundSeconds;
    for (const [index, [phase, seconds]] of kWay.entries()) {
      if (t > from && t <= to) {
        list.push({
          number: round * kWay.length + index + 1,
          at: us(t),
          channel: 'TASK_STATE',
          key: '',
          kind: 'task',
          state: phase,
          text: `${kWay[Math.max(0, index - 1)][0]} -> ${phase}`,
          level: phase === 'DONE' ? 'good' : 'info',
        });
      }
      t += seconds;
    }
  }
  return list;
}

export function update(t, look, once_a_second) {
  const message = {type: 'update', now: us(t), slots: slots(t, look), arm: arm(t), places: places(t), floor: floor(t)};
  if (once_a_second) {
    const figure = (type, hz) => ({
      type,
      hz,
      age_s: 1 / hz,
      lost: 0,
      writers: 1,
      stale: false,
      bytes: Math.round(t * 1000),
      bytes_per_second: hz * 500,
      undecodable: 0,
    });
    message.figures = {
      STEREO_FRAME: figure('StereoFrame', 11),
      TASK_STATE: figure('TaskState', 11),
      JOINT_STATE: figure('JointState', 84),
      ROBOT_POSE: figure('RobotPose', 50),
      SONAR_SCAN: {...figure('SonarScan', 10), stale: true, age_s: 12.3},
      SERVICE_STATUS: figure('ServiceStatus', 7),
    };
    message.latency = {MARK_DETECTION: 0.012, TARGET_POSE: 0.019, SERVO_STATUS: 0.021, JOINT_COMMAND: 0.022};
  }
  return message;
}

function boxes(t) {
  const grip = arm(t).measured[3];
  return {
    left: {
      hand: [200 + 300 * grip[0], 330 - 200 * (grip[2] - 0.3), 42],
      red_book: [330, 180, 40],
      blue_book: [430, 182, 40],
    },
    right: {
      hand: [110 + 300 * grip[0], 330 - 200 * (grip[2] - 0.3), 42],
      red_book: [240, 180, 40],
      blue_book: [340, 182, 40],
    },
  };
}

const kRgb = {hand: [49, 180, 90], red_book: [192, 57, 47], blue_book: [53, 102, 192]};

function png(marks) {
  const raw = Buffer.alloc(kHeight * (kWidth * 3 + 1));
  for (let v = 0; v < kHeight; v++) {
    const row = v * (kWidth * 3 + 1) + 1;
    const wood = v > 300 ? [120, 96, 70] : [168, 165, 158];
    for (let u = 0; u < kWidth; u++) for (let c = 0; c < 3; c++) raw[row + u * 3 + c] = wood[c] - ((u >> 5) % 2) * 6;
  }
  for (const [name, [x, y, size]] of Object.entries(marks)) {
    for (let v = Math.round(y); v < y + size; v++) {
      for (let u = Math.round(x); u < x + size; u++) {
        if (u < 0 || v < 0 || u >= kWidth || v >= kHeight) continue;
        for (let c = 0; c < 3; c++)
          raw[v * (kWidth * 3 + 1) + 1 + u * 3 + c] = kRgb[name][c] - (((u * 7 + v * 13) >> 3) % 4) * 12;
      }
    }
  }
  const chunk = (type, data) => {
    const body = Buffer.concat([Buffer.from(type), data]);
    const out = Buffer.alloc(body.length + 8);
    out.writeUInt32BE(data.length, 0);
    body.copy(out, 4);
    out.writeUInt32BE(crc32(body), body.length + 4);
    return out;
  };
  const head = Buffer.alloc(13);
  head.writeUInt32BE(kWidth, 0);
  head.writeUInt32BE(kHeight, 4);
  head.set([8, 2, 0, 0, 0], 8);
  return Buffer.concat([
    Buffer.from([137, 80, 78, 71, 13, 10, 26, 10]),
    chunk('IHDR', head),
    chunk('IDAT', deflateSync(raw, {level: 1})),
    chunk('IEND', Buffer.alloc(0)),
  ]);
}

const kTable = Array.from({length: 256}, (_, n) => {
  let c = n;
  for (let k = 0; k < 8; k++) c = c & 1 ? 0xedb88320 ^ (c >>> 1) : c >>> 1;
  return c >>> 0;
});

function crc32(bytes) {
  let crc = 0xffffffff;
  for (const byte of bytes) crc = kTable[(crc ^ byte) & 255] ^ (crc >>> 8);
  return (crc ^ 0xffffffff) >>> 0;
}

/** A binary message: the fake cameras say PNG, which browsers know by its first bytes. */
export function picture(t, number) {
  const all = boxes(t);
  const view = ([x, y, size]) => {
    const mask = Buffer.alloc(size * ((size + 7) >> 3));
    for (let j = 3; j < size - 3; j++)
      for (let i = 3; i < size - 3; i++) mask[j * ((size + 7) >> 3) + (i >> 3)] |= 1 << (i & 7);
    return {
      seen: true,
      clipped: false,
      x: Math.round(x),
      y: Math.round(y),
      width: size,
      height: size,
      area: size * size,
      u: x + (size - 1) / 2,
      v: y + (size - 1) / 2,
      patch: {
        x: Math.round(x),
        y: Math.round(y),
        scale: 1,
        width: size,
        height: size,
        bgr: {bytes: 3 * size * size},
        mask: mask.toString('base64'),
      },
    };
  };
  const matches = Object.keys(all.left).map((name) => {
    const points = [...Array(14).keys()].map((i) => [5 + ((i * 17) % 32), 5 + ((i * 11) % 30)]);
    return {
      name,
      num_matches: 14,
      u_left: points.map((p) => all.left[name][0] + p[0]),
      v_left: points.map((p) => all.left[name][1] + p[1]),
      u_right: points.map((p) => all.right[name][0] + p[0]),
      v_right: points.map((p) => all.right[name][1] + p[1]),
      residual: points.map((_, i) => (i % 7) / 8),
    };
  });
  const left = png(all.left);
  const right = png(all.right);
  const header = Buffer.from(
    JSON.stringify({
      number,
      frame_session: '7777777777777777777',
      frame_seq: String(Math.round(t * 10)),
      utime: us(t),
      at: us(t),
      width: kWidth,
      height: kHeight,
      left_size: left.length,
      right_size: right.length,
      detection: {
        marks: Object.keys(all.left).map((name) => ({name, left: view(all.left[name]), right: view(all.right[name])})),
      },
      matches: {marks: matches},
      pose: null,
      servo: null,
    }),
  );
  const length = Buffer.alloc(4);
  length.writeUInt32LE(header.length, 0);
  return Buffer.concat([length, header, left, right]);
}
