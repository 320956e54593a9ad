import assert from 'node:assert/strict';
import test from 'node:test';
import {FloorScale} from '../src/drawing/floor_map.js';
import {afterPlaceKey, placedAt, placeOf, placeWords, textsOf, turnedTo} from '../src/operate/wished_place.js';

const kRightAngle = Math.PI / 2;
const near = (a: number, b: number): boolean => Math.abs(a - b) < 1e-6;

test('a place in px is that in m, and back', () => {
  const scale = new FloorScale(250, [0.2, 0.55], [400, 500]);
  const [u, v] = scale.at(0.37, -0.12);
  const [x, y] = scale.placeAt(u, v);
  assert.ok(near(x, 0.37) && near(y, -0.12));
});

test('what is clicked is a place to 1 cm, with the heading of before', () => {
  assert.deepEqual(placedAt(0.2049, -0.951, null), {x: 0.2, y: -0.95, heading: 0});
  assert.ok(near(placedAt(0, 0, {x: 1, y: 1, heading: kRightAngle}).heading, kRightAngle));
});

test('it is turned to where it is dragged, to 1 degree', () => {
  const place = {x: 1, y: 1, heading: 0};
  assert.ok(near(turnedTo(place, 1, 3).heading, kRightAngle));
  assert.ok(near(turnedTo(place, -1, 1).heading, Math.PI));
  assert.equal(turnedTo(place, 1, 1), place);
});

test('arrows move it, with Shift they turn it, and other keys are not for it', () => {
  const place = {x: 0, y: 0, heading: 0};
  assert.deepEqual(afterPlaceKey(place, 'ArrowUp', false), {x: 0, y: 0.05, heading: 0});
  assert.deepEqual(afterPlaceKey(place, 'ArrowLeft', false), {x: -0.05, y: 0, heading: 0});
  const left = afterPlaceKey(place, 'ArrowLeft', true)!;
  assert.ok(near(left.heading, kRightAngle / 18) && left.x === 0);
  assert.ok(near(afterPlaceKey(place, 'ArrowRight', true)!.heading, -kRightAngle / 18));
  assert.equal(afterPlaceKey(place, 's', false), null);
});

test('36 turns of 10 degrees lead back, and never beyond half a turn', () => {
  let place = {x: 0, y: 0, heading: 0};
  for (let turn = 0; turn < 72; turn++) {
    place = afterPlaceKey(place, 'ArrowUp', true)!;
    assert.ok(place.heading <= Math.PI && place.heading > -Math.PI);
  }
  assert.ok(near(place.heading, 0));
});

test('what is shown in the fields is what they say', () => {
  const place = placedAt(0.2, 0.95, {x: 0, y: 0, heading: kRightAngle});
  assert.deepEqual(textsOf(place), {x: '0.2', y: '0.95', heading: '90'});
  const read = placeOf(textsOf(place))!;
  assert.ok(near(read.x, 0.2) && near(read.y, 0.95) && near(read.heading, kRightAngle));
  assert.equal(placeWords(place), '0.20, 0.95 m, 90°');
});

test('fields that are empty, no number or too far are no place', () => {
  assert.equal(placeOf(textsOf(null)), null);
  assert.equal(placeOf({x: '1', y: '', heading: '0'}), null);
  assert.equal(placeOf({x: '1', y: '-', heading: '0'}), null);
  assert.equal(placeOf({x: '1e5', y: '0', heading: '0'}), null);
  assert.ok(near(placeOf({x: '1', y: '0', heading: '270'})!.heading, -kRightAngle));
});
