// Chromium without a window.
import {existsSync} from 'node:fs';
import {createRequire} from 'node:module';
import {kRepository} from './process.mjs';

/** The page's own packages: playwright-core, axe-core. */
export const fromPage = createRequire(`${kRepository}/services/mmi/page/package.json`);

const kFlags = ['--headless', '--no-sandbox', '--disable-quic', '--no-first-run', '--disable-background-networking',
  '--disable-component-update', '--disable-sync', '--enable-unsafe-swiftshader'];
export const kViewport = {width: 1280, height: 720};

export function openBrowser() {
  const executablePath = process.env.CHROMIUM ?? '/usr/bin/chromium';
  if (!existsSync(executablePath)) throw new Error(`${executablePath} does not exist; CHROMIUM=PATH names another`);
  return fromPage('playwright-core').chromium.launch({executablePath, args: kFlags});
}

/** A page at `view` of mmi at `address`, heard by it; what goes wrong inside is added to `errors`. */
export async function openPage(browser, address, view, {errors = [], before = null, colorScheme = 'light'} = {}) {
  const page = await browser.newPage({viewport: kViewport, colorScheme});
  page.on('pageerror', (error) => errors.push(error.message));
  page.on('console', (message) => /Content Security|Refused/.test(message.text()) && errors.push(message.text()));
  if (before) await page.addInitScript(before);
  await page.goto(`${address}/#view=${view}`);
  await page.waitForSelector('body:not([data-connection=lost])[data-connection]', {timeout: 15000});
  return page;
}
