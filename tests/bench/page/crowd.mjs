// Ten clients of mmi: eight that keep up, one of them vanishing after a while and coming back, one that stalls, one that
// reads a byte a second. Usage: crowd.mjs SECONDS (--port PORT | --path PATH) [1]; 1: one client alone that keeps up.
// Prints one line of JSON at its end:
// pictures a second of each quick client, and how old the first picture is that the stalled one sees when it reads again.
import {WebSocketPeer} from './web_socket.mjs';

const seconds = Number(process.argv[2]);
const place = process.argv[3] === '--path' ? {path: process.argv[4]} : {port: Number(process.argv[4])};
const alone = process.argv[5] === '1';
const kQuick = alone ? 1 : 8;

// What a browser does with a message, but for the drawing: it tells that it has it.
function client() {
  const told = {pictures: 0, picture_at_us: 0, received_at_ms: 0};
  const opened = (self) => {
    self.say({type: 'hello', protocol: 1});
    self.say({type: 'pictures', on: true});
  };
  const peer = new WebSocketPeer(place, opened, (isText, payload) => {
    if (isText) {
      // {"type":"update","number":N, at the beginning of every update.
      const number = /^\{"type":"update","number":(\d+)/.exec(payload.subarray(0, 60).toString());
      if (number) peer.say({type: 'took', number: Number(number[1])});
      return;
    }
    const header = JSON.parse(payload.subarray(4, 4 + payload.readUInt32LE(0)).toString());
    ++told.pictures;
    told.picture_at_us = Number(header.at);
    told.received_at_ms = Date.now();
    peer.say({type: 'seen', number: header.number});
  });
  return {peer, told};
}

const wait = (ms) => new Promise((resolve) => setTimeout(resolve, ms));
const quick = Array.from({length: kQuick}, client);
if (alone) {
  await wait(1000 * seconds);
  console.log(JSON.stringify({pictures_per_s: [quick[0].told.pictures / seconds]}));
  process.exit(0);
}

const stalled = client();
const dribbling = client();
await wait(1000);
const begun = Date.now();
const counted = quick.map((one) => one.told.pictures);
stalled.peer.stall();
dribbling.peer.stall();
const sip = setInterval(() => {
  dribbling.peer.socket.read(1);
}, 1000);
quick[kQuick - 1].peer.vanish();
quick.pop();
await wait(1000 * seconds - (Date.now() - begun));
const passed = (Date.now() - begun) / 1000;
const rates = quick.map((one, i) => (one.told.pictures - counted[i]) / passed);

// The pictures that waited for it come first: two at most, which it acknowledges, and then new ones.
const before = stalled.told.pictures;
const resumed = Date.now();
stalled.peer.resume();
let fresh_s = null;
while (fresh_s === null && Date.now() - resumed < 5000) {
  await wait(5);
  const age_ms = stalled.told.received_at_ms - stalled.told.picture_at_us / 1000;
  if (stalled.told.pictures > before && age_ms < 500) fresh_s = (Date.now() - resumed) / 1000;
}
clearInterval(sip);
console.log(JSON.stringify({pictures_per_s: rates.map((rate) => Number(rate.toFixed(2))), fresh_after_stall_s: fresh_s}));
process.exit(0);
