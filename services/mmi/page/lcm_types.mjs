// What the page's code gets of `import {kMessageTypes} from 'lcmtypes'`: the fields of all message types, read from the
// .lcm files when the page or its tests are bundled.
import {readFileSync, readdirSync} from 'node:fs';
import {dirname, join} from 'node:path';
import {fileURLToPath} from 'node:url';

const kFolder = join(dirname(fileURLToPath(import.meta.url)), '..', '..', '..', 'lcmtypes');

/** Takes a constant to the row of names that it belongs to: each row counts up from 0, as common/reflection has it. */
function addConstants(text, rows) {
  for (const [, name, number] of text.matchAll(/(\w+)\s*=\s*([^,\s]+)/g)) {
    const value = Number(number);
    if (value === 0) rows.push([]);
    if (rows.length > 0 && value === rows[rows.length - 1].length) rows[rows.length - 1].push(name);
  }
}

/** `{NAME: [{name, kind, names?}]}` of the structs in the text of an .lcm file. */
export function parseTypes(text) {
  const types = {};
  const bare = text.replace(/\/\*[^]*?\*\/|\/\/.*/g, '');
  for (const [, name, body] of bare.matchAll(/struct\s+(\w+)\s*\{([^}]*)\}/g)) {
    const rows = [];
    const fields = [];
    for (const statement of body.split(';').map((part) => part.trim())) {
      const [, kind, rest] = /^([\w.]+)\s+([^]*)$/.exec(statement) ?? [];
      if (kind === 'const') addConstants(rest.replace(/^\w+\s+/, ''), rows);
      else if (kind) {
        for (const field of rest.split(',').map((part) => part.trim())) {
          fields.push({name: /^\w+/.exec(field)[0], kind, is_array: field.includes('[')});
        }
      }
    }
    const named = fields.filter((field) => field.kind === 'int8_t' && !field.is_array);
    rows.slice(0, named.length).forEach((row, index) => (named[index].names = row));
    types[name] = fields.map(({is_array, ...field}) => field);
  }
  return types;
}

export function messageTypes() {
  const files = readdirSync(kFolder).filter((name) => name.endsWith('.lcm'));
  return Object.assign({}, ...files.sort().map((name) => parseTypes(readFileSync(join(kFolder, name), 'utf8'))));
}

/** For esbuild. */
export const lcmTypes = {
  name: 'lcmtypes',
  setup(build) {
    build.onResolve({filter: /^lcmtypes$/}, () => ({path: 'lcmtypes', namespace: 'lcmtypes'}));
    build.onLoad({filter: /.*/, namespace: 'lcmtypes'}, () => ({
      contents: `export const kMessageTypes = ${JSON.stringify(messageTypes())};`,
      loader: 'js',
    }));
  },
};
