// The troubles, each brought about for real and mended again. `cause` brings it about, `mend` mends it: both return
// when it is done, `mend` what else must be waited for until it is mended. `by`: `message` where a message tells it,
// `silence` where one is missing. `code` and `subject`: as the page shall name it.
import {copyFileSync, writeFileSync} from 'node:fs';
import {lose, loseNothing, fragmentsOf} from '../lib/loss.mjs';
import {kRepository, Process, processOf} from '../lib/process.mjs';
import {setWorld, task} from '../lib/stack.mjs';
import {state} from '../lib/state.mjs';
import {must, pause} from '../lib/wait.mjs';

/** ms: until what a reset of the world brings about has been told. */
const kResetTold_ms = 2000;

const kOrder = ['scripts/task', 'start', '--target', 'red_book'];

function order(...words) {
  return new Process([`${kRepository}/${kOrder[0]}`, ...kOrder.slice(1), ...words]);
}

/** While its work goes on, the light lacks a colour of the mark. */
function unseen(code, subject, colour) {
  let working;
  return {
    code, subject, by: 'message',
    async prepare({bin}) {
      await task('reset');
      await setWorld(bin, `light.cast_${colour}=0`);
    },
    async cause() {
      working = order();
    },
    mend: ({bin}) => setWorld(bin, `light.cast_${colour}=1`),
    async after() {
      await working.end();
      await task('abort');
    },
  };
}

function frozen(code, subject, service) {
  let pid;
  return {
    code, subject, by: 'silence',
    async cause({stack}) {
      pid = stack.pidOf(service);
      process.kill(pid, 'SIGSTOP');
    },
    async mend({stack}) {
      try {
        process.kill(pid, 'SIGCONT');
      } catch (error) {
        if (error.code !== 'ESRCH') throw error;
        // stack-watch has killed it for its silence, and supervisord begins it anew.
        await must(`${service} runs again`, () => stack.pidOf(service), 20);
      }
    },
  };
}

function record(folder) {
  return new Process([`${kRepository}/scripts/record`, '--without-frames', '--out', folder]);
}

const recording = () => {
  let recorder;
  let another;
  return {
    code: 'recording_ended', subject: 'recording', by: 'silence',
    async prepare({stack}) {
      recorder = record(`${stack.folder}/recording`);
      await must('a recording', async () => (await state(stack.address))?.recording?.recording, 10);
    },
    cause: () => recorder.end('SIGKILL'),
    async mend({stack}) {
      another = record(`${stack.folder}/another`);
      await must('another recording', () => another.said.includes('recording '), 10);
    },
    after: () => another.end(),
  };
};

/** `folder`/robot.yaml is the stack's own. */
const dead = () => ({
  code: 'process_dead', subject: 'target-locator', by: 'message',
  async cause({stack}) {
    writeFileSync(stack.robot_file, 'no: robot\n');
    process.kill(stack.pidOf('target-locator'), 'SIGKILL');
  },
  async mend({stack}) {
    copyFileSync(`${kRepository}/config/robot.yaml`, stack.robot_file);
    const restarted = stack.ask('restart', '--may-wait', 'target-locator');
    await must('target-locator runs', () => processOf(new RegExp(`^${stack.bin}/target-locator (?!--check)`)), 10);
    return restarted;
  },
});

function beside(code, subject, command) {
  let other;
  return {
    code, subject, by: 'message',
    async cause({bin}) {
      other = new Process(command(bin));
    },
    mend: () => other.end(),
  };
}

const refused = () => ({
  code: 'target_refused', subject: 'red_book', by: 'message',
  async prepare({bin}) {
    await setWorld(bin, '--reset', '1', 'books.y=0.6');
    await task('reset');
  },
  cause: () => task('start', '--target', 'red_book'),
  mend: async () => {
    order('--drive', '0.20,1.05,90');
  },
  async after({bin}) {
    await task('abort');
    await setWorld(bin, '--reset', '1');
  },
});

// From 1 m before the dock of config/scenes/shelf.yaml.
const blocked = () => ({
  code: 'base_blocked', subject: 'base', by: 'message',
  async prepare({bin}) {
    const obstacle = ['obstacle.present=1', 'obstacle.x=0.20', 'obstacle.y=0.85'];
    await setWorld(bin, '--reset', '1', 'base.start_y=0.05', ...obstacle);
    await task('reset');
  },
  async cause() {
    order('--drive', '0.20,1.05,90');
  },
  mend: ({bin}) => setWorld(bin, 'obstacle.present=0'),
  async after({bin}) {
    await task('abort');
    await setWorld(bin, '--reset', '1');
  },
});

function localised({stack}) {
  return must('a pose', async () => (await state(stack.address))?.pose?.state === 'LOCALISED', 20, 20);
}

const carriedAway = () => ({
  code: 'pose_lost', subject: 'base', by: 'message',
  async prepare(world) {
    await setWorld(world.bin, '--reset', '1');
    await task('reset');
    await pause(kResetTold_ms); // this reset may lose the pose too
    await localised(world);
  },
  async cause({bin}) {
    await setWorld(bin, '--reset', '1', 'base.start_x=3.0', 'base.start_y=3.0');
    await task('reset');
  },
  async mend(world) {
    await setWorld(world.bin, '--reset', '1');
    await localised(world);
  },
});

const stopped = () => ({
  code: 'stop_latched', subject: 'arm, base', by: 'message',
  prepare: () => task('reset'),
  cause: () => task('stop'),
  mend: () => task('reset'),
});

function lost(code, subject, by, match) {
  return {code, subject, by, cause: () => lose(match), mend: () => loseNothing()};
}

const kMachine = process.arch === 'arm64' ? 'aarch64' : 'x86_64';
const clock = (bin) => ['env', 'LD_PRELOAD=libfaketime.so.1',
  `LD_LIBRARY_PATH=/usr/lib/${kMachine}-linux-gnu/faketime`, 'FAKETIME=+1h', `${bin}/mark-watcher`,
  '--robot-file', 'config/robot.yaml'];

export const kInjections = [
  stopped(),
  refused(),
  unseen('mark_unseen', 'red_book', 'red'),
  unseen('hand_unseen', 'hand', 'green'),
  blocked(),
  carriedAway(),
  lost('camera_silent', 'cameras', 'silence', fragmentsOf('STEREO_FRAME')),
  dead(),
  frozen('process_hung', 'target-locator', 'target-locator'),
  beside('second_writer', 'ROBOT_POSE', (bin) => [`${bin}/rfid-localizer`, '--robot-file', 'config/robot.yaml']),
  beside('clock_ahead', 'mark-watcher', clock),
  lost('messages_lost', '', 'message', 'numgen random mod 100 < 20'),
  recording(),
  frozen('stop_device_silent', 'arm', 'simulator'),
  frozen('mmi_lost', 'mmi', 'mmi'),
];
