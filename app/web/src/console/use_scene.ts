// Mounts the 3-D view in an element, feeds it the frames of the trial and the vessel, and lets the
// mouse turn and zoom it.
import {type PointerEvent, useCallback, useEffect, useRef, useState} from 'react';
import type {Briefing} from '../wire/types';
import type {RunningTrial} from './running_trial';
import {MonitorScene, type SceneSettings} from './scene/monitor_scene';
import {loadVessel} from './scene/vessel_model';
import {fullForce} from './trial_gauges';

const noWebGl = 'This browser cannot draw in 3-D (WebGL 2). Switch on hardware acceleration or use another browser.';

export interface MountedScene {
  /** for the ref of the element */
  readonly attach: (element: HTMLElement | null) => (() => void) | undefined;
  readonly scene: MonitorScene | null;
  /** how many times thicker than life the instrument is drawn */
  readonly thickness: number;
  readonly problem: string | null;
  readonly retry: (() => void) | null;
}

export function useScene(trial: RunningTrial, briefing: Briefing, settings: SceneSettings): MountedScene {
  const [scene, setScene] = useState<MonitorScene | null>(null);
  const [thickness, setThickness] = useState(1);
  const [problem, setProblem] = useState<string | null>(null);
  const [attempt, setAttempt] = useState(0);
  const fullForce_n = fullForce(briefing);
  const radius_mm = briefing.instrument.outer_diameter_mm / 2;

  const attach = useCallback((element: HTMLElement | null) => {
    if (!element) return undefined;
    let made: MonitorScene;
    try {
      made = new MonitorScene(element, {radius_mm, fullForce_n}, setThickness);
    } catch {
      setProblem(noWebGl);
      return undefined;
    }
    if (trial.store.latest) made.push(trial.store.latest);
    const forget = trial.store.onFrame((frame) => made.push(frame));
    // React listens passively to the wheel, and the page must not scroll
    const turned = (event: WheelEvent) => {
      event.preventDefault();
      made.zoom(Math.sign(event.deltaY));
    };
    element.addEventListener('wheel', turned, {passive: false});
    setScene(made);
    return () => {
      forget();
      element.removeEventListener('wheel', turned);
      made.dispose();
      setScene(null);
    };
  }, [trial, radius_mm, fullForce_n]);

  useEffect(() => {
    scene?.configure(settings);
  }, [scene, settings]);

  useEffect(() => {
    if (!scene) return;
    let stale = false;
    loadVessel(`/api/anatomies/${encodeURIComponent(briefing.anatomy_id)}/mesh.glb`, scene.detail).then(
      (vessel) => {
        if (stale) vessel.dispose();
        else {
          scene.setVessel(vessel);
          setProblem(null);
        }
      },
      (reason: unknown) => {
        if (!stale) setProblem(reason instanceof Error ? reason.message : String(reason));
      },
    );
    return () => {
      stale = true;
    };
  }, [scene, briefing.anatomy_id, attempt]);

  const retry = useCallback(() => setAttempt((count) => count + 1), []);
  return {attach, scene, thickness, problem, retry: scene ? retry : null};
}

const click_px = 3;

/** Dragging turns the view, with any button: nothing else can be dragged there. A click on the inset swaps. */
export function useOrbit(scene: MonitorScene | null, onInset: () => void) {
  const from = useRef<{x: number; y: number; moved: boolean} | null>(null);
  return {
    onPointerDown: (event: PointerEvent<HTMLElement>) => {
      event.currentTarget.setPointerCapture(event.pointerId);
      from.current = {x: event.clientX, y: event.clientY, moved: false};
    },
    onPointerMove: (event: PointerEvent<HTMLElement>) => {
      const start = from.current;
      if (!start || !scene) return;
      const dx = event.clientX - start.x;
      const dy = event.clientY - start.y;
      if (!start.moved && Math.hypot(dx, dy) < click_px) return;
      from.current = {x: event.clientX, y: event.clientY, moved: true};
      scene.orbit(dx, dy);
    },
    onPointerUp: (event: PointerEvent<HTMLElement>) => {
      const start = from.current;
      from.current = null;
      const box = event.currentTarget.getBoundingClientRect();
      if (start && !start.moved && scene?.isOnInset(event.clientX - box.left, event.clientY - box.top)) onInset();
    },
    onPointerCancel: () => {
      from.current = null;
    },
    onContextMenu: (event: React.MouseEvent) => event.preventDefault(),
  };
}
