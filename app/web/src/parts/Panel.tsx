import {useId, type ReactNode} from 'react';

interface Props {
  title: string;
  aside?: ReactNode;
  children: ReactNode;
  className?: string | undefined;
}

/** One level of panel: a titled surface. */
export function Panel({title, aside, children, className = ''}: Props) {
  const heading = useId();
  return (
    <section className={`panel ${className}`} aria-labelledby={heading}>
      <div className="panel-head">
        <h2 id={heading}>{title}</h2>
        {aside !== undefined && <span className="aside num">{aside}</span>}
      </div>
      <div className="panel-body">{children}</div>
    </section>
  );
}
