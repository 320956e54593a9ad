// Stop, in real time, while ten clients look: from a click or key to STOP on the bus, and on to every device's echo, in
// turn with scripts/task stop; and what the page says of devices that are silent.
import {openBrowser, openPage} from '../lib/browser.mjs';
import {BusEar} from '../lib/bus_ear.mjs';
import {lose, loseNothing} from '../lib/loss.mjs';
import {kRepository, Process} from '../lib/process.mjs';
import {quantile} from '../lib/report.mjs';
import {Stack, task} from '../lib/stack.mjs';
import {must, pause} from '../lib/wait.mjs';

const kDevices = ['arm', 'base'];
const kSilentRounds = 10;
const kPatience_s = 10;
const kClickToBus_ms = 100;
const kAboveTask_ms = 20;
const kNamedWithin_ms = 500;
/** s; longer than all rounds: it is ended with them. */
const kCrowd_s = 7200;
/** The packets of STOP_STATE in which base speaks, as nft says it: the channel's name, and the first text. */
const kStatesOfBase = `@th,128,80 0x${Buffer.from('STOP_STATE').toString('hex')} `
  + `@th,504,32 0x${Buffer.from('base').toString('hex')}`;
/** What a test calls itself in its STOP. */
const kSource = 'bench';

/** Inside the page: when Stop was asked for by hand, and what the page then said of it. */
function noteStops() {
  // By the wall clock, as the ear on the bus.
  const now = (at_ms) => Date.now() - performance.now() + at_ms;
  window.stops = {asked_ms: null, said: []};
  for (const name of ['pointerdown', 'keydown'])
    addEventListener(name, (event) => (window.stops.asked_ms ??= now(event.timeStamp)), true);
  const last = new Map();
  const note = () => {
    for (const element of document.querySelectorAll('[data-stop]')) {
      const who = element.dataset.device ?? 'all';
      if (last.get(who) === element.dataset.stop) continue;
      last.set(who, element.dataset.stop);
      window.stops.said.push({at_ms: now(performance.now()), who, state: element.dataset.stop});
    }
  };
  const what = {subtree: true, childList: true, attributes: true, attributeFilter: ['data-stop']};
  new MutationObserver(note).observe(document, what);
}

const ways = [
  ['click', (page) => page.mouse.down().then(() => page.mouse.up())],
  ['Escape', (page) => page.keyboard.press('Escape')],
  ['S', (page) => page.keyboard.press('s')],
];

const sayings = (page) => page.evaluate(() => window.stops);
const stateOf = (page, who = 'all') => page.evaluate((wanted) =>
  document.querySelector(wanted === 'all' ? 'button.stop' : `[data-device=${wanted}]`)?.dataset.stop, who);

/** Nothing is stopped, and page and ear have heard so. */
async function release(page, ear) {
  ear.forget();
  await task('reset');
  await must('all devices free', () => ear.free(kDevices), kPatience_s, 5);
  await must('no stop on the page', async () => (await stateOf(page)) === 'idle', kPatience_s, 5);
  const {x, y, width, height} = await page.locator('button.stop').boundingBox();
  await page.mouse.move(x + width / 2, y + height / 2);
  await page.evaluate(() => (window.stops = {asked_ms: null, said: []}));
  ear.forget();
}

async function stopByPage(page, ear, [, act]) {
  await release(page, ear);
  await act(page);
  const stop = await must('STOP on the bus', () => ear.stopBy('page'), kPatience_s, 5);
  const echoes = await must("every device's echo", () => ear.echoes(stop, kDevices), kPatience_s, 5);
  await must('acknowledged', async () => (await stateOf(page)) === 'acknowledged', kPatience_s, 10);
  const {asked_ms, said} = await sayings(page);
  const acknowledged_ms = said.find((one) => one.who === 'all' && one.state === 'acknowledged').at_ms;
  return {click_to_bus_ms: stop.at_ms - asked_ms, bus_to_echo_ms: Math.max(...echoes) - stop.at_ms,
    echo_to_page_ms: acknowledged_ms - Math.max(...echoes)};
}

async function stopByTask(page, ear) {
  await release(page, ear);
  await task('stop', '--source', kSource);
  const stop = await must('STOP on the bus', () => ear.stopBy(kSource), kPatience_s, 5);
  const echoes = await must("every device's echo", () => ear.echoes(stop, kDevices), kPatience_s, 5);
  return Math.max(...echoes) - stop.at_ms;
}

/** Devices that say nothing, from `silence()` to `speech()`: when each of `silent` was named, ms after the click. */
async function stopInSilence(page, ear, silent, silence, speech) {
  await release(page, ear);
  await silence();
  try {
    await ways[0][1](page);
    await must(`${silent.join()} named`, async () => {
      const states = await Promise.all(silent.map((device) => stateOf(page, device)));
      return states.every((state) => state === 'silent');
    }, kPatience_s, 20);
    await pause(300); // for what the page would say wrongly
    const {asked_ms, said} = await sayings(page);
    const named = silent.map((device) =>
      said.find((one) => one.who === device && one.state === 'silent').at_ms - asked_ms);
    return {named_ms: Math.max(...named), early: said.some((one) => one.who === 'all' && one.state === 'acknowledged')};
  } finally {
    await speech();
    await must('acknowledged at last', async () => (await stateOf(page)) === 'acknowledged', kPatience_s, 20);
  }
}

function add(report, what, values, bar_ms, rounds) {
  for (const [name, q] of [['p50', 0.5], ['p99', 0.99]]) {
    const value = quantile(values, q);
    const barred = name === 'p99' && bar_ms !== null;
    report.add(`${what}, ${name} of ${values.length}, ms`, value, barred ? String(bar_ms) : null,
      barred ? value <= bar_ms : null, name === 'p99' ? {rounds} : {});
  }
}

async function measureRounds(report, page, ear, rounds) {
  const [by_page, by_task, failed] = [[], [], []];
  for (let i = 0; i < rounds; ++i) {
    try {
      const way = ways[i % ways.length];
      by_page.push({way: way[0], ...await stopByPage(page, ear, way)});
      by_task.push(await stopByTask(page, ear));
    } catch (error) {
      failed.push(`round ${i}: ${error.message}`);
    }
  }
  const of = (name) => by_page.map((round) => round[name]);
  add(report, 'click or key to STOP on the bus', of('click_to_bus_ms'), kClickToBus_ms, by_page);
  add(report, "STOP on the bus to every device's echo, page", of('bus_to_echo_ms'), null, []);
  add(report, "STOP on the bus to every device's echo, scripts/task", by_task, null, by_task);
  const above = quantile(of('bus_to_echo_ms'), 0.5) - quantile(by_task, 0.5);
  report.add("the page's median above scripts/task's, ms", above, String(kAboveTask_ms), above <= kAboveTask_ms);
  add(report, 'last echo to "acknowledged" in the page', of('echo_to_page_ms'), null, []);
  const early = of('echo_to_page_ms').filter((value) => value < 0).length;
  report.add('"acknowledged" before every echo', early, '0', early === 0);
  report.add('rounds that did not come to their end', failed.join('; ') || 0, '0', failed.length === 0);
}

async function measureSilence(report, page, ear, stack) {
  const simulator = stack.pidOf('simulator');
  const all = [];
  const one = [];
  for (let i = 0; i < kSilentRounds; ++i) {
    const signal = (name) => () => process.kill(simulator, name);
    all.push(await stopInSilence(page, ear, kDevices, signal('SIGSTOP'), signal('SIGCONT')));
    one.push(await stopInSilence(page, ear, ['base'], () => lose(kStatesOfBase), loseNothing));
  }
  for (const [what, rounds] of [['all devices silent', all], ['one of two silent', one]]) {
    const slowest = Math.max(...rounds.map((round) => round.named_ms));
    report.add(`${what}: click to named in the page, slowest of ${rounds.length}, ms`, slowest, String(kNamedWithin_ms),
      slowest <= kNamedWithin_ms, {rounds});
    const early = rounds.filter((round) => round.early).length;
    report.add(`${what}: "acknowledged" all the same`, early, '0', early === 0);
  }
}

export async function measure(report, {bin, rounds}) {
  const stack = new Stack({bin});
  const browser = await openBrowser();
  const ear = new BusEar();
  try {
    await stack.start();
    await ear.listens();
    const page = await openPage(browser, stack.address, 'grasp', {before: noteStops});
    const crowd = new Process(['node', `${kRepository}/tests/bench/page/crowd.mjs`, String(kCrowd_s), '--port',
      new URL(stack.address).port]);
    await measureRounds(report, page, ear, rounds);
    await crowd.end('SIGKILL');
    await measureSilence(report, page, ear, stack);
  } finally {
    await loseNothing();
    await ear.end();
    await browser.close();
    await stack.stop();
  }
}
