import type {ReactNode} from 'react';
import type {Resource} from './api';
import {ErrorState} from './ErrorState';
import {Loading} from './Loading';

interface Props<T> {
  resource: Resource<T>;
  what: string;
  children: (value: T, retry: () => void) => ReactNode;
}

/** Grey blocks, the error, or the page: every view waits in the same way. */
export function Loaded<T>({resource, what, children}: Props<T>) {
  if (resource.state === 'loading') return <Loading what={what} />;
  if (resource.state === 'failed') return <ErrorState problem={resource.problem} onRetry={resource.retry} />;
  return children(resource.value, resource.retry);
}
