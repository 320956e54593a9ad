/** Numbers as people read them, always with their unit. */

const kMissing = '–';

export function microseconds(value: number | string | null | undefined): number {
  return value === null || value === undefined || value === '' ? NaN : Number(value);
}

function known(value: number | null | undefined): value is number {
  return value !== null && value !== undefined && Number.isFinite(value);
}

export function millimetres(metres: number | null | undefined, digits = 1): string {
  return known(metres) ? `${(metres * 1000).toFixed(digits)} mm` : kMissing;
}

export function metres(value: number | null | undefined, digits = 3): string {
  return known(value) ? `${value.toFixed(digits)} m` : kMissing;
}

export function degrees(radians: number | null | undefined, digits = 1): string {
  return known(radians) ? `${((radians * 180) / Math.PI).toFixed(digits)}°` : kMissing;
}

export function hertz(value: number | null | undefined): string {
  return known(value) ? `${value.toFixed(value < 10 ? 1 : 0)} Hz` : kMissing;
}

export function bytes(value: number | string | null | undefined): string {
  const number = Number(value ?? NaN);
  if (!Number.isFinite(number)) return kMissing;
  const units = ['B', 'KB', 'MB', 'GB', 'TB'];
  let scaled = number;
  let unit = 0;
  while (scaled >= 1000 && unit < units.length - 1) {
    scaled /= 1000;
    unit++;
  }
  return `${unit === 0 || scaled >= 100 ? scaled.toFixed(0) : scaled.toFixed(1)} ${units[unit]}`;
}

/** A span of seconds: 85 ms, 1.23 s, 2 min 05 s, 3 h 07 min. */
export function span(seconds: number | null | undefined): string {
  if (!known(seconds)) return kMissing;
  const sign = seconds < 0 ? '−' : '';
  const size = Math.abs(seconds);
  if (size < 0.0995) return `${sign}${(size * 1000).toFixed(0)} ms`;
  if (size < 9.995) return `${sign}${size.toFixed(2)} s`;
  if (size < 99.95) return `${sign}${size.toFixed(1)} s`;
  const whole = Math.round(size);
  if (whole < 3600) return `${sign}${Math.floor(whole / 60)} min ${String(whole % 60).padStart(2, '0')} s`;
  if (whole < 86400)
    return `${sign}${Math.floor(whole / 3600)} h ${String(Math.floor((whole % 3600) / 60)).padStart(2, '0')} min`;
  return `${sign}${Math.floor(whole / 86400)} d ${Math.floor((whole % 86400) / 3600)} h`;
}

/** Time of the day in UTC with milliseconds. */
export function clock(us: number | string | null | undefined): string {
  const value = microseconds(us);
  if (!Number.isFinite(value) || Math.abs(value) > 8.64e18) return kMissing;
  return new Date(value / 1000).toISOString().slice(11, 23);
}

/** A number without a unit of its own: whole ones as they are, others with `digits` significant digits. */
export function plain(value: number | null | undefined, digits = 5): string {
  if (!known(value)) return kMissing;
  return Number.isInteger(value) ? String(value) : String(Number(value.toPrecision(digits)));
}

/** The unit that a field's name stands for, to show it by; lengths of messages without one are m. */
export function unitOfField(path: string): {unit: string; factor: number} {
  const name = path
    .split('.')
    .pop()!
    .replace(/\[\d+\]$/, '');
  if (/(^|\.)(left|right)\.(patch\.)?(x|y|width|height)$/.test(path)) return {unit: 'px', factor: 1};
  if (/(^|\.)normal(_[A-Z]+)?\./.test(path)) return {unit: '', factor: 1};
  if (/_px$|^(u|v|u_left|v_left|u_right|v_right|residual)$/.test(name)) return {unit: 'px', factor: 1};
  if (/^(heading|heading_error|position|shaft|direction)$/.test(name)) return {unit: '°', factor: 180 / Math.PI};
  if (/error_C/.test(path)) return {unit: 'mm', factor: 1000};
  if (/turn_rate|speed_limit/.test(name)) return {unit: '°/s', factor: 180 / Math.PI};
  if (/^speed$/.test(name)) return {unit: 'm/s', factor: 1};
  if (/latency|^age$|delay/.test(name)) return {unit: 's', factor: 1};
  if (/bytes/.test(name)) return {unit: 'B', factor: 1};
  if (/rssi/.test(name)) return {unit: 'dBm', factor: 1};
  if (/^(x|y|z|range|distance|.*_distance|clearance|tolerance|gripper_opening|nearest)$/.test(name)) {
    return {unit: 'm', factor: 1};
  }
  return {unit: '', factor: 1};
}
