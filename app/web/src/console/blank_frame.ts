import type {Frame} from '../wire/frame';

/** What the panels show until the first frame comes. */
export const blankFrame: Frame = {
  paused: true, ended: false, filed: false, started: false, frame: 0, step: 0, time_s: 0, elapsed_s: 0, paused_s: 0,
  slowed_s: 0, handle_axial_mm: 0, handle_rotation_deg: 0, inserted_mm: 0, handle_force_n: 0, handle_force_peak_n: 0,
  handle_torque_n_mm: 0, handle_torque_peak_n_mm: 0, contact_force_n: 0, contact_force_peak_n: 0, step_value: 0,
  step_start: 0, held_s: 0, step_index: 0, contact_count: 0, limit_count: 0, node_count: 0, end_reason: null,
  limits: [], nodes: new Float32Array(0),
};
