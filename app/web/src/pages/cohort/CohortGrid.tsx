import {useEffect, useLayoutEffect, useRef, useState, type CSSProperties, type KeyboardEvent, type MouseEvent, type PointerEvent} from 'react';
import {useLocation} from 'wouter';
import {shortTitle} from '../../parts/format';
import type {CohortRow} from '../../wire/types';
import styles from './cohort.module.css';
import {GridRow, nowColumn, personColumn, leadColumns} from './GridRow';
import {cellSentence, helpCount, personFacts, shapeOf, type CohortExercise} from './cohort_view';
import {placeAfterKey, type Place} from './grid_place';
import {heightOf, rowsWithin, topOf, totalHeight, type RowRange, type Rows} from './row_window';

interface Props {
  caption: string;
  people: readonly CohortRow[];
  exercises: readonly CohortExercise[];
  /** person -> trial that runs now */
  running: ReadonlyMap<string, string>;
}

const beyond = 10;      // rows drawn out of sight on both sides
const sides_px = 64;    // margins of the page, for the first guess at the width
const firstHeight_px = 800;

function placeOf(target: EventTarget): Place | null {
  const cell = target instanceof Element ? target.closest('[data-place]')?.getAttribute('data-place') : null;
  const [row, column] = (cell ?? '').split(' ').map(Number);
  return row === undefined || column === undefined || Number.isNaN(column) ? null : {row, column};
}

const same = (a: Place | null, b: Place | null) => a?.row === b?.row && a?.column === b?.column;

/** Person by exercise. Only the rows in sight are drawn; one cell at a time is in the order of the Tab key, arrows move. */
export function CohortGrid({caption, people, exercises, running}: Props) {
  const area = useRef<HTMLDivElement>(null);
  const [, navigate] = useLocation();
  const [width, setWidth] = useState(() => window.innerWidth - sides_px);
  const [seen, setSeen] = useState({from: 0, until: firstHeight_px});
  const [wanted, setWanted] = useState<Place>({row: 0, column: personColumn});
  const [hovered, setHovered] = useState<Place | null>(null);
  const [inside, setInside] = useState(false);
  const takesFocus = useRef(false);

  const shape = shapeOf(width, exercises.length);
  const rows: Rows = {count: people.length, tall: helpCount(people), tall_px: 68, usual_px: shape.compact ? 44 : 52};
  const columns = exercises.length + leadColumns;
  // a search may have left fewer rows than the place was on
  const place: Place = {row: Math.min(wanted.row, people.length - 1), column: Math.min(wanted.column, columns - 1)};
  const range = rowsWithin(rows, seen.from, seen.until, beyond);

  useLayoutEffect(() => {
    const element = area.current;
    if (!element) return;
    const measure = () => {
      setWidth(element.clientWidth);
      setSeen({from: element.scrollTop, until: element.scrollTop + element.clientHeight});
    };
    measure();
    const observer = new ResizeObserver(measure);
    observer.observe(element);
    return () => observer.disconnect();
  }, []);

  useEffect(() => {
    if (!takesFocus.current) return;
    takesFocus.current = false;
    const cell = area.current?.querySelector<HTMLElement>(`[data-place="${wanted.row} ${wanted.column}"]`);
    cell?.focus({preventScroll: true});
    cell?.scrollIntoView({block: 'nearest', inline: 'nearest'});
  }, [wanted]);

  const onScroll = () => {
    const element = area.current;
    if (!element) return;
    const next = rowsWithin(rows, element.scrollTop, element.scrollTop + element.clientHeight, beyond);
    // most scrolling stays within the rows that are drawn already
    if (next.first === range.first && next.end === range.end) return;
    setSeen({from: element.scrollTop, until: element.scrollTop + element.clientHeight});
  };
  const onKeyDown = (event: KeyboardEvent) => {
    if (event.altKey || event.metaKey || event.shiftKey) return;
    const page = Math.max(1, Math.floor((area.current?.clientHeight ?? firstHeight_px) / rows.usual_px) - 2);
    const next = placeAfterKey(place, {key: event.key, ctrl: event.ctrlKey}, {rows: people.length, columns, page});
    if (!next) return;
    event.preventDefault();
    takesFocus.current = true;
    setWanted(next);
  };
  const onClick = (event: MouseEvent) => {
    if (event.defaultPrevented || event.button !== 0 || event.ctrlKey || event.metaKey || event.shiftKey || event.altKey) return;
    const href = event.target instanceof Element ? event.target.closest('a')?.getAttribute('href') : null;
    if (!href) return;
    event.preventDefault();
    navigate(href);
  };
  const onPointerOver = (event: PointerEvent) => {
    const over = event.pointerType === 'mouse' ? placeOf(event.target) : null;
    if (!same(over, hovered)) setHovered(over);
  };

  const told = hovered ?? (inside ? place : null);
  const size: CSSProperties & Record<`--${string}`, string> = {
    '--person': `${shape.person}px`, '--now': `${shape.now}px`, '--cell': `${shape.cell}px`, '--columns': String(exercises.length),
  };
  return (
    <section className={`panel ${styles.panel}`} style={size}>
      <div
        ref={area} role="grid" aria-label={caption} aria-rowcount={people.length + 1} aria-colcount={columns}
        className={styles.grid} data-compact={shape.compact} data-testid="cohort-grid"
        onScroll={onScroll} onKeyDown={onKeyDown} onClick={onClick} onPointerOver={onPointerOver} onPointerLeave={() => setHovered(null)}
        onFocus={(event) => {
          const at = placeOf(event.target);
          if (at && !same(at, wanted)) setWanted(at);
          setInside(true);
        }}
        onBlur={(event) => setInside(event.currentTarget.contains(event.relatedTarget))}
      >
        <div role="rowgroup" className={styles.headGroup}>
          <div role="row" aria-rowindex={1} className={`${styles.row} ${styles.head}`}>
            <div role="columnheader" aria-colindex={personColumn + 1} className={styles.person}>Person</div>
            <div role="columnheader" aria-colindex={nowColumn + 1} className={styles.now}>Now</div>
            {exercises.map((exercise, index) => (
              <div key={exercise.exercise_id} role="columnheader" aria-colindex={index + leadColumns + 1} className={styles.title} title={exercise.title}>
                <span>{shortTitle(exercise.title)}</span>
              </div>
            ))}
          </div>
        </div>
        <div role="rowgroup" className={styles.rows} style={{height: totalHeight(rows)}}>
          {drawn(range, place.row).map((index) => {
            const person = people[index];
            return person && (
              <GridRow
                key={person.person_id} person={person} exercises={exercises} index={index} top_px={topOf(rows, index)}
                height_px={heightOf(rows, index)} compact={shape.compact} active={index === place.row ? place.column : -1}
                running={running.has(person.person_id)}
              />
            );
          })}
        </div>
      </div>
      <p className={`small num ${styles.told}`} data-testid="cohort-told">
        <Told place={told} people={people} exercises={exercises} running={running} />
      </p>
    </section>
  );
}

// the rows in the window, and the one that holds the focus wherever it is
function drawn({first, end}: RowRange, active: number): number[] {
  const indices = Array.from({length: end - first}, (_, offset) => first + offset);
  if (active < first) return [active, ...indices];
  return active >= end ? [...indices, active] : indices;
}

interface ToldProps {
  place: Place | null;
  people: readonly CohortRow[];
  exercises: readonly CohortExercise[];
  running: ReadonlyMap<string, string>;
}

/** What the pointed-at or focused cell stands for, in whole words. */
function Told({place, people, exercises, running}: ToldProps) {
  const person = place && people[place.row];
  if (!person) return <span className="faint">Point at a cell or use the arrow keys: its state stands here in words. Enter opens it.</span>;
  const exercise = exercises[place.column - leadColumns];
  const name = <span className="strong">{person.display_name}{exercise ? `, ${shortTitle(exercise.title)}` : ''}: </span>;
  if (exercise) return <>{name}{cellSentence(person.cells[place.column - leadColumns] ?? null)}</>;
  if (place.column === nowColumn) {
    return <>{name}{running.has(person.person_id) ? 'a trial is running now.' : 'no trial is running.'}</>;
  }
  return <>{name}{person.needs_help ? `${person.why} ` : ''}{personFacts(person)}{person.groups.length > 0 ? ` · ${person.groups.join(', ')}` : ''}</>;
}
