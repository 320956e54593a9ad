/** The WebSocket's messages, protocol 1, as services/mmi/README.md has them. Times in us, lengths in m, angles in rad. */

/** A message of the bus as JSON: what it holds is told by its .lcm file, and is checked where it is used. */
export type BusMessage = any;

/** Microseconds: a number, or a text where it is a 64-bit integer of a message. */
export type Microseconds = number | string;

export type Point = [number, number, number];

export interface ChannelRow {
  name: string;
  type: string;
  what: string;
  writers: string[];
  readers: string[];
  truth: boolean;
  moves_robot: boolean;
}

export interface Transition {
  from: string;
  to: string;
  when: string;
}

export interface CamerasScene {
  width_px: number;
  height_px: number;
  fx_px: number;
  fy_px: number;
  cx_left_px: number;
  cx_right_px: number;
  cy_px: number;
  baseline: number;
  p_RC: Point;
}

export interface BaseScene {
  front: number;
  rear: number;
  half_width: number;
  sonars: {number: number; beam_width: number; max_range: number} | null;
}

export interface MarkScene {
  name: string;
  role: string;
  size: number;
  surface: string;
  outline: string;
  colour: string;
  width: number;
}

export interface TagScene {
  uid: string;
  place: [number, number];
}

export interface Scene {
  cameras: CamerasScene | null;
  arm: {foot_R: Point; column_top_R: Point; reach: number} | null;
  base: BaseScene | null;
  rfid: {p_RF: [number, number]; reading_radius: number} | null;
  tags: TagScene[];
  marks: MarkScene[];
}

export type Level = 'info' | 'good' | 'warning' | 'bad';

export interface RobotEvent {
  number: number;
  at: Microseconds;
  channel: string;
  key: string;
  kind: string;
  state: string;
  text: string;
  level: Level;
}

export interface Hello {
  type: 'hello';
  protocol: number;
  mode: 'live' | 'log';
  version: string;
  robot: string;
  bus: string;
  robot_file: {path: string; from: string} | null;
  channels: ChannelRow[];
  phases: string[];
  transitions: Transition[];
  states: Record<string, string[]>;
  stop_devices: string[];
  /** s; updates come at least as often, empty ones if need be. Without it silence tells nothing. */
  update_at_least_every?: number;
  scene: Scene;
  log?: {path: string; begin: Microseconds; end: Microseconds; damaged: boolean; note: string};
  events: RobotEvent[];
}

export interface Slot {
  channel: string;
  key: string;
  at: Microseconds;
  message?: BusMessage;
  bad?: string;
}

export interface ArmPoints {
  utime: Microseconds;
  measured: Point[] | null;
  commanded: Point[] | null;
}

/** xx, xy, xz, yy, yz, zz in m^2. */
export type Covariance6 = [number, number, number, number, number, number];

export interface PlacedMark {
  name: string;
  role: number | string;
  status: number | string;
  cue: number | string;
  p_R: Point | null;
  covariance_R: Covariance6 | null;
  normal_R: Point | null;
}

export interface Places {
  utime: Microseconds;
  frame_seq: Microseconds;
  marks: PlacedMark[];
  grip_goal_R: Point | null;
}

/** Of a SONAR_SCAN: the sonar's pose in R and what it heard at, m. */
export interface SonarEchoMessage {
  pose: {x: number; y: number; heading: number};
  heard: boolean;
  range: number;
}

export interface TagRead {
  uid: string;
  rssi: number | null;
  at: Microseconds;
  count: number;
  place: [number, number] | null;
}

export interface FloorRound {
  utime: Microseconds;
  expected: string[];
  read: TagRead[];
  missed: string[];
  unexpected: string[];
}

export interface Trouble {
  code: string;
  subject: string;
  since_utime: Microseconds;
  text: string;
  remedy: string;
}

export type StopWord = 'idle' | 'requested' | 'acknowledged' | 'silent';

export interface StopDevice {
  device: string;
  state: StopWord;
  latched: boolean | null;
  reason: string;
}

export interface Stop {
  state: StopWord;
  request?: Microseconds;
  devices: StopDevice[];
}

/** As /channels.json has them. */
export interface ChannelFigures {
  type: string;
  hz: number | null;
  age_s: number | null;
  lost: number | null;
  writers: number | string[];
  stale: boolean;
  bytes: number;
  bytes_per_second: number | null;
  undecodable: number;
  /** How many messages break their type's rules, and how the last one did. */
  refused?: number;
  refusal?: string;
}

export type CommandKind = 'start' | 'carry' | 'abort' | 'home' | 'drive' | 'reset';

/** Who commands, and what can be commanded: of this conversation. */
export interface Desk {
  /** Of this conversation's commands. */
  session: string;
  /** Its token is that of commands. */
  may: boolean;
  holder: 'none' | 'you' | 'another';
  /** When the lease began. */
  since: Microseconds;
  /** Names of marks that can be taken. */
  targets: string[];
  /** Why each cannot be done for now; empty where it can. Carrying is starting. */
  why: Record<Exclude<CommandKind, 'carry'>, string>;
}

export interface Answer {
  seq: number | string;
  state: 'refused' | 'sent' | 'under_way' | 'done' | 'failed' | 'unanswered';
  /** The rule by which it was refused. */
  code: string;
  text: string;
}

export interface Play {
  utime: Microseconds;
  playing: boolean;
  speed: number;
}

export interface Update {
  type: 'update';
  /** To be told back by `took`. */
  number?: number;
  /** The source begins anew (a log was sought): what was known before no longer holds. */
  anew?: boolean;
  now: Microseconds;
  slots?: Slot[];
  events?: RobotEvent[];
  arm?: ArmPoints | null;
  places?: Places | null;
  floor?: FloorRound | null;
  troubles?: Trouble[];
  stop?: Stop;
  figures?: Record<string, ChannelFigures>;
  latency?: Record<string, number | null>;
  play?: Play;
  /** Only where commands are enabled. */
  desk?: Desk;
  answers?: Answer[];
}

export interface PictureHeader {
  number: number;
  frame_session: string;
  frame_seq: string;
  utime: Microseconds;
  at: Microseconds;
  width: number;
  height: number;
  left_size: number;
  right_size: number;
  detection: BusMessage | null;
  matches: BusMessage | null;
  pose: BusMessage | null;
  servo: BusMessage | null;
}

/** `take`: also from another. */
export interface LeaseWord {
  type: 'lease';
  on: boolean;
  take?: boolean;
}

export interface CommandWord {
  type: 'command';
  session: string;
  seq: number;
  /** us by mmi's clock, as text. */
  expires: string;
  kind: CommandKind;
  target?: string;
  /** x, y and heading in W. */
  place?: Point;
}

export type ToServer =
  | LeaseWord
  | CommandWord
  | {type: 'hello'; protocol: 1; token?: string}
  | {type: 'pictures'; on: boolean}
  | {type: 'seen'; number: number}
  | {type: 'took'; number: number}
  | {type: 'look'; channels: string[]}
  | {type: 'stop'; reason: string}
  | {type: 'play'; speed: number}
  | {type: 'pause'}
  | {type: 'seek'; utime: string}
  | {type: 'step'; by: 1 | -1};

/** A binary message taken apart; the images stay parts of `bytes`. Throws RangeError when the lengths do not fit. */
export function parsePicture(bytes: ArrayBuffer): {header: PictureHeader; left: Uint8Array; right: Uint8Array} {
  const header_size = bytes.byteLength < 4 ? -1 : new DataView(bytes).getUint32(0, true);
  if (header_size < 0 || 4 + header_size > bytes.byteLength) throw new RangeError('picture: its header is cut off');
  const header = JSON.parse(new TextDecoder().decode(new Uint8Array(bytes, 4, header_size))) as PictureHeader;
  const left_begin = 4 + header_size;
  if (left_begin + header.left_size + header.right_size > bytes.byteLength) {
    throw new RangeError('picture: its images are cut off');
  }
  return {
    header,
    left: new Uint8Array(bytes, left_begin, header.left_size),
    right: new Uint8Array(bytes, left_begin + header.left_size, header.right_size),
  };
}
