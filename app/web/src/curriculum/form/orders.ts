// The keys of the format in the order in which the built-in curricula write them.
export const orders = {
  curriculum: ['schema', 'id', 'version', 'status', 'title', 'authors', 'defaults', 'benchmarks', 'exercises', 'plan', 'completion'],
  attempt: ['time_limit_s', 'on_timeout', 'on_abort'],
  feedback: ['during', 'after'],
  benchmark: ['metric', 'rule', 'value', 'source', 'reason'],
  exercise: ['id', 'version', 'title', 'goal', 'requires', 'scene', 'steps', 'limits', 'attempt', 'feedback', 'record', 'pass', 'proficiency', 'ratings'],
  scene: ['anatomy', 'instruments', 'start_mm', 'seed'],
  step: ['id', 'do', 'to_mm', 'to_deg', 'seconds', 'tolerance_mm', 'tolerance_deg', 'hold_s'],
  limit: ['metric', 'op', 'value', 'on_breach'],
  criterion: ['metric', 'errors', 'op', 'value', 'benchmark'],
  proficiency: ['consecutive', 'additional', 'min_trials', 'max_trials'],
  block: ['block', 'title', 'exercises', 'order', 'max_trials_per_day', 'after'],
  completion: ['all_blocks', 'sign_off', 'retention_test'],
} as const;

/** "step", {"step", "step-2"} -> "step-3": an id that nothing has yet. */
export function freeId(wanted: string, taken: readonly string[]): string {
  if (!taken.includes(wanted)) return wanted;
  const stem = wanted.replace(/-\d+$/, '');
  let number = 2;
  while (taken.includes(`${stem}-${number}`)) ++number;
  return `${stem}-${number}`;
}
