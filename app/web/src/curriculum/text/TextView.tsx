import {useCallback} from 'react';
import type {TextDesk} from './desk';
import styles from './text.module.css';

/** The text of a curriculum with its problems. The desk keeps the editor; this only gives it a place. */
export function TextView({desk, hint}: {desk: TextDesk; hint: string}) {
  const attach = useCallback((host: HTMLDivElement | null) => {
    if (!host) return undefined;
    host.append(desk.view.dom);
    desk.view.requestMeasure();
    return () => desk.view.dom.remove();
  }, [desk]);
  return (
    <div className={styles.text}>
      <div className={styles.host} ref={attach} />
      <p id="text-keys" className={`xs faint ${styles.keys}`}>{hint}</p>
    </div>
  );
}
