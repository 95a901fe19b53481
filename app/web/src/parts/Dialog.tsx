import {useEffect, useId, useRef, type ReactNode} from 'react';
import styles from './native_dialog.module.css';

interface Props {
  title: string;
  onClose: () => void;
  children: ReactNode;
  /** The buttons; the primary one first. */
  actions: ReactNode;
}

/** A question that has to be answered before anything else: the browser keeps the focus inside, Esc closes. */
export function Dialog({title, onClose, children, actions}: Props) {
  const heading = useId();
  const dialog = useRef<HTMLDialogElement>(null);
  useEffect(() => {
    const element = dialog.current;
    // back to what opened it
    const before = document.activeElement;
    element?.showModal();
    return () => {
      element?.close();
      if (before instanceof HTMLElement) before.focus();
    };
  }, []);
  return (
    <dialog
      ref={dialog} className={styles.dialog} aria-labelledby={heading}
      onCancel={(event) => {
        event.preventDefault();
        onClose();
      }}
    >
      <h2 id={heading}>{title}</h2>
      <div className={styles.body}>{children}</div>
      <div className={styles.actions}>{actions}</div>
    </dialog>
  );
}
