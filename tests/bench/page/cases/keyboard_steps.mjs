// The whole job by keyboard alone: each step throws where it cannot be done. A page begins with nothing in focus.
import {tabTo} from '../lib/keyboard.mjs';
import {task} from '../lib/stack.mjs';
import {must, pause} from '../lib/wait.mjs';

const kViews = ['grasp', 'drive', 'health', 'log'];
const kPatience_s = 10;
const kPicturesBefore = 4;
const kSameBefore = 4;
/** ms: long enough for what should not happen to be seen, were it to happen. */
const kNothing_ms = 700;

const left = '.image-frame[data-side=left]';
const frameOf = (page) => page.getAttribute(left, 'data-frame-seq');
const viewOf = (page) => page.getAttribute('[data-view]', 'data-view');
const isPast = async (page) => (await page.getAttribute('body', 'data-past')) === 'yes';
const stopOf = (page) => page.getAttribute('button.stop', 'data-stop');
/** us; the address has it of what is held. */
const timeOf = (page) => /[#&]at=(\d+)/.exec(page.url())?.[1] ?? null;
const placeOf = (page) => page.textContent('output.time span');

function expect(holds, words) {
  if (!holds) throw new Error(words);
}

/** The frame that stays drawn, once it does: a seek on a busy machine may leave the old one for a while. */
async function settled(page) {
  const frames = [];
  await must('a picture that stays', async () => {
    await pause(kNothing_ms);
    frames.unshift(await frameOf(page));
    const last = frames.slice(0, kSameBefore);
    return last.length === kSameBefore && frames[0] && last.every((frame) => frame === frames[0]);
  }, kPatience_s);
  return frames[0];
}

async function press(page, key, times = 1) {
  for (let i = 0; i < times; ++i) await page.keyboard.press(key);
}

async function openViews(page) {
  await tabTo(page, '[role=tab][aria-selected=true]');
  for (const view of [...kViews.slice(1), kViews[0]]) {
    await press(page, 'ArrowDown');
    await must(`the arrow opens ${view}`, async () => (await viewOf(page)) === view, kPatience_s);
  }
  for (const [index, view] of kViews.entries()) {
    await press(page, String(index + 1));
    await must(`key ${index + 1} opens ${view}`, async () => (await viewOf(page)) === view, kPatience_s);
  }
  await press(page, '1');
}

async function freeze(page) {
  const seen = new Set();
  await must('some pictures', async () => seen.add(await frameOf(page)).size > kPicturesBefore, kPatience_s);
  await tabTo(page, '.transport .play');
  await press(page, 'Space');
  await must('the past', () => isPast(page), kPatience_s);
  const frozen = await settled(page);
  await pause(kNothing_ms);
  expect((await frameOf(page)) === frozen, `frozen at ${frozen}, and then ${await frameOf(page)}`);
  await press(page, ',');
  await must('one picture back', async () => Number(await frameOf(page)) < Number(frozen), kPatience_s);
  await press(page, '.');
  await must('one picture on', async () => (await frameOf(page)) === frozen, kPatience_s);
}

async function zoom(page) {
  const place = () => page.$eval(`${left} .stage`, (stage) => stage.style.transform);
  await tabTo(page, left);
  await press(page, '+', 4);
  await must('larger', async () => Number(/scale\(([\d.]+)\)/.exec(await place())?.[1]) > 2, kPatience_s);
  const before = await place();
  await press(page, 'ArrowRight', 2);
  await must('moved', async () => (await place()) !== before, kPatience_s);
}

async function backToLive(page) {
  await press(page, 'l');
  await must('live', async () => !(await isPast(page)), kPatience_s);
}

async function chooseMark(page) {
  await tabTo(page, '.mark-button');
  await press(page, 'Enter');
  await must('a mark is lit up', async () => (await page.locator('.mark-button[aria-pressed=true]').count()) === 1
    && /select=/.test(page.url()), kPatience_s);
}

async function chooseEvent(page) {
  await tabTo(page, '.events.scroll');
  await press(page, 'ArrowDown', 2);
  const number = await page.evaluate(() => document.activeElement.closest('[data-event]')?.dataset.event ?? null);
  expect(number !== null, 'the arrow leads to no event');
  await press(page, 'Enter');
  await must('its time is shown', () => isPast(page), kPatience_s);
  await backToLive(page);
}

async function openFields(page) {
  await press(page, '3');
  await tabTo(page, 'mmi-channels .row-button');
  const channel = await page.evaluate(() => document.activeElement.textContent.trim());
  await press(page, 'Enter');
  await must(`the fields of ${channel}`, async () => (await page.locator('mmi-fields tr').count()) > 3
    && (await page.textContent('mmi-fields .fields-head')).includes(channel), kPatience_s);
  await tabTo(page, 'mmi-fields .row-button');
  await press(page, 'Enter');
  await must('a number is plotted', () => page.locator('mmi-fields [aria-pressed=true]').count().then((n) => n > 0),
    kPatience_s);
}

async function zoomCurves(page) {
  const whole = '.plot-tools .whole';
  await press(page, '4');
  await tabTo(page, '.plot-tools [aria-label="Less time"]');
  await press(page, 'Enter', 2);
  await tabTo(page, whole);
  await press(page, 'Enter');
  await must('whole time again', () => page.locator(`${whole}[disabled]`).count(), kPatience_s);
  await press(page, '1');
}

async function moveFloor(page) {
  const place = () => page.$eval('[data-pose=fused]', (robot) => robot.getBoundingClientRect().x);
  await press(page, '2');
  await must('the robot on the floor', () => page.locator('[data-pose=fused]').count(), kPatience_s);
  await tabTo(page, '.floor');
  const before = await place();
  await press(page, '+', 2);
  await press(page, 'ArrowLeft', 2);
  await must('the floor moves', async () => Math.abs((await place()) - before) > 20, kPatience_s);
  await press(page, '1');
}

/** Nothing stops while S is typed, and Escape stops all the same. */
async function type(page) {
  await task('reset');
  await must('no stop', async () => (await stopOf(page)) === 'idle', kPatience_s);
  await page.evaluate(() => {
    const field = document.createElement('input');
    field.id = 'typed';
    document.body.append(field);
    field.focus();
  });
  await press(page, 's');
  await pause(kNothing_ms);
  expect((await page.inputValue('#typed')) === 's', 'S was not typed');
  expect((await stopOf(page)) === 'idle', 'S stopped while it was typed');
  await stopBy(page, 'Escape');
  await page.$eval('#typed', (field) => field.remove());
}

async function stopBy(page, key) {
  await task('reset');
  await must('no stop', async () => (await stopOf(page)) === 'idle', kPatience_s);
  await press(page, key);
  await must('all acknowledged', async () => (await stopOf(page)) === 'acknowledged', kPatience_s);
  const devices = await page.$$eval('[data-device]', (all) =>
    all.map((one) => `${one.dataset.device} ${one.dataset.stop}`));
  expect(devices.length > 0 && devices.every((one) => one.endsWith(' acknowledged')), devices.join());
}

/** A list that is open hands Escape on, closes by it, and chooses nothing. */
async function stopFromAList(page) {
  const box = '.kinds [role=combobox]';
  const isOpen = async () => (await page.getAttribute(box, 'aria-expanded')) === 'true';
  await tabTo(page, box);
  await press(page, 'ArrowDown', 2);
  await must('a list that is open', isOpen, kPatience_s);
  await stopBy(page, 'Escape');
  expect(!(await isOpen()), 'the list is still open');
  expect((await page.textContent(box)).includes('all kinds'), 'Escape chose');
}

async function stopFromFullView(page) {
  await tabTo(page, '.expand');
  await press(page, 'Enter');
  await must('enlarged', async () => (await page.locator('.panel.is-large').count()) === 1, kPatience_s);
  await stopBy(page, 's');
  await press(page, 'Enter');
  await must('as before', async () => (await page.locator('.panel.is-large').count()) === 0, kPatience_s);
}

export const liveSteps = {
  'each view opened': openViews,
  'a picture frozen, one back, one on': freeze,
  'a picture enlarged and moved': zoom,
  'live again': backToLive,
  'a mark chosen': chooseMark,
  'an event chosen': chooseEvent,
  "a channel's fields opened, one plotted": openFields,
  'the floor enlarged and moved': moveFloor,
  'curves enlarged and whole again': zoomCurves,
  'S while typing types, Escape stops': type,
  'Escape stops from a list that is open': stopFromAList,
  'Stop by Escape, every device acknowledged': (page) => stopBy(page, 'Escape'),
  'Stop by S, every device acknowledged': (page) => stopBy(page, 's'),
  'Stop by S with a panel enlarged': stopFromFullView,
  'Stop by Tab and Enter': async (page) => {
    await task('reset');
    await must('no stop', async () => (await stopOf(page)) === 'idle', kPatience_s);
    await tabTo(page, 'button.stop');
    await press(page, 'Enter');
    await must('all acknowledged', async () => (await stopOf(page)) === 'acknowledged', kPatience_s);
  },
};

async function seek(page) {
  await tabTo(page, 'mmi-time input[type=range]');
  await press(page, 'Home');
  await must('the beginning', async () => (await placeOf(page)).trim().startsWith('0 ms of'), kPatience_s);
  await press(page, 'PageUp', 3);
  await must('a later time', async () => !(await placeOf(page)).trim().startsWith('0 ms of'), kPatience_s);
  await must('a picture', () => frameOf(page), kPatience_s);
}

async function play(page) {
  await tabTo(page, '.transport .play');
  const before = await placeOf(page);
  await press(page, 'Space');
  await must('time goes on', async () => (await placeOf(page)) !== before, kPatience_s);
  const says = () => page.getAttribute('.transport .play', 'aria-label');
  await must('it plays', async () => (await says()) === 'Pause', kPatience_s);
  await press(page, 'k');
  await must('it is paused', async () => (await says()) === 'Play', kPatience_s);
}

async function step(page) {
  await tabTo(page, 'mmi-time input[type=range]');
  await press(page, 'Home');
  await press(page, 'PageUp', 3);
  const frame = await settled(page);
  await press(page, '.');
  await must('one picture on', async () => Number(await frameOf(page)) > Number(frame), kPatience_s);
  await press(page, ',');
  await must('one picture back', async () => (await frameOf(page)) === frame, kPatience_s);
}

async function nextEvent(page) {
  const before = timeOf(page);
  await press(page, 'n');
  await must('the next event', () => timeOf(page) !== before, kPatience_s);
  const there = timeOf(page);
  await press(page, 'n');
  await must('the one after', () => timeOf(page) !== there, kPatience_s);
  await press(page, 'p');
  await must('the one before', () => timeOf(page) === there, kPatience_s);
}

export const logSteps = {
  'each view opened': openViews,
  'sought by the time line': seek,
  'played and paused': play,
  'stepped by pictures': step,
  'from event to event': nextEvent,
  'an event chosen': async (page) => {
    const before = timeOf(page);
    await tabTo(page, '.events.scroll');
    await press(page, 'ArrowDown', 3);
    await press(page, 'Enter');
    await must('its time is shown', () => timeOf(page) !== before, kPatience_s);
  },
  'no Stop in a log': async (page) => {
    await press(page, 's');
    await press(page, 'Escape');
    expect((await page.locator('button.stop').count()) === 0, 'a log has a Stop');
  },
};
