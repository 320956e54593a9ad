// Looks at a live page as an operator does: node test/live.mjs FOLDER ADDRESS COMMAND... where COMMAND starts the server.
import {spawn} from 'node:child_process';
import {openChromium} from './chromium.mjs';

const [folder, address, ...command] = process.argv.slice(2);
const wait = (ms) => new Promise((done) => setTimeout(done, ms));
const serve = () => spawn(command[0], command.slice(1), {stdio: ['ignore', 'inherit', 'inherit']});
let bad = 0;
const check = (what, holds, seen = '') => {
  bad += holds ? 0 : 1;
  console.log(`${holds ? 'ok  ' : 'FAIL'} ${what} ${seen}`);
};

let server = serve();
await wait(1500);
const browser = await openChromium();
const page = await browser.newPage({viewport: {width: 1280, height: 720}});
page.on('pageerror', (error) => check('no error in the page', false, error.stack));
page.on(
  'console',
  (message) =>
    /Content Security|Refused/.test(message.text()) && check('nothing against the policy', false, message.text()),
);
await page.goto(address);
const state = () => page.getAttribute('body', 'data-connection');
await page.waitForSelector('body[data-connection=live]', {timeout: 5000});
await page.waitForSelector('[data-mark]', {timeout: 20000}).catch(() => check('marks are drawn', false));
check('live', (await state()) === 'live');
const box = await page.locator('button.stop').boundingBox();
check('Stop is large', box.width >= 64 && box.height >= 64, JSON.stringify(box));
await page.screenshot({path: `${folder}/live-grasp.png`});

const first = await page.getAttribute('.image-frame', 'data-frame-seq');
await page.keyboard.press('k');
await wait(200);
const paused = await page.getAttribute('.image-frame', 'data-frame-seq');
await wait(1500);
check(
  'pause holds the picture',
  paused === (await page.getAttribute('.image-frame', 'data-frame-seq')),
  `${first} ${paused}`,
);
await page.keyboard.press(',');
for (let i = 0; i < 50 && Number(await page.getAttribute('.image-frame', 'data-frame-seq')) >= Number(paused); i++)
  await wait(100);
const back = await page.getAttribute('.image-frame', 'data-frame-seq');
check('one picture back', Number(back) < Number(paused), `${paused} ${back}`);
check('the time is in the address', /at=\d+/.test(await page.evaluate('location.hash')));
await page.screenshot({path: `${folder}/live-paused.png`});
await page.keyboard.press('l');
await wait(700);
check('live again, data went on', Number(await page.getAttribute('.image-frame', 'data-frame-seq')) > Number(paused));

await page.locator('[data-mark]').first().click();
check(
  'a click chooses a mark everywhere',
  (await page.locator('.is-selected').count()) > 0 && /select=/.test(await page.evaluate('location.hash')),
  await page.evaluate('location.hash'),
);

await page.keyboard.press('3');
await wait(1500);
await page.locator('mmi-channels .row-button', {hasText: 'JOINT_STATE'}).click();
await wait(600);
check('fields of a channel', (await page.locator('mmi-fields tr').count()) > 3);
await page.screenshot({path: `${folder}/live-health.png`});
await page.keyboard.press('4');
await wait(1500);
await page.screenshot({path: `${folder}/live-plots.png`});

const asked = Date.now();
await page.keyboard.press('s');
await page.waitForSelector('button.stop:not([data-stop=idle])', {timeout: 2000}).catch(() => {});
check('S stops', (await page.getAttribute('button.stop', 'data-stop')) !== 'idle', `${Date.now() - asked} ms`);
await wait(900);
console.log(
  '     devices',
  await page.$$eval('[data-device]', (all) => all.map((one) => `${one.dataset.device} ${one.dataset.stop}`).join()),
);
await page.screenshot({path: `${folder}/live-stop.png`});

const killed = Date.now();
server.kill('SIGKILL');
await page.waitForSelector('body[data-connection=lost]', {timeout: 3000}).catch(() => {});
check('lost within 1 s', (await state()) === 'lost' && Date.now() - killed < 1000, `${Date.now() - killed} ms`);
await wait(1500);
await page.screenshot({path: `${folder}/live-lost.png`});
check('the status line says so', (await page.getAttribute('[data-trouble]', 'data-trouble')) === 'mmi_lost');
server = serve();
const again = Date.now();
await page.waitForSelector('body[data-connection=live]', {timeout: 8000}).catch(() => {});
check('comes back', (await state()) === 'live', `${Date.now() - again} ms`);

server.kill('SIGSTOP');
const frozen = Date.now();
await page.waitForSelector('body[data-connection=lost]', {timeout: 4000}).catch(() => {});
check(
  'a hung mmi is lost within 1 s',
  (await state()) === 'lost' && Date.now() - frozen < 1000,
  `${Date.now() - frozen} ms`,
);
server.kill('SIGCONT');
await page.waitForSelector('body[data-connection=live]', {timeout: 8000}).catch(() => {});
check('and comes back', (await state()) === 'live');
await browser.close();
server.kill();
process.exit(bad > 0 ? 1 : 0);
