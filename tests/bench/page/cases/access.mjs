// Whether everybody can use the page: what axe-core finds in each view, live and of a log, light and dark; and the
// whole job by keyboard alone.
import {existsSync, mkdtempSync, readFileSync, rmSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {fromPage, openBrowser, openPage} from '../lib/browser.mjs';
import {tabRound} from '../lib/keyboard.mjs';
import {kRepository, Process, run} from '../lib/process.mjs';
import {Stack, task} from '../lib/stack.mjs';
import {state} from '../lib/state.mjs';
import {must, pause} from '../lib/wait.mjs';
import {logSteps, liveSteps} from './keyboard_steps.mjs';

const kViews = ['grasp', 'drive', 'health', 'log'];
const kThemes = ['light', 'dark'];
const kGrave = ['serious', 'critical'];
const kLogPort = 8081;
const kRecorded_s = 4;
/** ms: until a view has drawn what it first hears. */
const kDrawn_ms = 2500;

/** A log: the newest that there is, else one made now, of the robot that runs. */
async function someLog(folder) {
  const newest = `${kRepository}/logs/latest`;
  if (existsSync(`${newest}/log.lcm`)) return newest;
  await run([`${kRepository}/scripts/record`, '--for', String(kRecorded_s), '--out', `${folder}/recording`]);
  return `${folder}/recording`;
}

async function findingsOf(page) {
  const axe = readFileSync(fromPage.resolve('axe-core/axe.min.js'), 'utf8');
  const {violations} = await page.evaluate(`${axe}; axe.run({resultTypes: ['violations']})`);
  return violations.map(({id, impact, nodes}) =>
    ({id, impact, at: nodes.slice(0, 3).map((node) => node.html.slice(0, 200))}));
}

async function lookAtViews(report, browser, address, source) {
  for (const colorScheme of kThemes) {
    const page = await openPage(browser, address, kViews[0], {colorScheme});
    const all = [];
    for (const view of kViews) {
      await page.goto(`${address}/#view=${view}`);
      await page.waitForSelector(`[data-view=${view}]`);
      await pause(kDrawn_ms);
      all.push(...(await findingsOf(page)).map((finding) => ({view, ...finding})));
    }
    const grave = all.filter(({impact}) => kGrave.includes(impact));
    const words = grave.map(({view, id, at}) => `${view}: ${id} ${at[0]}`).join('; ');
    report.add(`axe-core, ${kViews.length} views, ${source}, ${colorScheme}: serious or critical`, words || 0, '0',
      grave.length === 0, {findings: all});
    await page.close();
  }
}

async function tabThroughViews(report, page, source) {
  for (const view of kViews) {
    await page.keyboard.press(String(1 + kViews.indexOf(view)));
    await page.waitForSelector(`[data-view=${view}]`);
    const {reached, missed, unmarked} = await tabRound(page);
    report.add(`Tab, ${source} ${view}: out of reach, of ${reached + missed.length}`, missed.join('; ') || 0, '0',
      missed.length === 0);
    report.add(`Tab, ${source} ${view}: focus not to be seen`, unmarked.join('; ') || 0, '0', unmarked.length === 0);
  }
}

/** Each step by keyboard; why one cannot be done is said. */
async function work(report, page, source, steps) {
  for (const [name, step] of Object.entries(steps)) {
    let why = 'done';
    try {
      await step(page);
    } catch (error) {
      why = error.message.split('\n')[0];
    }
    report.add(`by keyboard, ${source}: ${name}`, why, 'done', why === 'done');
  }
}

async function freshPage(browser, address, errors) {
  const page = await openPage(browser, address, '', {errors});
  await page.waitForSelector('[data-view] canvas');
  return page;
}

async function useLog(report, browser, folder, bin, errors) {
  const log = await someLog(folder);
  const address = `http://127.0.0.1:${kLogPort}`;
  const mmi = new Process([`${bin}/mmi`, '--log', log, '--listen', `127.0.0.1:${kLogPort}`]);
  await must(`mmi shows ${log}`, async () => (await state(address)) !== null, 20);
  await lookAtViews(report, browser, address, 'log');
  const page = await freshPage(browser, address, errors);
  await tabThroughViews(report, page, 'log');
  await page.close();
  await work(report, await freshPage(browser, address, errors), 'log', logSteps);
  await mmi.end();
}

export async function measure(report, {bin}) {
  const folder = mkdtempSync(join(tmpdir(), 'bench-page-'));
  const stack = new Stack({bin});
  const browser = await openBrowser();
  const errors = [];
  try {
    await stack.start();
    await lookAtViews(report, browser, stack.address, 'stopped');
    await task('reset');
    const working = new Process([`${kRepository}/scripts/task`, 'start', '--target', 'red_book']);
    await lookAtViews(report, browser, stack.address, 'at work');
    await working.end();
    const page = await freshPage(browser, stack.address, errors);
    await tabThroughViews(report, page, 'live');
    await page.close();
    await work(report, await freshPage(browser, stack.address, errors), 'live', liveSteps);
    await useLog(report, browser, folder, bin, errors);
    report.add('errors of the page', errors.join('; ') || 0, '0', errors.length === 0);
  } finally {
    await browser.close();
    await stack.stop();
    rmSync(folder, {recursive: true, force: true});
  }
}
