import {Button} from '@mantine/core';
import type {ReactNode} from 'react';
import {Dialog} from './Dialog';
import {Problem} from './Problem';

interface Props {
  title: string;
  /** What will happen, and what will not. */
  children: ReactNode;
  /** The verb on the button. */
  action: string;
  busy: boolean;
  problem: string;
  onConfirm: () => void;
  onClose: () => void;
}

/** Asks before something that cannot simply be done again. */
export function Confirm({title, children, action, busy, problem, onConfirm, onClose}: Props) {
  return (
    <Dialog title={title} onClose={onClose} actions={(
      <>
        <Button loading={busy} onClick={onConfirm}>{action}</Button>
        <Button variant="default" onClick={onClose}>Cancel</Button>
      </>
    )}>
      {children}
      <Problem sentence={problem} />
    </Dialog>
  );
}
