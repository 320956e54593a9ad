// Takes pictures of the page and runs axe-core over it: node test/look.mjs ADDRESS FOLDER [VIEW...]
import {readFileSync} from 'node:fs';
import {createRequire} from 'node:module';
import {openChromium} from './chromium.mjs';

const [address, folder, ...views] = process.argv.slice(2);
const axe = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');
const kShapes = [
  ['wide-light', 1280, 720, 'light'],
  ['wide-dark', 1280, 720, 'dark'],
  ['tablet-light', 1024, 768, 'light'],
];

const browser = await openChromium();
let bad = 0;
for (const [name, width, height, colorScheme] of kShapes) {
  const page = await browser.newPage({viewport: {width, height}, colorScheme});
  page.on(
    'console',
    (message) =>
      ['error', 'warning'].includes(message.type()) &&
      !/GPU stall|favicon|404/.test(message.text()) &&
      console.log('console:', message.text()),
  );
  page.on('pageerror', (error) => console.log('error:', error.message));
  for (const view of views.length > 0 ? views : ['grasp', 'drive', 'health', 'log']) {
    await page.goto(`${address}/#view=${view}`);
    await page.waitForTimeout(2500);
    await page.screenshot({path: `${folder}/${view}-${name}.png`});
    const found = await page.evaluate(`${axe}; axe.run({resultTypes: ['violations']})`);
    for (const violation of found.violations) {
      const serious = ['serious', 'critical'].includes(violation.impact);
      bad += serious ? 1 : 0;
      console.log(
        `${view} ${name}: ${violation.impact} ${violation.id}: ${violation.nodes
          .slice(0, 3)
          .map((node) => node.html.slice(0, 160))
          .join(' | ')}`,
      );
    }
    const overflow = await page.evaluate(
      'document.documentElement.scrollHeight > innerHeight || document.documentElement.scrollWidth > innerWidth',
    );
    if (overflow) console.log(`${view} ${name}: the page scrolls`);
  }
  await page.close();
}
await browser.close();
console.log(`serious or critical findings: ${bad}`);
process.exit(bad > 0 ? 1 : 0);
