import type {ReactNode} from 'react';
import {Icon} from './Icon';
import styles from './notices.module.css';

/** Says why there is nothing and what to do about it. */
export function EmptyState({title, children}: {title: string; children: ReactNode}) {
  return (
    <div className={styles.empty}>
      <span className="state tone-idle"><Icon name="circle" /><span>{title}</span></span>
      <div className="muted">{children}</div>
    </div>
  );
}
