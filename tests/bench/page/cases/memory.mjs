// What a browser holds once its buffers are full: it may look for hours.
import {readdirSync, readFileSync} from 'node:fs';
import {openBrowser, openPage} from '../lib/browser.mjs';
import {Stack} from '../lib/stack.mjs';
import {must, pause} from '../lib/wait.mjs';

const kPairs = 9000;
const kBuffersFull_s = 320; // the page keeps 5 minutes
const kMegabyte = 1e6;

// MB of all processes of the browser: pages that several share count once.
function proportionalSize() {
  let bytes = 0;
  for (const name of readdirSync('/proc')) {
    try {
      if (!readFileSync(`/proc/${name}/cmdline`, 'utf8').includes('chromium')) continue;
      bytes += 1024 * Number(/^Pss:\s*(\d+)/m.exec(readFileSync(`/proc/${name}/smaps_rollup`, 'utf8'))[1]);
    } catch {
      // It is no process, or has ended.
    }
  }
  return bytes / kMegabyte;
}

async function collected(session) {
  await session.send('HeapProfiler.collectGarbage');
  await pause(2000);
  const heap = await session.send('Runtime.getHeapUsage');
  return {heap: heap.usedSize / kMegabyte, proportional: proportionalSize()};
}

// How many pairs the page has drawn; it counts by the frame that it shows.
function frameShown(page) {
  return page.evaluate(() => Number(document.querySelector('[data-side=left][data-frame-seq]')?.dataset.frameSeq ?? 0));
}

export async function measure(report, {bin}) {
  const stack = new Stack({bin});
  const browser = await openBrowser();
  try {
    await stack.start();
    const page = await openPage(browser, stack.address, 'grasp');
    const session = await page.context().newCDPSession(page);
    await must('a picture', async () => (await frameShown(page)) > 0, 30);
    await pause(1000 * kBuffersFull_s);
    const before = await collected(session);
    const first = await frameShown(page);
    await must(`${kPairs} pairs`, async () => (await frameShown(page)) - first >= kPairs, 3600, 1000);
    const after = await collected(session);
    report.add(`growth over ${kPairs} pairs, MB`, after.proportional - before.proportional, '50', after.proportional - before.proportional <= 50, {before, after});
    report.add("the page's heap, MB", after.heap, '250', after.heap <= 250);
  } finally {
    await browser.close();
    await stack.stop();
  }
}
