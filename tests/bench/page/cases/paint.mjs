// How soon the page is there, and how large it is.
import {readdirSync, readFileSync} from 'node:fs';
import {join} from 'node:path';
import {gzipSync} from 'node:zlib';
import {openBrowser, kViewport} from '../lib/browser.mjs';
import {quantile} from '../lib/report.mjs';
import {Stack} from '../lib/stack.mjs';

const kRounds = 10;

async function paintOf(browser, address) {
  // No cache of an earlier round.
  const context = await browser.newContext({viewport: kViewport});
  const page = await context.newPage();
  await page.goto(`${address}/`);
  await page.waitForSelector('mmi-status .trouble', {timeout: 15000});
  const said = await page.evaluate(() => new Promise((resolve) => {
    new PerformanceObserver((list) => {
      const found = list.getEntriesByName('first-contentful-paint')[0];
      if (found) resolve({first: performance.getEntriesByName('first-paint')[0]?.startTime ?? null, contentful: found.startTime});
    }).observe({type: 'paint', buffered: true});
  }));
  await context.close();
  return said;
}

function sizes(folder) {
  const files = readdirSync(folder).map((name) => readFileSync(join(folder, name)));
  return {
    raw: files.reduce((sum, file) => sum + file.length, 0),
    compressed: files.reduce((sum, file) => sum + gzipSync(file, {level: 9}).length, 0),
  };
}

export async function measure(report, {bin}) {
  const {raw, compressed} = sizes(join(bin, '../page'));
  report.add('all files, KB', raw / 1000, 'under 1000', raw < 1e6);
  report.add('compressed, KB', compressed / 1000, 'under 300', compressed < 300e3);
  const stack = new Stack({bin});
  const browser = await openBrowser();
  try {
    await stack.start();
    const rounds = [];
    for (let i = 0; i < kRounds; ++i) rounds.push(await paintOf(browser, stack.address));
    const contentful = rounds.map((round) => round.contentful / 1000);
    report.add('first paint, median of rounds, s', quantile(contentful, 0.5), '1', quantile(contentful, 0.5) <= 1, {rounds});
    report.add('first paint, slowest round, s', Math.max(...contentful), '1', Math.max(...contentful) <= 1);
  } finally {
    await browser.close();
    await stack.stop();
  }
}
