// Walks through a log's page by keyboard and looks at what is drawn: node test/walk.mjs ADDRESS FOLDER
import {openChromium} from './chromium.mjs';

const [address, folder] = process.argv.slice(2);
const browser = await openChromium();
const page = await browser.newPage({viewport: {width: 1280, height: 720}});
page.on(
  'console',
  (message) => message.type() === 'error' && !/404/.test(message.text()) && console.log('console:', message.text()),
);
page.on('pageerror', (error) => console.log('error:', error.stack));
await page.goto(`${address}/#view=grasp`);
await page.waitForSelector('[data-connection="log"], [data-connection="live"]');
console.log(
  'connection',
  await page.getAttribute('body', 'data-connection'),
  'stop buttons',
  await page.locator('button.stop').count(),
);
await page.waitForSelector('[data-mark]', {timeout: 5000}).catch(() => console.log('no mark yet'));
const phases = [];
for (let i = 0; i < 60; i++) {
  await page.keyboard.press('n');
  await page.waitForTimeout(120);
  const phase = await page.getAttribute('svg.procedure', 'data-state');
  if (phase && phase !== phases[phases.length - 1]) {
    phases.push(phase);
    await page.waitForTimeout(300);
    await page.screenshot({path: `${folder}/walk-${phases.length}-${phase}.png`});
  }
}
console.log(phases.join(' '));
console.log('time', await page.textContent('mmi-time .time'));
console.log(
  'marks',
  await page.locator('[data-mark]').count(),
  'matches',
  await page.locator('[data-match]').count(),
  'joints',
  await page.locator('[data-joint]').count(),
);
await page.keyboard.press('2');
await page.waitForSelector('[data-view="drive"]');
await page.waitForTimeout(500);
console.log(
  'poses',
  await page.$$eval('[data-pose]', (all) => all.map((one) => one.dataset.pose).join()),
  'tags',
  await page.locator('[data-tag]').count(),
);
await page.keyboard.press('k');
await page.waitForTimeout(2500);
await page.keyboard.press('4');
await page.waitForTimeout(2500);
await page.screenshot({path: `${folder}/walk-plots.png`});
await page.keyboard.press('k');
await page.waitForTimeout(300);
const at = (await page.evaluate('location.hash')).match(/at=(\d+)/)?.[1];
console.log('address', await page.evaluate('location.hash'));
await page.reload();
await page.waitForTimeout(1500);
console.log('after reload', await page.evaluate('location.hash'), at);
console.log(
  'events',
  await page.locator('[data-event]').count(),
  'heap',
  await page.evaluate('Math.round(performance.memory.usedJSHeapSize / 1e6)'),
  'MB',
);
await browser.close();
