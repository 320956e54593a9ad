// Commands the invented robot by mouse, touch and keyboard: node test/operate.mjs FOLDER ADDRESS, at a fake_server.mjs with
// the word `commands`. Leaves pictures in FOLDER.
import {openChromium} from './chromium.mjs';

const [folder, address] = process.argv.slice(2);
let bad = 0;
const check = (what, holds, seen = '') => {
  bad += holds ? 0 : 1;
  console.log(`${holds ? 'ok  ' : 'FAIL'} ${what} ${seen}`);
};
const browser = await openChromium();
const context = await browser.newContext({viewport: {width: 1280, height: 720}, hasTouch: true});

async function open(hash) {
  const page = await context.newPage();
  page.on('pageerror', (error) => check('no error in the page', false, error.stack));
  page.on(
    'console',
    (message) =>
      /Content Security|Refused/.test(message.text()) && check('nothing against the policy', false, message.text()),
  );
  page.words = [];
  page.on('websocket', (socket) => {
    socket.on('framesent', ({payload}) => {
      const word = JSON.parse(payload);
      if (['lease', 'command'].includes(word.type)) page.words.push({...word, at_ms: Date.now()});
    });
  });
  await page.goto(`${address}/#${hash}`);
  await page.waitForSelector('[data-operate]', {timeout: 10000});
  return page;
}
const commands = (page) => page.words.filter(({type}) => type === 'command');
const seen = (page, selector, timeout = 3000) =>
  page
    .waitForSelector(selector, {timeout, state: 'attached'})
    .then(() => true)
    .catch(() => false);
const answered = (page, kind, state, timeout = 6000) =>
  seen(page, `[data-answer][data-kind=${kind}][data-state=${state}]`, timeout);

const stranger = await open('view=grasp');
check('without a token it is said', /no token: open the address/.test(await stranger.textContent('.operate-whys')));
await stranger.click('[data-command=home]', {force: true});
await stranger.click('[data-control]', {force: true});
check('and nothing is sent', stranger.words.length === 0);
await stranger.close();

const page = await open('view=grasp&token=fake');
await page.screenshot({path: `${folder}/operate-nobody.png`});
check('nobody operates', await seen(page, '[data-operate=none]'));
check('control comes first', /no lease: take control first/.test(await page.textContent('.operate-whys')));
await page.click('[data-command=home]', {force: true});
check('a button that cannot sends nothing', commands(page).length === 0);
await page.click('[data-control]');
check('control is taken', await seen(page, '[data-operate=you]'));
check('no target is chosen', /no target chosen/.test(await page.textContent('.operate-whys')));

await page.waitForSelector('[data-mark=red_book]', {timeout: 10000});
await page.locator('[data-mark=red_book]').first().click();
check('a click in the image names it', await seen(page, '[data-command=start][data-can=yes]:has-text("red_book")'));
await page.click('[data-command=start]');
check('start is under way', await answered(page, 'start', 'under_way'));
check('meanwhile it cannot start again', await seen(page, '[data-command=start][data-can=no]'));
await page.screenshot({path: `${folder}/operate-start.png`});
await page.keyboard.press('Escape');
check('Escape stops', await seen(page, 'button.stop:not([data-stop=idle])'));
check('reset can', await seen(page, '[data-command=reset][data-can=yes]'));

await page.locator('[data-command=reset]').focus();
await page.keyboard.press('Enter');
check('reset by keyboard', await answered(page, 'reset', 'done'));
check('the start is done', await answered(page, 'start', 'done'));
await page.locator('[data-command=home]').tap();
check('home by touch', await answered(page, 'home', 'done'));

await page.keyboard.press('2');
await page.waitForSelector('.floor.is-choosing');
const box = await page.locator('.floor').boundingBox();
await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
await page.mouse.down();
await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2 - 80, {steps: 4});
await page.mouse.up();
const wished = () => page.$eval('[data-pose=wished]', ({dataset}) => [dataset.x, dataset.y, dataset.heading].map(Number));
const dragged = await wished();
check('a drag sets the heading', Math.abs(dragged[2] - Math.PI / 2) < 0.02, dragged.join());
await page.locator('.floor').focus();
await page.keyboard.press('ArrowRight');
await page.keyboard.press('Shift+ArrowRight');
const moved = await wished();
check('keys move and turn it', moved[0] > dragged[0] && moved[2] < dragged[2], moved.join());
await page.fill('[data-place-field=x]', '0.25');
await page.fill('[data-place-field=heading]', '45');
const typed = await wished();
check('fields set it', typed[0] === 0.25 && Math.abs(typed[2] - Math.PI / 4) < 1e-9, typed.join());
await page.fill('[data-place-field=y]', '');
check('an empty field is no place', /no place chosen/.test(await page.textContent('.operate-whys')));
await page.touchscreen.tap(box.x + box.width / 2, box.y + box.height / 3);
check('a tap is one', await seen(page, '[data-pose=wished]'));
await page.screenshot({path: `${folder}/operate-drive.png`});
await page.click('[data-command=drive]');
check('drive', await answered(page, 'drive', 'done'));
check('with that very place', JSON.stringify(commands(page).at(-1).place) === JSON.stringify(await wished()));
check(
  'each is numbered once',
  commands(page)
    .map(({seq}) => seq)
    .join() === '1,2,3,4',
);

for (const view of ['1', '2']) {
  await page.keyboard.press(view);
  await page.waitForTimeout(300);
  const small = await page.$$eval('mmi-operate :is(button, input), .chooser', (all) =>
    all
      .map((one) => [one.textContent.trim(), one.getBoundingClientRect()])
      .filter(([, {width, height}]) => width < 44 || height < 44)
      .map(([name, {width, height}]) => `${name} ${width} x ${height}`),
  );
  check('targets of 44 px', small.length === 0, small.join());
}

const other = await open('view=drive&token=fake');
check('another sees that', await seen(other, '[data-operate=another]'));
await other.click('[data-control]');
check('it takes over', await seen(other, '[data-operate=you]'));
check('and the first is told', await seen(page, '[data-loss=taken]'));
await page.screenshot({path: `${folder}/operate-taken.png`});
await other.waitForTimeout(5500);
const times = other.words.map(({at_ms}) => at_ms);
const gaps = times.slice(1).map((at, index) => at - times[index]);
check('renewed each second', gaps.length >= 4 && gaps.every((gap) => gap > 900 && gap < 1300), gaps.join());
await other.click('[data-control]');
check('given up', (await seen(other, '[data-operate=none]')) && (await seen(page, '[data-operate=none]')));
await browser.close();
process.exit(bad > 0 ? 1 : 0);
