import type {BusMessage} from './protocol.js';

/** As services/log-tool/known_values.cpp has it: what is known only where another field, as text, has this value. */
interface Condition {
  type: string;
  field: string;
  value: string;
  values: string[];
  /** Or then not. */
  unless?: boolean;
}

export const kConditions: readonly Condition[] = [
  {type: 'BaseGoal', field: 'kind', value: 'DRIVE', values: ['pose']},
  {type: 'ChannelStatus', field: 'age', value: '-1', values: ['age', 'latency_p50', 'latency_p99'], unless: true},
  {type: 'JointState', field: 'contact_known', value: 'true', values: ['contact']},
  {type: 'LocatedMark', field: 'status', value: 'LOCATED', values: ['p_C', 'covariance', 'normal_C']},
  {
    type: 'MarkView',
    field: 'seen',
    value: 'true',
    values: ['x', 'y', 'width', 'height', 'area', 'u', 'v', 'm_uu', 'm_uv', 'm_vv'],
  },
  {
    type: 'PaperLocalisation',
    field: 'measured_known',
    value: 'true',
    values: ['utime', 'measured_x', 'measured_y', 'delay', 'compensated_x', 'compensated_y'],
  },
  {type: 'PaperLocalisation', field: 'direction_known', value: 'true', values: ['direction', 'speed']},
  {type: 'RfidTagHit', field: 'read_time_known', value: 'true', values: ['read_utime']},
  {type: 'RfidTagHit', field: 'rssi_known', value: 'true', values: ['rssi']},
  {type: 'ServoGoal', field: 'kind', value: 'SERVO', values: ['p_TG_C', 'tolerance']},
  {type: 'TaskCommand', field: 'expected_known', value: 'true', values: ['p_CT_expected']},
  {type: 'TaskCommand', field: 'drive', value: 'true', values: ['drive_pose']},
];

/** Likewise: what is 0, all of it, where it is not known. */
export const kZeroWhileUnknown: readonly {type: string; values: string[]}[] = [
  {type: 'BaseStatus', values: ['distance', 'heading_error']},
  {type: 'LocatedMark', values: ['normal_C']},
  {type: 'MarkPatch', values: ['x', 'y', 'width', 'height']},
  {type: 'ServoStatus', values: ['error_C', 'covariance']},
];

function isZero(value: unknown): boolean {
  if (typeof value === 'number') return value === 0;
  if (typeof value === 'string') return value !== '' && Number(value) === 0;
  if (value === null || typeof value !== 'object' || Array.isArray(value)) return false;
  return Object.values(value).every(isZero);
}

/** The fields of a message of `type` that hold nothing known. `textOf`: a field's value as text, or its constant's name. */
export function unknownFields(type: string, message: BusMessage, textOf: (field: string) => string): Set<string> {
  const unknown = new Set<string>();
  for (const {type: of, field, value, values, unless} of kConditions) {
    if (of !== type || !(field in message)) continue;
    if ((textOf(field) === value) === (unless ?? false)) values.forEach((name) => unknown.add(name));
  }
  for (const {type: of, values} of kZeroWhileUnknown) {
    if (of === type && values.every((name) => isZero(message[name]))) values.forEach((name) => unknown.add(name));
  }
  return unknown;
}
