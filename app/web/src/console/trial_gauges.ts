// The gauges of the console from one frame, and the alarm they raise.
import type {Frame} from '../wire/frame';
import type {Briefing} from '../wire/types';
import {type Alarm, type GaugeReading, limitOn, readAlarm, readGauge, readLimits} from './readings';

export interface Gauges {
  readonly contact: GaugeReading;
  readonly push: GaugeReading;
  readonly torque: GaugeReading;
}

// ends of a scale that has no limit to go by
const forceScales_n = [1, 2, 5, 10, 20];
const torqueScales_n_mm = [2, 5, 10, 20, 50, 100];
const usualFullForce_n = 2;

export function readGauges(briefing: Briefing, frame: Frame): Gauges {
  const limit = (metric: string) => limitOn(briefing.limits, metric);
  return {
    contact: readGauge(frame.contact_force_n, frame.contact_force_peak_n, limit('force_max_n'), forceScales_n),
    push: readGauge(frame.handle_force_n, frame.handle_force_peak_n, limit('handle_force_max_n'), forceScales_n),
    torque: readGauge(frame.handle_torque_n_mm, frame.handle_torque_peak_n_mm, limit('torque_max_n_mm'), torqueScales_n_mm),
  };
}

/** The contact force that is drawn red: the limit, or an ordinary one where there is none. */
export function fullForce(briefing: Briefing): number {
  return limitOn(briefing.limits, 'force_max_n') ?? usualFullForce_n;
}

export function alarmOf(briefing: Briefing, frame: Frame): Alarm {
  const gauges = readGauges(briefing, frame);
  return readAlarm(
    [
      {name: 'Contact force', unit: 'N', reading: gauges.contact},
      {name: 'Push force', unit: 'N', reading: gauges.push},
      {name: 'Torque', unit: 'N mm', reading: gauges.torque},
    ],
    readLimits(briefing, frame),
  );
}
