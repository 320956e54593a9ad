// Whether the page draws what the bus says: live, in lockstep, and the same run from its recording.
import {kRepository, Process} from '../lib/process.mjs';
import {openBrowser, openPage} from '../lib/browser.mjs';
import {ask, installProbe, sampled} from '../lib/page_probe.mjs';
import {newestAt, readRecording, recordedPicture} from '../lib/recording.mjs';
import {RecordedRun} from '../lib/recorded_run.mjs';
import {readRobot} from '../lib/robot_arithmetic.mjs';
import {canvasPicture, ScreenshotReader, shots} from '../lib/screenshot.mjs';
import {udpSocketsOf} from '../lib/sockets.mjs';
import {TruthReport} from '../lib/truth_report.mjs';
import {must, pause} from '../lib/wait.mjs';

const kSeeds = [1, 2];
const kInstants = 20;
const kStepToOther = 7; // prime to kInstants: the second time each instant is come to from another one
const kLogPort = 8090;
const kTask_s = 600;
const kBetweenShots_ms = 6000;
const kListSettled_ms = 2000;
const kSettled_ms = 600; // of a log's page after a seek: an old picture goes after 400 ms
const kAnswered_us = 20e3; // a frame is recorded this much before the answer to the one before, at most
const kMarks = ['hand', 'red_book', 'yellow_book', 'blue_book'];

// Holds the page still, looks where the crosses stand in its pixels, and goes on.
async function shootPaused(page, reader) {
  await page.keyboard.press('k');
  await page.waitForSelector('body[data-past=yes]');
  await pause(kSettled_ms);
  const {id} = (await ask(page, 'readImages'))[0];
  const shot = {id, crosses: await reader.crosses(page, kMarks)};
  await page.keyboard.press('l');
  return shot;
}

async function watchLive(run, {browser, reader, errors}) {
  const grasp = await openPage(browser, run.address, 'grasp', {errors, before: installProbe});
  const drive = await openPage(browser, run.address, 'drive', {errors, before: installProbe});
  const referee = run.begin();
  const paused = [];
  const end = Date.now() + 1000 * kTask_s;
  while (referee.code === undefined && Date.now() < end) {
    await pause(kBetweenShots_ms);
    if ((await ask(grasp, 'readImages'))[0].id !== '') paused.push(await shootPaused(grasp, reader));
  }
  if (referee.code === undefined) throw new Error(`the task: not done within ${kTask_s} s: ${referee.said.slice(-500)}`);
  await pause(kListSettled_ms);
  const rows = await ask(grasp, 'readTaskEvents');
  const [of_grasp, of_drive] = [await sampled(grasp), await sampled(drive)];
  await Promise.all([grasp.close(), drive.close()]);
  return {rows, paused, ...of_grasp, poses: of_drive.poses, referee: referee.code};
}

function reportLive(report, live) {
  report.add('the task, exit code', live.referee, null, null);
  report.phases(live.rows);
  report.foreign(live.foreign, live.images);
  report.marks(live.marks);
  report.crosses(live.paused);
  const arms = report.arms(live.arms);
  const poses = report.poses(live.poses);
  report.add('a newer arm known, but not drawn yet, at most, s', arms.behind_ms / 1000, null, null);
  report.add('a newer pose known, but not drawn yet, at most, s', poses.behind_ms / 1000, null, null);
}

// Goes to `at` (us of the log) by the address, as a link would.
async function seek(page, at) {
  await page.evaluate((utime) => (location.hash = `view=grasp&at=${utime}`), at);
  await must(`the log's page at ${at}`, () => page.evaluate((utime) => Number(window.probe.play?.utime) === utime, at), 20);
  await page.mouse.move(0, 0);
  await pause(kSettled_ms);
  await must(`a picture at ${at}`, async () => (await ask(page, 'readImages')).every(({id}) => id !== ''), 20);
  await pause(kSettled_ms / 2);
}

// Goes to an instant and reads it: screenshots of images, side view and, in the other view, floor.
async function shootInstant(page, at, read = {}) {
  await seek(page, at);
  await read.grasp?.();
  const grasp = await shots(page, ['.image-frame[data-side=left]', '.image-frame[data-side=right]', '.sides']);
  await page.keyboard.press('2');
  await page.waitForSelector('[data-view=drive] .floor svg');
  await pause(kSettled_ms / 2);
  await read.drive?.();
  return [...grasp, ...(await shots(page, ['.floor']))];
}

// Instants spread over the log, each somewhere between two frames' detections; the same ones each time.
function instantsOf({detections}, seed) {
  return Array.from({length: kInstants}, (_, i) => {
    const index = Math.floor(((i + 0.5) / kInstants) * (detections.length - 1));
    const share = ((i + 1) * 0.618 + seed * 0.37) % 1;
    return Math.round(detections[index].at + share * (detections[index + 1].at - detections[index].at));
  });
}

// s of the log between which a frame that is shown at `at` was recorded: since the answer to the one before.
async function frameWindow(page, {detections}, at, id) {
  const begin = Number((await page.evaluate(() => window.probe.log)).begin);
  const index = detections.findIndex((detection) => detection.id === id);
  const from = index > 0 ? detections[index - 1].at - kAnswered_us : begin;
  return {from_s: Math.max(0, (from - begin) / 1e6), to_s: (at - begin + 1) / 1e6};
}

function readInstant({page, reader, recording, log, bin}, at, found) {
  const of = (entries) => [newestAt(entries, at)].filter(Boolean).map(({id}) => ({id, behind_ms: 0}));
  return shootInstant(page, at, {
    grasp: async () => {
      const images = await ask(page, 'readImages');
      found.images.push(...images);
      // A frame whose marks were not known yet at that instant has none.
      found.shots.push({id: images[0].marks.length > 0 ? images[0].id : '', crosses: await reader.crosses(page, kMarks)});
      found.arms.push({views: await ask(page, 'readArm'), of: of(recording.joints)});
      const recorded = await recordedPicture(bin, log, images[0].id, await frameWindow(page, recording, at, images[0].id));
      found.pictures.push(await reader.difference(await canvasPicture(page), recorded));
    },
    drive: async () => {
      const pose = await ask(page, 'readPose');
      found.poses.push(pose ? {...pose, of: of(recording.poses)} : {pose: null, tags: null, of: []});
    },
  });
}

async function watchLog(context, seed) {
  const {page, recording} = context;
  const instants = instantsOf(recording, seed);
  const found = {images: [], shots: [], arms: [], poses: [], pictures: [], first: [], second: new Array(kInstants)};
  for (const at of instants) found.first.push(await readInstant(context, at, found));
  for (let i = 0; i < kInstants; ++i) {
    const index = (i * kStepToOther + 3) % kInstants;
    found.second[index] = await shootInstant(page, instants[index]);
  }
  await seek(page, Number((await page.evaluate(() => window.probe.log)).end));
  found.rows = await ask(page, 'readTaskEvents');
  const all = await sampled(page);
  return {...found, foreign: all.foreign, sampled: all.images};
}

function reportLog(report, found) {
  report.phases(found.rows);
  report.foreign(found.foreign, found.sampled);
  report.marks(found.images);
  report.crosses(found.shots);
  report.arms(found.arms);
  report.poses(found.poses);
  report.pictures(found.pictures);
  report.sameTwice(found.first, found.second);
}

async function measureLog(report, {bin, browser, errors, ...context}, seed) {
  const address = `http://127.0.0.1:${kLogPort}`;
  const server = new Process([`${bin}/mmi`, '--log', context.log, '--listen', address.replace('http://', '')]);
  await must(`mmi of ${context.log}`, () => fetch(`${address}/state.json`).then((answer) => answer.ok, () => {
    if (server.code !== undefined) throw new Error(server.said);
    return false;
  }), 60);
  const page = await openPage(browser, address, 'grasp', {errors, before: installProbe});
  reportLog(report, await watchLog({...context, bin, page}, seed));
  const udp = udpSocketsOf(server.pid);
  report.add('UDP sockets of mmi', udp, '0', udp === 0);
  await page.close();
  await server.end();
}

async function measureSeed(report, context, seed) {
  const run = new RecordedRun({bin: context.bin, seed});
  try {
    let live;
    try {
      await run.start();
      live = await watchLive(run, context);
    } finally {
      await run.end();
    }
    const recording = await readRecording(context.bin, run.log);
    const begin = (told) => new TruthReport(report, `seed ${seed}, ${told}`, recording, context.robot);
    reportLive(begin('live'), live);
    await measureLog(begin('log'), {...context, log: run.log, recording}, seed);
  } finally {
    run.remove();
  }
}

export async function measure(report, {bin}) {
  const browser = await openBrowser();
  try {
    const errors = [];
    const reader = await ScreenshotReader.open(browser);
    const context = {bin, browser, errors, reader, robot: readRobot(`${kRepository}/config/robot.yaml`)};
    for (const seed of kSeeds) await measureSeed(report, context, seed);
    report.add('errors inside the page', errors.length, '0', errors.length === 0, {errors: errors.slice(0, 20)});
  } finally {
    await browser.close();
  }
}
