// A still of an anatomy: drawn once, then the graphics card is given back.
import {useCallback, useState} from 'react';
import {PerspectiveCamera, Scene, WebGLRenderer} from 'three';
import {basisOf, bestYaw, eyeOf, fieldOfView_deg, fit} from '../../console/scene/camera_rig';
import {loadVessel, wholeLayer} from '../../console/scene/vessel_model';
import styles from './scene.module.css';

const detail = {close: 1000, whole: 60_000};

export default function ScenePicture({anatomyId}: {anatomyId: string}) {
  const [problem, setProblem] = useState('');
  const attach = useCallback((host: HTMLDivElement | null) => {
    if (!host) return undefined;
    let stale = false;
    draw(host, anatomyId, () => stale).catch((reason: unknown) => {
      if (!stale) setProblem(reason instanceof Error ? reason.message : String(reason));
    });
    return () => {
      stale = true;
      host.replaceChildren();
    };
  }, [anatomyId]);
  return (
    <>
      <div className={styles.picture} ref={attach} role="img" aria-label={`Picture of the anatomy ${anatomyId}`} />
      {problem !== '' && <p className="small tone-bad">{problem}</p>}
    </>
  );
}

async function draw(host: HTMLElement, anatomyId: string, isStale: () => boolean): Promise<void> {
  const vessel = await loadVessel(`/api/anatomies/${encodeURIComponent(anatomyId)}/mesh.glb`, detail);
  try {
    if (isStale()) return;
    const {clientWidth: width, clientHeight: height} = host;
    const view = fit(vessel.outline, {yaw: bestYaw(vessel.outline), pitch: 0}, width / height);
    const camera = new PerspectiveCamera(fieldOfView_deg, width / height, Math.max(1, view.distance * 0.05), view.distance * 4 + 2000);
    camera.layers.enable(wholeLayer);
    camera.up.set(...basisOf(view).up);
    camera.position.set(...eyeOf(view));
    camera.lookAt(...view.target);
    const scene = new Scene();
    scene.add(vessel.group);
    const renderer = new WebGLRenderer({antialias: true, preserveDrawingBuffer: true});
    try {
      renderer.setPixelRatio(Math.min(2, window.devicePixelRatio));
      renderer.setSize(width, height, false);
      renderer.setClearColor('#0c0e11');
      renderer.render(scene, camera);
      const still = document.createElement('canvas');
      still.width = renderer.domElement.width;
      still.height = renderer.domElement.height;
      still.getContext('2d')?.drawImage(renderer.domElement, 0, 0);
      host.replaceChildren(still);
    } finally {
      renderer.dispose();
      renderer.forceContextLoss();
    }
  } finally {
    vessel.dispose();
  }
}
