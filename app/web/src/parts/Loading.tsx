import {Skeleton} from '@mantine/core';

/** Grey blocks where a page will be. Screen readers hear what is being loaded. */
export function Loading({what}: {what: string}) {
  return (
    <div className="stack" role="status" aria-label={`Loading ${what}`}>
      <Skeleton height={28} width={240} />
      <Skeleton height={160} radius="lg" />
      <Skeleton height={280} radius="lg" />
    </div>
  );
}
