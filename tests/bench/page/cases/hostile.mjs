// Who means harm: refused or harmless, and the open page's Stop works all the while.
import {connect} from 'node:net';
import {openBrowser, openPage} from '../lib/browser.mjs';
import {Stack, task} from '../lib/stack.mjs';
import {state} from '../lib/state.mjs';
import {must, pause} from '../lib/wait.mjs';
import {WebSocketPeer} from '../web_socket.mjs';

const kConnections = 10000;
const kPort = 8080;
const kScript = '<img src=x onerror="window.__harmed=true"><script>window.__harmed=true</script>';

// What the server answers to these bytes, until it hangs up or `patience_ms` is over.
function say(bytes, patience_ms = 3000) {
  return new Promise((resolve) => {
    const socket = connect(kPort, '127.0.0.1');
    let answer = '';
    const end = () => {
      socket.destroy();
      resolve(answer);
    };
    const timer = setTimeout(end, patience_ms);
    socket.on('data', (data) => (answer += data));
    socket.on('close', () => {
      clearTimeout(timer);
      end();
    });
    socket.on('error', () => {});
    socket.write(bytes);
  });
}

function get(path, headers = '', host = `127.0.0.1:${kPort}`) {
  return say(`GET ${path} HTTP/1.1\r\nHost: ${host}\r\n${headers}Connection: close\r\n\r\n`);
}

const kUpgrade = 'Upgrade: websocket\r\nSec-WebSocket-Version: 13\r\nSec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n';

async function refusals(report, address) {
  const answers = {
    'foreign Host': [await get('/', '', 'evil.example'), /403/],
    'foreign Origin': [await get('/state.json', 'Origin: http://evil.example\r\n'), /403/],
    "foreign page's picture": [await get('/frame/left.jpg', 'Sec-Fetch-Site: cross-site\r\n'), /403/],
    'foreign WebSocket': [await say(`GET /socket HTTP/1.1\r\nHost: 127.0.0.1:${kPort}\r\nOrigin: http://evil.example\r\nConnection: Upgrade\r\n${kUpgrade}\r\n`), /403/],
    'WebSocket without Origin': [await say(`GET /socket HTTP/1.1\r\nHost: 127.0.0.1:${kPort}\r\nConnection: Upgrade\r\n${kUpgrade}\r\n`), /403/],
    'a way out of the folder': [await get('/../../../../etc/passwd'), /404/],
    'the same, encoded': [await get('/%2e%2e/%2e%2e/etc/passwd'), /404/],
    'POST': [await say(`POST /state.json HTTP/1.1\r\nHost: 127.0.0.1:${kPort}\r\nConnection: close\r\n\r\n`), /403/],
    'a header of 1 MB': [await get('/', `X: ${'x'.repeat(1 << 20)}\r\n`), /^(?!.*200 OK)/],
    'no HTTP': [await say('\x16\x03\x01\x02\x00\r\n\r\n'), /^(?!.*200 OK)/],
  };
  for (const [what, [answer, expected]] of Object.entries(answers)) {
    const line = answer.split('\r\n')[0];
    report.add(what, line || 'hung up', 'refused', expected.test(answer) && !answer.includes('root:'));
  }
  const before = (await state(address)).refused;
  const begun = Date.now();
  await say('GET / HTTP/1.1\r\nHost:', 15000);
  report.add('a slow header is let go after, s', (Date.now() - begun) / 1000, '10 to 12', Math.abs((Date.now() - begun) / 1000 - 11) < 1.5);
  const after = (await state(address)).refused;
  report.add('counted', `${JSON.stringify(before)} then ${JSON.stringify(after)}`, 'more', after.slow > before.slow && before.requests >= 6);
}

// Says what makes no sense, each on a connection of its own: why it was let go.
async function senseless() {
  const words = ['{', 'null', '[]', '{"type":"fly"}', '{"type":"hello","protocol":99}', '['.repeat(60000), '{"type":"seek","utime":"1"}'];
  const ends = words.map((word) => new Promise((resolve) => {
    const peer = new WebSocketPeer({port: kPort}, (self) => {
      self.say({type: 'hello', protocol: 1});
      self.sayText(word);
    }, () => {}, () => resolve(true));
    setTimeout(() => {
      peer.vanish();
      resolve(false);
    }, 5000);
  }));
  return (await Promise.all(ends)).filter((ended) => ended).length === words.length;
}

// A gigabyte announced, and begun.
function gigabyte() {
  return new Promise((resolve) => {
    const peer = new WebSocketPeer({port: kPort}, (self) => {
      self.socket.write(Buffer.from([0x81, 0xff, 0, 0, 0, 0, 0x40, 0, 0, 0, 0, 0, 0, 0]));
      self.socket.write(Buffer.alloc(200000, 'x'));
    }, () => {}, () => resolve(true));
    setTimeout(() => {
      peer.vanish();
      resolve(false);
    }, 5000);
  });
}

async function flood() {
  const sockets = [];
  for (let i = 0; i < kConnections; ++i) {
    const socket = connect(kPort, '127.0.0.1');
    socket.on('error', () => {});
    sockets.push(socket);
    if (i % 100 === 99) await pause(1);
  }
  return () => sockets.forEach((socket) => socket.destroy());
}

// s, from the key to the page's word that every device has echoed: no other can be asked, for nobody else gets in.
async function stopFrom(page) {
  const begun = Date.now();
  await page.keyboard.press('Escape');
  await must('every device acknowledged', () => page.evaluate(() => document.querySelector('[data-stop=acknowledged]') !== null), 15, 20);
  return (Date.now() - begun) / 1000;
}

export async function measure(report, {bin}) {
  const stack = new Stack({bin, port: kPort});
  const browser = await openBrowser();
  try {
    await stack.start();
    const errors = [];
    const page = await openPage(browser, stack.address, 'grasp', {errors});
    await refusals(report, stack.address);
    const ended = await senseless();
    report.add('clients that make no sense', ended ? 'all let go' : 'some stay', 'let go', ended);
    const large = await gigabyte();
    report.add('a message of 1 GB', large ? 'let go' : 'stays', 'let go', large);

    // Script in every text that a message on the bus has.
    await task('start', '--target', 'red_book', '--source', kScript).catch(() => {});
    await task('stop', '--source', kScript);
    await pause(1500);
    const harmed = await page.evaluate(() => window.__harmed === true);
    report.add('script in the texts of the bus', harmed ? 'runs' : 'is text', 'is text', !harmed && errors.length === 0, {errors});

    await task('reset');
    await must('no stop', async () => (await state(stack.address)).troubles.every((one) => one.code !== 'stop_latched'), 10);
    const letGo = await flood();
    const stopped = await stopFrom(page);
    report.add(`Stop from the open page beside ${kConnections} connections, s`, stopped, '2', stopped < 2);
    letGo();
  } finally {
    await browser.close();
    await stack.stop();
  }
}
