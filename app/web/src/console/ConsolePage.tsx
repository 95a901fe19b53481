import {useEffect, useMemo, useRef, useState, useSyncExternalStore} from 'react';
import {useLocation} from 'wouter';
import {EmptyState} from '../parts/EmptyState';
import {ErrorState} from '../parts/ErrorState';
import {Loading} from '../parts/Loading';
import {useResource, useSignedIn} from '../parts/api';
import {paths} from '../parts/paths';
import type {BegunTrial} from '../wire/types';
import {blankFrame} from './blank_frame';
import styles from './ConsolePage.module.css';
import {HandleColumn} from './HandleColumn';
import {InstrumentPanel} from './InstrumentPanel';
import {KeyLegend} from './KeyLegend';
import {MonitorPanel} from './MonitorPanel';
import {Overlay} from './Overlay';
import {type Opened, overlayOf} from './overlay_state';
import {RunningTrial} from './running_trial';
import type {MonitorScene, SceneSettings} from './scene/monitor_scene';
import {TaskPanel} from './TaskPanel';
import {TopBar} from './TopBar';
import {alarmOf, readGauges} from './trial_gauges';
import {type KeyAction, useSteering} from './use_steering';

export interface ConsoleProps {
  trialId: string;
}

/** The cath lab: one running trial. Comes back to it after a reload, and goes on to the debrief by itself. */
export default function ConsolePage({trialId}: ConsoleProps) {
  const mine = useResource(`live/${trialId}`, (api) => api.liveMine());
  const [, navigate] = useLocation();
  if (mine.state === 'loading') return <main className={styles.waiting}><Loading what="the trial" /></main>;
  if (mine.state === 'failed') return <main className={styles.waiting}><ErrorState problem={mine.problem} onRetry={mine.retry} /></main>;
  const begun = mine.value.trial;
  if (begun?.trial_id !== trialId) {
    return (
      <main className={styles.waiting}>
        <EmptyState title="This trial is not running">
          It has ended, or another trial is running now.
        </EmptyState>
        <p className={styles.links}>
          <button type="button" onClick={() => navigate(paths.debrief(trialId))}>See its debrief</button>
          {begun && <button type="button" onClick={() => navigate(paths.console(begun.trial_id))}>Go to the running trial</button>}
          <button type="button" onClick={() => navigate(paths.training)}>My training</button>
        </p>
      </main>
    );
  }
  return <Console key={trialId} begun={begun} />;
}

function Console({begun}: {begun: BegunTrial}) {
  const {briefing, ordinal, trial_id} = begun;
  const {session} = useSignedIn();
  const [, navigate] = useLocation();
  const trial = useMemo(() => new RunningTrial(trial_id), [trial_id]);
  const snapshot = useSyncExternalStore(trial.store.subscribe, trial.store.getSnapshot);
  const [opened, setOpened] = useState<Opened>(null);
  const [settings, setSettings] = useState<SceneSettings>({mode: 'follow', trueSize: false});
  const scene = useRef<MonitorScene | null>(null);

  useEffect(() => {
    trial.start();
    return () => trial.stop();
  }, [trial]);

  useEffect(() => {
    if (snapshot.filed) navigate(paths.debrief(trial_id), {replace: true});
  }, [snapshot.filed, navigate, trial_id]);

  const kind = overlayOf(snapshot, opened);
  const steering = kind === null;
  const frame = snapshot.frame ?? blankFrame;

  // what is opened over a running trial pauses it, and closing lets it go on
  const resumes = useRef(false);
  const open = (what: Opened) => {
    resumes.current = opened === null ? steering : resumes.current;
    if (steering) trial.pause();
    setOpened(what);
  };
  const close = () => {
    setOpened(null);
    if (resumes.current) trial.resume();
    resumes.current = false;
  };
  const end = () => {
    setOpened(null);
    trial.end();
  };
  const canOpen = kind === null || kind === 'paused' || kind === 'restored' || kind === 'start' || kind === opened;

  const act = (action: KeyAction) => {
    const waiting = kind === 'start' || kind === 'paused' || kind === 'restored';
    const look: Partial<Record<KeyAction, () => void>> = {
      view: () => setSettings({...settings, mode: settings.mode === 'whole' ? 'follow' : 'whole'}),
      true_size: () => setSettings({...settings, trueSize: !settings.trueSize}),
      reset: () => scene.current?.reset(),
      closer: () => scene.current?.zoom(-1),
      further: () => scene.current?.zoom(1),
      confirm: () => { if (waiting) trial.resume(); },
      pause: () => {
        if (steering) trial.pause();
        else if (waiting && kind !== 'start') trial.resume();
      },
      end: () => {
        if (opened) close();
        else if (canOpen) open('confirm_end');
      },
      controls: () => {
        if (opened === 'controls') close();
        else if (canOpen) open('controls');
      },
    };
    look[action]?.();
  };
  useSteering(trial, steering, act);

  const gauges = readGauges(briefing, frame);
  const alarm = alarmOf(briefing, frame);
  const step = briefing.steps[frame.step_index] ?? null;
  return (
    <div className={styles.console} data-theme="lab">
      <TopBar
        title={briefing.title} ordinal={ordinal} person={session.display_name} snapshot={snapshot}
        canPause={steering} canEnd={canOpen} onPause={() => trial.pause()} onEnd={() => open('confirm_end')}
      />
      <MonitorPanel
        trial={trial} briefing={briefing} alarm={alarm} contact={gauges.contact} settings={settings} onSettings={setSettings}
        ref={scene}
        side={<HandleColumn store={trial.store} hand={trial.hand} steering={steering} steps={briefing.steps} step={step} />}
      >
        {kind && (
          <Overlay
            kind={kind} briefing={briefing} snapshot={snapshot} onResume={() => trial.resume()} onEnd={end}
            onAskEnd={() => open('confirm_end')} onClose={close}
            onTryAgain={() => trial.tryAgain()} onTraining={() => navigate(paths.training)}
            onDebrief={() => navigate(paths.debrief(trial_id), {replace: true})}
          />
        )}
      </MonitorPanel>
      <div className={styles.right}>
        <TaskPanel briefing={briefing} frame={frame} done_s={snapshot.done_s} />
        <InstrumentPanel
          store={trial.store} instrument={briefing.instrument} inserted_mm={frame.inserted_mm}
          rotation_deg={frame.handle_rotation_deg} gauges={gauges}
        />
      </div>
      <KeyLegend />
      <p className="visually-hidden" aria-live="polite">{step ? `Step ${frame.step_index + 1}: ${step.title}` : 'All steps are done'}</p>
      <p className="visually-hidden" aria-live="polite">{alarm.spoken}</p>
    </div>
  );
}
