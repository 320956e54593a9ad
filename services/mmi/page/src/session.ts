import {Connection} from './connection.js';
import {microseconds} from './format.js';
import {Operator} from './operate/operator.js';
import {PictureDecoder} from './pictures.js';
import {parsePicture} from './protocol.js';
import {Store} from './store.js';
import {readAddress} from './address.js';

export const store = new Store();

/** What the page draws from messages of the bus; the parts of updates come without asking. */
const kDrawnChannels = [
  'TASK_STATE',
  'SERVO_STATUS',
  'SERVO_GOAL',
  'JOINT_STATE',
  'JOINT_COMMAND',
  'ROBOT_POSE',
  'BASE_GOAL',
  'BASE_STATUS',
  'SONAR_SCAN',
  'SIM_BASE_TRUTH',
  'SERVICE_STATUS',
  'PROCESS_STATUS',
  'RECORDER_STATUS',
  'STOP_STATE',
  'RFID_TAG_HITS',
];

/** A seek takes 0.2 s at most; a flash of no picture before that would be worse than the old one. */
const kPictureAwaited_ms = 400;

/** How often it is asked whether the lease wants a word: it is renewed each second. */
const kLeaseStep_ms = 100;

const token = readAddress(location.hash).token;

/** Numbers of the pictures that mmi sent and that it has not been told of as drawn. */
const under_way = new Set<number>();

function acknowledge(number: number): void {
  if (under_way.delete(number)) connection.send({type: 'seen', number});
}

const decoder = new PictureDecoder(
  (picture) => {
    const old = store.picture;
    store.picture = picture;
    store.tell('picture');
    old?.left.close();
    old?.right.close();
    requestAnimationFrame(() => acknowledge(picture.header.number));
  },
  (number) => acknowledge(number),
);

export const connection = new Connection(
  `${location.protocol === 'https:' ? 'wss' : 'ws'}://${location.host}/socket`,
  token,
  {
    onHello: (hello) => {
      under_way.clear();
      operator.onHello();
      store.onHello(hello);
      askForWhatIsDrawn();
    },
    onUpdate: (update) => {
      operator.onUpdate(update, performance.now());
      store.onUpdate(update);
      if (update.anew) awaitPicture();
      if (store.past_is_lost) dropLostPicture();
    },
    onLife: (life, why) => {
      operator.onLife(life);
      store.onLife(life, why);
    },
    onStopFate: () => store.tell('choice'),
    onPicture: (bytes) => {
      const header = parsePicture(bytes).header;
      if (!store.is_log) store.pictures.add(microseconds(header.at), bytes);
      under_way.add(header.number);
      if (store.paused_at === null) decoder.ask(bytes);
      else acknowledge(header.number);
    },
  },
);

export const operator = new Operator(
  (word) => connection.send(word),
  () => store.tell('operate'),
);

let further_channels: string[] = [];

/** Asks for what is always drawn, and for `further` channels, from now on. */
export function askForWhatIsDrawn(further: string[] = further_channels): void {
  further_channels = further;
  const known = new Set(store.hello?.channels.map((row) => row.name));
  connection.look([...kDrawnChannels, ...further].filter((name) => known.has(name)));
}

function showNoPicture(): void {
  store.picture?.left.close();
  store.picture?.right.close();
  store.picture = null;
  store.tell('picture');
}

/** A log was sought: the picture that is drawn is of another time, and goes unless the right one comes soon. */
function awaitPicture(): void {
  const old = store.picture;
  setTimeout(() => {
    if (old !== null && store.picture === old) showNoPicture();
  }, kPictureAwaited_ms);
}

/** The past that is shown has moved on to what is still kept; a picture of before is of another time than the rest. */
function dropLostPicture(): void {
  if (store.picture && microseconds(store.picture.header.at) < (store.kept_begin ?? -Infinity)) showNoPicture();
}

/** Draws the picture that was the newest at `at` (us), of those that are kept. */
export function showPastPicture(at: number): void {
  const past = store.pictures.at(at);
  if (past) decoder.ask(past.bytes);
  else showNoPicture();
}

const picture_viewers = new Set<unknown>();

/** `viewer` draws pictures from now on, or no longer does. */
export function viewPictures(viewer: unknown, on: boolean): void {
  if (on) picture_viewers.add(viewer);
  else picture_viewers.delete(viewer);
  connection.pictures(picture_viewers.size > 0 && !document.hidden);
}

function keepLease(): void {
  operator.step(performance.now(), document.visibilityState === 'visible');
}

export function start(): void {
  document.addEventListener('visibilitychange', () => {
    connection.pictures(picture_viewers.size > 0 && !document.hidden);
    keepLease();
  });
  setInterval(keepLease, kLeaseStep_ms);
  connection.start();
}
