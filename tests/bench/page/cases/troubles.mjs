// Each trouble, brought about for real: how soon it is first in the status line and in /state.json, and how soon gone.
import {copyFileSync} from 'node:fs';
import {openBrowser, openPage} from '../lib/browser.mjs';
import {kRepository} from '../lib/process.mjs';
import {Stack, task} from '../lib/stack.mjs';
import {StateLog, watchStatusLine} from '../lib/trouble_log.mjs';
import {pause, until} from '../lib/wait.mjs';
import {kInjections} from './injections.mjs';

const kToldWithin_s = 1;
const kSilenceWithin_s = 4;
const kGoneWithin_s = 2;
const kReadable_px = 28;
const kPatience_s = 20;

const lines = (page) => page.evaluate(() => window.statusLines);
const names = (line, {code, subject}) => line?.code === code && line.subject.includes(subject);

async function quiet(page) {
  await task('reset');
  if (await until(async () => (await lines(page)).at(-1)?.code === 'none', 3)) return;
  await task('home'); // what was refused is, until the next command
  const last = async () => (await lines(page)).at(-1);
  if (await until(async () => (await last())?.code === 'none', 20)) return;
  throw new Error(`not tried, for this stays: ${JSON.stringify(await last())}`);
}

/** When it came to be first, and by what. */
async function waitUntilFirst(page, log, injection, begun_ms) {
  const is_it = (line) => line.at_ms >= begun_ms && names(line, injection);
  const shown = await until(async () => (await lines(page)).find(is_it), kPatience_s);
  // The page alone knows that it hears nothing.
  const told = injection.code === 'mmi_lost' ? null
    : await until(() => log.entries.find((entry) => entry.at_ms >= begun_ms && names(entry.worst, injection)), 2);
  await pause(200); // the remedy is judged once it is laid out
  const last = (await lines(page)).findLast((line) => names(line, injection));
  return {shown: shown && {...shown, remedy_seen: last.remedy_seen}, told};
}

async function goneSince(page, log, injection, mended_ms) {
  const left = await until(async () => {
    const all = await lines(page);
    const last = all.findLastIndex((line) => names(line, injection));
    return last >= 0 && last + 1 < all.length ? all[last + 1] : null;
  }, kPatience_s);
  const untold = await until(() => log.entries.find((entry) => entry.at_ms >= mended_ms && entry.said !== null
    && entry.all.every((trouble) => trouble.code !== injection.code)), kPatience_s);
  return {left, untold};
}

const seconds = (to_ms, from_ms) => (to_ms === undefined || to_ms === null ? null : (to_ms - from_ms) / 1000);
const words = (value) => (value === null || Number.isNaN(value) ? 'never' : `${Math.max(0, value).toFixed(2)} s`);

async function tryOne(report, page, world, injection) {
  await quiet(page);
  await injection.prepare?.(world);
  const log = new StateLog(world.stack.address);
  const begun_ms = Date.now();
  const caused = injection.cause(world);
  const {shown, told} = await waitUntilFirst(page, log, injection, begun_ms);
  await caused;
  const working = await injection.mend(world);
  const mended_ms = Date.now();
  const {left, untold} = await goneSince(page, log, injection, mended_ms);
  await log.end();
  await working;
  await injection.after?.(world);
  judge(report, injection, {begun_ms, mended_ms, shown, told, left, untold});
}

function judge(report, injection, {begun_ms, mended_ms, shown, told, left, untold}) {
  // mmi says when it heard the first message that tells it, or, of silence, the last one.
  const first_ms = told ? Number(told.worst.since_utime) / 1000 : begun_ms;
  const bar_s = injection.by === 'silence' ? kSilenceWithin_s : kToldWithin_s;
  const [page_s, state_s] = [seconds(shown?.at_ms, first_ms), seconds(told?.at_ms, first_ms)];
  const cause_s = seconds(shown?.at_ms, begun_ms);
  const [gone_s, untold_s] = [seconds(left?.at_ms, mended_ms), seconds(untold?.at_ms, mended_ms)];
  const state_in_time = injection.code === 'mmi_lost' || (state_s !== null && state_s <= bar_s + 0.1);
  const in_time = page_s !== null && page_s <= bar_s && state_in_time;
  const gone = gone_s !== null && gone_s <= kGoneWithin_s && untold_s !== null && untold_s <= kGoneWithin_s + 0.1;
  const readable = !!shown && shown.remedy !== '' && shown.remedy_seen;
  const message = injection.by === 'silence' ? 'last' : 'first';
  report.add(`${injection.code}: page ${words(page_s)}, state.json ${words(state_s)} after the ${message} message`
    + ` (${words(cause_s)} after its cause); gone ${words(gone_s)}, ${words(untold_s)} after it was mended; remedy`,
    readable ? 'seen' : 'NOT SEEN', `${bar_s} s, gone ${kGoneWithin_s} s`, in_time && gone && readable,
    {code: injection.code, page_s, state_s, cause_s, gone_s, untold_s, shown, told: told?.worst ?? null});
}

export async function measure(report, {bin, only = process.env.TROUBLES?.split(',')}) {
  const stack = new Stack({bin});
  stack.robot_file = `${stack.folder}/robot.yaml`;
  copyFileSync(`${kRepository}/config/robot.yaml`, stack.robot_file);
  const browser = await openBrowser();
  try {
    await stack.start();
    const page = await openPage(browser, stack.address, 'grasp', {before: watchStatusLine});
    for (const injection of kInjections) {
      if (only && !only.includes(injection.code)) continue;
      try {
        await tryOne(report, page, {bin, stack}, injection);
      } catch (error) {
        report.add(injection.code, error.message, null, false);
      }
    }
    const good = report.figures.filter((figure) => figure.holds).length;
    const all = report.figures.length;
    report.add('troubles told in time and gone in time', `${good} of ${all}`, 'all', good === all);
    const sizes = report.figures.map((figure) => figure.shown?.size_px).filter(Boolean);
    const least = Math.min(...sizes);
    report.add('smallest letters of the status line, px', least, String(kReadable_px), least >= kReadable_px);
  } finally {
    await browser.close();
    await stack.stop();
  }
}
