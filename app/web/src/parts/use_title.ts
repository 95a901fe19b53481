import {useEffect} from 'react';

/** The title of the browser tab: the view first, then the application. */
export function useTitle(view: string): void {
  useEffect(() => {
    document.title = `${view} · Cathedra`;
  }, [view]);
}
